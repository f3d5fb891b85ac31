//! Operands for which an operation has no value, and arguments that nothing checks.
#pragma once

#include "analyzer/dataflow/facts/application.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/queries/values/passed_values.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace maclint::queries {

/// By which an operation may have no value.
namespace exemptions {
inline constexpr Exemption compared_before;
} // namespace exemptions

/// Why an operation may have no value.
struct OperandRisk {
    enum class Evidence : std::uint8_t {
        passed,         ///< a call passes such a value
        left_out,       ///< a call leaves the variable out, and it counts as 0
        lets_zero_pass, ///< the program checks the variable with `check`, which lets 0 pass
        asked_vacancy,  ///< the program asks whether the variable is there, and for nothing else
        others_checked, ///< the program checks `other`, and not this variable
        unchecked,      ///< nothing checks the variable
    } evidence;
    Variable variable;                           ///< that decides the operand
    const Caller* call;                          ///< of `passed` and `left_out`
    std::optional<Variable> other;               ///< of `others_checked`
    const dataflow::Comparison* check = nullptr; ///< of `lets_zero_pass`
};

/// Looks at one program; what it compares is gathered once.
class OperandRisks {
  public:
    explicit OperandRisks(const ProgramAnalysis& analysis);

    /// The risk of a division, a root, a tangent, a logarithm, an arc sine or cosine, of which the last
    /// operand decides whether it has a value; nothing where it has one, or nobody can tell. What the program
    /// compares counts as checked, unless it only stops at values that do no harm and goes on with 0.
    [[nodiscard]] std::optional<OperandRisk> risk_of(const dataflow::Application& application);

    /// The risk that the argument which is read holds anything, or nothing: the program neither compares it
    /// nor asks whether it was passed; holding it against `counter` is no check. Nothing where all known
    /// calls pass it.
    [[nodiscard]] std::optional<OperandRisk>
    risk_of_argument(const dataflow::Read& read, std::optional<Variable> counter = std::nullopt) const;

  private:
    /// Of a variable whose value at the start, or what is calculated from it, is compared.
    struct Checks {
        std::vector<const dataflow::Comparison*> comparisons;
        /// The variables that stand alone on their sides, each pair once: many loops may be alike.
        std::set<std::pair<std::optional<dataflow::Key>, std::optional<dataflow::Key>>> sides;
    };
    [[nodiscard]] const Checks* checks_of(Variable variable) const;
    [[nodiscard]] bool is_checked(Variable variable, std::optional<Variable> counter) const;
    [[nodiscard]] std::optional<OperandRisk> shown_by_call(const dataflow::Application& application) const;
    [[nodiscard]] bool may_be_anything(Variable variable) const;
    [[nodiscard]] std::optional<OperandRisk> risk_of_root(const dataflow::Value& operand) const;
    [[nodiscard]] OperandRisk unchecked(Variable variable) const;
    [[nodiscard]] bool lets_zero_pass(Variable variable, const dataflow::Comparison& comparison);
    [[nodiscard]] std::optional<Variable> checked_beside(Variable variable) const;

    const ProgramAnalysis& analysis_;
    ZeroSources zeros_;
    std::unordered_map<dataflow::Key, Checks> checks_;
    std::unordered_map<dataflow::SymbolId, int> looks_; ///< at a value: not again and again at one
    int walks_ = 0;                                     ///< through the program
    std::vector<Variable> asked_;                       ///< whether it was passed
    std::vector<Variable> guarded_; ///< arguments without which, or with a wrong value, the program stops
};

} // namespace maclint::queries
