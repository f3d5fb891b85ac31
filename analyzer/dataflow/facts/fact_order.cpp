//! Sorts by key and place.
#include "analyzer/dataflow/facts/fact_order.hpp"

#include <algorithm>

namespace maclint::dataflow {

std::vector<std::uint32_t> order_of(const std::vector<std::uint32_t>& keys) {
    constexpr unsigned bits_of_place = 32;
    std::vector<std::uint64_t> keys_and_places;
    keys_and_places.reserve(keys.size());
    for (const std::uint32_t key : keys)
        keys_and_places.push_back(std::uint64_t{key} << bits_of_place | keys_and_places.size());
    std::sort(keys_and_places.begin(), keys_and_places.end());
    std::vector<std::uint32_t> order;
    order.reserve(keys.size());
    for (const std::uint64_t both : keys_and_places) order.push_back(static_cast<std::uint32_t>(both));
    return order;
}

} // namespace maclint::dataflow
