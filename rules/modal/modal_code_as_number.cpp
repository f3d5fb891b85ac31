//! MAC574: a modal G code that was read from a system variable is multiplied, divided or given to a function.
#include "analyzer/dataflow/facts/modal_read.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/values/amounts.hpp"
#include "analyzer/queries/values/copies.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <optional>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule modal_code_as_number{
    .code = "MAC574",
    .name = "modal-code-as-number",
    .summary = "A G code read from a system variable is multiplied, divided or given to a function",
    .why =
        "The code of a modal group, 90 or 91 for instance, is a name and no amount. A position or size that "
        "is computed from it is as wrong as the mode happens to be; mostly another variable was meant.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::ModalRead, dataflow::Read, dataflow::Store>(),
    .data_flow = true,
    .messages = {{"copy", "G code used as a number: '{0}' calculates with '{1}', a copy of '{2}' ({3}).",
                  "Use the variable that is meant."},
                 {"direct", "G code used as a number: '{0}' calculates with '{1}' ({2}).",
                  "Use the variable that is meant."}},
    .bad = {{"fanuc", R"nc(
O9574(ELLIPSE POINT, A ANGLE D HEIGHT)
#3=#4003
#5=#7/2
G90 G0 X#5 Y[#3*SIN[#1]]
G#3
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9574(ELLIPSE POINT, A ANGLE D HEIGHT)
#3=#4003
#5=#7/2
G90 G0 Y[#5*SIN[#1]]
G#3
M99
)nc"},
             {"fanuc", R"nc(
O9574(FIRST VARIABLE OF THE WORK OFFSET)
#100=5201+[#4014-53]*20
M99
)nc"}},
    .sources = {"SEED-001:1340-1357"},
    .check = &check,
};

namespace {

/// What the code stands for; nothing when the source is no G code.
std::optional<std::string> code_name(const ProgramAnalysis& analysis, const queries::CopySource& source) {
    if (source.group) {
        const ModalGroup& group = analysis.control().groups[*source.group];
        return group.letter == 'G' ? std::optional(std::string(group.name)) : std::nullopt;
    }
    if (source.range != nullptr && source.range->is_code) return "unknown group";
    return std::nullopt;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const auto calculation_with = queries::calculations_with_amounts(program);
    const auto text = [&](ExpressionId id) { return quoted(program, program.expressions[id].span); };
    for (const dataflow::ModalRead& read : analysis.facts().all<dataflow::ModalRead>()) {
        const auto calculation = calculation_with[read.expression];
        if (!calculation) continue;
        const auto name = code_name(analysis, {read.expression, read.group, nullptr});
        if (!name) continue;
        Finding& finding =
            reporter.report({analysis, read.effect, *calculation}, program.expressions[*calculation].span,
                            "direct", {text(*calculation), text(read.expression), *name});
        trace(finding, analysis, read.node, "the G code is used as a number here");
    }
    for (const dataflow::Read& read : analysis.facts().all<dataflow::Read>()) {
        const auto calculation = calculation_with[read.expression];
        if (!calculation) continue;
        const auto source = queries::copy_source(analysis, read.expression, read.value);
        const auto name = source ? code_name(analysis, *source) : std::nullopt;
        if (!name) continue;
        Finding& finding = reporter.report(
            {analysis, read.effect, *calculation}, program.expressions[*calculation].span, "copy",
            {text(*calculation), program.spell(read.variable), text(source->expression), *name});
        trace(finding, analysis, queries::store_of(analysis, read.value)->node,
              {analysis.source(), program.expressions[source->expression].span, "the G code is read here"},
              read.node, "and used as a number here");
    }
}

} // namespace
} // namespace maclint::rules
