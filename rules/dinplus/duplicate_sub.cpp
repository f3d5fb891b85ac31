//! DIN510: two subprograms of one name.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/program/model.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <map>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule duplicate_sub{
    .code = "DIN510",
    .name = "duplicate-sub",
    .summary = "Two SUBPROGRAM sections of a file have the same name",
    .why = "A call means one of them, and the other one never runs.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::sections},
    .messages = {{"plain", "Name twice: SUBPROGRAM '{0}' stands on line {1} already.",
                  "Rename one of them, and its calls."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 L"FACE"
N99 M30
SUBPROGRAM "FACE"
N20 G4 F1
RETURN
SUBPROGRAM "FACE"
N30 G4 F2
RETURN
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 L"FACE"
N11 L"CHAMFER"
N99 M30
SUBPROGRAM "FACE"
N20 G4 F1
RETURN
SUBPROGRAM "CHAMFER"
N30 G4 F2
RETURN
END
)nc"}},
    .sources = {"SEED-003:2945"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    std::map<std::string, Span> known;
    for (const Program& program : file.programs) {
        if (!program.local) continue;
        const auto [first, is_new] = known.emplace(in_capitals(program.name), program.name_span);
        if (is_new) continue;
        Finding& finding =
            reporter.report({file, program.name_span}, program.name_span, "plain",
                            {quoted(program, program.name_span), line_number(file, first->second.begin)});
        finding.related.push_back({file.source, first->second, "the first one stands here"});
    }
}

} // namespace
} // namespace maclint::rules
