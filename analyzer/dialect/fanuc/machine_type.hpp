//! Guesses from a program's text whether it was written for a lathe, and with which G code system.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/program/tables.hpp"

#include <string_view>

namespace maclint::fanuc {

constexpr char no_lathe = 0;

struct MachineOfText {
    /// The G code system 'A', 'B' or 'C' of a text for a lathe. 'A' where nothing tells the systems apart,
    /// and where anything of A stands.
    char lathe_system;
    MachineSigns signs;
};

/// `machine` is what is known of it: of a mill, the words must leave no doubt that a lathe was meant (turning
/// cycles, speed limits or turret positions, and nothing of a mill), else it is `no_lathe`.
[[nodiscard]] MachineOfText machine_of(std::string_view text, Machine machine);

} // namespace maclint::fanuc
