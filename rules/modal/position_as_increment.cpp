//! MAC536: a position that was read stands in a move that counts from where the tool is.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"
#include "rules/modal/position_as_increment_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule position_as_increment{
    .code = "MAC536",
    .name = "position-as-increment",
    .summary = "A position that was read is taken for a distance, because G91 is in force",
    .why = "The axis moves by as much as its position is far from zero, and not to that position.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::BeforeNode, dataflow::Read, dataflow::Store>(),
    .data_flow = true,
    .messages = {{"plain",
                  "Position as a distance: '{0}' moves by the position that '{1}' reads, because {2} of line "
                  "{3} is still in force.",
                  "Write {4} before it, or take the difference from where the tool is."}},
    .bad = {{"fanuc", R"nc(
O9536(ROWS, X LENGTH Y STEP F)
#33=#5041
#32=0
WHILE[#32LT5]DO1
G90 G1 X[#33+#24] F#9
X#33
G91 Y#25
X#33
#32=#32+1
END1
G90
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9536(ROWS, X LENGTH Y STEP F)
#33=#5041
#32=0
WHILE[#32LT5]DO1
G90 G1 X[#33+#24] F#9
X#33
G91 Y#25
X[#33-#5041]
#32=#32+1
END1
G90
M99
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const PositionAsIncrement& found : find_positions_as_increments(analysis)) {
        const ControlModel& control = analysis.control();
        const Span begun = queries::span_of(analysis, found.mode);
        Finding& finding = reporter.report(
            {analysis, found.word}, found.word, "plain",
            {quoted(program, found.word), quoted(program, program.expressions[found.position].span),
             control.spell(found.group, *found.mode.code), line_number(analysis.file(), begun.begin),
             control.spell(found.group, control.machine_words->absolute)});
        trace(finding, analysis, found.mode.node, {analysis.source(), begun, "it begins here"}, found.node,
              "the axis moves by the position");
    }
}

} // namespace
} // namespace maclint::rules
