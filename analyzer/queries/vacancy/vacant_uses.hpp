//! Whether it matters that what is read is vacant.
#pragma once

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/execution/path_search.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

namespace maclint::queries {

/// By which a value that is not there does no harm.
namespace exemptions {
inline constexpr Exemption handed_on_without_a_value;
inline constexpr Exemption speed_for_some_cases;
inline constexpr Exemption word_before_an_alarm;
} // namespace exemptions

/// Whether the program does something with the value of the read: it moves by it, calculates with it, decides
/// by it. It does not where it only passes it on, as an argument or to a variable that nobody of this program
/// reads in turn, and where what it calculates is replaced before it is read.
[[nodiscard]] bool is_used(const ProgramAnalysis& analysis, const dataflow::Read& read);

/// A path to the word that reads a variable, on which nothing sets the variable, and after which the program
/// can go on as if nothing was wrong: a word that is ignored does no harm on the way to an alarm. `search` is
/// one of the same program.
[[nodiscard]] execution::PathFound
path_past_word(execution::PathSearch& search, const ProgramAnalysis& analysis, const dataflow::Read& read);

} // namespace maclint::queries
