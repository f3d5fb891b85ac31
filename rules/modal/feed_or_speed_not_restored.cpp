//! MAC503: a macro leaves another feed or speed than it found.
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/queries/modal_leaks.hpp"
#include "analyzer/queries/modal_parts.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/modal/modal_leak.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule feed_or_speed_not_restored{
    .code = "MAC503",
    .name = "feed-or-speed-not-restored",
    .summary = "A macro changes F or S and does not put the caller's value back",
    .why = "The caller's next block without F or S moves or turns at the macro's value: a plunge "
           "feed for a finishing cut, or a rapid one into the material.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::ExitState, dataflow::Store, dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"every-path",
                  "'{0}' is still in force when the macro returns: the caller's {1} is lost. Save "
                  "{2} at the start and put it back before M99."},
                 {"some-paths",
                  "'{0}' is still in force on some of the paths on which the macro returns: the "
                  "caller's {1} is lost there. Put it back on those, too."}},
    .bad = {{"fanuc", R"nc(
O9503(PLUNGE, Z DEPTH F FEED)
G1 Z#26 F#9
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9503(PLUNGE, Z DEPTH F FEED)
#33=#4109
G1 Z#26 F#9
F#33
M99
)nc"}},
    .sources = {"SEED-001:206"},
    .check = &check,
};

namespace {

/// A value of this macro's own: not the caller's, not what may be a saved copy, not MAC505's wrong variable.
/// A speed that the caller passes is the speed it wants.
bool is_fault(const ProgramAnalysis& analysis, const ModalGroup& group, const dataflow::ExitState& exit,
              const dataflow::ModalPart& part) {
    if (exit.exit.kind != flow::ExitKind::returns) return false;
    const queries::NumberSource source = queries::source_of(analysis, part);
    if (source == queries::NumberSource::at_start) return group.letter == 'F';
    return source != queries::NumberSource::other;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (!analysis.is_macro()) return;
    const auto leaks =
        queries::find_modal_leaks(analysis, RestorePolicy::value,
                                  [&](const ModalGroup& group, GroupId, const auto& exit, const auto& part) {
                                      return is_fault(analysis, group, exit, part);
                                  });
    for (const queries::ModalLeak& leak : leaks) {
        const ModalGroup& group = analysis.control().groups[leak.group];
        report_leak(analysis, reporter, leak,
                    {word_of(analysis, leak.group, leak.part), std::string(group.name),
                     analysis.control().variable_of(leak.group).value_or("it")});
    }
}

} // namespace
} // namespace maclint::rules
