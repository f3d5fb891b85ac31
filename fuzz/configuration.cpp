//! Configurations of any bytes, and patterns for paths.
#include "cli/config/settings.hpp"
#include "fuzz/harness.hpp"
#include "tests/support/folder.hpp"

#include <filesystem>
#include <variant>

using namespace maclint;

namespace {

/// A word that names nothing would switch rules off, or leave them on, without a sign.
void require_rules(const std::vector<cli::RuleWord>& words) {
    for (const cli::RuleWord& word : words)
        fuzz::require(!cli::rules_named(word.word).empty(), "a word that names no rule was taken");
}

void check(const cli::Configuration& configuration, const std::string& path) {
    if (configuration.select) require_rules(*configuration.select);
    require_rules(configuration.ignore);
    for (const cli::PerFileIgnore& entry : configuration.per_file_ignores) require_rules(entry.rules);
    static_cast<void>(configuration.exclude.takes("a/b/O1.nc"));
    cli::Overrides overrides;
    overrides.config_path = path;
    cli::Settings settings(overrides);
    fuzz::require(settings.for_file("a/b/O1.nc").has_value(), "what was loaded is refused");
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const test::TemporaryFolder folder;
    const std::string_view text = fuzz::text_of(data, size);
    const std::string path = folder.write(".maclint.json", text);
    const auto loaded = cli::load_configuration(path, cli::Reach::of_folder(folder.path()));
    if (const auto* configuration = std::get_if<std::shared_ptr<const cli::Configuration>>(&loaded))
        check(**configuration, path);
    else
        fuzz::require_harmless(printable(std::get<cli::Notice>(loaded).message), "a message");
    const std::size_t end = std::min(text.find('\n'), text.size());
    const cli::GlobSet globs({{std::string(text.substr(0, end)), folder.path().string()}});
    static_cast<void>(globs.takes(folder.path() / text.substr(std::min(end + 1, text.size()))));
    return 0;
}
