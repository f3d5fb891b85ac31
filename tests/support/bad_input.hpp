//! Lints bad input by the executable, beside a file whose defect must be found whatever lies there.
#pragma once

#include "tests/support/in_repository.hpp"
#include "tests/support/lines.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {

/// `text` again and again, at least `bytes` long.
inline std::string repeated(std::string_view text, std::size_t bytes) {
    std::string out;
    while (out.size() < bytes) out += text;
    return out;
}

/// A folder with the bad input of the test and a file whose defect must be found whatever lies beside it.
class BadInput : public InRepository {
  protected:
    void SetUp() override {
        InRepository::SetUp();
        folder.write("neighbour.nc", with_defect);
    }

    void take_fixture(const std::string& name) const {
        std::filesystem::copy_file(std::filesystem::path(MACLINT_SOURCE_DIR) / "tests/fixtures/bad-input" /
                                       name,
                                   folder.path() / name);
    }

    /// Lints the paths; the neighbour, which has to be among them, keeps its finding.
    [[nodiscard]] Finished lint(std::vector<std::string> paths) const {
        paths.insert(paths.begin(), {"check", "--format", "concise"});
        Finished finished = run(paths);
        EXPECT_THAT(codes(finished, "neighbour.nc"), testing::ElementsAre("4:1 MAC301"));
        return finished;
    }

    /// "line:column code" of every finding in the file.
    static std::vector<std::string> codes(const Finished& finished, const std::string& name) {
        std::vector<std::string> found;
        for (const std::string& line : lines_of(finished.out)) {
            if (!line.starts_with(name + ":")) continue;
            const std::size_t place = name.size() + 1;
            const std::size_t code = line.find('[', place) + 1;
            found.push_back(line.substr(place, line.find(": ", place) - place) + ' ' +
                            line.substr(code, line.find(']', code) - code));
        }
        return found;
    }
};

} // namespace maclint::test
