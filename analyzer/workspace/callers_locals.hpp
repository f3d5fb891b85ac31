//! Which local variables callers may have set for a program that shares theirs.
#pragma once

#include "analyzer/flow/components.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <deque>
#include <functional>
#include <optional>
#include <vector>

namespace maclint {

/// Follows the calls that share local variables, from the programs that run on their own.
class CallersLocals {
  public:
    using Asked = std::function<bool(const ProgramAnalysis&)>;
    /// The references must outlive it. `begins_vacant` tells of a program without callers whether its local
    /// variables are vacant when it begins, `has_unknown_callers` whether calls may mean a program that are
    /// not among its callers.
    CallersLocals(const std::deque<ProgramAnalysis>& programs, const flow::Components& components,
                  const Asked& begins_vacant, const Asked& has_unknown_callers);

    /// What may be set when one of the known calls of the program runs it for the first time; nothing: any.
    [[nodiscard]] std::optional<std::vector<Variable>> set_before(const ProgramAnalysis& called) const;

  private:
    /// Local variables, in no order.
    struct Locals {
        bool any = false;
        std::vector<Variable> some = {};

        void add(Variable variable);
        void add(const Locals& more);
    };

    [[nodiscard]] static Locals stored_in(const ProgramAnalysis& analysis);
    [[nodiscard]] bool shares(const Caller& caller) const;
    [[nodiscard]] Locals stored_below(const ProgramAnalysis& analysis) const;
    void add_before(Locals& before, ProgramIndex caller, ProgramIndex called) const;

    const flow::Components& components_;
    const std::deque<ProgramAnalysis>& programs_;
    std::vector<Locals> stored_; ///< of each program, by itself
    std::vector<Locals> below_;  ///< of each component, with what it calls
    std::vector<Locals> before_; ///< of each component: set when its program begins
};

} // namespace maclint
