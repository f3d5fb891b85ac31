//! Looks at what follows each test for 0, and where else the variable is tested.
#include "rules/variables/zero_test_misses_vacant_tests_finder.hpp"

#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/paths/exits.hpp"
#include "analyzer/queries/vacancy/unset_reads.hpp"
#include "rules/variables/zero_test_misses_vacant_trials_finder.hpp"
#include "rules/variables/zero_test_misses_vacant_uses_finder.hpp"

#include <cstddef>
#include <optional>
#include <unordered_map>

namespace maclint::rules {
namespace {

using dataflow::Comparison;
using dataflow::Vacancy;
using dataflow::Value;

/// A test for 0 of a variable that may be vacant.
struct ZeroTest {
    const Comparison& comparison;
    const Value& value;
    Variable variable;

    [[nodiscard]] flow::NodeId node() const { return comparison.node; }
    /// Whether the test is true of 0.
    [[nodiscard]] bool is_equal() const { return comparison.operation == Operation::equal; }
};

bool is_zero(const Value& value) { return value.vacancy == Vacancy::set && value.constant() == 0.0; }

std::optional<ZeroTest> zero_test(const Program& program, const Comparison& comparison) {
    if (comparison.operation != Operation::equal && comparison.operation != Operation::not_equal)
        return std::nullopt;
    const bool zero_left = is_zero(comparison.left);
    if (!zero_left && !is_zero(comparison.right)) return std::nullopt;
    const Value& value = zero_left ? comparison.right : comparison.left;
    const auto variable = queries::plain_variable(program, zero_left ? comparison.right_expression
                                                                     : comparison.left_expression);
    const bool may_be_vacant = value.vacancy == Vacancy::maybe || value.vacancy == Vacancy::unknown;
    if (!may_be_vacant || !variable || !queries::may_hold_vacant(program, *variable)) return std::nullopt;
    return ZeroTest{comparison, value, *variable};
}

/// Where the control comes when the test in the node is true.
std::optional<flow::NodeId> target_of(const ProgramAnalysis& analysis, flow::NodeId test) {
    const auto jump = queries::only_successor(analysis, test, true);
    return jump ? queries::only_successor(analysis, *jump, std::nullopt) : std::nullopt;
}

/// Whether the comparison before or behind the test is one for the vacancy of another variable that jumps to
/// the same block in the same case: IF[#24NE#0]GOTO3, IF[#25NE0]GOTO3.
bool has_sibling(const ProgramAnalysis& analysis, const ZeroTest& test) {
    const Operation meant = test.is_equal() ? Operation::is_vacant : Operation::is_set;
    const auto target = target_of(analysis, test.node());
    if (!target) return false;
    const auto& all = analysis.facts().all<Comparison>();
    const auto at = static_cast<std::size_t>(&test.comparison - all.data());
    const auto is_alike = [&](std::size_t other) {
        return other < all.size() && all[other].operation == meant &&
               target_of(analysis, all[other].node) == target;
    };
    return is_alike(at + 1) || (at != 0 && is_alike(at - 1));
}

class MissedVacancies {
  public:
    explicit MissedVacancies(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , trials_(analysis) {
        for (const Comparison& comparison : analysis.facts().all<Comparison>())
            if (semantics::is_vacancy_test(comparison.operation))
                if (const auto variable =
                        queries::plain_variable(analysis.program(), comparison.left_expression))
                    tested_.emplace(*variable, analysis.program().expressions[comparison.expression].span);
    }

    std::optional<MissedVacancy> look_at(const ZeroTest& test) {
        const auto known = tested_.find(test.variable);
        const auto tested = known == tested_.end() ? std::nullopt : std::optional(known->second);
        if (!analysis_.program().is_formal(test.variable) && (!tested || test.value.vacancy_origin == 0))
            return std::nullopt;
        const AfterZeroTest after =
            find_after_zero_test(analysis_, test.comparison, test.value, test.variable);
        if (!after.is_reached) return std::nullopt;
        const auto used = after.use ? after.use : after.compared;
        if (tested && queries::ends_in_alarm(analysis_, test.node(), !test.is_equal()))
            return missed(test, *tested, false);
        if (zero_is_refused(test, after) || (!used && !tested)) return std::nullopt;
        using enum VacancyTrials::Refused;
        // A choice among numbers may refuse what is missing; a range that 0 need not be in may not.
        const auto refused = after.is_default || after.is_held_in_range ? is_different
                             : after.use                                ? at_once
                                                                        : is_alike;
        const bool may_be_alike = !after.use && !after.is_default;
        if (trials_.are_alike(test.comparison, test.variable, refused).value_or(may_be_alike))
            return std::nullopt;
        return missed(test, used ? *used : *tested, used.has_value());
    }

  private:
    /// 0 ends in an alarm, and what is vacant is treated in another way: the author tells them apart.
    [[nodiscard]] bool zero_is_refused(const ZeroTest& test, const AfterZeroTest& after) const {
        return exemptions::zero_is_refused.is_on() && !after.use && after.asked &&
               queries::ends_in_alarm(analysis_, test.node(), test.is_equal()) &&
               !has_sibling(analysis_, test);
    }

    static MissedVacancy missed(const ZeroTest& test, Span shows, bool is_used) {
        return {&test.comparison, &test.value, test.variable, shows, is_used};
    }

    const ProgramAnalysis& analysis_;
    VacancyTrials trials_;
    /// The first test for vacancy of each variable: the author expects that it can be vacant.
    std::unordered_map<Variable, Span, VariableHash> tested_;
};

} // namespace

std::vector<MissedVacancy> find_missed_vacancy(const ProgramAnalysis& analysis) {
    std::vector<MissedVacancy> all;
    std::optional<MissedVacancies> search; // most programs have no such test
    for (const Comparison& comparison : analysis.facts().all<Comparison>()) {
        const auto test = zero_test(analysis.program(), comparison);
        if (!test) continue;
        if (!search) search.emplace(analysis);
        if (const auto missed = search->look_at(*test)) all.push_back(*missed);
    }
    return all;
}

} // namespace maclint::rules
