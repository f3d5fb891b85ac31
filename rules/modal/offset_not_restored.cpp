//! MAC519: a called program leaves another work offset, or no tool length, to a caller with its own.
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modal_leaks.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "rules/modal/modal_leak.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);

constexpr Exemption set_again_later;
} // namespace

extern const Rule offset_not_restored{
    .code = "MAC519",
    .name = "offset-not-restored",
    .summary =
        "A called program changes the work offset, or cancels the tool length compensation, of a caller "
        "that moves on under its own",
    .why =
        "The caller's positions count from another zero point after the call, or its tool comes down by its "
        "whole length.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::ExitState, dataflow::ModalWrite, dataflow::CallMade, dataflow::Read,
                             dataflow::Store, dataflow::Clobber>(),
    .data_flow = true,
    .messages =
        {{"left",
          "{0} '{1}' is left to the caller, which has set its own before the call and moves on without "
          "it in {2}.",
          "Save the caller's code and put it back before the return, or set it again after the call."},
         {"not-put-back", "{0} is left to the caller on some of the paths.", "{1}."}},
    .bad = {{"fanuc", R"nc(
O0001(PLATE IN THE SECOND VICE)
G90 G55 G0 X0 Y0
M98 P9519
X100. Y50.
M30
O9519(TO THE CLEANING PLACE)
G54
G0 X0 Y0
M99
)nc"},
            {"fanuc", R"nc(
O0001(PLATE)
G90 G43 H1 Z50.
M98 P9519
G0 Z2.
M30
O9519(UP)
G49
G53 Z0
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O0001(PLATE IN THE SECOND VICE)
G90 G55 G0 X0 Y0
M98 P9519
X100. Y50.
M98 P9520
G0 X0 Y0
G43 H2 Z50.
M30
O9519(TO THE CLEANING PLACE)
#1=#4014
G54
G0 X0 Y0
G#1
M99
O9520(UP)
G49
G53 Z0
M99
)nc"}},
    .exemptions = {{&set_again_later,
                    "set-again-later",
                    "A later block of the caller switches the offset on again: the move before it may be one "
                    "of other axes.",
                    {"fanuc", R"nc(
O0519(JOB)
G90 G43 H1 Z50.
M98 P1519
G0 X0
G43 H2 Z50.
M30
O1519(PROBE)
G49
M99
)nc"}}},
    .sources = {"SEED-001:1384", "T"},
    .check = &check,
};

namespace {

/// Whether a later block of the program sets the group again: the move before it may be one of other axes.
bool is_set_after(const Program& program, GroupId group, Offset offset) {
    bool found = false;
    for_each_block(program, [&](const BlockView& block) {
        if (block.span.begin <= offset) return true;
        for (const BlockSetting& setting : block.settings) found |= setting.group == group;
        for (const Effect& effect : program.effects_in(block.effects))
            if (const auto* set = std::get_if<SetModal>(&effect.what)) found |= !set->group;
        return !found;
    });
    return found;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (analysis.is_main()) return;
    const auto leaks =
        queries::find_modal_leaks(analysis, RestorePolicy::offset,
                                  [&](const ModalGroup& group, GroupId, const auto& exit, const auto& part) {
                                      const auto code = queries::own_code(analysis, part);
                                      return exit.exit.kind == flow::ExitKind::returns && code &&
                                             (!group.cancel || group.cancel == *code);
                                  });
    for (const queries::ModalLeak& leak : leaks) {
        if (leak.kept) {
            if (leak.kept->is_put_back) // else MAC507
                report_leak(analysis, reporter, leak, block_cause(analysis, leak.part), "not-put-back",
                            {subject_of(analysis, leak), cure_by_saving(analysis, leak)});
            continue;
        }
        const queries::LeakUse& use = leak.leak_use;
        const bool cancels = analysis.control().groups[leak.group].cancel.has_value();
        if (!use.own_is_lost || use.program == nullptr ||
            (set_again_later.is_on() && cancels &&
             is_set_after(use.program->program(), leak.group, use.block.begin)))
            continue;
        const std::string line = "line " + line_number(use.program->file(), use.block.begin);
        report_leak(analysis, reporter, leak, cause_at(analysis, leak.part.origin), "left",
                    {capital_name(analysis, leak.group), word_of(analysis, leak.group, leak.part),
                     line + " of " + use.program->program().name});
    }
}

} // namespace
} // namespace maclint::rules
