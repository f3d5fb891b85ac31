//! Asks what is in force at each block that holds what is wanted.
#include "rules/sinumerik/under_compensation.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/left_active.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "rules/path.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <ranges>
#include <set>

namespace maclint::rules {

void report_stretch(const ProgramAnalysis& analysis, std::string_view message, Reporter& reporter,
                    const CompensationStretch& stretch) {
    const ControlModel& control = analysis.control();
    const auto group = *control.group_with(ModalRole::cutter_compensation);
    Finding& finding = reporter.report(
        {analysis, stretch.there}, stretch.there, message,
        {control.spell(group, stretch.code), line_number(analysis.file(), stretch.begun.begin),
         quoted(analysis.program(), stretch.there), control.spell(group, *control.groups[group].cancel)});
    trace(finding, analysis, stretch.begun_at, {analysis.source(), stretch.begun, "compensation begins here"},
          stretch.at, "it is still in force here");
}

void report_under_compensation(const ProgramAnalysis& analysis, std::string_view message, Reporter& reporter,
                               const std::function<bool(EffectId)>& wanted) {
    const Program& program = analysis.program();
    const auto group = analysis.control().group_with(ModalRole::cutter_compensation);
    if (!group) return;
    const std::optional<double> off = analysis.control().groups[*group].cancel;
    queries::ModesAt modes_at(analysis);
    queries::Lasting lasting(analysis);
    std::set<Offset> reported; // blocks that begin it: one finding for each
    for_each_block_with_effects(program, [&](const BlockView& block) {
        const auto effects = std::views::iota(block.effects.first, block.effects.first + block.effects.count);
        const auto found = std::ranges::find_if(effects, wanted);
        if (found == effects.end()) return;
        const queries::Modes modes = modes_at(block).with_words(*group);
        if (modes.unknown) return;
        const flow::NodeId node = *analysis.graph().node_of(*found);
        for (const queries::Mode& mode : modes.possible) {
            if (mode.set_by != queries::Mode::SetBy::word || !mode.code || mode.code == off) continue;
            const Span begun = queries::span_of(analysis, mode);
            if (!lasting.until(node, *group, mode.node) || !reported.insert(begun.begin).second) continue;
            report_stretch(analysis, message, reporter,
                           {*mode.code, begun, mode.node, program.effects[*found].span, node});
            return;
        }
    });
}

} // namespace maclint::rules
