//! Names that a program uses and does not define, held against what else defines names.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

namespace maclint::queries {

/// One letter off something that is known, and nothing else has the name.
[[nodiscard]] bool is_misspelt(const ProgramAnalysis& analysis, const UnknownName& name);
/// Nothing has the name, as far as all names are known; not what is_misspelt() tells.
[[nodiscard]] bool is_undefined(const ProgramAnalysis& analysis, const UnknownName& name);
/// Whether the name that stands there is one that is_misspelt() tells.
[[nodiscard]] bool is_misspelt_at(const ProgramAnalysis& analysis, Span span);

} // namespace maclint::queries
