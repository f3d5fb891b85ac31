//! Collects sequence numbers and looks them up.
#include "analyzer/queries/sequence_numbers.hpp"

#include "analyzer/program/block_view.hpp"

#include <algorithm>

namespace maclint::queries {

std::vector<SequenceNumber> find_sequence_numbers(const Program& program) {
    std::vector<SequenceNumber> numbers;
    for_each_block(program, [&](const BlockView& block) {
        if (block.number) numbers.push_back({*block.number, block.number_span.begin});
    });
    std::ranges::stable_sort(numbers, {}, &SequenceNumber::number);
    const auto repeated = std::ranges::unique(numbers, {}, &SequenceNumber::number);
    numbers.erase(repeated.begin(), repeated.end());
    return numbers;
}

std::vector<SequenceNumber> find_neighbours(const std::vector<SequenceNumber>& numbers, std::int64_t wanted) {
    std::vector<SequenceNumber> neighbours;
    const auto above = std::ranges::upper_bound(numbers, wanted, {}, &SequenceNumber::number);
    const auto least = std::ranges::lower_bound(numbers, wanted, {}, &SequenceNumber::number);
    if (least != numbers.begin()) neighbours.push_back(*(least - 1));
    if (above != numbers.end()) neighbours.push_back(*above);
    return neighbours;
}

} // namespace maclint::queries
