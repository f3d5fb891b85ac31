//! Which of the findings count: what a baseline knows does not, nor what shows no line that has changed.
#pragma once

#include "cli/command_line.hpp"
#include "cli/engine/engine.hpp"
#include "cli/engine/snapshot.hpp"
#include "cli/gate/changed_lines.hpp"
#include "cli/gate/known_findings.hpp"
#include "cli/notice.hpp"

#include <optional>
#include <variant>
#include <vector>

namespace maclint::cli {

class Gate {
  public:
    /// Reads baselines, those that have changed since the store was asked last, and asks git, before files
    /// are analysed. What is wrong ends the run.
    [[nodiscard]] static std::variant<Gate, Notice> open(const CheckRequest& request,
                                                         const Snapshot& snapshot, BaselineStore& store);

    [[nodiscard]] bool has_baseline() const { return known_.in_use(); }
    [[nodiscard]] bool has_stale_entries() const { return known_.has_stale_entries(); }

    /// Marks findings that are known, then leaves out those that nothing changed at, then marks those of a
    /// maker's programs, and says what is worth telling.
    [[nodiscard]] std::vector<Notice> judge(const Snapshot& snapshot, Result& result);

  private:
    KnownFindings known_;
    std::optional<ChangedLines> changed_;
    std::string since_;
};

} // namespace maclint::cli
