//! The sequence numbers of a program, by their size.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <vector>

namespace maclint::queries {

struct SequenceNumber {
    std::int64_t number;
    Offset at; ///< byte at which it stands; of several the first
};

/// Each number once, rising.
[[nodiscard]] std::vector<SequenceNumber> find_sequence_numbers(const Program& program);

/// The greatest number below `wanted` and the least above it, as far as there are such.
[[nodiscard]] std::vector<SequenceNumber> find_neighbours(const std::vector<SequenceNumber>& numbers,
                                                          std::int64_t wanted);

/// Those that somebody may have meant who typed `wanted`, at most three: such with one digit more or less, or
/// two digits exchanged, then the neighbours; these first where `wanted` has one digit.
[[nodiscard]] std::vector<SequenceNumber> find_nearest(const std::vector<SequenceNumber>& numbers,
                                                       std::int64_t wanted);

/// The numbers that are this one with a digit put in or left out, each once, rising.
[[nodiscard]] std::vector<std::int64_t> numbers_a_digit_away(std::int64_t number);

} // namespace maclint::queries
