//! Canned cycles and the positions at which the blocks after them carry them out.
#pragma once

#include "analyzer/source/span.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <vector>

namespace maclint::queries {

/// A block that begins a cycle, and what follows up to the one that ends it.
struct StoredCycle {
    Span code;                              ///< G81
    std::optional<Span> no_repeats;         ///< K0 or L0: it is stored and carried out nowhere
    std::optional<Span> end;                ///< of the block that ends it; nothing: nobody knows which does
    bool is_carried_out = false;            ///< a later block has a position
    std::optional<Span> incremental_level;  ///< Z or R, which surely stands under G91
    std::optional<Span> absolute, position; ///< a later G90, and the first position under it without levels
};

/// Those that are given without repeats or with levels under G91, in the order of the text. Wants
/// dataflow::BeforeNode.
[[nodiscard]] std::vector<StoredCycle> stored_cycles(const ProgramAnalysis& analysis);

} // namespace maclint::queries
