//! The cycles that the control brings.
#pragma once

#include "analyzer/program/language_words.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace maclint::sinumerik {

enum class CycleUse : std::uint8_t {
    drilling, ///< one position, or with MCALL each of those that follow
    pattern,  ///< positions for the cycle that MCALL names
    milling,
    turning,
    grinding,
    measuring,
    contour, ///< names a contour for the next cycle
    setting, ///< turns the frame or sets modes for what follows
    other,
};

struct CycleRow {
    std::string_view name; ///< capitals
    CycleUse use;
    std::string_view what; ///< "deep holes"
    /// The parameters before SINUMERIK Operate, blanks between them; empty: no list is known.
    std::string_view older_parameters;
    /// How many places calls in programs had, blanks between the counts. Versions differ: these are no
    /// limits.
    std::string_view places_seen;
    std::string_view source; ///< of the parameters
};

/// What a cycle may change for the blocks behind it.
struct CycleSettings {
    std::string_view cycle;
    std::span<const std::uint8_t> groups; ///< G groups, by their numbers
    bool frames;                          ///< the programmable frame, which it deletes or adds to
    bool transformation;                  ///< TRAORI and its like, which it may switch off
};

/// Nothing for a cycle that leaves all modes as they are, or of which nobody knows.
[[nodiscard]] const CycleSettings* find_settings(std::string_view capitals);

/// Nothing for a cycle without a row, of which is_cycle_name() may still know.
[[nodiscard]] const CycleRow* find_cycle(std::string_view capitals);
/// Whether the name is a cycle's: it has a row, or is CYCLE and digits, which is kept for Siemens
/// [FUND04 p.60].
[[nodiscard]] bool is_cycle_name(std::string_view capitals);

/// All that have a row, and older ones of which less is known.
[[nodiscard]] std::vector<BroughtCycle> brought_cycles();

/// So many program levels a cycle needs below the one that calls it [NCP19 p.493].
inline constexpr int cycle_levels = 3;

} // namespace maclint::sinumerik
