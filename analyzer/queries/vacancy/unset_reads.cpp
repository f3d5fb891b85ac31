//! Looks for a path to each read of a variable that is as it was at the program's start.
#include "analyzer/queries/vacancy/unset_reads.hpp"

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/queries/vacancy/vacant_uses.hpp"
#include "analyzer/queries/values/copies.hpp"
#include "analyzer/queries/values/origins.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace maclint::queries {
namespace {

constexpr int most_attempts = 64; // reads of one variable to which a path is looked for

/// The searches for reads of one variable.
struct Attempts {
    int searches = 0;
    bool some_failed = false;
};

/// Why the value may be vacant is that the variable is as it was when the program began.
bool is_as_at_entry(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    if (read.value.vacancy != dataflow::Vacancy::vacant && read.value.vacancy != dataflow::Vacancy::maybe)
        return false;
    return variable_of_origin(analysis, read.value.vacancy_origin) == read.variable;
}

using Variables = std::unordered_set<Variable, VariableHash>;

/// The variables of a program with unknown callers that can be arguments by series of I, J and K. Nobody
/// tells them from others but by the program reading all of a set, and all sets before.
Variables series_taken(const ProgramAnalysis& analysis) {
    Variables taken;
    const auto& series = analysis.control().series;
    if (!exemptions::argument_of_a_series.is_on() || series.empty() || analysis.is_main() ||
        !analysis.callers().empty())
        return taken;
    Variables read_as_given;
    for (const dataflow::Read& read : analysis.facts().all<dataflow::Read>())
        if (Budget::allows() && is_as_at_entry(analysis, read)) read_as_given.insert(read.variable);
    for (const auto& set : series) {
        const bool whole =
            std::ranges::all_of(set, [&](Variable variable) { return read_as_given.contains(variable); });
        if (!whole) break;
        taken.insert(set.begin(), set.end());
    }
    return taken;
}

/// The variables that the program stores in somewhere, be it where no path leads.
class SetSomewhere {
  public:
    explicit SetSomewhere(const Program& program)
        : program_(program) {}
    [[nodiscard]] bool has(Variable variable) { return collected().contains(variable); }
    /// Each of its assignments only adds to what it holds: none is a first value.
    [[nodiscard]] bool is_only_counted(Variable variable) {
        const auto found = collected().find(variable);
        return found != collected().end() && found->second;
    }

  private:
    using Counted = std::unordered_map<Variable, bool, VariableHash>;

    [[nodiscard]] const Counted& collected() {
        if (variables_) return *variables_;
        variables_.emplace();
        for (const Effect& effect : program_.effects) {
            const auto* assign = std::get_if<Assign>(&effect.what);
            const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
            if (target == nullptr) continue;
            const auto [found, fresh] = variables_->try_emplace(*target, true);
            found->second = found->second && adds_to(*target, assign->value);
        }
        return *variables_;
    }

    [[nodiscard]] bool adds_to(Variable variable, ExpressionId value) const {
        const auto* apply = std::get_if<Apply>(&program_.expressions[value].node);
        if (apply == nullptr ||
            (apply->operation != Operation::add && apply->operation != Operation::subtract))
            return false;
        return std::ranges::any_of(program_.operands_of(*apply), [&](ExpressionId operand) {
            const auto* load = std::get_if<Load>(&program_.expressions[operand].node);
            return load != nullptr && load->variable == variable;
        });
    }

    const Program& program_;
    std::optional<Counted> variables_; ///< nothing: nobody has asked
};

/// A comparison may be the very test that takes care of vacancy: of a flag that only some paths set. Of a
/// counter without a first value it is none: the loop is never run.
bool may_be_a_test(const ProgramAnalysis& analysis, const dataflow::Read& read, SetSomewhere& set) {
    return exemptions::compared_as_a_test.is_on() && read.use == dataflow::Use::comparison &&
           may_hold_vacant(analysis.program(), read.variable) &&
           (read.value.vacancy == dataflow::Vacancy::maybe ||
            (set.has(read.variable) && !set.is_only_counted(read.variable)));
}

/// #33=#33+1: arithmetic takes vacant for 0, and counting from there is a custom.
bool counts(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    if (!exemptions::counting_from_vacant.is_on() || !may_hold_vacant(analysis.program(), read.variable))
        return false;
    return std::ranges::any_of(
        analysis.facts().at<dataflow::Store>(read.effect),
        [&](const dataflow::Store& store) { return store.variable == read.variable && store.step; });
}

/// The program has found that the variable is vacant, and only then comes here: no block has made it so.
bool is_as_tested(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    if (read.value.vacancy != dataflow::Vacancy::vacant) return false;
    if (is_as_at_entry(analysis, read)) return !analysis.data().is_vacant_at_entry(read.variable);
    const dataflow::Store* store = store_of(analysis, read.value);
    return read.value.vacancy_origin == 0 &&
           (store == nullptr || store->value.vacancy != dataflow::Vacancy::vacant);
}

/// Without arguments a called program may be one that shares its caller's locals.
bool has_own_locals(const ProgramAnalysis& analysis) { return analysis.is_main() || analysis.is_macro(); }

bool is_as_nothing_set_it(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    return has_own_locals(analysis) && is_as_at_entry(analysis, read) &&
           analysis.data().is_vacant_at_entry(read.variable);
}

/// The program shares the local variables of its callers, of which none that is known sets it.
bool is_as_callers_left_it(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    return is_as_at_entry(analysis, read) && analysis.data().is_set_by_no_caller(read.variable);
}

/// No block of the program sets the variable, no letter of a call stands for it, and no caller is known: one
/// that shares its variables may have set it.
bool is_left_to_unknown_callers(const ProgramAnalysis& analysis, const dataflow::Read& read,
                                SetSomewhere& set) {
    const auto& kinds = analysis.control().calls;
    return !has_own_locals(analysis) && !knows_callers(analysis) &&
           std::ranges::find(kinds, Frame::shared, &CallKind::frame) != kinds.end() &&
           is_as_at_entry(analysis, read) && analysis.data().is_vacant_at_entry(read.variable) &&
           !set.has(read.variable);
}

/// Whether the read uses what is not there: a test takes care of it. It is unknown whether a control still
/// looks at what decides nothing any more, as after NDEF(…) OR.
bool uses_unset(const ProgramAnalysis& analysis, const dataflow::Read& read, SetSomewhere& set) {
    return read.use != dataflow::Use::vacancy_test &&
           (is_as_nothing_set_it(analysis, read) || is_as_callers_left_it(analysis, read) ||
            is_left_to_unknown_callers(analysis, read, set) || is_as_tested(analysis, read)) &&
           !asks_for_vacancy(analysis.program(), analysis.facts(), read.node, read.node, read.variable) &&
           !may_be_a_test(analysis, read, set) && is_used(analysis, read);
}

Unset kind_of(const ProgramAnalysis& analysis, const dataflow::Read& read, SetSomewhere& set) {
    if (is_as_callers_left_it(analysis, read)) return Unset::by_callers;
    if (is_left_to_unknown_callers(analysis, read, set)) return Unset::unless_by_callers;
    if (read.value.vacancy != dataflow::Vacancy::vacant) return Unset::in_some_cases;
    if (is_as_tested(analysis, read)) return Unset::as_tested;
    const auto& formals = analysis.control().formals;
    const bool formal = std::ranges::find(formals, read.variable) != formals.end();
    return formal && !analysis.is_main() ? Unset::as_argument : Unset::always;
}

/// A path to the read; on none of its nodes is the variable set where it is as it was at the start.
execution::PathFound path_to(execution::PathSearch& search, const ProgramAnalysis& analysis,
                             const dataflow::Read& read) {
    if (is_as_at_entry(analysis, read))
        return path_without_assignment(search, analysis, read.variable, read.node);
    return search.find(std::array{execution::Leg{read.node, {}}});
}

/// Puts the read to those that go back to the same mistake.
void add_to(std::vector<UnsetReads>& groups, const ProgramAnalysis& analysis, Unset kind, UnsetRead found) {
    MissingCase missing;
    if (kind == Unset::in_some_cases)
        missing = missing_case_on(analysis, found.path, found.read->variable, found.read->node);
    const auto group = std::ranges::find_if(groups, [&](const UnsetReads& reads) {
        return Budget::allows() && reads.kind == kind && kind != Unset::as_tested &&
               (kind != Unset::in_some_cases || reads.first.read->node == found.read->node ||
                is_same_case(analysis.program(), reads.missing, missing));
    });
    if (group == groups.end()) {
        groups.push_back({kind, std::move(found), {}, std::move(missing)});
        return;
    }
    group->others.push_back(found.read);
    if (missing.subjects.size() < group->missing.subjects.size()) group->missing = std::move(missing);
}

bool lacks_a_value(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    using dataflow::Vacancy;
    if (read.value.vacancy != Vacancy::vacant && read.value.vacancy != Vacancy::maybe) return false;
    return !may_hold_vacant(analysis.program(), read.variable) ||
           is_owed_to_unset_variable(analysis, read.value);
}

} // namespace

bool may_hold_vacant(const Program& program, Variable variable) {
    return program.control->spaces[variable.space].initial_value != InitialValue::undefined;
}

bool is_owed_to_unset_variable(const ProgramAnalysis& analysis, const dataflow::Value& value) {
    const auto variable = variable_of_origin(analysis, value.vacancy_origin);
    return variable && analysis.data().is_vacant_at_entry(*variable);
}

bool is_owed_to_missing_value(const ProgramAnalysis& analysis, EffectId effect, ExpressionId expression) {
    const auto& expressions = analysis.program().expressions;
    std::vector<std::pair<EffectId, ExpressionId>> made_by{{effect, expression}}; // still to be looked at
    std::set<EffectId> seen{effect};
    while (!made_by.empty()) {
        const auto [by, value] = made_by.back();
        made_by.pop_back();
        for (const dataflow::Read& read : analysis.facts().at<dataflow::Read>(by)) {
            if (!Budget::allows()) return false;
            if (!expressions[value].span.covers(expressions[read.expression].span)) continue;
            if (lacks_a_value(analysis, read)) return true;
            const dataflow::Store* store = store_of(analysis, read.value);
            if (store != nullptr && seen.insert(store->effect).second)
                made_by.emplace_back(store->effect, store->expression);
        }
    }
    return false;
}

std::vector<UnsetReads> find_unset_reads(const ProgramAnalysis& analysis) {
    std::vector<UnsetReads> groups;
    const Variables series = series_taken(analysis);
    std::unordered_map<Variable, Attempts, VariableHash> attempts;
    SetSomewhere set(analysis.program());
    WithoutAssignment without_assignment(analysis);
    std::optional<execution::PathSearch> search; // most programs have no such read
    for (const dataflow::Read& read : analysis.facts().all<dataflow::Read>()) {
        Attempts& tried = attempts[read.variable];
        if (tried.searches >= most_attempts || series.contains(read.variable) ||
            !uses_unset(analysis, read, set) || counts(analysis, read))
            continue;
        if (tried.some_failed && !without_assignment.leads_to(read.variable, read.node)) continue;
        ++tried.searches;
        if (!search) search.emplace(analysis);
        execution::PathFound found = path_to(*search, analysis, read);
        if (!found.path && !found.gave_up) {
            without_assignment.exclude(read.variable, read.node);
            tried.some_failed = true;
        }
        if (found.path && exemptions::word_before_an_alarm.is_on() && read.use == dataflow::Use::word &&
            is_as_at_entry(analysis, read))
            found = path_past_word(*search, analysis, read);
        if (!found.path) continue;
        tried.searches = most_attempts; // once a variable
        add_to(groups, analysis, kind_of(analysis, read, set), {&read, *std::move(found.path)});
    }
    return groups;
}

} // namespace maclint::queries
