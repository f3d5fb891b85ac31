//! Findings counted by rule and by file.
#pragma once

#include "cli/report/report.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace maclint::cli {

struct RuleCount {
    const Rule* rule;
    const RuleRow* row; ///< nullptr: of a rule without rows
    Severity severity;  ///< a rule's findings may differ in it
    std::size_t findings;
};

struct FileCount {
    const Source* source;
    std::size_t findings;
};

/// Of all findings that no comment allows, shown or not; most first.
struct Statistics {
    std::vector<RuleCount> rules;
    std::vector<FileCount> files;
};
[[nodiscard]] Statistics statistics_of(const Report& report);

/// Two tables for people; of many files the first ones.
[[nodiscard]] std::string statistics_text(const Report& report);

} // namespace maclint::cli
