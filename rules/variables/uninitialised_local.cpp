//! MAC209: a local variable is read although nothing can have set it.
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/vacancy/unset_reads.hpp"
#include "analyzer/queries/vacancy/vacant_uses.hpp"
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
    .exemptions =
        {{&queries::exemptions::argument_of_a_series,
          "series-of-arguments",
          "The program reads whole sets of I, J and K, one after the other, and no caller is known: calls "
          "that repeat these letters pass them.",
          {"fanuc", R"nc(
O9209(THREE HOLES, I J K REPEATED)
G90 G0 X#4 Y#5 Z#6
X#7 Y#8 Z#9
X#10 Y#11 Z#12
M99
)nc"}},
         {&queries::exemptions::counting_from_vacant,
          "counts-from-vacant",
          "The variable counts: arithmetic takes vacant for 0, and to begin there is a custom.",
          {"fanuc", R"nc(
O0209(ROW OF FOUR)
N1 #33=#33+1
G91 G0 X10.
IF[#33LT4]GOTO1
M30
)nc"}},
         {&queries::exemptions::compared_as_a_test,
          "compared-as-a-test",
          "It is only compared, and some paths set it: a flag, and the comparison may be the very test for "
          "what else has happened.",
          {"fanuc", R"nc(
O0209(PROBE)
IF[#1001EQ1]THEN#33=1
IF[#33EQ1]GOTO9
G90 G0 Z50.
N9 M30
)nc"}},
         {&queries::exemptions::handed_on_without_a_value,
          "handed-on",
          "It is only handed on to another program, which gets a letter without a value: as good as none.",
          {"fanuc", R"nc(
O9209(BORE, Z)
G65 P9853 Z#26 E#14
M99
)nc"}},
         {&queries::exemptions::speed_for_some_cases,
          "speed-for-some-cases",
          "Conditions set it, and a block of its own takes it for the speed or the feed: in other cases that "
          "stays as it is.",
          {"fanuc", R"nc(
O9209(TAP, A Z)
IF[#1EQ1.]THEN#10=800
S#10
G90 G1 Z#26 F100.
M99
)nc"}},
         {&queries::exemptions::word_before_an_alarm,
          "word-before-an-alarm",
          "A word takes it where the program can only go on to an alarm: the control ignores the word, and "
          "stops.",
          {"fanuc", R"nc(
O9209(PROBE, A Z)
IF[#1EQ#0]GOTO9
#31=#5003
G90 G0 Z#26
G0 Z#31
M99
N9 G0 Z#31
#3000=91(INPUT)
)nc"}}},
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
