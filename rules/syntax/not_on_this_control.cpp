//! MAC124: what other controls of the family have, and this one lacks.
#include "analyzer/program/lacking.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/program/tables.hpp"
#include "rules/rule.hpp"
#include "rules/syntax/not_on_this_control_finder.hpp"
#include "rules/syntax_errors.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule not_on_this_control{
    .code = "MAC124",
    .name = "not-on-this-control",
    .summary = "A function, a form of it, an axis or a variable with a name that the control does not have",
    .why = "Newer series and other makers have functions that an older control stops at. A program that runs "
           "on the "
           "machine beside it stops here, when the control comes to the block.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"function", "Function that the control lacks: it stops at '{0}'.", "{1}."},
                 {"form", "Form that the control lacks: it stops at '{0}'.", "{1}."},
                 {"condition", "Condition without a comparison: the control stops at '{0}'.", "{1}."},
                 {"elsewhere", "Condition without a comparison: the assumed control stops at '{0}'.",
                  "If the program runs on {2}, name that (--control), or compare, as in [#1 NE 0]."},
                 {"name", "Variable with a name: the control has none, and stops at '{0}'.", "{1}."},
                 {"axis", "Axis that the machine lacks: '{0}', and the configuration names {1}.",
                  "Correct the letter, or add it to \"axes\" of the control."},
                 {"unsure", "Unlisted: no list of what this control has holds '{0}'.", "{1}."},
                 {"macro-a",
                  "Macro A in a program of macro B: '{0}' is a statement of macro A, and a call here.",
                  "{1}."}},
    .bad = {{"fanuc", R"nc(
O9124(ONCE)
IF[#500]GOTO9
#500=1
N9 M99
)nc"},
            {"fanuc", R"nc(
O0124(GAUGE EVERY 25)
#530=#530+1
G65 H81 P50 Q#530 R25
M99
N50 #530=0
M0
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9124(ONCE)
IF[#500NE0]GOTO9
#500=1
#3=POW[#500,3]
G0 X#3 A[ATAN[#3]/[#500]]
N9 M99
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "113", "IMPROPER COMMAND", true, "lacks-function"},
               {"FANUC 30i/0i-D", "009", "IMPROPER NC-ADDRESS", true, "axis"}},
    .sources = {"ISORP", "SEED-001:263-278", "SINHA-EXP", "HAAS-118", "GH-ALM"},
    .check = &check,
};

namespace {

std::string_view message_for(const SyntaxError& error) {
    if (error.fault == lacking::macro_a) return "macro-a";
    if (error.answer == Answer::unknown) return "unsure";
    if (error.answer == Answer::stops_if_assumed) return "elsewhere";
    return error.fault.substr(error.fault.find('-') + 1); // "lacks-form"
}

/// Whether the program there stores by `=`, which macro A does not have.
bool is_macro_b(const ProgramFile& file, Offset at) {
    return std::ranges::any_of(file.programs, [&](const Program& program) {
        return program.span.contains(at) && std::ranges::any_of(program.effects, [](const Effect& effect) {
                   return std::holds_alternative<Assign>(effect.what);
               });
    });
}

/// The first word of each; further ones are the same slip.
void report_axes(const ProgramFile& file, const Program& program, Reporter& reporter) {
    std::set<std::string_view> told;
    for_each_missing_axis(program, [&](const Word& word) {
        if (!told.insert(word.address).second) return;
        reporter.report({file, word.span}, word.span, "axis",
                        {std::string(program.slice(word.span)), program.control->axes});
    });
}

void check(const ProgramFile& file, Reporter& reporter) {
    for (const Program& program : file.programs) report_axes(file, program, reporter);
    SyntaxCauses causes(file);
    for (const SyntaxError& error : file.syntax_errors) {
        if (!lacking::is_one(error)) continue;
        if (error.fault == lacking::macro_a && !is_macro_b(file, error.span.begin)) continue;
        Finding& finding = reporter.report({file, error.span}, error.span, message_for(error),
                                           {error.subject, error.cure, error.elsewhere});
        finding.alarm = reporter.alarm_for(file, error.fault);
        if (error.answer != Answer::stops) {
            finding.severity = Severity::warning;
            finding.alarm = {};
        }
        finding.same_cause = causes.of(error) + std::string(error.fault) + error.subject;
    }
}

} // namespace
} // namespace maclint::rules
