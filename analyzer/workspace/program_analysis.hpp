//! Everything that is known of one program: what rules are given.
#pragma once

#include "analyzer/dataflow/loops.hpp"
#include "analyzer/dataflow/solver/analysis.hpp"
#include "analyzer/dataflow/solver/liveness.hpp"
#include "analyzer/flow/graph.hpp"
#include "analyzer/flow/regions.hpp"
#include "analyzer/flow/shortest_paths.hpp"
#include "analyzer/program/call_kinds.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/source/made_once.hpp"
#include "analyzer/workspace/call_paths.hpp"
#include "analyzer/workspace/resolve.hpp"
#include "analyzer/workspace/search_memory.hpp"
#include "analyzer/workspace/workspace.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace maclint {

namespace machine {
class SwitchStates;
class States;
} // namespace machine

struct Caller {
    ProgramIndex program;
    EffectId effect;
};

/// The calls that may mean any of several programs of one number or name, equally near.
struct UndecidedCalls {
    std::vector<Caller> callers;
    std::vector<Variable> passed; ///< by some caller; sorted
    bool locals_shared = false;   ///< some caller shares its locals
};

/// Some of the calls that may mean a program. Where thousands of programs have one number, each would be
/// asked about the calls of thousands.
struct PossibleCallers {
    static constexpr std::size_t most = 100;
    std::vector<Caller> first; ///< not more than that
    bool all;                  ///< there are no others
};

/// One call in a program and the program of the workspace that it means.
struct CallSite {
    EffectId effect;
    std::optional<ProgramIndex> target; ///< empty: computed, not in the workspace, or several equally near
    bool in_cycle;                      ///< caller and callee call each other, perhaps through others
    bool closes_cycle;                  ///< it calls a program from which its own program was called
    std::size_t candidates;             ///< programs of that number or name in the workspace
    std::vector<dataflow::PassedReference> references; ///< of the target
};

/// How often each limit is used up on a chain of calls.
struct CallDepth {
    int macro = 0;
    int subprogram = 0;
};

/// Flow and data flow are there for programs that are asked for, their callers, and what these call.
class ProgramAnalysis {
  public:
    ProgramAnalysis(const Workspace& workspace, ProgramIndex index, const WorkspaceFile& file,
                    const Program& program);
    ProgramAnalysis(const ProgramAnalysis&) = delete;
    ProgramAnalysis& operator=(const ProgramAnalysis&) = delete;
    ~ProgramAnalysis();

    [[nodiscard]] const Workspace& workspace() const { return *workspace_; }
    [[nodiscard]] ProgramIndex index() const { return index_; }
    [[nodiscard]] const ProgramFile& file() const { return *file_->file; }
    [[nodiscard]] const std::shared_ptr<const Source>& source() const { return file_->file->source; }
    [[nodiscard]] bool asked() const { return file_->asked; }
    /// Every program of its control is in the workspace, or meant by no call of it.
    [[nodiscard]] bool complete() const { return file_->complete; }
    /// Names that the program need not define.
    [[nodiscard]] const NamesElsewhere& names_elsewhere() const { return file_->names_elsewhere; }
    [[nodiscard]] const Program& program() const { return *program_; }
    [[nodiscard]] const ControlModel& control() const { return *program_->control; }
    [[nodiscard]] const flow::Regions& regions() const { return regions_; }
    [[nodiscard]] const flow::Graph& graph() const { return graph_; }
    [[nodiscard]] const dataflow::Analysis& data() const { return *data_; }
    /// A shortest path from the program's start to the node, over edges that can be taken; nothing when there
    /// is none. May be asked on several threads.
    [[nodiscard]] std::optional<std::vector<flow::EdgeId>> path_from_start(flow::NodeId node) const;
    [[nodiscard]] const dataflow::Facts& facts() const { return data_->facts(); }
    /// Which stored values may still be read. May be asked on several threads.
    [[nodiscard]] const dataflow::Liveness& liveness() const;
    /// What the machine is doing at its blocks. May be asked on several threads.
    [[nodiscard]] const machine::States& machine() const;
    /// What is switched on and off at its blocks. May be asked on several threads.
    [[nodiscard]] const machine::SwitchStates& switches() const;
    /// What is learnt about the program while paths through it are looked for.
    [[nodiscard]] SearchMemory& search_memory() const { return search_memory_; }
    [[nodiscard]] const std::vector<dataflow::Loop>& loops() const { return loops_; }
    /// Cycles that nothing ends.
    [[nodiscard]] const std::vector<dataflow::Loop>& inescapable_cycles() const {
        return inescapable_cycles_;
    }
    [[nodiscard]] const dataflow::Summary& summary() const { return data_->summary(); }

    /// The blocks that a jump can reach; none when that is unknown.
    [[nodiscard]] std::vector<flow::LabelledBlock> targets_of(const flow::ResolvedJump& jump) const;
    /// The first jump that can go to the label, or call that can return there.
    [[nodiscard]] std::optional<EffectId> user_of_label(const Label& label) const;
    /// The modal calls of this program that are active in the state at a node: where each was made. None when
    /// an unknown program may have ended them.
    [[nodiscard]] std::vector<dataflow::OriginId> own_modal_calls(const dataflow::State& state,
                                                                  flow::NodeId node) const;

    [[nodiscard]] const std::vector<CallSite>& calls() const { return calls_; }
    [[nodiscard]] const CallSite* call_at(EffectId effect) const;
    /// The word of a file of definitions that the call names instead of a program, where it is known what it
    /// does there: beside other words one that sets something may be any piece of the block. Otherwise
    /// nullptr.
    [[nodiscard]] const GivenWord* word_at(EffectId call) const;
    [[nodiscard]] const std::vector<Caller>& callers() const { return callers_; }
    /// Calls that mean this program or another one, equally near: the first of them.
    [[nodiscard]] PossibleCallers possible_callers() const;
    [[nodiscard]] bool has_possible_callers() const { return !undecided_.empty(); }
    /// It runs on its own: nobody calls it, and it does not return to anybody.
    [[nodiscard]] bool is_main() const { return data_->entry() == dataflow::Entry::main; }
    /// Whether a call of it gives it local variables of its own: a caller does so, or it reads arguments and
    /// its callers are unknown.
    [[nodiscard]] bool is_macro() const { return is_macro_; }
    /// It calls itself, directly or through others.
    [[nodiscard]] bool is_recursive() const { return recursive_; }
    /// How deep the deepest calls of the workspace that reach it are.
    [[nodiscard]] CallDepth depth() const { return depth_; }
    /// It is called over more levels than any control takes: states are not followed into it, for each level
    /// is one of the C++ stack, too.
    [[nodiscard]] bool is_too_deep() const {
        constexpr int most_levels = 100;
        return depth_.macro + depth_.subprogram > most_levels;
    }
    /// Calls that lead from this program to another; none when there is no such path or it is the same
    /// program. May be asked on several threads.
    [[nodiscard]] CallPath path_to(ProgramIndex program) const;
    /// The calls along that path for the limit, outermost first.
    [[nodiscard]] std::vector<Caller> chain_to(NestingLimit nesting) const;

  private:
    friend class Workspace;
    friend class WorkspaceBuilder;
    /// The program whose states the call's caller takes over; nullptr: they are unknown.
    [[nodiscard]] const ProgramAnalysis* followed(const CallSite* site) const;

    const Workspace* workspace_;
    ProgramIndex index_;
    const WorkspaceFile* file_;
    const Program* program_;
    flow::Regions regions_;
    flow::Graph graph_;
    std::optional<dataflow::Analysis> data_;
    std::vector<dataflow::Loop> loops_, inescapable_cycles_;
    mutable MadeOnce<flow::ShortestPaths> paths_; ///< most programs have no finding
    mutable MadeOnce<dataflow::Liveness> liveness_;
    mutable MadeOnce<std::unique_ptr<const machine::States>> machine_;
    mutable MadeOnce<std::unique_ptr<const machine::SwitchStates>> switches_;
    mutable SearchMemory search_memory_;
    std::vector<CallSite> calls_;
    std::vector<Caller> callers_;
    std::vector<std::shared_ptr<const UndecidedCalls>> undecided_; ///< that may mean it
    bool is_macro_ = false;
    bool locals_are_callers_ = false; ///< some caller shares its own with it, or may
    bool recursive_ = false;
    CallDepth depth_;
    std::optional<Caller> deepest_macro_caller_, deepest_subprogram_caller_;
};

} // namespace maclint
