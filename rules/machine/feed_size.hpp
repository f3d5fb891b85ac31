//! Feeds that nobody gives a turn, or a minute.
#pragma once

#include "analyzer/machine/state.hpp"
#include "analyzer/program/machine_words.hpp"

namespace maclint {

/// Whether the feed in force cannot be meant for the mode in force: F80 a turn, F0.1 a minute. The limits lie
/// far from what anybody cuts with; where nothing says which unit, those of both units hold.
class FeedSize {
  public:
    FeedSize(const machine::State& state, const MachineWords& letters);

    [[nodiscard]] bool is_too_much_for_a_turn(double feed) const;
    [[nodiscard]] bool is_too_little_for_a_minute(double feed) const;

  private:
    bool may_be_metric_, may_be_inch_;
};

} // namespace maclint
