//! MAC209: a local variable is read although nothing can have set it.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule uninitialised_local{
    .code = "MAC209",
    .name = "uninitialised-local",
    .aliases = "DIN301",
    .summary = "A local variable is read before anything has set it, and no argument can have done so.",
    .why = "Such a variable is vacant: a word that uses it is ignored (the axis stays where it is, the feed "
           "does "
           "not change), and arithmetic takes it for 0. The control raises no alarm.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = true,
    .messages =
        {{"main", "'{0}' is vacant here: this program has not set it, and a program that nobody calls gets "
                  "no arguments. Set it first, or correct the number."},
         {"called", "'{0}' is vacant here: this program has not set it, and no argument of a call reaches "
                    "it. Set it first, or correct the number."},
         {"not-passed", "'{0}' is vacant here: this program has not set it, and no caller passes it. Set it "
                        "first, or pass the argument."},
         {"some-ways", "'{0}' is vacant here when the way that sets it is not taken. Set it on every way, "
                       "or test it with EQ #0 first."}},
    .bad = {{"fanuc", "O0209(FACE)\n"
                      "#100=10.\n"
                      "G90 G54 G0 X0 Y0\n"
                      "G43 Z#100 H1\n"
                      "G1 Z#10 F200.\n"
                      "G0 Z#100\n"
                      "M30\n"}},
    .also = {},
    .good = {{"fanuc", "O0209(FACE)\n"
                       "#100=10.\n"
                       "#10=-2.\n"
                       "G90 G54 G0 X0 Y0\n"
                       "G43 Z#100 H1\n"
                       "G1 Z#10 F200.\n"
                       "G0 Z#100\n"
                       "M30\n"}},
    .alarms = {},
    .sources = {"SEED-001:187"},
    .check = &check,
};

namespace {

/// Why the value is vacant is that the variable is as it was when the program began.
bool is_vacant_since_entry(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    if (read.value.vacancy != dataflow::Vacancy::vacant && read.value.vacancy != dataflow::Vacancy::maybe)
        return false;
    const dataflow::Origin& doubt = analysis.data().origin(read.value.doubt);
    return doubt.kind == dataflow::Origin::Kind::entry &&
           static_cast<std::int32_t>(doubt.id) == read.place.number && doubt.node == read.place.space &&
           analysis.data().value_at_entry(read.place).vacancy == dataflow::Vacancy::vacant;
}

std::string_view message_for(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    if (read.value.vacancy == dataflow::Vacancy::maybe) return "some-ways";
    if (analysis.is_main()) return "main";
    const auto& formals = analysis.control().formals;
    return std::ranges::find(formals, read.place) == formals.end() ? "called" : "not-passed";
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    // Without arguments a called program may be one that shares its caller's locals.
    if (!analysis.is_main() && !analysis.is_macro()) return;
    const Program& program = analysis.program();
    std::vector<Place> known;
    for (const dataflow::Read& read : analysis.facts().reads) {
        if (read.use == dataflow::Use::vacancy_test || !is_vacant_since_entry(analysis, read)) continue;
        if (std::ranges::find(known, read.place) != known.end()) continue;
        known.push_back(read.place);
        const Span span = program.expressions[read.expression].span;
        const std::string name = program.spell(read.place);
        Finding& finding = reporter.report(analysis.file(), span, message_for(analysis, read), {name});
        trace(finding, analysis, read.value.doubt, name + " is vacant when the program begins", read.node,
              name + " is read");
    }
}

} // namespace
} // namespace maclint::rules
