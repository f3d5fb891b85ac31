//! Facts in the order of their nodes or effects. The sort itself is compiled once, not for each type of fact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace maclint::dataflow {

/// Which of the things with these keys comes to each place; those of one key stay in order.
[[nodiscard]] std::vector<std::uint32_t> order_of(const std::vector<std::uint32_t>& keys);

/// Whether they are in the order of that member.
template<class T, class Key>
[[nodiscard]] bool is_in_order(const std::vector<T>& facts, Key key) {
    for (std::size_t i = 1; i < facts.size(); ++i)
        if (facts[i].*key < facts[i - 1].*key) return false;
    return true;
}

/// Puts them in the order of that member, a number; those of one number stay in order.
template<class T, class Key>
void put_in_order_of(std::vector<T>& facts, Key key) {
    if (is_in_order(facts, key)) return;
    std::vector<std::uint32_t> keys;
    keys.reserve(facts.size());
    for (const T& fact : facts) keys.push_back(fact.*key);
    std::vector<T> as_found;
    as_found.reserve(facts.size());
    for (T& fact : facts) as_found.push_back(std::move(fact));
    std::size_t place = 0;
    for (const std::uint32_t comes_here : order_of(keys)) facts[place++] = std::move(as_found[comes_here]);
}

} // namespace maclint::dataflow
