//! From files to judged findings: what the command, the tests and an editor ask for.
#pragma once

#include "cli/engine/connections.hpp"
#include "cli/engine/outline_store.hpp"
#include "cli/engine/program_store.hpp"
#include "cli/engine/read_as.hpp"
#include "cli/engine/snapshot.hpp"
#include "cli/engine/timing.hpp"
#include "cli/filter/apply_suppressions.hpp"
#include "cli/progress.hpp"

#include <cstddef>
#include <memory>
#include <stop_token>
#include <utility>
#include <vector>

namespace maclint::cli {

/// A maker's program, whose users will not change it.
struct VendorProgram {
    const Source* source; ///< of the findings in it
    Span text;
};

struct Result {
    std::vector<FilteredFinding> findings = {}; ///< in the order of reports
    std::vector<Notice> notices = {}; ///< on files that were asked for, in the order of the snapshot
    std::vector<std::shared_ptr<const Source>> sources =
        {};                                 ///< of files that were asked for and linted, as above
    std::vector<ReadAs> read_as = {};       ///< each of `sources`
    std::vector<VendorProgram> vendor = {}; ///< those whose warnings and notes nobody asked for
    Timing timing = {};
    bool cancelled = false; ///< somebody asked to stop: the rest is empty
};

struct EngineOptions {
    unsigned jobs = 1;          ///< threads, at least 1
    std::size_t kept_bytes = 0; ///< of text, whose programs are kept for the next snapshot; with any, what a
                                ///< look at the others has shown is kept, too
    ExemptionChoice exemptions = {};
};

/// Analyses one snapshot after the other. Only programs that calls connect with those that were asked for
/// are read whole, group by group; a group is let go when its rules have run.
class Engine {
  public:
    Engine(EngineOptions options, Progress& progress)
        : options_(std::move(options))
        , progress_(progress)
        , store_(options.kept_bytes) {}

    [[nodiscard]] Result analyse(const Snapshot& snapshot, const std::stop_token& stop = {});
    [[nodiscard]] const ProgramStore& store() const { return store_; }
    /// What looks at files have shown: others may ask and add. May be asked on several threads.
    [[nodiscard]] OutlineStore& outlines() { return outlines_; }
    /// How many files were looked at, because what they show was not known.
    [[nodiscard]] std::size_t looks() const { return looks_; }

  private:
    EngineOptions options_;
    Progress& progress_;
    ProgramStore store_;
    OutlineStore outlines_;
    std::shared_ptr<const Connections> connections_; ///< of the last snapshot
    std::size_t looks_ = 0;
};

} // namespace maclint::cli
