//! A baseline is read again when its file has changed, and only then.
#include "analyzer/source/platform/paths.hpp"
#include "cli/gate/baseline_store.hpp"
#include "tests/support/folder.hpp"

#include <chrono>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;
using cli::Baseline;
using cli::BaselineStore;
using cli::NamedBy;

std::string with_entry(const std::string& file) {
    return cli::baseline_text({{.place = {file, "MAC301", "f"}, .block = {}}});
}

std::string first_file(BaselineStore& store, const std::string& path) {
    const auto read = store.read(path, NamedBy::configuration);
    const auto* baseline = std::get_if<std::shared_ptr<const Baseline>>(&read);
    return baseline == nullptr ? "refused" : (*baseline)->front().place.file;
}

TEST(BaselineStore, ReadsAgainWhatHasChanged) {
    TemporaryFolder folder;
    const fs::path path = folder.path() / "known.json";
    const auto write = [&](const std::string& text, std::chrono::hours age) {
        folder.write("known.json", text);
        fs::last_write_time(path, fs::file_time_type::clock::now() - age);
    };
    BaselineStore store;
    const std::string name = platform::text_of(path);
    write(with_entry("a.nc"), std::chrono::hours(2));
    for (int i = 0; i < 3; ++i) EXPECT_EQ(first_file(store, name), "a.nc");
    EXPECT_EQ(store.reads(), 1U);
    write(with_entry("bb.nc"), std::chrono::hours(1));
    EXPECT_EQ(first_file(store, name), "bb.nc");
    EXPECT_EQ(store.reads(), 2U);
    write("no baseline", std::chrono::hours(1));
    EXPECT_EQ(first_file(store, name), "refused");
}

} // namespace
} // namespace maclint::test
