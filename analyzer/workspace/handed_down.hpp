//! Which variables programs have from those that call them, directly or through others.
#pragma once

#include "analyzer/dataflow/domain/persistent_map.hpp"
#include "analyzer/flow/components.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <deque>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace maclint {

/// A program hands variables down to all that it calls, and to those that these call. What two programs are
/// given shares memory as far as it is the same: a chain of calls costs no more than its text.
class HandedDown {
  public:
    /// The references must outlive it.
    HandedDown(const std::deque<ProgramAnalysis>& programs, const flow::Components& components);

    /// What the program is given, as it numbers that: names have their own numbers in every program. Sorted;
    /// nothing when no caller is there to be asked. May be asked on several threads.
    [[nodiscard]] std::optional<std::vector<Variable>> to(const ProgramAnalysis& taker) const;

  private:
    using Key = dataflow::Key;
    using Root = dataflow::Root;
    /// Keys of variables, each with how many programs give it.
    struct Given {
        Root numbered = 0, named = 0;
    };

    /// Puts what the program gives to `given`.
    void add(const Program& giver, Given& given);

    const flow::Components& components_;
    dataflow::PersistentMap map_;
    std::vector<Given> above_;                         ///< of each component: what programs outside it give
    std::unordered_map<std::uint32_t, Given> circles_; ///< of components of several programs: what these give
    std::unordered_map<std::string_view, std::int32_t> names_;
};

} // namespace maclint
