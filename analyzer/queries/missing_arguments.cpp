//! Compares what a program reads with what its callers pass.
#include "analyzer/queries/missing_arguments.hpp"

#include "analyzer/execution/path_search.hpp"
#include "analyzer/queries/callers.hpp"
#include "analyzer/queries/feasible_paths.hpp"
#include "analyzer/queries/provoking_calls.hpp"

#include <algorithm>
#include <optional>

namespace maclint::queries {
namespace {

bool opens_locals(const ProgramAnalysis& analysis, const Caller& caller) {
    const Call& call = call_of(calling_program(analysis, caller).program(), caller.effect);
    return calling_program(analysis, caller).control().calls[call.kind].frame == Frame::fresh;
}

bool passes(const ProgramAnalysis& analysis, const Caller& caller, Variable formal) {
    const Program& program = calling_program(analysis, caller).program();
    const decltype(Argument::given) given = formal;
    const auto arguments = program.arguments_of(call_of(program, caller.effect));
    return std::ranges::find(arguments, given, &Argument::given) != arguments.end();
}

/// Whether a call whose program only the running program knows may mean it.
bool may_be_computed(const ProgramAnalysis& analysis) {
    return analysis.has_possible_callers() ||
           std::ranges::any_of(analysis.workspace().files(), [&](const WorkspaceFile& file) {
               return file.file.get() == &analysis.file() && file.may_be_computed;
           });
}

/// The value of the variable at the program's start.
bool is_as_passed(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    const dataflow::Symbol& symbol = analysis.data().table().symbols[read.value.symbol];
    return symbol.kind == dataflow::Symbol::Kind::entry && symbol.a == dataflow::key_of(read.variable);
}

bool is_asked_for(const ProgramAnalysis& analysis, const dataflow::Read& wanted) {
    return std::ranges::any_of(analysis.facts().all<dataflow::Read>(), [&](const dataflow::Read& read) {
        const bool asks = read.use == dataflow::Use::vacancy_test || read.use == dataflow::Use::comparison;
        return asks && (read.value.symbol == wanted.value.symbol || read.variable == wanted.variable);
    });
}

} // namespace

std::vector<MissingArgument> find_missing_arguments(const ProgramAnalysis& analysis) {
    std::vector<MissingArgument> found;
    const auto& callers = analysis.callers();
    const auto& formals = analysis.control().formals;
    if (callers.empty() || may_be_computed(analysis) ||
        !std::ranges::all_of(callers, [&](const Caller& caller) { return opens_locals(analysis, caller); }))
        return found;
    std::optional<execution::PathSearch> search; // most programs have no such read
    for (const dataflow::Read& read : analysis.facts().all<dataflow::Read>()) {
        const bool known = std::ranges::any_of(
            found, [&](const MissingArgument& other) { return other.read->variable == read.variable; });
        if (known || read.use != dataflow::Use::arithmetic || !is_as_passed(analysis, read) ||
            std::ranges::find(formals, read.variable) == formals.end() || is_asked_for(analysis, read))
            continue;
        if (std::ranges::any_of(
                callers, [&](const Caller& caller) { return passes(analysis, caller, read.variable); }))
            continue;
        if (!search) search.emplace(analysis);
        const auto way = path_without_assignment(*search, analysis, read.variable, read.node);
        const Caller* call = way.path ? call_that_leaves_out(analysis, read.variable, *way.path) : nullptr;
        if (call != nullptr) found.push_back({&read, call});
    }
    return found;
}

} // namespace maclint::queries
