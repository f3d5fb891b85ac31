//! MAC566: a dwell whose time is in another unit than it was meant.
#include "analyzer/queries/words/missing_points.hpp"
#include "rules/fixes.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule dwell_format{
    .code = "MAC566",
    .name = "dwell-format",
    .summary = "A dwell is written in another unit than the control counts",
    .why = "X and U of a dwell are seconds, and without a point least increments, thousandths of a second; P "
           "is milliseconds. X2 for two seconds waits for 2 ms, and X500. for half a second for eight "
           "minutes.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages =
        {{"increments",
          "Dwell of thousandths of a second: '{0}' has no point, as the lengths of the file have, and "
          "waits for {1} ms.",
          "Write '{0}.' for {1} seconds."},
         {"long", "Dwell of many minutes: '{0}' counts seconds.",
          "Write milliseconds with P, or the point in its place."},
         {"short", "Dwell of {1} ms: '{0}' counts milliseconds.", "Write P{1}000 for {1} seconds.", true}},
    .bad = {{"fanuc", R"nc(
O0566(GROOVE)
G90 G54 G0 X10. Y10.
G1 Z-2. F150.
G4 X2
X30. Y12.
X50. Y15.
X55. Y30.
X50. Y45.
G0 Z50.
M30
)nc"},
            {"fanuc", R"nc(
O0566(GROOVE)
G90 G54 G0 X10. Y10.
G1 Z-2. F150.
G4 X500.
G0 Z50.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O0566(GROOVE)
G90 G54 G0 X10. Y10.
G1 Z-2. F150.
G4 X2.
G4 P500
X30. Y12.
X50. Y15.
X55. Y30.
X50. Y45.
G0 Z50.
M30
)nc"}},
    .sources = {"T", "GEDIT", "MACHINEMFG"},
    .check = &check,
};

namespace {

/// What is wrong with the time; empty: nothing is known to be.
std::string_view message_for(const queries::LengthWord& time, bool lengths_have_points) {
    constexpr double minutes = 300, an_instant = 10, a_tenth_of_a_second = 100;
    const auto& [value, has_point] = time.number;
    if (time.address == "P") return !has_point && value < an_instant ? "short" : "";
    if (has_point) return value >= minutes ? "long" : "";
    return lengths_have_points && value < a_tenth_of_a_second ? "increments" : "";
}

void check(const ProgramFile& file, Reporter& reporter) {
    const queries::Lengths lengths = queries::lengths_of(file);
    for (const queries::LengthWord& time : lengths.times) {
        const std::string_view message = message_for(time, lengths.have_points());
        if (message.empty()) continue;
        const std::string number = number_word(time.number.value);
        Finding& finding = reporter.report({file, time.word}, time.word, message,
                                           {quoted(*time.program, time.word), number});
        const std::string word(time.program->slice(time.word));
        if (message == "increments") offer_text(finding, Applicability::unsafe, time.word, word + ".");
        if (message == "short") offer_text(finding, Applicability::unsafe, time.word, word + "000");
    }
}

} // namespace
} // namespace maclint::rules
