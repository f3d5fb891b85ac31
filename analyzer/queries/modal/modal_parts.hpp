//! What one thing that a modal group can be is: a code, a value, whose it is.
#pragma once

#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/program/modal_groups.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace maclint::queries {

/// The number of the code; nothing when it is computed, or the caller's.
[[nodiscard]] std::optional<double> code_of(const ProgramAnalysis& analysis, const dataflow::ModalPart& part);

/// The code of the part, when a literal word of this program set it: `G91`, not `G#3`.
[[nodiscard]] std::optional<double> own_code(const ProgramAnalysis& analysis,
                                             const dataflow::ModalPart& part);

/// Whether the part is a code of this program's own that is no customary one of its group.
[[nodiscard]] bool is_switched_on(const ProgramAnalysis& analysis, const ModalGroup& group,
                                  const dataflow::ModalPart& part);

/// Whether it may be what was in force in the group when the program began: nothing in this program set it,
/// or a word put it back.
[[nodiscard]] bool may_be_callers(const ProgramAnalysis& analysis, GroupId group,
                                  const dataflow::ModalPart& part);

/// What the number that a word asks for is made of.
enum class NumberSource : std::uint8_t {
    constant,   ///< written, or known from what is written
    at_start,   ///< what a variable held when the program began: an argument
    calculated, ///< the result of an operation on something unknown
    other,      ///< a state that was read, or one of several values
};
[[nodiscard]] NumberSource source_of(const ProgramAnalysis& analysis, const dataflow::ModalPart& part);

/// Whether the word at the point sets the group of that role, to another code than each that can be in force
/// there. False where one of the codes is unknown.
[[nodiscard]] bool sets_another_code(const ProgramAnalysis& analysis, const dataflow::PointState& point,
                                     ModalRole role);

/// The effects of this program whose setting of some group is in force at a return; sorted.
[[nodiscard]] std::vector<EffectId> effects_in_force_at_return(const ProgramAnalysis& analysis);

} // namespace maclint::queries
