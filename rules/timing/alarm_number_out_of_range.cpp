//! MAC601: an alarm of the program's own with a number that no control takes.
#include "analyzer/program/tables.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule alarm_number_out_of_range{
    .code = "MAC601",
    .name = "alarm-number-out-of-range",
    .summary = "An alarm of the program's own has a number that none may have",
    .why = "The control shows the number of #3000 with the text. What it does with one out of its range no "
           "document "
           "tells: "
           "it may stop with another alarm, or not show the text. How far the range goes documents "
           "contradict each "
           "other, so only what lies above all of them is told.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .messages = {{"plain", "Alarm number out of range: '{0}', and no control takes more than {1}.",
                  "Use a number that the control shows."},
                 {"sign", "Alarm number out of range: '{0}' is no whole number from 0 on.",
                  "Use a number that the control shows."},
                 {"cure", "Alarm number out of range: '{0}' raises no alarm of this program, {1} do.",
                  "Use a number from 65000 on: those below are of the control's cycles."}},
    .bad = {{"fanuc", R"nc(
O9601(CHECK)
IF[#24EQ#0]THEN #3000=10001(X MISSING)
M99
)nc"},
            {"sinumerik", R"nc(
IF R1>5
SETAL(5201,"R1 is too large")
ENDIF
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9601(CHECK)
IF[#24EQ#0]THEN #3000=101(X MISSING)
M99
)nc"}},
    .alarms = {{"SINUMERIK", "15700", "illegal number in SETAL", false}},
    .sources = {"CNCCI", "ZAPP-ALM"},
    .check = &check,
};

namespace {

/// The greatest number that the variable takes which raises an alarm; 0: none is known.
double greatest_alarm(const ControlModel& control) {
    for (const VariableFamily& family : control.families)
        for (const VariableRange& range : family.ranges)
            if (range.on_write == OnWrite::alarm && range.last_number) return *range.last_number;
    return 0;
}

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::alarm_number, reporter);
    const double most = greatest_alarm(*file.control);
    if (most == 0) return;
    for (const Program& program : file.programs)
        for (const Effect& effect : program.effects) {
            const auto* stop = std::get_if<Stop>(&effect.what);
            if (stop == nullptr || stop->kind != Stop::Kind::alarm || !stop->number) continue;
            const auto* number = std::get_if<Literal>(&program.expressions[*stop->number].node);
            if (number == nullptr) continue;
            const bool is_one = number->value >= 0 && number->value == std::floor(number->value);
            if (is_one && number->value <= most) continue;
            reporter.report({file, effect.span}, effect.span, is_one ? "plain" : "sign",
                            {quoted(program, effect.span), number_word(most)});
        }
}

} // namespace
} // namespace maclint::rules
