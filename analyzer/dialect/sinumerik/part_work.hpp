//! What the blocks of a part of a program do, whoever runs it.
#pragma once

#include "analyzer/program/model.hpp"

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace maclint::sinumerik {

/// Blocks in a row, from the first to the last.
struct Part {
    ItemId first, last;
};

struct PartWork {
    /// What the last word sets in each modal group; nothing: it is calculated.
    std::map<GroupId, std::optional<double>> groups;
    std::vector<Variable> read, written;
    bool in_a_row = true; ///< its blocks run one after the other, whatever is in force
    bool moves = false;
    bool stops_look_ahead = false;
    bool handles_machine = false; ///< it has words of tools or of what the machine's maker added; or of
                                  ///< coolant alone
    bool may_do_anything = false; ///< it calls, may end the program, or nobody knows what it stores
};

/// `stays_inside`: whether a jump to the label ends in the part.
[[nodiscard]] PartWork work_of(const Program& program, Part part,
                               const std::function<bool(const Label&)>& stays_inside);

} // namespace maclint::sinumerik
