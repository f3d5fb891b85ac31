//! MAC211: a call passes a value that the called program never reads.
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/calls/unread_arguments.hpp"
#include "rules/listed.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule argument_unused{
    .code = "MAC211",
    .name = "argument-unused",
    .aliases = "DIN513 MAC212",
    .summary = "A call passes a value that the called program never reads, or overwrites first",
    .why =
        "Whoever wrote the call counts on a depth, a radius or a clearance that changes nothing. Often the "
        "letter is the wrong one, or the program is another version than the call was written for.",
    .severity = Severity::warning,
    .severity_elsewhere = {{"dinplus", Severity::note}},
    .precision = Precision::high,
    .messages = {{"unread", "Argument never read: {0} does not read {1}, which '{2}' passes.",
                  "Correct the letter, or leave it out."},
                 {"several", "Arguments never read: {0} reads none of {1}, which this call passes.",
                  "Correct the letters, or leave them out."},
                 {"overwritten",
                  "Argument never read: {0} sets {1}, which '{2}' passes, on line {3} before it reads it.",
                  "Read it first, or leave it out of the call."}},
    .bad = {{"fanuc", R"nc(
O0211(PLATE)
G65 P9211 Z-5. K2. F100.
M30
O9211(DRILL, Z Q F)
G90 G1 Z#26 F#9
IF[#17EQ#0]GOTO1
G0 Z[#26+#17]
N1 M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 L"CHAMFER" LA50 LB2
N20 M30
SUBPROGRAM "CHAMFER"
N30 G0 X#__la
RETURN
END
)nc"}},
    .good = {{"fanuc", R"nc(
O0211(PLATE)
G65 P9211 Z-5. Q2. F100.
M30
O9211(DRILL, Z Q F)
G90 G1 Z#26 F#9
IF[#17EQ#0]GOTO1
G0 Z[#26+#17]
N1 M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 L"CHAMFER" LA50 LB2
N20 M30
SUBPROGRAM "CHAMFER"
N30 G0 X#__la
N40 IF DEF(__lb)
N50 THEN
N60 G1 Zi-#__lb
N70 ENDIF
RETURN
END
)nc"}},
    .exemptions = {{&queries::exemptions::program_to_be_written,
                    "program-to-be-written",
                    "The called program reads no argument at all: it stands in for one that is still to be "
                    "written, or for one of the machine's maker.",
                    {"fanuc", R"nc(
O0211(PLATE)
G65 P9211 Z-5. Q2. F100.
M30
O9211(DRILL, TO BE WRITTEN)
M99
)nc"}}},
    .sources = {"SEED-003:19938", "T"},
    .check = &check,
};

namespace {

using queries::UnreadArgument;

/// Of one call: those that nothing names, or one that is overwritten.
void report(const ProgramAnalysis& analysis, const std::vector<UnreadArgument>& unread, Reporter& reporter) {
    const UnreadArgument& first = unread.front();
    const Program& called = first.called->program();
    const Span span = first.argument->span;
    std::vector<std::string> names;
    std::map<std::pair<ProgramIndex, EffectId>, std::vector<std::string>> others; // and what they pass
    for (const UnreadArgument& one : unread) {
        names.push_back(with_letter(*one.called, one.variable));
        for (const auto& [program, effect] : one.others) others[{program, effect}].push_back(names.back());
    }
    std::vector<std::string> words{called.name, listed(names, " and "), quoted(analysis.program(), span)};
    if (first.overwritten) {
        const Span store = called.effects[*first.overwritten].span;
        words.push_back(line_number(first.called->file(), store.begin));
    }
    const std::string_view kept = unread.size() == 1 ? "unread" : "several";
    const std::string_view message = first.overwritten ? "overwritten" : kept;
    Finding& finding = reporter.report({analysis, span}, span, message, std::move(words));
    for (const auto& [call, passed] : others) {
        const std::string what = unread.size() == 1 ? "it" : listed(passed, " and ");
        const ProgramAnalysis& caller = queries::calling_program(analysis, {call.first, call.second});
        finding.related.push_back(
            related_at_effect(caller, call.second, "this call passes " + what + ", too"));
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    std::vector<UnreadArgument> together;
    const auto flush = [&] {
        if (!together.empty()) report(analysis, std::exchange(together, {}), reporter);
    };
    for (UnreadArgument& unread : queries::unread_arguments(analysis)) {
        if (!together.empty() && together.front().call != unread.call) flush();
        if (unread.overwritten)
            report(analysis, {unread}, reporter);
        else
            together.push_back(std::move(unread));
    }
    flush();
}

} // namespace
} // namespace maclint::rules
