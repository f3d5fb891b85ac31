//! The G groups of the language and their codes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace maclint::sinumerik {

/// A code, with or without a number: "G18", "DIAMON". `member` is its number in its group, which
/// `$P_GG[group]` reads and `G[group]=` sets [SV].
struct GCodeRow {
    std::string_view name; ///< capitals, no leading zeros
    std::uint8_t group, member;
};

/// A group. Those without codes in our source are there, too: 5, 38, 58, 63 and 64.
struct GGroupRow {
    std::uint8_t number;
    std::string_view what; ///< "distance mode": for messages
    bool modal;
    std::uint8_t reset; ///< the member in force after a reset of a control as it is delivered; 0: none. The
                        ///< maker of a machine changes it: lathes have G18, G95, DIAMON [MD20150]
};

/// Nothing for a code of no group. The grinding frames GFRAME[n] are no codes here.
[[nodiscard]] const GCodeRow* find_g_code(std::string_view capitals);
/// The code that is this member of its group; nothing where there is none.
[[nodiscard]] const GCodeRow* find_member(int group, double member);
/// All codes, sorted by name.
[[nodiscard]] std::span<const GCodeRow> g_codes();
/// By number, from 1 on without gaps.
[[nodiscard]] std::span<const GGroupRow> g_groups();

/// `G01` is G1: leading zeros are ignored [FUND04 p.61].
[[nodiscard]] std::string code_name(std::string_view written);

} // namespace maclint::sinumerik
