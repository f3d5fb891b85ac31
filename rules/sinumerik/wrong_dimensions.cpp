//! SIN208: the number of indices of an array.
#include "analyzer/queries/names/array_indices.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <cstddef>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule wrong_dimensions{
    .code = "SIN208",
    .name = "wrong-dimensions",
    .summary = "A variable has more or fewer indices than its definition",
    .why = "The control stops with an alarm at the block.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"cure", "Wrong number of indices: '{0}', where the definition has {1}.",
                  "Correct the index, or the definition."}},
    .bad = {{"sinumerik", R"nc(
DEF REAL PLACE[4,2]
G0 X=PLACE[1]
M30
)nc"},
            {"sinumerik", R"nc(
DEF REAL DEPTH
G0 Z=DEPTH[0]
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
DEF REAL PLACE[4,2], DEPTH
G0 X=PLACE[1,0] Z=DEPTH
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12400", "array element does not exist", false}},
    .sources = {"JP10 p.23", "FUND06 p.63"},
    .check = &check,
};

namespace {

std::string indices(std::size_t count) {
    if (count == 0) return "no index";
    return std::to_string(count) + (count == 1 ? " index" : " indices");
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const SyntaxError& error : analysis.file().syntax_errors_in(program.span))
        if (error.kind == SyntaxErrorKind::wrong_dimensions)
            reporter.report({analysis, error.span}, error.span, "cure", {error.subject, error.cure});
    for (const auto& [element, wanted] : queries::other_dimensions(analysis))
        reporter.report({analysis, element}, element, "cure", {quoted(program, element), indices(wanted)});
}

} // namespace

} // namespace maclint::rules
