//! DIN504: V1 in the call of a local subprogram.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule v1_on_local{
    .code = "DIN504",
    .name = "v1-on-local",
    .summary = "A call with V1 names a subprogram that stands in its own file",
    .why = "V1 looks for a file: the subprogram of this program is passed over, and an older one in a "
           "folder may run.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"plain", "Call of a file: '{0}' has V1, and SUBPROGRAM '{1}' of this program does not run.",
                  "Remove V1, or rename one of the two."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 L"FACE" V1
N99 M30
SUBPROGRAM "FACE"
N20 G4 F1
RETURN
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 L"FACE"
N99 M30
SUBPROGRAM "FACE"
N20 G4 F1
RETURN
END
)nc"}},
    .sources = {"SEED-003:19928"},
    .check = &check,
};

namespace {

bool is_local(const ProgramFile& file, const std::string& name) {
    return std::ranges::any_of(file.programs, [&](const Program& program) {
        return program.local && in_capitals(program.name) == name;
    });
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const CallSite& site : analysis.calls()) {
        const Effect& effect = program.effects[site.effect];
        const auto& call = std::get<Call>(effect.what);
        const auto* name = std::get_if<Text>(&call.program);
        if (name == nullptr || analysis.control().calls[call.kind].lookup != LookupScope::other_files)
            continue;
        const std::string_view written = program.slice(name->characters);
        if (is_local(analysis.file(), in_capitals(written)))
            reporter.report({analysis, site.effect}, effect.span, "plain",
                            {quoted(program, effect.span), quoted(program, name->characters)});
    }
}

} // namespace
} // namespace maclint::rules
