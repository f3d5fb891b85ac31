//! MAC502: what acts on every later move is still switched on when the program is left.
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modal_leaks.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "analyzer/queries/paths/exits.hpp"
#include "analyzer/queries/values/origins.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/modal/modal_leak.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule compensation_or_transform_left_active{
    .code = "MAC502",
    .name = "compensation-or-transform-left-active",
    .summary = "A program ends with cutter compensation, a canned cycle, rotation, polar "
               "coordinates, scaling, mirror image or a local offset active that it switched on "
               "itself",
    .why = "Every later move is shifted, turned, mirrored or drilled: the caller, or the next "
           "program when reset does not cancel it, cuts somewhere else than it was told to.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::ExitState, dataflow::ModalWrite, dataflow::CallMade, dataflow::Store,
                             dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"every-path",
                  "{0} is still active when the program is left: every later move is subject to it.", "{1}."},
                 {"some-paths",
                  "{0} is still active on some of the paths on which the program is left: every later move "
                  "is subject to it.",
                  "{1}."}},
    .bad = {{"fanuc", R"nc(
O9502(SLOT AT AN ANGLE)
G68 X0 Y0 R30.
G1 X20. F200.
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9502(SLOT AT AN ANGLE)
G68 X0 Y0 R30.
G1 X20. F200.
G69
M99
)nc"}},
    .exemptions = {{&queries::exemptions::callers_cancel,
                    "callers-cancel",
                    "What every caller cancels on all of its paths may be switched on for them.",
                    {"fanuc", R"nc(
O0001(CONTOUR)
M98 P9502
G1 Y20. F300.
G40 X0
M30
O9502(TO THE CONTOUR)
G1 G41 D1 X20. F300.
M99
)nc"}}},
    .alarms = {{"FANUC 16i/18i/21i", "044", "G27-G30 NOT ALLOWED IN FIXED CYC"}},
    .sources = {"SEED-001:206,714", "SEED-002:396-528"},
    .check = &check,
};

namespace {

/// A canned cycle ends with the program that is over; a rotation or compensation need not.
bool is_fault(const ProgramAnalysis& analysis, const ModalGroup& group, const dataflow::ExitState& exit,
              const dataflow::ModalPart& part) {
    if (group.restore_policy == RestorePolicy::cycle && exit.exit.kind != flow::ExitKind::returns)
        return false;
    return queries::is_switched_on(analysis, group, part);
}

/// Compensation ends in a move, the last one; anything else in a block of its own.
std::string cure(const ProgramAnalysis& analysis, const queries::ModalLeak& leak) {
    const std::string words = words_to_cancel(analysis.control(), leak.group);
    std::string before = "Write " + words + " before " + exit_text(analysis, leak);
    if (analysis.control().groups[leak.group].role != ModalRole::cutter_compensation) return before;
    const Span set = queries::span_of_origin(analysis, leak.part.origin);
    const auto retreat = queries::last_move_before(analysis, leak.exit->exit);
    if (!retreat || retreat->begin <= set.begin) return before;
    return "Write " + words + " into a straight retreat (the last move is on line " +
           line_number(analysis.file(), retreat->begin) + ")";
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const RestorePolicy restore_policy : {RestorePolicy::operation, RestorePolicy::cycle}) {
        const auto leaks = queries::find_modal_leaks(
            analysis, restore_policy,
            [&](const ModalGroup& group, GroupId, const auto& exit, const auto& part) {
                return is_fault(analysis, group, exit, part);
            });
        for (const queries::ModalLeak& leak : leaks) {
            const std::string code =
                analysis.control().spell(leak.group, *queries::own_code(analysis, leak.part));
            report_leak(analysis, reporter, leak, {code, cure(analysis, leak)});
        }
    }
}

} // namespace
} // namespace maclint::rules
