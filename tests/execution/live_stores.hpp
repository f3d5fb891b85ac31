//! Holds what a run reads against what is claimed to be dead.
#pragma once

#include "analyzer/execution/stepper.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace maclint::test {

/// Remembers which store every variable holds the value of.
class LiveStores {
  public:
    /// To be called with every event of a run.
    void observe(execution::Stepper& stepper, const execution::Event& event);

    /// The first store whose value was read although it is said to be dead.
    [[nodiscard]] const std::optional<std::string>& refuted() const { return refuted_; }
    /// How many reads were held against a store.
    [[nodiscard]] std::size_t held() const { return held_; }

  private:
    struct Store {
        const ProgramAnalysis* analysis;
        EffectId effect;
    };
    using Place = std::tuple<std::size_t, SpaceId, std::int32_t>; ///< set of locals (0: none), variable

    /// Nothing for variables whose number means something else in every program.
    [[nodiscard]] std::optional<Place> place_of(const ProgramAnalysis& analysis, Variable variable) const;

    std::vector<std::size_t> locals_; ///< the set of each level
    std::size_t sets_ = 0;
    bool fresh_ = true;       ///< the next program that begins has a set of its own
    bool in_unknown_ = false; ///< a program runs that is not there
    std::map<Place, Store> held_by_;
    std::optional<std::string> refuted_;
    std::size_t held_ = 0;
};

} // namespace maclint::test
