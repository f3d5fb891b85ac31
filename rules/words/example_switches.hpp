//! The blocks around an example's that switch on what its code wants, and off what is on.
#pragma once

#include "rules/words/example_after.hpp"

#include <string>

namespace maclint {

/// With their ends of line.
struct SwitchedAround {
    std::string before, after;
};

/// `kept`: such as the row wants it, else not, where the row is about it.
[[nodiscard]] SwitchedAround switched_around(const RowForCode& row, const ExampleBlock& block,
                                             const ExamplePlace& place, bool kept);

/// The blocks that put the first code of WordRow::under in force; `after` gains those that end it.
[[nodiscard]] std::string switched_under(const WordRow& row, const ExamplePlace& place, std::string& after);

} // namespace maclint
