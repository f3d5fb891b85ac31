//! MAC209: a local variable is read although nothing can have set it.
#include "analyzer/dataflow/conditions.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/dataflow/feasible_paths.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

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
    .why =
        "Such a variable is vacant: a word that uses it is ignored (the axis stays where it is, the feed "
        "does "
        "not change), and arithmetic takes it for 0. The control raises no alarm. Where the language knows "
        "no vacant value, it is undefined and may read as 0.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .data_flow = true,
    .messages =
        {{"main", "'{0}' is vacant here: this program has not set it, and a program that nobody calls gets "
                  "no arguments. Set it first, or correct the number."},
         {"called", "'{0}' is vacant here: this program has not set it, and no letter of a call stands for "
                    "it, unless I, J and K are repeated. Set it first, or correct the number."},
         {"not-passed", "'{0}' is vacant here: this program has not set it, and no caller passes it. Set it "
                        "first, or pass the argument."},
         {"some-paths", "'{0}' is vacant here when the path that sets it is not taken. Set it on every path, "
                        "or test it with EQ #0 first."},
         {"undefined", "'{0}' has no value here: this program has not set it. Set it first, or correct the "
                       "name."},
         {"undefined-not-passed", "'{0}' has no value here: no caller passes it. Pass it in the call."},
         {"undefined-some-paths",
          "'{0}' has no value here when the path that sets it is not taken. Set it on "
          "every path."}},
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

/// Why the value may be vacant is that the variable is as it was when the program began.
bool is_as_at_entry(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    if (read.value.vacancy != dataflow::Vacancy::vacant && read.value.vacancy != dataflow::Vacancy::maybe)
        return false;
    const dataflow::Origin& vacancy_origin = analysis.data().origin(read.value.vacancy_origin);
    return vacancy_origin.kind == dataflow::Origin::Kind::entry &&
           static_cast<std::int32_t>(vacancy_origin.id) == read.variable.number &&
           vacancy_origin.node == read.variable.space;
}

bool is_vacant_since_entry(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    return is_as_at_entry(analysis, read) && analysis.data().is_vacant_at_entry(read.variable);
}

/// The variables of a program with unknown callers that can be arguments by series of I, J and K. Nobody
/// tells them from others but by the program reading all of a set, and all sets before.
std::vector<Variable> series_taken(const ProgramAnalysis& analysis) {
    std::vector<Variable> taken;
    if (analysis.is_main() || !analysis.callers().empty()) return taken;
    std::vector<Variable> read_as_given;
    for (const dataflow::Read& read : analysis.facts().all<dataflow::Read>())
        if (is_as_at_entry(analysis, read) &&
            std::ranges::find(read_as_given, read.variable) == read_as_given.end())
            read_as_given.push_back(read.variable);
    for (const auto& set : analysis.control().series) {
        const bool whole = std::ranges::all_of(set, [&](Variable variable) {
            return std::ranges::find(read_as_given, variable) != read_as_given.end();
        });
        if (!whole) break;
        taken.insert(taken.end(), set.begin(), set.end());
    }
    return taken;
}

/// How the program can get here without setting the variable; nothing when it cannot. A comparison may be the
/// very test that takes care of vacancy.
std::optional<std::vector<flow::EdgeId>> path_to(const ProgramAnalysis& analysis,
                                                 const dataflow::Read& read) {
    const bool may_be_a_test = dataflow::may_hold_vacant(analysis.program(), read.variable);
    if (may_be_a_test && read.value.vacancy == dataflow::Vacancy::maybe &&
        read.use == dataflow::Use::comparison)
        return std::nullopt;
    return dataflow::path_without_assignment(analysis.program(), analysis.graph(), analysis.data(),
                                             read.variable, read.node);
}

/// #33=#33+1: arithmetic takes vacant for 0, and counting from there is a custom.
bool counts(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    if (!dataflow::may_hold_vacant(analysis.program(), read.variable)) return false;
    return std::ranges::any_of(
        analysis.facts().at<dataflow::Store>(read.effect),
        [&](const dataflow::Store& store) { return store.variable == read.variable && store.step; });
}

std::string_view message_for(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    const bool vacant = dataflow::may_hold_vacant(analysis.program(), read.variable);
    if (read.value.vacancy == dataflow::Vacancy::maybe) return vacant ? "some-paths" : "undefined-some-paths";
    const auto& formals = analysis.control().formals;
    const bool formal = std::ranges::find(formals, read.variable) != formals.end();
    if (!vacant) return formal ? "undefined-not-passed" : "undefined";
    if (analysis.is_main()) return "main";
    return formal ? "not-passed" : "called";
}

/// An alias, not the variable after it; without the brackets around it.
std::string as_written(const Program& program, Span span) {
    std::string name = quoted(program, span);
    while (name.size() > 2 && (name.front() == '[' || name.front() == '('))
        name = name.substr(1, name.size() - 2);
    return name;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    // Without arguments a called program may be one that shares its caller's locals.
    if (!analysis.is_main() && !analysis.is_macro()) return;
    constexpr int most_attempts = 64; // reads of one variable to which a path is looked for
    const Program& program = analysis.program();
    const std::vector<Variable> series = series_taken(analysis);
    std::vector<std::pair<Variable, int>> attempts;
    for (const dataflow::Read& read : analysis.facts().all<dataflow::Read>()) {
        if (read.use == dataflow::Use::vacancy_test || !is_vacant_since_entry(analysis, read)) continue;
        // It is unknown whether a control still looks at what decides nothing any more, as after NDEF(…) OR.
        if (dataflow::asks_for_vacancy(program, analysis.facts(), read.node, read.node, read.variable))
            continue;
        if (std::ranges::find(series, read.variable) != series.end()) continue;
        auto tried = std::ranges::find(attempts, read.variable, &std::pair<Variable, int>::first);
        if (tried == attempts.end()) tried = attempts.insert(tried, {read.variable, 0});
        if (tried->second >= most_attempts || counts(analysis, read)) continue;
        ++tried->second;
        const auto path = path_to(analysis, read);
        if (!path && read.value.vacancy != dataflow::Vacancy::vacant) continue;
        tried->second = most_attempts; // once a variable
        const Span span = program.expressions[read.expression].span;
        const std::string name = as_written(program, span);
        Finding& finding = reporter.report({analysis, read}, span, message_for(analysis, read), {name});
        finding.path.push_back(
            related_at(analysis, read.value.vacancy_origin, name + " has no value when the program begins"));
        for (RelatedLocation& step :
             path ? steps_along(analysis, *path) : path_between(analysis, 0, read.node))
            finding.path.push_back(std::move(step));
        finding.path.push_back({analysis.source(), span, name + " is read"});
    }
}

} // namespace
} // namespace maclint::rules
