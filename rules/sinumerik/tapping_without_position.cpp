//! SIN506: a tap is cut and nothing has brought the spindle into position control.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/brought_cycles.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule tapping_without_position{
    .code = "SIN506",
    .name = "tapping-without-position",
    .summary = "G331 cuts a thread, and no block of the program brings the spindle into position control",
    .why =
        "G331 moves the axis by the angle of the spindle. Unless SPOS has put it under position control the "
        "control stops with an alarm, or the tap runs away from its thread.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"plain",
                  "Tapping without a position: nothing puts the spindle under position control before '{0}'.",
                  "Write SPOS= with the angle of the start in a block before it."}},
    .bad = {{"sinumerik", R"nc(
G17 G90 G54
T="TAP_M10" D1 M6
G0 X0 Y0 Z5
G331 Z-20 K1.5 S400
G332 Z5 K1.5
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
G17 G90 G54
T="TAP_M10" D1 M6
G0 X0 Y0 Z5
SPOS=0
G331 Z-20 K1.5 S400
G332 Z5 K1.5
M30
)nc"}},
    .sources = {"SEED-004:266"},
    .check = &check,
};

namespace {

/// The first block that sets the code, which is a name in its group.
std::optional<Span> first_block_with(const Program& program, std::string_view code) {
    const auto group = program.control->group_with(ModalRole::motion);
    if (!group) return std::nullopt;
    const auto& members = program.control->groups[*group].members;
    const auto member = std::ranges::find(members, code, &ModalMember::spelling);
    std::optional<Span> first;
    if (member == members.end()) return first;
    for_each_block_that_sets(program, *group, [&](const BlockView& block) {
        const bool is_it = std::ranges::any_of(block.settings, [&](const BlockSetting& setting) {
            return setting.group == *group && setting.value == member->number;
        });
        if (is_it && (!first || block.span.begin < first->begin)) first = block.span;
    });
    return first;
}

/// Whether the line says something that may put a spindle under position control, remarks left out.
bool positions_a_spindle(std::string_view line) {
    constexpr std::string_view words[] = {"SPOS", "SPCON", "M19", "M70", "=19", "=70"};
    const std::string code = in_capitals(line.substr(0, line.find(';')));
    return std::ranges::any_of(words,
                               [&](std::string_view word) { return code.find(word) != std::string::npos; });
}

/// A called program may do it, and a block that nobody can read.
bool may_be_done_elsewhere(const Program& program) {
    return queries::calls_programs(program) || std::ranges::any_of(program.effects, [](const Effect& effect) {
               return std::holds_alternative<UnreadableBlock>(effect.what);
           });
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const auto tapping = analysis.is_main() ? first_block_with(program, "G331") : std::nullopt;
    if (!tapping || may_be_done_elsewhere(program)) return;
    std::string_view text = program.slice(program.span);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        if (positions_a_spindle(text.substr(0, end))) return;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    reporter.report({analysis.file(), *tapping}, *tapping, "plain", {quoted(program, *tapping)});
}

} // namespace
} // namespace maclint::rules
