//! Names that programs use and that something else than their own text defines.
#pragma once

#include "analyzer/program/given.hpp"
#include "analyzer/source/text_hash.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace maclint {

/// Names in capitals: whole ones, and beginnings.
struct ListedNames {
    TextSet names;
    std::vector<std::string> beginnings;

    [[nodiscard]] bool match(std::string_view capitals) const {
        return names.contains(capitals) || std::ranges::any_of(beginnings, [&](const std::string& beginning) {
                   return capitals.starts_with(beginning);
               });
    }
};

/// By name.
template<class Given>
using GivenByName = std::unordered_map<std::string, Given, TextHash, std::equal_to<>>;

/// Of a program's control. Sets are shared; nullptr: there is none.
struct NamesElsewhere {
    std::shared_ptr<const TextSet> defined;                     ///< by files of definitions of the workspace
    std::shared_ptr<const GivenByName<GivenWord>> words;        ///< of these, pieces of blocks
    std::shared_ptr<const GivenByName<ArrayDefinition>> arrays; ///< and variables; no type where files differ
    std::shared_ptr<const ListedNames> named;                   ///< by somebody who knows the machine
    bool are_all = false; ///< nothing else is defined: what is not among them the control does not know

    [[nodiscard]] bool contain(std::string_view capitals) const {
        return (defined != nullptr && defined->contains(capitals)) ||
               (named != nullptr && named->match(capitals));
    }
    /// nullptr: no file of definitions gives it.
    [[nodiscard]] const GivenWord* word(std::string_view capitals) const { return find(words, capitals); }
    /// Only where such a file is the program's own.
    [[nodiscard]] const ArrayDefinition* array(std::string_view capitals) const {
        return are_all ? find(arrays, capitals) : nullptr;
    }

  private:
    template<class Given>
    static const Given* find(const std::shared_ptr<const GivenByName<Given>>& all,
                             std::string_view capitals) {
        if (all == nullptr) return nullptr;
        const auto found = all->find(capitals);
        return found == all->end() ? nullptr : &found->second;
    }
};

} // namespace maclint
