//! Holds what a run shows against what the analysis claims of every run.
#pragma once

#include "analyzer/execution/stepper.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace maclint::test {

/// Variables that are looked at as a whole: at calls, at the begin and the end of programs.
using Watched = std::vector<Variable>;

class HeldAgainstFacts {
  public:
    explicit HeldAgainstFacts(const Workspace& workspace);

    /// Before each run.
    void begin();
    /// To be called with every event of the run.
    void observe(execution::Stepper& stepper, const execution::Event& event);
    /// After the run: what is claimed of whole paths. `machine_stood_still`: two reads of one of its values
    /// gave the same.
    void end(bool machine_stood_still);

    /// The first claim that a run has shown to be false.
    [[nodiscard]] const std::optional<std::string>& refuted() const { return refuted_; }
    /// How often each kind of claim was held against a run.
    [[nodiscard]] const std::map<std::string, std::size_t>& held() const { return held_; }

  private:
    using Content = semantics::Content;
    /// One program that is under way.
    struct Level {
        const ProgramAnalysis* analysis;
        std::vector<Content> variables; ///< at the start, of watched_
        std::vector<double> codes;      ///< at the start, of all groups
        std::vector<Content> before_call;
        std::optional<flow::NodeId> node;
        std::optional<EffectId> effect;   ///< the last one in the node
        Offset offset = 0;                ///< of the last plain block in the node
        std::optional<double> jumped_to;  ///< the label that a computed jump has just named
        std::vector<flow::EdgeId> path;   ///< from the program's start
        std::optional<std::size_t> cycle; ///< of the inescapable ones of the analysis
        Offset block = 0;                 ///< that is under way
    };

    void on(execution::Stepper& stepper, const execution::ProgramBegins& event);
    void on(execution::Stepper& stepper, const execution::BlockBegins& event);
    void on(execution::Stepper& stepper, const execution::EffectBegins& event);
    void on(execution::Stepper& stepper, const execution::VariableRead& event);
    void on(execution::Stepper& stepper, const execution::GroupRead& event);
    void on(execution::Stepper& stepper, const execution::Applied& event);
    void on(execution::Stepper& stepper, const execution::Compared& event);
    void on(execution::Stepper&, const execution::ValueTaken&) {} // its parts have events of their own
    void on(execution::Stepper& stepper, const execution::Decided& event);
    void on(execution::Stepper& stepper, const execution::Stored& event);
    void on(execution::Stepper& stepper, const execution::GroupSet& event);
    void on(execution::Stepper& stepper, const execution::JumpComputed& event);
    void on(execution::Stepper& stepper, const execution::CallBegins& event);
    void on(execution::Stepper& stepper, const execution::CallEnds& event);
    void on(execution::Stepper& stepper, const execution::ProgramLeft& event);

    /// What is claimed of every group at a block.
    struct BlockClaims {
        bool reached;
        bool falls_through; ///< the run may pass it by
        std::vector<queries::Modes> before, with_words;
    };
    using ClaimsByBlock = std::map<Offset, BlockClaims>;
    [[nodiscard]] static ClaimsByBlock claims_of(const ProgramAnalysis& analysis);
    void check_modes(execution::Stepper& stepper, const std::vector<queries::Modes>& modes,
                     const std::string& kind);
    [[nodiscard]] bool allows(const queries::Modes& modes, GroupId group, double code) const;

    void come_to(flow::NodeId node, bool goes_on);
    [[nodiscard]] std::optional<std::vector<flow::EdgeId>> path(const ProgramAnalysis& analysis,
                                                                flow::NodeId from, flow::NodeId to,
                                                                std::optional<double> jumped_to = {});
    void check_exit(execution::Stepper& stepper, const execution::ProgramLeft& left);
    void check_summary(execution::Stepper& stepper, const execution::ProgramLeft& left);
    void check_stop();
    [[nodiscard]] static bool in_a_later_round(const Level& level, const dataflow::Loop& loop);
    void check_path(const Level& level);
    void check_changes(execution::Stepper& stepper, EffectId call);

    [[nodiscard]] Watched watched_in(const ProgramAnalysis& analysis) const;
    [[nodiscard]] std::optional<Content> value_of(dataflow::SymbolId id) const;
    [[nodiscard]] bool allows(const dataflow::Value& value, Content content) const;
    [[nodiscard]] bool allows(const dataflow::ModalValue& value, double code) const;
    void claim(bool holds, const std::string& kind, const std::string& what);
    [[nodiscard]] const dataflow::Facts& facts() const { return levels_.back().analysis->facts(); }

    const Workspace& workspace_;
    std::unordered_map<const ProgramAnalysis*, Watched> watched_;
    std::unordered_map<const ProgramAnalysis*, ClaimsByBlock> claims_by_block_;
    std::map<std::tuple<const ProgramAnalysis*, flow::NodeId, flow::NodeId, std::optional<double>>,
             std::optional<std::vector<flow::EdgeId>>>
        paths_;
    std::vector<Level> levels_;
    std::vector<Level> left_; ///< the levels of this run that are left
    std::optional<std::string> refuted_;
    std::map<std::string, std::size_t> held_;
};

} // namespace maclint::test
