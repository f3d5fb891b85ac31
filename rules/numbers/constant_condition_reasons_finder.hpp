//! Why somebody may have meant a condition that never changes.
#pragma once

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/queries/conditions/guards_before.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/numbers/constant_condition_settings_finder.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>

namespace maclint::rules {

/// By which a condition that decides nothing is taken for meant.
namespace exemptions {
inline constexpr Exemption condition_on_settings;
inline constexpr Exemption condition_on_vacancy;
inline constexpr Exemption jump_to_same_place;
inline constexpr Exemption same_block_guarded_again;
inline constexpr Exemption last_case_tested;
} // namespace exemptions

/// Gathered in one pass over the facts of a program.
class DeliberateConditions {
  public:
    explicit DeliberateConditions(const ProgramAnalysis& analysis);

    /// Whether a condition that is always true, or never, may be meant so: numbers that users edit decide it,
    /// it only makes sure of a limit, repeats a test, or tests what other cases left over. Not: one that is
    /// decided by the other parts of it, as #1LT8 OR #1GT6 is, one after which no block is left to run, and
    /// one that asks again what the guard before it has asked. What such a guard decides, no setting does.
    [[nodiscard]] bool may_be_meant(const dataflow::Condition& condition,
                                    const std::optional<queries::GuardBefore>& guard) const;

  private:
    [[nodiscard]] bool asks_for_a_count(const dataflow::Condition& condition) const;
    [[nodiscard]] bool repeats_another(const dataflow::Condition& condition) const;
    [[nodiscard]] bool leaves_nothing_to_run(const dataflow::Condition& condition) const;
    [[nodiscard]] bool does_what_another_does(const dataflow::Condition& condition) const;

    const ProgramAnalysis& analysis_;
    Settings settings_;
    std::map<Label, flow::NodeId> first_tests_; ///< facts are in the order of nodes
    std::map<std::string, int> guarded_;        ///< how many conditions guard what reads like this
};

/// Why a condition is decided where it stands.
struct Reason {
    enum class Kind : std::uint8_t {
        unknown,    ///< neither of these tells why
        same_sides, ///< a variable is compared with itself
        itself,     ///< its parts decide it, whatever the values are: #1LT8 OR #1GT6
        number,     ///< a variable that it asks for is one number
        test,       ///< an earlier test of the same variable
        same_test,  ///< the guard before it, which asks the very same
    } kind;
    std::optional<Variable> variable; ///< of Kind::number
    double number = 0;
    Span since;                          ///< what set the variable, or the earlier test
    std::optional<ExpressionId> earlier; ///< of the same variable
};

[[nodiscard]] Reason reason_for(const ProgramAnalysis& analysis, const dataflow::Condition& condition,
                                const std::optional<queries::GuardBefore>& guard);

} // namespace maclint::rules
