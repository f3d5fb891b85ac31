//! SIN203: a name that is one letter off a variable, or off a word of the control.
#include "analyzer/queries/names/unknown_names.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>
#include <utility>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule misspelled_name{
    .code = "SIN203",
    .name = "misspelled-name",
    .summary = "A name that nothing defines is one letter off a variable or a word of the control",
    .why = "The control does not find the name, and stops with an alarm, or it is a variable of the "
           "machine that has another value. No program of the folder has the name, no file of definitions "
           "in it gives it, and `known-names` in the configuration does not list it.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Name that is defined nowhere here: '{0}' is one letter off '{1}'.",
                  "Correct the one or the other."},
                 {"word", "Misspelt word: '{0}' is one letter off {1}, and no program has the name.",
                  "Correct it, or list the name under 'known-names' in .maclint.json."}},
    .bad = {{"sinumerik", R"nc(
DEF REAL LENGTH_1
LENGTH_1=5
G1 X=LENGTHH_1 F100
M30
)nc"},
            {"sinumerik", R"nc(
G54 G90
TRNAS X40
G0 X0 Y0
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
DEF REAL LENGTH_1
LENGTH_1=5
G1 X=LENGTH_1 Y=LENGTH_2 F100
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12550", "name not defined, or option or function not available", false}},
    .sources = {"NCP19 p.404"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const UnknownName& name : analysis.program().unknown_names)
        if (std::string meant = queries::meant_by(analysis, name); !meant.empty())
            reporter.report({analysis.file(), name.span}, name.span, name.of_the_program ? "cure" : "word",
                            {std::string(analysis.program().slice(name.span)), std::move(meant)});
}

} // namespace

} // namespace maclint::rules
