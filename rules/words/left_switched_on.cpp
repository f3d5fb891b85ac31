//! MAC586: something that is still switched on when the program ends.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/machine/switches_at.hpp"
#include "analyzer/queries/structure/sections.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/words/row_of_block.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule left_switched_on{
    .code = "MAC586",
    .name = "left-switched-on",
    .summary = "Something is still switched on when the program ends",
    .why = "What the end of a program does not take back stays for the next part and the next program: a "
           "coupling turns the wrong spindle with it, a zero point lies elsewhere.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"tool", "The {1} is still on at '{3}' on line {4}, by {0}: {2}.",
                  "Switch it off before line {4}."},
                 {"end", "The {1} is still on when the program ends, by {0}: {2}.",
                  "Switch it off before the end."},
                 {"section", "The {1} is still on where the section ends, by {0}: {2}.",
                  "Switch it off before the end."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N1 T1
N2 G720 C0 S0 H1 Q1 F1
N3 G1 Z-5 F0.1
N4 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N1 T1
N2 G720 C0 S0 H1 Q1 F1
N3 G1 Z-5 F0.1
N4 G720
N5 M30
END
)nc"}},
    .sources = {"SEED-003:12675", "T: further rows name theirs"},
    .check = RowCheck{.says = RowStatement::left_on, .check = &check},
};

namespace {

bool is_on_at_end(const RowOfBlock& block, std::size_t of, bool in_section) {
    const Offset here = block.block.block.span.begin;
    queries::SwitchesAt& switches = block.block.switches_at;
    if (!in_section) return switches.still_on(of).at_end.contains(here);
    const machine::Switched switched = switches.at_end_of(block.block.section, of);
    return switched.is_surely_on() && switched.on_at == here;
}

/// The first tool change behind the block at which it is on.
std::optional<EffectId> tool_change_with(const RowOfBlock& block, std::size_t of) {
    const auto& changes = block.block.switches_at.still_on(of).at_tool_change;
    const auto change = changes.find(block.block.block.span.begin);
    return change == changes.end() ? std::nullopt : std::optional(change->second);
}

void check(const RowOfBlock& block, Reporter& reporter) {
    const ProgramAnalysis& analysis = block.block.analysis;
    const WordRow& row = block.row();
    const auto of = queries::find_switch(analysis.control(), row.while_on);
    if (!of) return;
    const bool in_section = analysis.control().switches[*of].where == Switch::Where::section;
    if (in_section && (block.block.section.executed == Section::Executed::when_reached ||
                       !queries::has_section(analysis.program(), SectionKind::Role::machining)))
        return;
    const std::string code = block.text_of(block.code), what(row.while_on), effect(row.effect);
    if (const auto change = row.others.empty() ? std::nullopt : tool_change_with(block, *of)) {
        const Span tool = analysis.program().effects[*change].span;
        block.report(
            reporter, block.code, "tool",
            {code, what, effect, quoted(analysis.program(), tool), line_number(analysis.file(), tool.begin)});
    } else if (is_on_at_end(block, *of, in_section)) {
        block.report(reporter, block.code, in_section ? "section" : "end", {code, what, effect});
    }
}

} // namespace
} // namespace maclint::rules
