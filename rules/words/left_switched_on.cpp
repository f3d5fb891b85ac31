//! MAC586: something that is still switched on when the program ends.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/sections.hpp"
#include "analyzer/queries/switches_at.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/words/row_of_block.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>

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

/// Whether a job is over there: not a part of one that a caller goes on with.
bool ends_job(const ProgramAnalysis& analysis, const flow::Exit& exit) {
    return exit.kind == flow::ExitKind::ends || exit.kind == flow::ExitKind::restarts ||
           (exit.kind == flow::ExitKind::runs_off && analysis.is_main());
}

/// Whether this block has switched it on, and nothing has switched it off.
bool is_left_on(const RowOfBlock& block, const machine::Switched& switched) {
    return switched.is_surely_on() && switched.on_at == block.block.block.span.begin;
}

bool is_on_at_end(const RowOfBlock& block, std::size_t of) {
    const ProgramAnalysis& analysis = block.block.analysis;
    if (analysis.control().switches[of].where == Switch::Where::section)
        return is_left_on(block, queries::switched_at_end(analysis.program(), block.block.section, of));
    return std::ranges::any_of(analysis.graph().exits, [&](const flow::Exit& exit) {
        return ends_job(analysis, exit) &&
               is_left_on(block, queries::switched_after(analysis, exit.node, of));
    });
}

/// The first tool change behind the block at which it is on.
std::optional<EffectId> tool_change_with(const RowOfBlock& block, std::size_t of) {
    const ProgramAnalysis& analysis = block.block.analysis;
    for (const flow::NodeId node : analysis.graph().with_effects) {
        const Slice effects = analysis.graph().nodes[node].effects;
        for (EffectId id = effects.first; id < effects.first + effects.count; ++id)
            if (std::holds_alternative<ToolChange>(analysis.program().effects[id].what) &&
                is_left_on(block, queries::switched_before(analysis, node, of)))
                return id;
    }
    return std::nullopt;
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
    } else if (is_on_at_end(block, *of)) {
        block.report(reporter, block.code, in_section ? "section" : "end", {code, what, effect});
    }
}

} // namespace
} // namespace maclint::rules
