//! MAC503: a macro leaves another feed or speed than it found.
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/modal_groups.hpp"
#include "analyzer/queries/modal/leak_use.hpp"
#include "analyzer/queries/modal/modal_leaks.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "analyzer/queries/modal/saved_state.hpp"
#include "analyzer/queries/paths/exits.hpp"
#include "analyzer/queries/values/origins.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/listed.hpp"
#include "rules/modal/modal_leak.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule feed_or_speed_not_restored{
    .code = "MAC503",
    .name = "feed-or-speed-not-restored",
    .summary = "A macro changes F or S and does not put the caller's value back",
    .why =
        "The caller's next block without F or S cuts or turns at the macro's value, a plunge feed or less. "
        "A note, on request, where the caller has set none of its own.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .yields_to = "MAC501",
    .facts = dataflow::facts<dataflow::ExitState, dataflow::ModalWrite, dataflow::CallMade, dataflow::Read,
                             dataflow::Store, dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"caller", "{0} is left to the caller, whose own is lost: {2} moves with it.", "{1}."},
                 {"not-saved", "{0} is left to the caller: the program saves {2}, but not this.", "{1}."},
                 {"not-put-back", "{0} is left to the caller on some of the paths.", "{1}."},
                 {"left", "Left to the caller: {0}.", "Write it again after the call.", true}},
    .bad = {{"fanuc", R"nc(
O9503(PLUNGE, Z DEPTH F FEED)
#1=#4003
G91 G1 Z#26 F#9
G#1
M99
)nc"},
            {"fanuc", R"nc(
O0001(ROUGH)
G1 X50. F800.
G65 P9503 Z-2. F50.
X100.
M30
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
    .exemptions = {{&queries::exemptions::angle_of_the_spindle,
                    "angle-of-the-spindle",
                    "S beside M19 may be the angle at which the spindle stops.",
                    {"fanuc", R"nc(
O0001(ROUGH)
S900 M3
G65 P9503 Z5.
M3
G1 X5. F90.
M30
O9503(ORIENT)
M19 S90.
G0 Z#26
M99
)nc"}},
                   {&queries::exemptions::speed_given_again,
                    "speed-given-again",
                    "Who starts a spindle that the program has stopped gives its speed, by custom.",
                    {"fanuc", R"nc(
O9503(PARK)
#1=#4003
G91 G0 Z#26
M05
S35
G#1
M99
)nc"}}},
    .sources = {"SEED-001:206"},
    .check = &check,
};

namespace {

/// A value of this macro's own: not the caller's, not what may be a saved copy, not MAC505's wrong variable.
/// A speed that the caller passes is the speed it wants.
bool is_fault(const ProgramAnalysis& analysis, const ModalGroup& group, const dataflow::ExitState& exit,
              const dataflow::ModalPart& part) {
    if (exit.exit.kind != flow::ExitKind::returns) return false;
    if (queries::is_made_by_call(analysis, part.origin)) return true;
    const queries::NumberSource source = queries::source_of(analysis, part);
    if (source == queries::NumberSource::at_start) return group.letter == 'F';
    return source != queries::NumberSource::other;
}

/// Whether the leak is a warning of its own: a caller loses what it had set, or the macro keeps other state.
bool report_alone(const ProgramAnalysis& analysis, const queries::ModalLeak& leak, Reporter& reporter) {
    const auto saves = queries::saves_of(analysis);
    std::string_view message;
    std::vector<std::string> words{subject_of(analysis, leak), cure_by_saving(analysis, leak)};
    if (leak.kept) {
        message = "not-put-back";
    } else if (leak.leak_use.own_is_lost) {
        const ProgramAnalysis& caller = *leak.leak_use.program;
        message = "caller";
        words.push_back(place_in(caller, leak.leak_use.block));
    } else if (!saves.empty()) {
        message = "not-saved";
        words.push_back(listed(variables_saved(analysis, saves), " and "));
    } else {
        return false;
    }
    const Cause missing(analysis, queries::span_of_exit(analysis, leak.exit->exit));
    report_leak(analysis, reporter, leak, missing, message, std::move(words));
    return true;
}

/// One note for all under which a known caller moves, though it has set none of its own. Of a macro that puts
/// back nothing and whose callers nobody knows there is nothing to tell: its callers write F and S again.
void report_rest(const ProgramAnalysis& analysis, std::vector<queries::ModalLeak> leaks, Reporter& reporter) {
    std::erase_if(leaks, [](const queries::ModalLeak& leak) { return leak.leak_use.program == nullptr; });
    if (leaks.empty()) return;
    std::vector<std::string> words;
    for (const queries::ModalLeak& leak : leaks)
        words.push_back("'" + word_of(analysis, leak.group, leak.part) + "'");
    report_leak(analysis, reporter, leaks.front(), block_cause(analysis, leaks.front().part), "left",
                {listed(words, " and ")})
        .severity = Severity::note;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (analysis.is_main()) return;
    const auto is_mine = [&](const ModalGroup& group, GroupId, const auto& exit, const auto& part) {
        return analysis.is_macro() && is_fault(analysis, group, exit, part);
    };
    auto leaks = queries::find_modal_leaks(analysis, RestorePolicy::value, is_mine);
    std::erase_if(leaks, [](const auto& leak) { return leak.kept && !leak.kept->is_put_back; }); // MAC507
    std::erase_if(leaks, [&](const auto& leak) { return report_alone(analysis, leak, reporter); });
    report_rest(analysis, std::move(leaks), reporter);
}

} // namespace
} // namespace maclint::rules
