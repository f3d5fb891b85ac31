//! What programs switch on and off at the machine, beside the modal groups: a C axis, a coupling, a probe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace maclint {

/// The most switches that a control can have.
inline constexpr std::size_t most_switches = 64;

/// One thing that is on or off. Codes are listed with commas between them, each with what must stand beside
/// it (word_condition.hpp): "M14, G16 B?0 Q!0"; a letter alone is any number of it, "M!8|9" any but these.
struct Switch {
    std::string_view name;        ///< of rows, and of messages: "C axis"
    std::string_view on, off;     ///< codes that switch it
    std::string_view either = {}; ///< codes after which nobody can say
    enum class Where : std::uint8_t {
        machine, ///< all channels share it: it is known only in programs of one
        channel, ///< each channel has its own
        section, ///< it lasts to the end of the section that describes something, where it begins off
    } where = Where::machine;
    std::string_view source;
};

} // namespace maclint
