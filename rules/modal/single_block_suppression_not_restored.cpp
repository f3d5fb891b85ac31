//! MAC515: single block, feed hold or override are still switched off when the program is left.
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modal_leaks.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/listed.hpp"
#include "rules/modal/modal_leak.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule single_block_suppression_not_restored{
    .code = "MAC515",
    .name = "single-block-suppression-not-restored",
    .summary = "#3003 or #3004 is set and not put back to 0 on every exit: single block, feed "
               "hold and override stay disabled",
    .why = "The operator presses feed hold or switches to single block, and the machine goes on "
           "moving.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::suppression},
    .facts = dataflow::facts<dataflow::ExitState, dataflow::ModalWrite, dataflow::CallMade, dataflow::Store,
                             dataflow::Clobber>(),
    .data_flow = true,
    .messages =
        {{"every-path", "No {1} any more: '{0}' is still in force when the program is left.",
          "Set it back to 0 before {2}."},
         {"some-paths",
          "No {1} any more: '{0}' is still in force on some of the paths on which the program is left.",
          "Set it back to 0 before {2}."}},
    .bad = {{"fanuc", R"nc(
O9515(UP WITHOUT A STOP)
#3003=1
G0 Z10.
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9515(UP WITHOUT A STOP)
#3003=1
G0 Z10.
#3003=0
M99
)nc"}},
    .sources = {"SEED-001:210-240"},
    .check = &check,
};

namespace {

/// What the code switches off: "feed hold and feed override".
std::string switched_off(const ProgramAnalysis& analysis, const queries::ModalLeak& leak) {
    const auto& names = analysis.control().groups[leak.group].switched_off;
    const auto code = static_cast<unsigned>(*queries::own_code(analysis, leak.part));
    std::vector<std::string> words;
    for (std::size_t bit = 0; bit < names.size(); ++bit)
        if ((code >> bit & 1U) != 0) words.emplace_back(names[bit]);
    return listed(words, " and ");
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const auto leaks = queries::find_modal_leaks(
        analysis, RestorePolicy::suppression,
        [&](const ModalGroup& group, GroupId, const auto&, const auto& part) {
            const auto code = queries::own_code(analysis, part);
            return code && std::ranges::find(group.customary, *code) == group.customary.end();
        });
    for (const queries::ModalLeak& leak : leaks)
        report_leak(analysis, reporter, leak,
                    {word_of(analysis, leak.group, leak.part), switched_off(analysis, leak),
                     exit_text(analysis, leak)});
}

} // namespace
} // namespace maclint::rules
