//! MAC552: a length without its point, in a file whose lengths have one.
#include "analyzer/queries/words/missing_points.hpp"
#include "rules/fixes.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule missing_decimal_motion{
    .code = "MAC552",
    .name = "missing-decimal-motion",
    .summary = "A length stands without its point, where the others of the file have one",
    .why = "A control that counts least increments takes X100 for 0.1 mm: the tool stops a long way before "
           "the place that was meant, or an arc does not meet its end.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"plain",
                  "Length without its point: '{0}' counts in least increments, and {1} of the {2} whole "
                  "lengths of the file have a point.",
                  "Write '{0}.' if that is the length."}},
    .bad = {{"fanuc", R"nc(
O0552(PLATE)
G90 G54 G0 X10. Y10.
G1 Z-2. F150.
X30. Y12.
X50. Y15.
X55 Y30.
X50. Y45.
G0 Z50.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O0552(PLATE)
G90 G54 G0 X10. Y10.
G1 Z-2. F150.
X30. Y12.
X50. Y15.
X55. Y30.
X50. Y0
G0 Z50.
M30
)nc"}},
    .sources = {"MAN-PB278", "NCT-40: there X325 is 325 mm"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    const queries::Lengths lengths = queries::lengths_of(file);
    if (!lengths.have_points()) return;
    for (const queries::LengthWord& bare : lengths.bare) {
        Finding& finding = reporter.report({file, bare.word}, bare.word, "plain",
                                           {quoted(*bare.program, bare.word),
                                            std::to_string(lengths.count - lengths.bare.size()),
                                            std::to_string(lengths.count)});
        offer_text(finding, Applicability::unsafe, bare.word,
                   std::string(bare.program->slice(bare.word)) + ".");
    }
}

} // namespace
} // namespace maclint::rules
