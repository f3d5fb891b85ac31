//! Tools: which a program lists, and which it calls.
#pragma once

#include "analyzer/program/model.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace maclint::queries {

/// A T with a number.
struct ToolWord {
    double number;         ///< of the tool, without its edge
    std::string_view edge; ///< the figures behind the point; empty: none, the main edge
    Span span;
    std::size_t list = 0; ///< of a listed tool: which of the program's lists has it
};

/// The tools of the list of a program, a section that a word of its own begins; empty where it has none, or
/// lists tools without numbers.
[[nodiscard]] std::vector<ToolWord> listed_tools(const Program& program);
/// The tools that the program calls where it works.
[[nodiscard]] std::vector<ToolWord> called_tools(const Program& program);

} // namespace maclint::queries
