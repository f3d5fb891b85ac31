//! Counts and bounds of the language. What no document confirms is marked T: what rests on
//! it is a warning, and says so.
#pragma once

#include <cstddef>

namespace maclint::sinumerik::limits {

constexpr std::size_t variable_name = 31; ///< characters [FUND04 p.60]
constexpr std::size_t program_name = 24;  ///< characters [NCP19 p.491]
constexpr std::size_t label = 32;         ///< characters [NCI]
constexpr std::size_t least_label = 2;    ///< characters [NCI]
constexpr std::size_t text = 200;         ///< characters of a STRING [FUND06 p.63]
constexpr std::size_t message = 124;      ///< characters of MSG [SEED-004:478]
constexpr int dimensions = 2;             ///< of an array; later versions have 3 [FUND06 p.63, T]
constexpr double least_integer = -2'147'483'648.0, last_integer = 2'147'483'647.0; ///< INT [T808 p.126]
constexpr int program_levels = 16;                       ///< level 0 is the main program [NCP23 p.490]
constexpr int structure_levels = 16;                     ///< IF, FOR, LOOP, WHILE, REPEAT in each other [T]
constexpr std::size_t parameters = 127;                  ///< of a program [T]
constexpr std::size_t block_length = 512;                ///< characters [T]
constexpr int least_passes = 1, most_passes = 9999;      ///< P of a call and of REPEAT [T]
constexpr int first_alarm = 60'000, last_alarm = 69'999; ///< of SETAL; up to 64999 those of cycles [T]
constexpr std::size_t block_functions_m = 5, block_functions_sh = 3; ///< M words; S words, H words [T]
constexpr double equal_within = 1e-12; ///< relative: comparisons of REAL [NCP19 p.444, MD10280]

} // namespace maclint::sinumerik::limits
