//! MAC506: the variable that holds the saved state is overwritten before it is put back.
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/modal/saved_value_lost_saves_finder.hpp"
#include "rules/modal/saved_value_lost_variable_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <string>
#include <utility>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule saved_value_lost{
    .code = "MAC506",
    .name = "saved-value-lost",
    .summary = "The variable that holds a saved modal value is overwritten before the value is "
               "put back",
    .why = "The word that should restore the caller's mode gives the control some other number: "
           "another G code, or one that it does not know.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::ModalWrite, dataflow::Store>(),
    .data_flow = true,
    .messages = {{"overwritten", "Saved value overwritten: '{0}' loses the {1} that {2} keeps for '{3}'.",
                  "Use a variable that is free, such as {4}."},
                 {"none-free", "Saved value overwritten: '{0}' loses the {1} that {2} keeps for '{3}'.",
                  "Use another variable."}},
    .bad = {{"fanuc", R"nc(
O9506(UP, K STEP)
#33=#4003
G91 G0 Z#6
#33=#5003+#6
G#33
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9506(UP, K STEP)
#33=#4003
G91 G0 Z#6
#32=#5003+#6
#100=#32
G#33
M99
)nc"}},
    .exemptions =
        {{&exemptions::computed_from_the_saved,
          "computed-from-the-saved",
          "The new value is calculated from the saved one: a feed or speed that is made slower or faster.",
          {"fanuc", R"nc(
O9506(BORE, Z)
#33=#4109
#33=#33*0.5
G90 G1 Z#26 F#33
M99
)nc"}}},
    .sources = {"T"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const std::vector<OverwrittenSave> all_lost = overwritten_saves(analysis);
    const auto other = all_lost.empty() ? std::nullopt : find_free_local(analysis);
    for (const OverwrittenSave& lost : all_lost) {
        const Span span = program.effects[lost.store->effect].span;
        const Span word = program.effects[lost.write->effect].span;
        std::vector<std::string> words{quoted(program, span),
                                       std::string(analysis.control().groups[*lost.saved.group].name),
                                       program.spell(lost.store->variable), quoted(program, word)};
        if (other) words.push_back(program.spell(*other));
        Finding& finding = reporter.report({analysis, lost.store->effect}, span,
                                           other ? "overwritten" : "none-free", std::move(words));
        trace(finding, analysis, lost.saved_in,
              {analysis.source(), program.expressions[lost.saved.expression].span, "it is saved here"},
              lost.store->node, "and overwritten here");
        finding.related.push_back({analysis.source(), word, "this word should put the saved value back"});
    }
}

} // namespace
} // namespace maclint::rules
