//! What a word of a file of definitions does to the machine.
#pragma once

#include "analyzer/machine/states.hpp"
#include "analyzer/program/given.hpp"
#include "analyzer/program/tables.hpp"

namespace maclint::machine {

/// The word stands alone in its block, and it is known what it does.
[[nodiscard]] Left left_by(const GivenWord& word, const ControlModel& control);

} // namespace maclint::machine
