//! MAC209: a local variable is read although nothing can have set it.
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/unset_reads.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"
#include "rules/variables/unset_words.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule uninitialised_local{
    .code = "MAC209",
    .name = "uninitialised-local",
    .aliases = "DIN301",
    .summary = "A local variable is read before anything has set it, and no argument can have done so",
    .why = "Such a variable is vacant: a word with it is ignored (the axis stays, the feed does not change), "
           "and arithmetic takes it for 0. Where the language knows no vacant value, it may read as 0.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::unset_locals},
    .facts = dataflow::facts<dataflow::Read, dataflow::Comparison, dataflow::Store, dataflow::Clobber>(),
    .data_flow = true,
    .messages =
        {{"main", "Nothing has set {0} before this block: a program that nobody calls gets no arguments.",
          "Set it first, or correct the number."},
         {"called",
          "Nothing has set {0} before this block, and no letter of a call stands for it, unless I, J "
          "and K are repeated.",
          "Set it first, or correct the number."},
         {"not-passed", "Nothing has set {0} before this block, and no caller passes it.",
          "Set it first, or pass the argument."},
         {"as-tested", "Variable {0} is always vacant here: the program only comes to this block when it is.",
          "Correct the test (EQ #0 or NE #0), or its jump."},
         {"by-callers",
          "Nothing has set {0} on a path to this block, nor do the programs that call this one.",
          "Set it on every path, or before the call."},
         {"unless-by-callers",
          "Nothing in this program sets {0}: vacant, unless a caller that shares its variables has set {0}.",
          "Set it here, or test for EQ #0 first."},
         {"cases", "{2} {0} may be vacant here: set only for {1}.",
          "Set a value in the other cases, too, or refuse them with an alarm."},
         {"depends", "{2} {0} may be vacant here, depending on {1}.",
          "Set a value on every path, or test for EQ #0 first."},
         {"some-paths", "{2} {0} may be vacant here: not every path sets a value.",
          "Set one on every path, or test for EQ #0 first."},
         {"undefined", "Nothing has set {0} before this block: it has no value.",
          "Set it first, or correct the name."},
         {"undefined-not-passed", "Variable {0} has no value here: no caller passes it.",
          "Pass it in the call."},
         {"undefined-some-paths", "{2} {0} may have no value here: not every path sets one.",
          "Set one on every path."}},
    .bad = {{"fanuc", R"nc(
O0209(FACE)
#100=10.
G90 G54 G0 X0 Y0
G43 Z#100 H1
G1 Z#10 F200.
G0 Z#100
M30
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 INPUT("Stock on the face",#l3)
N20 G0 X46 Z#l4
N30 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O0209(FACE)
#100=10.
#10=-2.
G90 G54 G0 X0 Y0
G43 Z#100 H1
G1 Z#10 F200.
G0 Z#100
M30
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 INPUT("Stock on the face",#l3)
N20 G0 X46 Z#l3
N30 M30
END
)nc"}},
    .sources = {"SEED-001:187", "ZAPP-ARG"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const queries::UnsetReads& reads : queries::find_unset_reads(analysis)) {
        const dataflow::Read& read = *reads.first.read;
        const Span span = analysis.program().expressions[read.expression].span;
        const std::string name = as_written(analysis, read.expression);
        Finding& finding =
            reporter.report({analysis, read}, span, message_of(analysis, reads),
                            {names_of(analysis, reads), words_for_cases(analysis, reads.missing),
                             reads.others.empty() ? "Variable" : "Variables"});
        if (reads.kind == queries::Unset::unless_by_callers)
            finding.severity = std::min(finding.severity, Severity::note);
        for (const dataflow::Read* other : reads.others)
            finding.related.push_back({analysis.source(),
                                       analysis.program().expressions[other->expression].span,
                                       "the same is true of " + as_written(analysis, other->expression)});
        if (const dataflow::OriginId origin = read.value.vacancy_origin; origin != 0)
            finding.path.push_back(begin_of_vacancy(analysis, origin, reads.first.path,
                                                    name + " has no value when the program begins"));
        for (RelatedLocation& step : steps_along(analysis, reads.first.path))
            finding.path.push_back(std::move(step));
        finding.path.push_back({analysis.source(), span, name + " is read"});
    }
}

} // namespace
} // namespace maclint::rules
