//! Values that depend on what a program is called with.
#pragma once

#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

namespace maclint::queries {

/// The variables whose values at the program's start the value is calculated from, and whether nothing but
/// these and constants decides it.
struct GivenVariables {
    std::vector<Variable> variables; ///< each once
    bool closed = true;
};

[[nodiscard]] GivenVariables given_variables(const ProgramAnalysis& analysis, const dataflow::Value& value);

/// The variables each of which makes a value 0 where it is 0 at the program's start: #6 of `#6`, `ABS[#6]`,
/// `2*#6`, also where the program may have replaced it by a number other than 0. Sums and differences have
/// none. Each value is looked at once.
class ZeroSources {
  public:
    explicit ZeroSources(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , without_assignment_(analysis) {}
    [[nodiscard]] const std::vector<Variable>& of(dataflow::SymbolId value);

  private:
    void collect(dataflow::SymbolId id, int depth, std::vector<Variable>& zeros);
    [[nodiscard]] bool has_only_defaults(Variable variable);

    const ProgramAnalysis& analysis_;
    WithoutAssignment without_assignment_;
    std::unordered_map<Variable, bool, VariableHash> has_only_defaults_; ///< as far as it was asked
    std::unordered_map<dataflow::SymbolId, std::vector<Variable>> known_;
};

/// What a value is for one call.
struct PassedValue {
    double number;
    std::optional<Variable> left_out; ///< an argument in it that the call leaves out, and that counts as 0
    const Caller* call;               ///< that passes it, or the first of those that hand it on
};

/// What the value is for the first known call that opens locals of its own, and for which it is `wanted`;
/// nothing where more than numbers of calls decides. What the calling program hands on as it was given it is
/// a number of its own callers, through three further calls, each on every path of its program.
[[nodiscard]] std::optional<PassedValue>
value_for_a_call(const ProgramAnalysis& analysis, const dataflow::Value& value,
                 const std::function<bool(const PassedValue&)>& wanted);

/// Whether callers are known, and each passes another number than 0, or hands on what its own callers pass.
[[nodiscard]] bool is_never_passed_as_zero(const ProgramAnalysis& analysis, Variable variable);
/// The same of a value, which is false where it is no argument as it was passed.
[[nodiscard]] bool is_never_passed_as_zero(const ProgramAnalysis& analysis, const dataflow::Value& value);

} // namespace maclint::queries
