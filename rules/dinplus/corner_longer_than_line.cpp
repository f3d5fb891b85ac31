//! DIN239: a chamfer or rounding that is longer than the line which it stands on.
#include "analyzer/queries/turning_outline.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <cmath>
#include <optional>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule corner_longer_than_line{
    .code = "DIN239",
    .name = "corner-longer-than-line",
    .summary = "A chamfer is longer than a line that it stands on",
    .why = "The corner does not fit: the control refuses the contour.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain", "Chamfer longer than its line: '{0}' cuts {1} off, and the line is {2} long.",
                  "Correct the chamfer, or the length of the line."}},
    .bad = {{"dinplus", R"nc(
FINISHED
N1 G0 X0 Z0
N2 G1 X40 BR-5
N3 G1 Z-3
N4 G1 X60
N5 G1 Z-40
MACHINING
N10 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
FINISHED
N1 G0 X0 Z0
N2 G1 X40 BR-2
N3 G1 Z-3
N4 G1 X60
N5 G1 Z-40
MACHINING
N10 M30
END
)nc"}},
    .sources = {"SEED-003:10616"},
    .check = &check,
};

namespace {

/// How long a straight element is; nothing where nobody can say.
std::optional<double> length_of(const queries::OutlineElement& element) {
    if (element.is_arc || !element.from || !element.to) return std::nullopt;
    return queries::distance(*element.from, *element.to);
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    constexpr double rounding = 0.001; // mm
    for (const queries::Outline& outline : queries::turning_contours(analysis.program())) {
        for (std::size_t i = 0; i < outline.elements.size(); ++i) {
            const queries::OutlineElement& element = outline.elements[i];
            if (!element.corner || *element.corner >= 0) continue;
            const double chamfer = -*element.corner;
            for (const std::size_t line : {i, i + 1}) {
                const auto length =
                    line < outline.elements.size() ? length_of(outline.elements[line]) : std::nullopt;
                if (!length || *length == 0 || chamfer <= *length + rounding) continue;
                reporter.report({analysis, element.corner_span}, element.corner_span, "plain",
                                {quoted(analysis.program(), element.corner_span), number_word(chamfer),
                                 number_word(std::round(*length * 1000) / 1000)});
                break;
            }
        }
    }
}

} // namespace
} // namespace maclint::rules
