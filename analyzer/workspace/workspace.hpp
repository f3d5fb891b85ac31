//! Many files together: which program a call means, what each program does to its callers, how deep calls go.
#pragma once

#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/source/made_once.hpp"
#include "analyzer/workspace/names_elsewhere.hpp"

#include <cstddef>
#include <deque>
#include <memory>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace maclint {

class CallPaths;
class ProgramAnalysis;

/// A file of the workspace.
struct WorkspaceFile {
    std::shared_ptr<const ProgramFile> file;
    bool asked; ///< findings are wanted; otherwise it is there only for callers and callees
    /// The configuration declares that every program of its control is there: in the workspace, or meant by
    /// no call of a program in it.
    bool complete = false;
    /// Some call whose program only the running program knows may mean one of this file's that other files
    /// can call.
    bool may_be_computed = false;
    /// Programs that the control may run for codes of the machine's own (O9010) are in its folder.
    bool has_macros_for_codes = false;
    NamesElsewhere names_elsewhere = {}; ///< that its programs may use
};

struct WorkspaceOptions {
    unsigned jobs;                                      ///< threads to use, at least 1
    dataflow::FactSet facts = dataflow::FactSet::all(); ///< that rules ask for; others may not be recorded
};

class Workspace {
  public:
    /// Builds flow and data flow of programs, callees before callers: of those that are asked for, of
    /// whatever calls them, and of what all these call. Analyses refer to their workspace: it does not move.
    static std::unique_ptr<Workspace> analyse(std::vector<WorkspaceFile> files,
                                              const WorkspaceOptions& options);

    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;
    ~Workspace();

    [[nodiscard]] std::span<const WorkspaceFile> files() const { return files_; }
    /// One analysis a program, in the order of files and programs. References stay valid.
    [[nodiscard]] const std::deque<ProgramAnalysis>& programs() const;
    /// How many programs have the name. May be asked on several threads.
    [[nodiscard]] std::size_t count_named(std::string_view name) const;

  private:
    friend class ProgramAnalysis;
    friend class WorkspaceBuilder;
    Workspace();
    std::vector<WorkspaceFile> files_;
    std::unique_ptr<std::deque<ProgramAnalysis>> programs_;
    std::unique_ptr<CallPaths> call_paths_;
    mutable MadeOnce<std::unordered_map<std::string_view, std::size_t>> named_;
    std::vector<std::int32_t> ambiguous_names_; ///< numbers that several shared names have; sorted
};

} // namespace maclint
