//! SIN117: a G code that the control does not have.
#include "analyzer/dialect/characters.hpp"
#include "analyzer/queries/names/unknown_names.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule unknown_g_code{
    .code = "SIN117",
    .name = "unknown-g-code",
    .summary = "A G code stands in the program that the control does not have",
    .why =
        "The control stops with an alarm at the block. A machine's maker may define a code of its own: one "
        "alone is told where a file of definitions (.DEF) lies by the program, the configuration lists "
        "`known-names`, or declares the folder complete; two and more of those that other controls drill "
        "and measure with are told always.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"plain", "Unknown G code: the control has no '{0}'.",
                  "Write what it is to do in this control's words, or list it under 'known-names' in "
                  ".maclint.json if the machine has it."}},
    .bad = {{"sinumerik", R"nc(
G17 G90 G54
G43 Z50 H1
G0 X0 Y0
G81 X10 Y10 Z-5 F100
G80
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
G17 G90 G54
G0 X0 Y0 Z50 D1
MCALL CYCLE81(50,0,2,-5,)
X10 Y10
MCALL
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12470", "unknown G function"}},
    .sources = {"MD", "NCI"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const auto is_foreign = [&](const UnknownName& code) {
        return queries::is_of_another_control(analysis.control(), code.name);
    };
    std::vector<const UnknownName*> codes;
    std::set<std::string_view> of_another_control;
    for (const UnknownName& name : analysis.program().unknown_names) {
        if (!queries::is_g_code(name) || analysis.names_elsewhere().contain(name.name)) continue;
        codes.push_back(&name);
        if (is_foreign(name)) of_another_control.insert(name.name);
    }
    const bool is_slip = of_another_control.size() > 1;
    for (const UnknownName* code : codes)
        if (queries::is_undefined(analysis, *code) || (is_slip && is_foreign(*code)))
            reporter.report({analysis.file(), code->span}, code->span, "plain", {code->name}).same_cause =
                code->name;
}

} // namespace
} // namespace maclint::rules
