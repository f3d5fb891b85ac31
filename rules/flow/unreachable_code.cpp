//! MAC460: blocks that no path reaches.
#include "analyzer/queries/unreached_regions.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string_view>
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
           "behind a GOTO may be switched off for a while: a note, and nothing where a remark says so.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .yields_to = "MAC302",
    .messages = {{"alarm", "Unreachable alarm: no jump leads to N{0}, so that '{1}' is never raised.",
                  "Add the test that was to lead there, or delete it."},
                 {"after", "Unreachable: '{0}' stands behind '{1}' in line {2} and is never run.",
                  "Move it before that, jump to it, or delete it."},
                 {"block", "Unreachable: no jump leads to N{0}, and '{1}' in line {2} passes it.",
                  "Add the jump that was to lead there, or delete the blocks."}},
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
END
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
    .sources = {"SEED-002:518", "SEED-003:20016", "SEED-003:20021", "T"},
    .check = &check,
};

namespace {

using queries::UnreachedRegion;

/// Jumps lead to some other alarm, so that those are no messages kept for later.
bool raises_another(const ProgramAnalysis& analysis) {
    return std::ranges::any_of(analysis.graph().exits, [&](const flow::Exit& exit) {
        return exit.kind == flow::ExitKind::alarm && analysis.data().reached(exit.node);
    });
}

/// The message; none where the blocks may stand there on purpose.
std::string_view message_for(const ProgramAnalysis& analysis, const UnreachedRegion& region) {
    const Effect& ender = analysis.program().effects[*region.ender];
    const auto* stop = std::get_if<Stop>(&ender.what);
    const bool ends = stop != nullptr && stop->kind != Stop::Kind::alarm;
    if (region.is_meant || region.is_explained) return {};
    if (region.number && region.is_alarm) return raises_another(analysis) ? "alarm" : std::string_view();
    if (region.leaves || !region.work) return {};
    if (ends && region.only_switches) return {}; // the end of a program switches off as well
    if (!region.number || ends) return "after";
    return region.moves && !region.is_alarm ? "block" : std::string_view();
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const UnreachedRegion& region : queries::unreached_regions(analysis)) {
        const std::string_view message = message_for(analysis, region);
        if (message.empty()) continue;
        const Span ender = program.effects[*region.ender].span;
        const std::string number = region.number ? std::to_string(*region.number) : "";
        const std::string line = line_number(analysis.file(), ender.begin);
        std::vector<std::string> words{number, quoted(program, ender), line};
        if (message == "after") words = {quoted(program, *region.work), quoted(program, ender), line};
        if (message == "alarm")
            words = {number, quoted(program, program.effects[region.alarms.front()].span)};
        const Span place = message == "after" ? *region.work : region.head;
        Finding& finding = reporter.report({analysis, region.text}, place, message, std::move(words));
        // Who puts a GOTO in front of blocks switches them off for a while.
        const bool jump = std::holds_alternative<Jump>(program.effects[*region.ender].what);
        const bool is_sure = message == "after" ? !jump : message == "alarm" && region.is_named;
        if (!is_sure) finding.severity = std::min(finding.severity, Severity::note);
        if (message != "alarm") continue;
        for (const EffectId other : region.alarms)
            if (other != region.alarms.front())
                finding.related.push_back(
                    related_at_effect(analysis, other, "this one is not raised, either"));
    }
}

} // namespace
} // namespace maclint::rules
