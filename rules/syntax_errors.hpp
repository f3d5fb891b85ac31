//! Findings for what is wrong with a text before any flow is looked at.
#pragma once

#include "rules/rule.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

/// The messages of a rule for its syntax errors, by their ids.
struct SyntaxMessages {
    std::string_view with_cure = "cure";      ///< where a cure is known
    std::string_view without = "plain";       ///< else, or where the rule has no such message
    std::string_view elsewhere = "elsewhere"; ///< where another control of the family takes it: a warning
    std::string_view unknown = "unknown";     ///< where no document tells: a note
    std::optional<Severity> severity = {};    ///< where the control stops; nothing: that of the rule
    /// Only errors with one of these faults; none: those which no rule of its own tells.
    std::vector<std::string_view> faults = {};
    /// Whether another rule tells of the error; nullptr: none does.
    bool (*is_of_another)(const SyntaxError&) = nullptr;
};

/// One finding for every syntax error of the kind; the arguments of its message are the offending text, the
/// cure, and the names of the controls that take it. Errors with the same reason in one program have one
/// cause.
void report_syntax_error(const ProgramFile& file, SyntaxErrorKind kind, Reporter& reporter,
                         const SyntaxMessages& messages = {});

/// Tells for Finding::same_cause which errors of a file have one cause.
class SyntaxCauses {
  public:
    explicit SyntaxCauses(const ProgramFile& file)
        : file_(file) {}
    [[nodiscard]] std::string of(const SyntaxError& error);

  private:
    const ProgramFile& file_;
    std::vector<Offset> begins_; ///< of the programs, sorted: a main part may begin behind its subprograms
};

} // namespace maclint
