//! Words that put back a modal state of another group than was changed.
#pragma once

#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <vector>

namespace maclint::rules {

/// A word, `G#3`, that puts back a state which the program need not put back there.
struct MisplacedSave {
    enum class Kind : std::uint8_t {
        twice,     ///< another word puts back the same group, saved in another variable
        beside,    ///< a code of the same group stands in its block
        unchanged, ///< nothing changes the group, and what is changed is not put back
    } kind;
    const dataflow::ModalWrite* write;
    const dataflow::Store* save;
    GroupId group;
    /// Kind::twice: the other save; beside: the code's word; unchanged: the word that changes the other
    /// group.
    Span other;
};

/// At most one for each group, in no order.
[[nodiscard]] std::vector<MisplacedSave> find_misplaced_saves(const ProgramAnalysis& analysis);

} // namespace maclint::rules
