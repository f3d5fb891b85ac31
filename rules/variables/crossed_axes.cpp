//! MAC215: of statements alike for two axes, or two work offsets, one takes the variable of the other.
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/variables/crossed_axes_cases_finder.hpp"
#include "rules/variables/crossed_axes_finder.hpp"
#include "rules/variables/crossed_axes_positions_finder.hpp"
#include "rules/variables/mistaken_axes.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule crossed_axes{
    .code = "MAC215",
    .name = "copy-paste-asymmetry",
    .summary = "Of statements alike for two axes or work offsets, one takes the variable of the other",
    .why = "A block was copied for the next axis, or the next work offset, and one variable in it left as it "
           "was: the axis goes to a place that the other one decides.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Read, dataflow::Store>(),
    .messages =
        {{"crossed", "Axes crossed: '{0}' is made of {1}, where '{2}' beside it is made of its own {3}.",
          "Take {4}, or say in a comment why not."},
         {"position",
          "Position of another axis: '{0}' sets an offset of the axis of {1}, and {2} is a place of "
          "another axis.",
          "Take {3}, or what was stored of it."},
         {"from-sibling",
          "Variable of another statement: '{0}' goes on from {1}, where '{2}' goes on from its own.",
          "Take {3}."},
         {"moves-another",
          "Position of another axis: '{0}' keeps a place of {1}, and {2} on line {3} moves there; {4} "
          "keeps the same for {1}.",
          "Take {5}."},
         {"case", "Another work offset: {0} belongs to {1}, and '{2}' stands in the case for {3}.",
          "Take {4}, as the other cases take their own."},
         {"store-of-case",
          "Variable of another case: '{0}' sets {1}, as line {2} does in its case; the statements beside it "
          "set "
          "those of their own.",
          "Take {3}."}},
    .bad = {{"fanuc", R"nc(
O9215(POINT FROM WHERE THE TOOL IS)
#24=#5001+#24
#25=#5002+#24
G0 X#24 Y#25
M99
)nc"},
            {"fanuc", R"nc(
O9216(PLACE OF THE TABLE, B ANGLE)
IF[#4014EQ54]THEN #131=#5221*COS[#2]
IF[#4014EQ54]THEN #133=#5263*SIN[#2]
IF[#4014EQ56]THEN #131=#5261*COS[#2]
IF[#4014EQ56]THEN #133=#5263*SIN[#2]
G0 X#131 Z#133
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9215(POINT FROM WHERE THE TOOL IS)
#24=#5001+#24
#25=#5002+#25
#21=#5001+#24
#22=#5002+#24
G0 X[#24+#21] Y[#25+#22]
M99
)nc"}},
    .sources = {"SEED-001:706"},
    .check = &check,
};

namespace {

void report_cases(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const OffsetOfAnotherCase& other : find_offsets_of_other_cases(analysis)) {
        const Span span = program.expressions[other.operand].span;
        Finding& finding = reporter.report({analysis, other.effect}, span, "case",
                                           {quoted(program, span), "G" + number_word(other.taken),
                                            quoted(program, program.effects[other.effect].span),
                                            "G" + number_word(other.asked), program.spell(other.meant)});
        finding.related.push_back(related_at_effect(analysis, other.own, "this case takes its own"));
    }
}

/// But for statements of which something is said already.
void report_positions(const ProgramAnalysis& analysis, const std::vector<EffectId>& told,
                      Reporter& reporter) {
    const Program& program = analysis.program();
    for (const PositionOfAnotherAxis& other : find_positions_of_other_axes(analysis)) {
        if (std::ranges::find(told, other.effect) != told.end()) continue;
        const Span span = program.effects[other.effect].span;
        const Span position = program.expressions[other.position].span;
        Finding& finding = reporter.report({analysis, other.effect}, span, "position",
                                           {quoted(program, span), program.spell(other.base),
                                            quoted(program, position), program.spell(other.meant)});
        if (!span.contains(position.begin))
            finding.related.push_back({analysis.source(), position, "it is read here"});
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    report_cases(analysis, reporter);
    const Program& program = analysis.program();
    std::vector<EffectId> told;
    for (const CrossedStatements& crossed : find_crossed_statements(program)) {
        const Span span = program.expressions[crossed.operand].span;
        const std::string meant = program.spell(crossed.meant);
        Finding& finding =
            reporter.report({analysis, crossed.effect}, span, "crossed",
                            {quoted(program, program.effects[crossed.effect].span), quoted(program, span),
                             quoted(program, program.effects[crossed.sibling].span),
                             program.spell(crossed.siblings_own), meant});
        finding.related.push_back(related_at_effect(analysis, crossed.sibling, "the statement beside it"));
        finding.offer({"Take " + meant, Applicability::unsafe, {{analysis.source(), span, meant}}});
        told.push_back(crossed.effect);
    }
    report_positions(analysis, told, reporter);
    report_mistaken_axes(analysis, reporter);
}

} // namespace
} // namespace maclint::rules
