//! DIN205: a cycle asks for a contour by a name that no contour has.
#include "analyzer/queries/contours/contour_names.hpp"
#include "rules/fixes.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule contour_name_missing{
    .code = "DIN205",
    .name = "aux-contour-id",
    .aliases = "DIN206",
    .summary = "A cycle asks for a contour by a name that no contour of the program has",
    .why = "The cycle does not find its contour, and the control stops with an error when it gets there.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"missing", "Missing contour: {1} asks for \"{0}\", and no contour has that name.",
                  "Correct the name, or describe the contour."},
                 {"near", "Missing contour: {1} asks for \"{0}\", and the contour is named \"{2}\".",
                  "Write the name as the contour has it."}},
    .bad = {{"dinplus", R"nc(
FINISHED
N1 G0 X60 Z0
N2 G1 Z-40
AUXIL_CONTOUR ID"SEAT"
N3 G0 X60 Z-10
N4 G1 X50
MACHINING
N10 T1
N11 G810 ID"GROOVE" P2
N12 M30
END
)nc"},
            {"dinplus", R"nc(
FINISHED
N1 G0 X60 Z0
N2 G1 Z-40
AUXIL_CONTOUR ID"SEAT 1"
N3 G0 X60 Z-10
N4 G1 X50
MACHINING
N10 T1
N11 G810 ID"Seat1" P2
N12 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
FINISHED
N1 G0 X60 Z0
N2 G1 Z-40
AUXIL_CONTOUR ID"SEAT"
N3 G0 X60 Z-10
N4 G1 X50
MACHINING
N10 T1
N11 G810 ID"SEAT" P2
N12 M30
END
)nc"}},
    .sources = {"SEED-003:10196", "SEED-003:13092"},
    .check = &check,
};

namespace {

/// The word with the name that the contour has.
std::string name_replaced(const ProgramFile& file, const queries::ContourName& wanted,
                          std::string_view name) {
    std::string word = file.source->to_utf8(file.source->bytes(wanted.span));
    if (const auto at = word.find(wanted.name); at != std::string::npos)
        word.replace(at, wanted.name.size(), name);
    return word;
}

/// One without a name, where none has a name.
bool has_auxiliary_contour(const ProgramFile& file) {
    return std::ranges::any_of(file.programs, [](const Program& program) {
        return std::ranges::any_of(program.sections,
                                   [](const Section& section) { return section.kind == "AUXIL_CONTOUR"; });
    });
}

void check(const ProgramFile& file, Reporter& reporter) {
    const queries::ContourNames names = queries::contour_names(file);
    const bool has_unnamed = has_auxiliary_contour(file);
    // A program that describes no contour may be a part of one that does.
    if (!names.is_complete || (names.described.empty() && !has_unnamed)) return;
    for (const queries::ContourName& wanted : names.wanted) {
        if (std::ranges::find(names.described, wanted.name, &queries::ContourName::name) !=
            names.described.end())
            continue;
        if (names.described.empty() && wanted.is_blank) continue; // an unnamed contour is no blank
        const auto near = std::ranges::find_if(names.described, [&](const queries::ContourName& one) {
            return queries::squeezed(one.name) == queries::squeezed(wanted.name);
        });
        if (near == names.described.end())
            reporter.report({file, wanted.span}, wanted.span, "missing",
                            {std::string(wanted.name), std::string(wanted.code)});
        else
            offer_text(reporter.report(
                           {file, wanted.span}, wanted.span, "near",
                           {std::string(wanted.name), std::string(wanted.code), std::string(near->name)}),
                       Applicability::unsafe, wanted.span, name_replaced(file, wanted, near->name));
    }
}

} // namespace
} // namespace maclint::rules
