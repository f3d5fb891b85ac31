//! Rows about calls of programs.
#pragma once

#include <cstdint>
#include <string_view>

namespace maclint {

/// Whether a call opens a fresh set of local variables.
enum class Frame : std::uint8_t { fresh, shared };
/// Which limit a call counts against.
enum class NestingLimit : std::uint8_t { macro, subprogram };
/// When the called program runs.
enum class CallTrigger : std::uint8_t { once, after_each_motion, after_each_block };
/// Where the called program is looked for.
enum class LookupScope : std::uint8_t { everywhere, same_file, other_files };

/// One row of the call table.
struct CallKind {
    std::string_view name; ///< "G65 macro call"
    Frame frame;
    NestingLimit counts_against;
    CallTrigger trigger;
    double modal_code; ///< the code in force in the modal-call group while it acts; 0 for a call made once
    std::string_view source;
    LookupScope lookup = LookupScope::everywhere;
    /// Where no program has the name the control brings one: it moves, and leaves variables and modal groups
    /// as they are.
    bool brought_by_control = false;
};

} // namespace maclint
