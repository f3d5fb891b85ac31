//! Findings of what acts on every later move until it is switched off.
#pragma once

#include "analyzer/program/modal_groups.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/rule.hpp"

#include <string>
#include <vector>

namespace maclint::rules {

/// The code that switched it on and what cancels it: "G42", "G40".
[[nodiscard]] std::vector<std::string> words_of(const ProgramAnalysis& analysis, GroupId id, double code);

/// Reports what `queries::left_at_end` finds: the arguments are the code and what cancels it.
void report_left_at_end(const ProgramAnalysis& analysis, ModalRole role, Reporter& reporter);

/// The check of rules that do nothing else.
template<ModalRole role>
void check_left_at_end(const ProgramAnalysis& analysis, Reporter& reporter) {
    report_left_at_end(analysis, role, reporter);
}

} // namespace maclint::rules
