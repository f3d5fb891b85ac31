//! MAC505: a word puts back a value that was saved from another kind of word.
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/values/copies.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/modal/misplaced_save.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule restore_from_wrong_variable{
    .code = "MAC505",
    .name = "restore-from-wrong-variable",
    .summary = "A word is given a copy of a system variable of another meaning: F from #4019, G "
               "from #4109, or a G word puts back a group that is not the one that was changed",
    .why = "The caller's feed, speed or mode is replaced by an unrelated number: F19. instead of "
           "F800., or a G code that the control does not know.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .facts = dataflow::facts<dataflow::ModalWrite, dataflow::Store, dataflow::ExitState, dataflow::CallMade,
                             dataflow::Clobber>(),
    .data_flow = true,
    .messages =
        {{"value", "Wrong value put back: '{0}' takes '{1}', which is not the {2}.",
          "Write {3} on line {4}."},
         {"code", "Wrong value put back: '{0}' takes '{1}', which is no G code.",
          "In line {2}, save the variable of the group that is meant."},
         {"twice", "Saved twice: '{0}' and '{1}' both save the {2}, and both are put back.",
          "Save the variable of another group in one of them."},
         {"beside",
          "Wrong value put back: '{0}' puts back the {2} beside '{1}' of its block, a code of the same "
          "group.",
          "In line {3}, save the variable of the group that is meant."},
         {"unchanged",
          "Wrong value put back: '{0}' puts back the {2}, which nothing here changes; '{1}' changes "
          "another group, which is not put back.",
          "In line {3}, save the variable of the group that is meant."}},
    .bad = {{"fanuc", R"nc(
O9505(PLUNGE, Z DEPTH F FEED)
#33=#4019
G1 Z#26 F#9
F#33
M99
)nc"},
            {"fanuc", R"nc(
O9505(DOWN, Z F)
#33=#4003
G1 Z#26
G#33
M99
)nc"},
            {"fanuc", R"nc(
O9505(UP, Z)
#32=#4003
#33=#4003
G91 G0 Z#26
G#32 G#33
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9505(PLUNGE, Z DEPTH F FEED)
#33=#4109
G1 Z#26 F#9
F#33
M99
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "115", "ILLEGAL VARIABLE NUMBER", false}},
    .sources = {"SEED-001:633,770,1360"},
    .check = &check,
};

namespace {

/// Modal values that have no group of their own, D and H for instance: nothing else can be written or changes
/// neither.
bool is_other_modal(const VariableRange& range) {
    return range.meaning == Meaning::machine && range.on_write == OnWrite::forbidden &&
           !range.changes_by_itself;
}

bool is_wrong(const ProgramAnalysis& analysis, const dataflow::ModalWrite& write,
              const queries::CopySource& source) {
    // A G word may well put back a code whose group is not known.
    if (source.range != nullptr)
        return is_other_modal(*source.range) && (write.stated || !source.range->is_code);
    if (!source.group) return false;
    if (write.stated) return write.group != source.group;
    return analysis.control().groups[*source.group].letter != 'G';
}

/// The assignment that saves what the word means: "#3=#4109".
std::string right_save(const ProgramAnalysis& analysis, GroupId group, const dataflow::Store* store) {
    const std::string variable = analysis.control().variable_of(group).value_or("the right variable");
    return store == nullptr ? variable : analysis.program().spell(store->variable) + "=" + variable;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    report_misplaced_saves(analysis, reporter);
    const Program& program = analysis.program();
    for (const dataflow::ModalWrite& write : analysis.facts().all<dataflow::ModalWrite>()) {
        const auto variable = queries::plain_variable(program, write.expression);
        const dataflow::Store* store =
            variable ? queries::only_store_of(analysis, *variable, write.value) : nullptr;
        const auto source = store == nullptr
                                ? queries::copy_source(analysis, write.expression, write.value)
                                : queries::copy_source(analysis, store->expression, store->value);
        if (!source || !is_wrong(analysis, write, *source)) continue;
        const Span span = program.effects[write.effect].span;
        const std::string text = quoted(program, span);
        const Span read = program.expressions[source->expression].span;
        const std::string line = line_number(analysis.file(), read.begin);
        Finding& finding = write.stated
                               ? reporter.report({analysis, write.effect}, span, "value",
                                                 {text, quoted(program, read),
                                                  std::string(analysis.control().groups[*write.group].name),
                                                  right_save(analysis, *write.group, store), line})
                               : reporter.report({analysis, write.effect}, span, "code",
                                                 {text, quoted(program, read), line});
        trace(finding, analysis, store != nullptr ? store->node : write.node,
              {analysis.source(), read, "the value comes from here"}, write.node, "and is put back here");
    }
}

} // namespace
} // namespace maclint::rules
