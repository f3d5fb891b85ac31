//! Which codes contradict each other in one block.
#pragma once

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/words/block_words.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace maclint::rules {

/// Codes of which a block may hold one.
struct ExclusiveKind {
    std::size_t row; ///< the same for all codes of the kind
    std::string_view name;
};

struct ExclusiveCode {
    Span span;
    double code; ///< its number in the group, where the group's codes are names
    ExclusiveKind kind;
};

/// The codes of a block that exclude others, in text order. Their kind is the row of the control's table or,
/// where it has none, the modal group.
[[nodiscard]] std::vector<ExclusiveCode> exclusive_codes_in(const queries::WordsOfBlock& block);

} // namespace maclint::rules
