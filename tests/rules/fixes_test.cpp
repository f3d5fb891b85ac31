//! A safe fix leaves what the program does, unless the control would have refused the block: held against
//! runs of the program before and after, over the bad examples of all rules and the defects of corpus/.
#include "cli/config/shop_demands.hpp"
#include "tests/execution/compared_runs.hpp"
#include "tests/support/linted.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;

/// A program that has a defect, and under which settings it is found.
struct Defective {
    LintedText text;
    cli::Overrides overrides;
};

std::vector<Defective> bad_examples() {
    std::vector<Defective> all;
    for (const Rule* rule : all_rules())
        for (const Example& example : rule->bad) {
            cli::Overrides overrides;
            overrides.dialect = find_dialect(example.dialect);
            overrides.select = {std::string(rule->code)};
            overrides.complete = example.complete;
            overrides.machine = cli::facts_of_example(example.control);
            all.push_back({{std::string(example.file), std::string(example.text)}, std::move(overrides)});
        }
    return all;
}

std::vector<Defective> defects_of_the_corpus() {
    std::vector<Defective> all;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(MACLINT_SOURCE_DIR) / "corpus")) {
        if (!entry.is_regular_file() || entry.path().parent_path().filename() != "defects") continue;
        std::ifstream in(entry.path(), std::ios::binary);
        cli::Overrides overrides;
        overrides.select = {"ALL"};
        all.push_back({{entry.path().filename().string(), std::string(std::istreambuf_iterator(in), {})},
                       std::move(overrides)});
    }
    return all;
}

std::string changed(const std::string& text, const Fix& fix) {
    std::string out = text;
    for (auto edit = fix.edits.rbegin(); edit != fix.edits.rend(); ++edit)
        out.replace(edit->span.begin, edit->span.length(), edit->text);
    return out;
}

/// The lines that the fix touches, and those that it adds.
ChangedLines lines_of(const std::string& path, const Fix& fix) {
    ChangedLines lines{path, {}, {}};
    for (const Edit& edit : fix.edits) {
        const std::uint32_t first = edit.source->position(edit.span.begin).line;
        const std::uint32_t last = edit.source->position(edit.span.end).line;
        for (std::uint32_t line = first; line <= last; ++line) lines.lines.push_back(line);
        if (const auto added = static_cast<std::uint32_t>(std::ranges::count(edit.text, '\n')); added > 0)
            lines.added.emplace_back(first, added);
    }
    return lines;
}

/// Safe fixes that were held against runs, and those with which the program does something else. A block that
/// the control refuses does nothing yet: the fix of an error has nothing to keep.
struct Held {
    std::size_t led_to = 0; ///< some run comes to the changed block
    std::vector<std::string> other = {};
};

bool is_kept_safe(const Finding& finding, const Fix& fix) {
    return fix.applicability == Applicability::safe && finding.severity != Severity::error;
}

void hold(const Defective& program, Held& held) {
    const auto& [path, text] = program.text;
    const cli::Result result = lint_texts({program.text}, program.overrides);
    for (const auto& [finding, suppressed] : result.findings)
        for (const Fix& fix : finding.fixes) {
            if (!is_kept_safe(finding, fix)) continue;
            const Comparison found =
                RunsOf({{path, text}}).compare(changed(text, fix), {}, lines_of(path, fix));
            held.led_to += found.touching > 0 ? 1U : 0U;
            if (!found.same())
                held.other.push_back(std::string(finding.rule->code) + " " + fix.title + ", line " +
                                     std::to_string(found.line) + " of\n" + text.substr(0, 600));
        }
}

TEST(Fixes, ThatAreSafeLeaveWhatTheProgramDoes) {
    Held held;
    for (const Defective& program : bad_examples()) hold(program, held);
    for (const Defective& program : defects_of_the_corpus()) hold(program, held);
    EXPECT_THAT(held.other, testing::IsEmpty());
    EXPECT_GE(held.led_to, 9U);
}

} // namespace
} // namespace maclint::test
