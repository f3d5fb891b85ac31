//! Names that programs use and that something else than their own text defines.
#pragma once

#include "analyzer/source/text_hash.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
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

/// Of a program's control. Sets are shared; nullptr: there is none.
struct NamesElsewhere {
    std::shared_ptr<const TextSet> defined;   ///< by files of definitions of the workspace
    std::shared_ptr<const TextSet> switches;  ///< of these, words that only switch something of the machine
    std::shared_ptr<const ListedNames> named; ///< by somebody who knows the machine
    bool are_all = false; ///< nothing else is defined: what is not among them the control does not know

    [[nodiscard]] bool contain(std::string_view capitals) const {
        return (defined != nullptr && defined->contains(capitals)) ||
               (named != nullptr && named->match(capitals));
    }
};

} // namespace maclint
