//! The baselines of a run: which findings they know, and what they are when it ends.
#pragma once

#include "cli/engine/engine.hpp"
#include "cli/engine/snapshot.hpp"
#include "cli/gate/baseline_file.hpp"
#include "cli/gate/baseline_store.hpp"
#include "cli/notice.hpp"

#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace maclint::cli {

/// What a run is to do with baselines, besides marking findings.
struct BaselineWishes {
    std::string read;  ///< --baseline, which files of the snapshot name, too; empty: each file's own
    std::string write; ///< --write-baseline; empty: no
    bool prune = false;
    bool fail_on_gone = false; ///< --fail-on-gone, which wants a baseline

    [[nodiscard]] NamedBy named_by() const {
        return read.empty() ? NamedBy::configuration : NamedBy::command_line;
    }
};

/// Read before files are analysed, so that nobody waits for a name that is wrong.
class KnownFindings {
  public:
    /// What is wrong ends the run.
    [[nodiscard]] static std::variant<KnownFindings, Notice>
    read(BaselineWishes wishes, const Snapshot& snapshot, BaselineStore& store);

    [[nodiscard]] bool in_use() const { return !baselines_.empty() || !wishes_.write.empty(); }

    /// Marks the findings that are known and writes what is to be written; says what is worth telling.
    [[nodiscard]] std::vector<Notice> mark(const Snapshot& snapshot, Result& result);
    /// Whether the last call met entries that are gone from the files checked, and left them in.
    [[nodiscard]] bool has_stale_entries() const { return has_stale_entries_; }

  private:
    BaselineWishes wishes_;
    std::map<std::string, std::shared_ptr<const Baseline>> baselines_; ///< by path
    bool has_stale_entries_ = false;
};

} // namespace maclint::cli
