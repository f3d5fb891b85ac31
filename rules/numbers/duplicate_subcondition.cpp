//! MAC719: the same test twice.
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/queries/conditions/repeated_tests.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule duplicate_subcondition{
    .code = "MAC719",
    .name = "duplicate-subcondition",
    .summary = "The same comparison stands twice in one condition, or in two IFs in a row that set the same "
               "variable",
    .why = "One of the two was meant to ask for another variable or another number: that case is missing.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Condition>(),
    .messages =
        {{"part", "Same test twice in one condition: '{0}'.",
          "Ask for the variable or the number that was meant, or remove one of the two."},
         {"case",
          "Same test twice: '{0}' on line {1} asks the same, and what it sets ({2}) is replaced here.",
          "Ask for the case that was meant."},
         {"copy", "Same block twice: '{0}' on line {1} asks the same and sets the same ({2}).",
          "Ask for the case that was meant, or remove one of the two."}},
    .bad = {{"fanuc", R"nc(
O9719(ROUND, D DIAMETER R RADIUS)
IF[[#7EQ#0]OR[#7EQ#0]]GOTO9
G0 X[#7+#18]
M99
N9 #3000=1(D OR R IS MISSING)
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 INPUT("Length",#l1)
N20 INPUT("Width",#l2)
N30 IF #l1>100 AND #l1>100
N40 THEN
N50 G95 F0.5
N60 ENDIF
N70 G0 X46 Z#l2
N80 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9719(ROUND, D DIAMETER R RADIUS)
IF[[#7EQ#0]OR[#18EQ#0]]GOTO9
G0 X[#7+#18]
M99
N9 #3000=1(D OR R IS MISSING)
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 INPUT("Length",#l1)
N20 INPUT("Width",#l2)
N30 IF #l1>100 AND #l2>100
N40 THEN
N50 G95 F0.5
N60 ENDIF
N70 G0 X46 Z#l2
N80 M30
END
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

/// Whether what the second IF does is written as what the first one sets.
bool sets_the_same(const Program& program, EffectId first, EffectId second) {
    const auto* guarded = std::get_if<Guarded>(&program.effects[second].what);
    return guarded != nullptr && guarded->effects.count == 1 &&
           without_blanks(program.slice(program.effects[guarded->effects.first].span)) ==
               without_blanks(program.slice(program.effects[first].span));
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const queries::RepeatedTest& test : queries::find_repeated_tests(analysis)) {
        const Span first = program.expressions[test.first].span;
        const Span second = program.expressions[test.second].span;
        std::vector<std::string> words{quoted(program, second)};
        if (test.lost) {
            words.push_back(line_number(analysis.file(), first.begin));
            words.push_back(quoted(program, program.effects[*test.lost].span));
        }
        const bool is_copy = test.lost && sets_the_same(program, *test.lost, test.effect);
        Finding& finding = reporter.report({analysis, test.effect, test.second}, second,
                                           is_copy     ? "copy"
                                           : test.lost ? "case"
                                                       : "part",
                                           std::move(words));
        if (is_copy) finding.severity = Severity::note;
        finding.related.push_back({analysis.source(), first, "the same test"});
    }
}

} // namespace
} // namespace maclint::rules
