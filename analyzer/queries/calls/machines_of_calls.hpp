//! What the machine does in a program that one call begins with its numbers.
#pragma once

#include "analyzer/machine/states.hpp"
#include "analyzer/queries/calls/begun_programs.hpp"

#include <functional>
#include <utility>

namespace maclint::queries {

class MachineOfCall {
  public:
    MachineOfCall(const ProgramAnalysis& analysis, const NumberedCall& call, dataflow::Analysis begun,
                  machine::States states)
        : analysis_(analysis)
        , call_(call)
        , begun_(std::move(begun))
        , states_(std::move(states)) {}

    [[nodiscard]] const NumberedCall& call() const { return call_; }
    [[nodiscard]] const machine::States& states() const { return states_; }
    /// Whether the call always comes by the node, unless it ends in an alarm before.
    [[nodiscard]] bool surely_comes_by(flow::NodeId node) const;

  private:
    const ProgramAnalysis& analysis_;
    const NumberedCall& call_;
    dataflow::Analysis begun_;
    machine::States states_;
};

/// For calls that pass numbers, some of which are words of its blocks, and that always come by a circle or a
/// canned cycle. The facts CallBegun and BeforeNode of the callers tell, and Read.
void for_each_machine_of_call(const ProgramAnalysis& analysis,
                              const std::function<void(const MachineOfCall&)>& visit);

} // namespace maclint::queries
