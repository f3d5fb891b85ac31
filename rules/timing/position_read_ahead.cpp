//! MAC605: a position is read while the control may still be making a move.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/machine/unfinished_moves.hpp"
#include "analyzer/queries/values/offsets.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <set>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule position_read_ahead{
    .code = "MAC605",
    .name = "lookahead-position-read",
    .summary =
        "The position of an axis is read behind a move with nothing between that stops look-ahead, and "
        "becomes an offset or is compared",
    .why =
        "A control reads blocks ahead and computes macro statements as soon as it has read them, while the "
        "axes still move: the position is one from somewhere on the way, another one each time, and so is "
        "the work offset that is made of it. An M code behind the move may stop look-ahead, where a "
        "parameter says "
        "so; name those that do under 'stops-look-ahead' of the control in .maclint.json.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Comparison, dataflow::Read, dataflow::Store>(),
    .data_flow = true,
    .messages =
        {{"offset",
          "Position read too early: '{0}' may be read before the move on line {1} has ended, and '{2}' "
          "makes an offset of it.",
          "Stop look-ahead after the move, as by G53 in a block of its own."},
         {"compared",
          "Position read too early: '{0}' may be read before the move on line {1} has ended, and '{2}' "
          "compares it.",
          "Stop look-ahead after the move, as by G53 in a block of its own."}},
    .bad = {{"fanuc", R"nc(
O9605(SET G54 X AT THE STOP)
G90 G1 X0 F200.
#31=#5021
#5221=#31-10.
M99
)nc"},
            {"fanuc", R"nc(
O9605(DOWN UNTIL Z IS LOW)
G90 G1 Z10. F200.
IF[#5043LT5.]GOTO9
M99
N9 #3000=1(TOO LOW)
)nc"}},
    .good = {{"fanuc", R"nc(
O9605(SET G54 X WHERE THE PROBE TOUCHED)
G91 G31 X-20. F200.
#5221=#5021-10.
G90 G1 X20.
#5222=#5021-#5041
#5223=#5003
G53
IF[#5041LT5.]GOTO9
M99
N9 #3000=1(TOO LOW)
)nc"}},
    .exemptions = {{&queries::exemptions::distance_along_an_axis,
                    "distance-along-an-axis",
                    "Two positions of one axis are taken from each other: both are read ahead, and what is "
                    "left is an offset.",
                    {"fanuc", R"nc(
O9605(SHIFT)
G91 G1 X10. F100.
IF[[#5021-#5041]GT1.]GOTO9
M99
N9 #3000=1(SHIFTED)
)nc"}}},
    .sources = {"MAN-AINANO", "SEED-001:1373", "HAAS-LA"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    if (queries::limits_look_ahead(program)) return; // wherever its block stands
    std::set<ExpressionId> said;                     // one read, one finding
    std::set<EffectId> conditions;                   // one condition, one finding
    const auto look_at = [&](EffectId effect, ExpressionId value, Span use, std::string_view message) {
        for (const queries::PositionRead& read : queries::positions_in(analysis, effect, value)) {
            const auto move = queries::unfinished_move_before(analysis, read.node, read.addresses);
            if (!move || !said.insert(read.expression).second) continue;
            if (message == "compared" && !conditions.insert(effect).second) continue;
            const Span span = program.expressions[read.expression].span;
            Finding& finding =
                reporter.report({analysis, span}, span, message,
                                {quoted(program, span), line_number(analysis.file(), move->span.begin),
                                 quoted(program, use)});
            trace(finding, analysis, move->node, {analysis.source(), move->span, "this move may still run"},
                  read.node, "when the position is read");
            if (use.begin > span.end || use.end < span.begin)
                finding.related.push_back({analysis.source(), use, "what is made of it"});
        }
    };
    for (EffectId id = 0; id < program.effects.size(); ++id)
        if (const auto* assign = std::get_if<Assign>(&program.effects[id].what);
            assign != nullptr && queries::makes_offset(analysis, *assign))
            look_at(id, assign->value, program.effects[id].span, "offset");
    for (const dataflow::Comparison& comparison : analysis.facts().all<dataflow::Comparison>()) {
        const Span use = program.expressions[comparison.expression].span;
        look_at(comparison.effect, comparison.expression, use, "compared");
    }
}

} // namespace
} // namespace maclint::rules
