//! MAC564: levels of a canned cycle that are given under G91 and used under G90.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/queries/words/stored_cycles.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule canned_cycle_data_mode{
    .code = "MAC564",
    .name = "canned-cycle-data-mode",
    .summary = "Levels of a canned cycle are given under G91, and a hole is made under G90",
    .why = "Z and R of a cycle are distances under G91 and positions under G90. Given as distances and used "
           "after a change to G90 they name other levels: the tool may go down in rapid traverse to a height "
           "that was meant as a distance.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::BeforeNode>(),
    .messages = {{"plain",
                  "Levels of a canned cycle in the other distance mode: '{0}' is given under G91, and '{1}' "
                  "makes a hole under G90.",
                  "Write Z and R again in that block, or G90 before the cycle."}},
    .bad = {{"fanuc", R"nc(
O0564(PLATE)
G90 G54 G0 X0 Y0
G43 Z50. H1
S2000 M3
G91 G81 Z-20. R-45. F150. K0
G90 X10. Y10.
X20.
G80
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O0564(PLATE)
G90 G54 G0 X0 Y0
G43 Z50. H1
S2000 M3
G90 G81 Z-15. R5. F150. K0
X10. Y10.
G91 X10. K4
G80
G90
M30
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const queries::StoredCycle& cycle : queries::stored_cycles(analysis)) {
        if (!cycle.position || !cycle.incremental_level) continue;
        Finding& finding =
            reporter.report({analysis, *cycle.position}, *cycle.position, "plain",
                            {quoted(program, *cycle.incremental_level), quoted(program, *cycle.position)});
        finding.related.push_back({analysis.source(), *cycle.incremental_level, "this level is a distance"});
        finding.related.push_back({analysis.source(), *cycle.absolute, "the distance mode changes here"});
    }
}

} // namespace
} // namespace maclint::rules
