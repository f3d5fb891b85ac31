//! Facts in another order than that of their list, for those who look for some of many.
#pragma once

#include "analyzer/source/made_once.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace maclint::dataflow {

/// Facts by a key, sorted when somebody asks first: for most programs nobody does.
template<class T>
class SortedFacts {
  public:
    /// Those for which `key_of` gives the key, in the order of their list; it is the same list and the same
    /// function in each call. May be asked on several threads.
    template<class Key, class KeyOf>
    [[nodiscard]] std::span<const T* const> with(std::span<const T> facts, const Key& key,
                                                 const KeyOf& key_of) const {
        const auto key_at = [&](const T* fact) { return key_of(*fact); };
        const std::vector<const T*>& sorted = sorted_.get([&] {
            std::vector<const T*> all;
            all.reserve(facts.size());
            for (const T& fact : facts) all.push_back(&fact);
            std::ranges::stable_sort(all, {}, key_at);
            return all;
        });
        const auto found = std::ranges::equal_range(sorted, key, {}, key_at);
        return {found.begin(), found.end()};
    }

  private:
    mutable MadeOnce<std::vector<const T*>> sorted_;
};

} // namespace maclint::dataflow
