//! Collects sequence numbers and looks them up.
#include "analyzer/queries/structure/sequence_numbers.hpp"

#include "analyzer/program/block_view.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

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

std::vector<std::int64_t> numbers_a_digit_away(std::int64_t number) {
    std::vector<std::int64_t> found;
    const auto add = [&](const std::string& digits) {
        std::int64_t value = 0;
        const bool is_written_so = digits == "0" || !digits.starts_with('0');
        const char* const end = digits.data() + digits.size();
        if (is_written_so && std::from_chars(digits.data(), end, value).ec == std::errc())
            found.push_back(value);
    };
    const std::string digits = std::to_string(number);
    for (std::size_t at = 0; at < digits.size(); ++at) add(std::string(digits).erase(at, 1));
    for (std::size_t at = 0; at <= digits.size(); ++at)
        for (char digit = '0'; digit <= '9'; ++digit) add(std::string(digits).insert(at, 1, digit));
    std::ranges::sort(found);
    const auto repeated = std::ranges::unique(found);
    found.erase(repeated.begin(), repeated.end());
    return found;
}

std::vector<SequenceNumber> find_nearest(const std::vector<SequenceNumber>& numbers, std::int64_t wanted) {
    constexpr std::size_t most_typed = 2, most = 3;
    std::vector<std::int64_t> typed = numbers_a_digit_away(wanted);
    const std::string digits = std::to_string(wanted);
    for (std::size_t at = 1; at < digits.size(); ++at) {
        std::string exchanged = digits;
        std::swap(exchanged[at - 1], exchanged[at]);
        typed.push_back(std::stoll(exchanged));
    }
    std::ranges::sort(typed, {}, [&](std::int64_t number) { return std::abs(number - wanted); });
    std::vector<SequenceNumber> nearest;
    const auto add = [&](const SequenceNumber& number) {
        if (number.number != wanted && nearest.size() < most &&
            std::ranges::find(nearest, number.number, &SequenceNumber::number) == nearest.end())
            nearest.push_back(number);
    };
    // Of one digit, any number that holds it is a digit away.
    if (digits.size() == 1)
        for (const SequenceNumber& neighbour : find_neighbours(numbers, wanted)) add(neighbour);
    for (const std::int64_t number : typed) {
        const auto found = std::ranges::lower_bound(numbers, number, {}, &SequenceNumber::number);
        if (found != numbers.end() && found->number == number && nearest.size() < most_typed) add(*found);
    }
    for (const SequenceNumber& neighbour : find_neighbours(numbers, wanted)) add(neighbour);
    return nearest;
}

} // namespace maclint::queries
