//! Programs that keep a row and that do not, made from the row and from what else is said of its code.
#pragma once

#include "rules/words/rule_row.hpp"

#include <string>

namespace maclint {

struct RowExamples {
    std::string dialect; ///< as --dialect takes it
    std::string control; ///< as --control takes it; empty where the row holds on any
    std::string bad;     ///< raises the row and no other one
    std::string good;    ///< raises no row
};

[[nodiscard]] RowExamples examples_of(const RowForCode& row);

} // namespace maclint
