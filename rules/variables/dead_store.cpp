//! MAC213: a value is stored that nothing reads.
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/values/copies.hpp"
#include "analyzer/queries/values/dead_stores.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"
#include "rules/variables/dead_store_copies_finder.hpp"
#include "rules/variables/mistaken_stores.hpp"

#include <algorithm>
#include <ranges>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);

constexpr Exemption number_to_edit, last_step, same_value_again, spare_copy;
} // namespace

extern const Rule dead_store{
    .code = "MAC213",
    .name = "dead-store",
    .summary = "A value is calculated and stored, and replaced on every path before anything reads it",
    .why =
        "One of the two assignments was meant for another variable, or stands in the wrong place: what the "
        "program has calculated is lost. A note, on request, where nothing follows that could read the "
        "value. Numbers that somebody may edit, vacant, counters, saved codes and copies that wait for "
        "their use are left alone, and so are variables that others may look at in between.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Store, dataflow::Read>(),
    .data_flow = true,
    .messages = {{"replaced", "Value lost: '{0}' is replaced on line {2} before anything reads {1}.",
                  "Set the variable that was meant, or remove one of the two."},
                 {"replaced-after",
                  "Value lost: '{0}' is replaced on every path, first on line {2}, before "
                  "anything reads {1}.",
                  "Set the variable that was meant, or remove one of the two."},
                 {"unread", "Value never used: nothing reads {1} after '{0}'.",
                  "Use it, or remove the assignment.", true},
                 {"other-number",
                  "Another variable: nothing reads {1} of '{0}', and nothing sets {2} of line {3}.",
                  "Correct the one that is wrong."},
                 {"itself", "Nothing stored: '{0}' sets {1} to what it is.",
                  "Take the variable that was meant, add what is to be counted, or remove it."},
                 {"never", "Variable never used: '{0}' sets {1}, and no block reads it.",
                  "Use it, or remove the assignment.", true}},
    .bad = {{"fanuc", R"nc(
O9213(SLOT, X LENGTH D TOOL R STOCK)
#33=#24-#7
#33=#24-2*#18
G0 X#33
M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 INPUT("Length",#l1)
N20 #l2=#l1-3
N30 #l2=#l1/2
N40 G0 X46 Z#l2
N50 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9213(SLOT, X LENGTH D TOOL R STOCK)
#33=#24-#7
#32=#24-2*#18
G0 X#33
G0 X-#32
M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 INPUT("Length",#l1)
N20 #l2=#l1-3
N30 #l3=#l1/2
N40 G0 X#l3 Z#l2
N50 M30
END
)nc"}},
    .exemptions = {{&number_to_edit,
                    "number-to-edit",
                    "Nothing but a number of the text is stored: somebody edits it, or exchanges the lines.",
                    {"fanuc", R"nc(
O0213(PLATE)
#5=0.3(ROUGH)
#5=0.1(FINISH)
G90 G0 Z#5
M30
)nc"}},
                   {&last_step,
                    "last-step",
                    "It is one more step of what the program has counted or added up: such rows end alike.",
                    {"fanuc", R"nc(
O9213(TWO HOLES, D STEP)
#1=0
#1=#1+#7
G90 G0 X#1
#1=#1+#7
M99
)nc"}},
                   {&same_value_again,
                    "same-value-again",
                    "What replaces it is the same value: nothing is lost.",
                    {"fanuc", R"nc(
O9213(BORE, X)
#5=#24*2
G90 G0 Z50.
#5=#24*2
X#5
M99
)nc"}},
                   {&spare_copy,
                    "spare-copy",
                    "It copies what stands elsewhere still: kept at hand for later, or to be seen.",
                    {"fanuc", R"nc(
O9213(BORE, X Z)
#32=#24
G90 G0 X#24 Z#26
M99
)nc"}}},
    .sources = {"T"},
    .check = &check,
};

namespace {

constexpr std::size_t most_named = 8; ///< assignments that replace the value

/// The same value comes again: nothing is lost.
bool is_only_repeated(const queries::DeadStore& dead) {
    return std::ranges::any_of(dead.replaced_by, [&](const dataflow::Store* next) {
        return queries::is_same_value(next->value, dead.store->value);
    });
}

std::string_view message_for(const queries::DeadStore& dead) {
    if (!dead.read_elsewhere) return "never";
    if (dead.may_end) return "unread";
    return dead.replaced_by.size() == 1 ? "replaced" : "replaced-after";
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    report_mistaken_stores(analysis, reporter);
    const Program& program = analysis.program();
    for (const queries::DeadStore& dead : queries::find_dead_stores(analysis)) {
        const bool special_case = dead.only_if && dead.read_elsewhere; // MAC214's
        if (special_case || (number_to_edit.is_on() && dead.is_setting) ||
            (last_step.is_on() && dead.store->step) || (same_value_again.is_on() && is_only_repeated(dead)) ||
            (spare_copy.is_on() && is_spare_copy(analysis, dead)))
            continue;
        const std::string_view message = message_for(dead);
        const Span span = program.effects[dead.store->effect].span;
        const std::string name = with_letter(analysis, dead.store->variable);
        std::vector<std::string> words{quoted(program, span), name};
        if (!dead.replaced_by.empty())
            words.push_back(
                line_number(analysis.file(), program.effects[dead.replaced_by.front()->effect].span.begin));
        Finding& finding = reporter.report({analysis, dead.store->effect}, span, message, std::move(words));
        if (dead.may_end || !dead.read_elsewhere) finding.severity = Severity::note;
        if (message == "never") finding.same_cause = program.name + " " + program.spell(dead.store->variable);
        for (const dataflow::Store* next : dead.replaced_by | std::views::take(most_named))
            finding.related.push_back(related_at_effect(analysis, next->effect, "replaces the value"));
        trace(finding, analysis, dead.store->node, "the value is stored");
    }
}

} // namespace
} // namespace maclint::rules
