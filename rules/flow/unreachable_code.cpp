//! MAC460: blocks that no path reaches.
#include "analyzer/queries/paths/unreached_regions.hpp"
#include "rules/flow/unreached_words.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <utility>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule unreachable_code{
    .code = "MAC460",
    .name = "unreachable-code",
    .aliases = "DIN414",
    .summary = "Blocks behind a jump, an alarm or an end of the program that nothing leads to",
    .why = "The control never runs them: an alarm that no test raises, a retract behind the end. What stands "
           "behind a GOTO may be switched off for a while: a note on request, and nothing where a remark "
           "says so.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .yields_to = "MAC302",
    .messages = {{"alarm", "Unreachable alarm: no jump leads to N{0}, so that '{1}' is never raised.",
                  "Add the test that was to lead there, or delete it."},
                 {"after", "Unreachable: '{0}' stands behind '{1}' on line {2} and is never run.",
                  "Move it before that, jump to it, or delete it."},
                 {"middle",
                  "End in the middle: '{0}' follows '{1}' on line {2} without a number, and is never run.",
                  "Delete the end, or what stands behind it."},
                 {"only-end",
                  "Unreachable end: no jump leads to N{0}, '{1}' on line {2} passes it, and the program ends "
                  "nowhere else but in alarms.",
                  "Correct the jump that was to lead there."},
                 {"passed", "Unreachable: '{0}' stands behind '{1}' on line {2} and is never run.",
                  "Move it before that, jump to it, or delete it.", true},
                 {"block", "Unreachable: no jump leads to N{0}, and '{1}' on line {2} passes it.",
                  "Add the jump that was to lead there, or delete the blocks.", true}},
    .bad = {{"fanuc", R"nc(
O9460(POCKET, X Y)
IF[#24EQ#0]GOTO91
G90 G0 X#24 Y#25
M99
N91 #3000=1(X MISSING)
N92 #3000=2(Y MISSING)
)nc"},
            {"fanuc", R"nc(
O9461(RETRACT)
IF[#5003GT100.]GOTO5
G90 G0 Z100.
M99
G91 G28 Z0
N5 M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 G0 X100 Z2
N20 M30
N30 G14 Q0
N40 M30
END
)nc"},
            {"dinplus", R"nc(
%DWELL.ncs
MACHINING
N1 RETURN
N2 G4 F2
RETURN
)nc"}},
    .good = {{"fanuc", R"nc(
O9460(POCKET, X Y)
GOTO3(DELETE TO USE THE STOP)
M98 P9461
N3 IF[#24EQ#0]GOTO91
IF[#25EQ#0]GOTO92
G90 G0 X#24 Y#25
M99
N91 #3000=1(X MISSING)
M0
N92 #3000=2(Y MISSING)
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 G0 X100 Z2
N20 G14 Q0
N30 M30
END
)nc"}},
    .exemptions =
        {{&queries::exemptions::remark_behind_jump,
          "remark-behind-the-jump",
          "A remark stands behind the jump that passes the blocks: somebody has switched them off, and says "
          "how they come back.",
          {"fanuc", R"nc(
O0460(PLATE)
G90 G0 X0
GOTO4(DELETE TO ENABLE)
G1 Z-5. F100.
N4 G0 Z50.
M30
)nc"}},
         {&exemptions::no_alarm_is_raised,
          "no-alarm-is-raised",
          "The program raises none of its alarms, and nothing moves in front of this one: they are kept for "
          "later, or were taken over with the rest.",
          {"fanuc", R"nc(
O9460(BORE, Z)
G90 G0 Z#26
M99
N900 #3000=1(NO Z)
)nc"}},
         {&exemptions::leads_to_an_end,
          "leads-to-an-end",
          "A block of them ends the program or returns: a part of its own, which is begun by hand.",
          {"fanuc", R"nc(
O0460(PLATE)
G90 G0 X0
M30
N100 G90 G0 Z50.
M30
)nc"}},
         {&exemptions::switches_behind_end,
          "switches-behind-the-end",
          "Behind the end of the program they only switch off what that switches off as well.",
          {"fanuc", R"nc(
O0460(PLATE)
G90 G0 X0
M30
G40 G49 G80
)nc"}},
         {&exemptions::block_without_moves,
          "block-without-moves",
          "They have a number, and neither move nor call: a place that is kept for something.",
          {"fanuc", R"nc(
O9460(BORE, Z)
G90 G0 Z#26
GOTO9
N5 #5=#26
N9 M99
)nc"}}},
    .sources = {"SEED-002:518", "SEED-003:20016", "SEED-003:20021", "T"},
    .check = &check,
};

namespace {

/// Whether some alarm is reached: the others are no messages kept for later.
bool raises_an_alarm(const ProgramAnalysis& analysis) {
    return std::ranges::any_of(analysis.graph().exits, [&](const flow::Exit& exit) {
        return exit.kind == flow::ExitKind::alarm && analysis.data().reached(exit.node);
    });
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const auto regions = queries::unreached_regions(analysis);
    const bool another_is_raised = !regions.empty() && raises_an_alarm(analysis);
    for (const queries::UnreachedRegion& region : regions) {
        auto said = words_for(analysis, region, another_is_raised);
        if (!said) continue;
        Finding& finding =
            reporter.report({analysis, region.text}, said->place, said->message, std::move(said->words));
        if (!said->is_sure) finding.severity = std::min(finding.severity, Severity::note);
        for (const EffectId other : said->others)
            finding.related.push_back(related_at_effect(analysis, other, "this one is not raised, either"));
    }
}

} // namespace
} // namespace maclint::rules
