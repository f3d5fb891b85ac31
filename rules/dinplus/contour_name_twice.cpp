//! DIN247: two contours with one name, for which a cycle asks.
#include "analyzer/queries/contours/contour_names.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule contour_name_twice{
    .code = "DIN247",
    .name = "contour-name-twice",
    .summary = "Two contours have the name that a cycle asks for",
    .why = "The control machines one of them: which one the program does not say.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain",
                  "Name twice: \"{0}\" is the contour of line {1} already, and {2} on line {3} asks for it.",
                  "Rename one of them."}},
    .bad = {{"dinplus", R"nc(
FINISHED
N1 G0 X80 Z0
N2 G1 Z-40
FACE_C Z0
N3 G308 ID"SLOT" P-3
N4 G301 XK0 YK20 A0 K24 B8
N5 G309
N6 G308 ID"SLOT" P-3
N7 G301 XK0 YK-20 A0 K24 B8
N8 G309
MACHINING
N10 T1
N11 G197 S1200 G193 F0.05 M103
N12 G110 C0
N13 G845 ID"SLOT" P2 U0.5 Q0 RB5
N14 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
FINISHED
N1 G0 X80 Z0
N2 G1 Z-40
FACE_C Z0
N3 G308 ID"SLOT" P-3
N4 G301 XK0 YK20 A0 K24 B8
N5 G309
N6 G308 ID"SLOT-2" P-3
N7 G301 XK0 YK-20 A0 K24 B8
N8 G309
MACHINING
N10 T1
N11 G197 S1200 G193 F0.05 M103
N12 G110 C0
N13 G845 ID"SLOT" P2 U0.5 Q0 RB5
N14 M30
END
)nc"}},
    .sources = {"SEED-003:10196", "SEED-003:13092"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    for (const Program& program : file.programs) // groups may have contours of the same names
        for (const Section& section : program.sections)
            if (section.kind == "CONTOUR") return;
    queries::ContourNames names = queries::contour_names(file);
    if (names.has_branches) return;
    std::erase_if(names.described, &queries::ContourName::is_blank);
    std::erase_if(names.wanted, &queries::ContourName::is_blank);
    for (auto one = names.described.begin(); one != names.described.end(); ++one) {
        const auto first = std::ranges::find(names.described, one->name, &queries::ContourName::name);
        const auto wanted = std::ranges::find(names.wanted, one->name, &queries::ContourName::name);
        if (first == one || wanted == names.wanted.end()) continue;
        reporter.report({file, one->span}, one->span, "plain",
                        {std::string(one->name), line_number(file, first->span.begin),
                         std::string(wanted->code), line_number(file, wanted->span.begin)});
    }
}

} // namespace
} // namespace maclint::rules
