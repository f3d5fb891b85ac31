//! Variables that nothing has set, in words.
#pragma once

#include "analyzer/queries/vacancy/unset_reads.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <string>

namespace maclint::rules {

/// The variable as the program names it: an alias, not the number after it; without the brackets around it.
[[nodiscard]] std::string as_written(const ProgramAnalysis& analysis, ExpressionId expression);

/// "#31", "#31 and #32", "#31 and 3 others".
[[nodiscard]] std::string names_of(const ProgramAnalysis& analysis, const queries::UnsetReads& reads);

/// "#4120 = 11, 12 or 13"; where it depends on more, what on: "#4120 and #7".
[[nodiscard]] std::string words_for_cases(const ProgramAnalysis& analysis,
                                          const queries::MissingCase& missing);

/// The name of the message that says why nothing may be there.
[[nodiscard]] std::string_view message_of(const ProgramAnalysis& analysis, const queries::UnsetReads& reads);

} // namespace maclint::rules
