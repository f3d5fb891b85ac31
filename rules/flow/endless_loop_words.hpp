//! What MAC319 says of a loop.
#pragma once

#include "analyzer/dataflow/loops.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::rules {

struct EndlessLoopWords {
    std::string_view id;
    std::vector<std::string> more; ///< arguments of the message after the loop itself
    std::string again;             ///< of the round in the trace
};

/// Nothing for a loop that may end, or of which another rule tells: MAC318 of DO without WHILE, MAC336 of
/// jumps that nothing leaves, MAC320 of steps away from the end, MAC718 of conditions without variables.
[[nodiscard]] std::optional<EndlessLoopWords> endless_loop_words(const ProgramAnalysis& analysis,
                                                                 const dataflow::Loop& loop);

} // namespace maclint::rules
