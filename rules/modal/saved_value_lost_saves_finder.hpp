//! Saved modal values that are gone before a word puts them back.
#pragma once

#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/values/copies.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

/// By which a saved value may be overwritten.
namespace exemptions {
inline constexpr Exemption computed_from_the_saved;
} // namespace exemptions

struct OverwrittenSave {
    queries::CopySource saved;         ///< the modal value, with its group
    flow::NodeId saved_in;             ///< where the variable got it
    const dataflow::Store* store;      ///< that overwrites it
    const dataflow::ModalWrite* write; ///< the word that puts back what was stored instead
};

/// For each word with a variable that would put back a saved value of the group, the assignments after which
/// it does not, on all paths or on one that the control can take. A new feed that is computed from the saved
/// one counts as put back, and a value that a word has put back already is not missed.
[[nodiscard]] std::vector<OverwrittenSave> overwritten_saves(const ProgramAnalysis& analysis);

} // namespace maclint::rules
