//! Blocks that stand before an example's so that its other rows are kept.
#pragma once

#include "rules/words/example_switches.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace maclint {

/// Writes each once, and before it what its own code wants.
class Preludes {
  public:
    explicit Preludes(ExamplePlace place)
        : place_(place) {}

    void switch_on(std::string_view name, SwitchedAround& around);
    /// What rows of the block want on, but for one.
    void want(const ExampleBlock& block, const WordRow* but, SwitchedAround& around);
    /// Another code than those under which rows of the block refuse it, where a program begins with one.
    void leave_reset(const ExampleBlock& block, const WordRow* but, SwitchedAround& around) const;
    /// A first element, where rows of the block want one in front of it.
    void begin_contour(const ExampleBlock& block, const WordRow* but, SwitchedAround& around) const;
    /// What the block, as it is written, leaves on is switched off, but for what the row says.
    [[nodiscard]] std::string switched_off(const ExampleBlock& block, const WordRow* but,
                                           std::string_view written) const;

  private:
    ExamplePlace place_;
    std::vector<std::string_view> begun_;
};

} // namespace maclint
