//! Chamfers and radii between two moves: the words that ask for one, and where the control cannot make it.
#pragma once

#include "analyzer/program/model.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace maclint {

class ProgramAnalysis;

namespace rules {

/// Good as long as its visitor runs.
struct ImpossibleCorner {
    const Word& word;
    /// "several", "unknown_word", "taper", "compensation", "no_move", "rapid", "short" or "no_end".
    std::string_view why;
    std::string words; ///< the word as it is written, or all of them
    std::string code;  ///< of compensation
};

/// Words after a comma, and on lathes a bare I, J, K or R in a straight cut. A block tells one thing. What
/// makers other than those with a list of alarms do is not known. Wants dataflow::BeforeNode.
void for_each_impossible_corner(const ProgramAnalysis& analysis,
                                const std::function<void(const ImpossibleCorner&)>& visit);

} // namespace rules

} // namespace maclint
