//! DIN105: a section in front of the one that it belongs after.
#include "analyzer/queries/structure/sections.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule section_order{
    .code = "DIN105",
    .name = "section-order",
    .summary = "A section stands in front of the one that it belongs after",
    .why = "The control builds the contours in the order of the text: those of a face or of the lateral "
           "surface lie on"
           " a finished part that must be there before, and what machines comes after all contours.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"early", "Section {0} in front of {1}, after which it belongs.", "Move it behind {1}."}},
    .bad = {{"dinplus", R"nc(
BLANK
N1 G20 X50 Z80 K1
FACE_C Z0
N2 G308 ID"HOLE" P-10
N3 G300 XK15 YK0 B8
N4 G309
FINISHED
N5 G0 X0 Z0
N6 G1 X40
MACHINING
N7 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
BLANK
N1 G20 X50 Z80 K1
FINISHED
N5 G0 X0 Z0
N6 G1 X40
FACE_C Z0
N2 G308 ID"HOLE" P-10
N3 G300 XK15 YK0 B8
N4 G309
MACHINING
N7 M30
END
)nc"}},
    .sources = {"SEED-003:2844", "SEED-003:10136"},
    .check = &check,
};

namespace {

/// A section that belongs after another one, where the program has both.
struct Order {
    std::string_view first, second;
};
constexpr std::array orders = {
    Order{"FINISHED", "FACE_C"},     Order{"FINISHED", "REAR_C"},    Order{"FINISHED", "LATERAL_C"},
    Order{"FINISHED", "FACE_Y"},     Order{"FINISHED", "REAR_Y"},    Order{"FINISHED", "LATERAL_Y"},
    Order{"BLANK", "MACHINING"},     Order{"FINISHED", "MACHINING"}, Order{"TURRET", "MACHINING"},
    Order{"PROGRAM HEAD", "TURRET"},
};

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const auto& sections = analysis.program().sections;
    for (const Order& order : orders) {
        const auto second = std::ranges::find(sections, order.second, &Section::kind);
        const auto first = std::ranges::find(sections, order.first, &Section::kind);
        // Contour groups repeat sections: the first ones tell.
        if (second == sections.end() || first == sections.end() || first < second) continue;
        reporter.report({analysis, second->heading}, second->heading, "early",
                        {std::string(order.second), std::string(order.first)});
    }
}

} // namespace
} // namespace maclint::rules
