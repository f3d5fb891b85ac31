//! What pages and JSON tell of a control, gathered from its tables, chapters and lists.
#pragma once

#include "analyzer/program/tables.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint::cli {

struct ChapterFacts {
    std::string_view chapter;
    std::vector<std::string_view> codes; ///< "G83", in the chapter's order
    std::size_t words = 0;
};

struct ControlFacts {
    std::vector<ChapterFacts> chapters; ///< that hold codes of it
    std::size_t codes = 0, words = 0;
    std::vector<const VariableRange*> variables; ///< ranges of numbers that it has
    std::size_t alarms = 0;                      ///< on its list
    std::size_t alarms_found = 0;
    std::vector<std::pair<std::string_view, int>> limits; ///< "nested macro calls"; those that are known
};

[[nodiscard]] ControlFacts facts_of(const ControlModel& control);
/// "mill", "lathe, G code system B".
[[nodiscard]] std::string machine_of(const ControlModel& control);

} // namespace maclint::cli
