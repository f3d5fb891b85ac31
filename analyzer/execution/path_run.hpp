//! A run along one path with unknowns: numbers where they are known, elsewhere symbols, of which equal ones
//! are equal values, and what the decisions on the path have assumed of them.
#pragma once

#include "analyzer/dataflow/domain/interner.hpp"
#include "analyzer/dataflow/solver/transfer.hpp"
#include "analyzer/execution/assumptions.hpp"
#include "analyzer/execution/search_work.hpp"
#include "analyzer/execution/skips.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace maclint::execution {

/// What some blocks may change, each of them run any number of times, when a path comes to a node.
struct Changes {
    std::uint32_t id = 0;            ///< no other changes in the program have it
    flow::NodeId at = 0;             ///< the node
    std::vector<Variable> variables; ///< sorted, each once
    std::vector<Variable>
        fractions;               ///< of them, sorted: those that change by no whole number, or become none
    std::vector<SpaceId> spaces; ///< of which any variable may change
    bool machine = false;        ///< modal state, and what the machine does
};

/// Whether the node does anything but calculate, decide and jump.
[[nodiscard]] bool acts(const Program& program, const flow::Node& node);

class PathRun {
  public:
    /// What is known at a place of the path.
    struct Point {
        dataflow::State state;
        Assumptions::Id assumed = Assumptions::none;
        dataflow::Transfer::MachineTime time;
    };

    /// The analysis and the work must outlive the run. What a step makes of a point is remembered: many paths
    /// begin alike. It counts for the thread's Budget each time, so that it makes no difference who comes
    /// first, and as work once. One step may look at `most_of_a_step` expressions and assumptions.
    PathRun(const ProgramAnalysis& analysis, SearchWork& work, std::size_t most_of_a_step);

    [[nodiscard]] Point at_start() const { return {states_.at_entry(), Assumptions::none, {}}; }
    /// From before the node to after it.
    [[nodiscard]] Point run(flow::NodeId node, Point point);
    /// From after an edge's node to the end of the edge; nothing when who came this way cannot take it.
    [[nodiscard]] std::optional<Point> along(flow::EdgeId id, const Point& after);
    /// Whatever the changes have made of the point.
    [[nodiscard]] Point after_changes(const Changes& changes, Point point);
    /// Nothing that was assumed on the way is sure any more.
    static void forget_assumptions(Point& point) { point.assumed = Assumptions::none; }

    /// What makes a difference later, when only decisions on these variables come: two points that agree in
    /// it can go the same ways.
    [[nodiscard]] std::uint64_t fingerprint(const Point& point, std::span<const Variable> deciding);
    /// Whether some variable of one list has the same value as one of the other, and that is no known number.
    [[nodiscard]] bool share_a_value(const Point& point, std::span<const Variable> some,
                                     std::span<const Variable> others);

  private:
    /// A step that was taken: the node, edge or changes, and the point before it.
    struct Step {
        enum class Kind : std::uint8_t { node, edge, rounds } kind;
        std::uint32_t id;
        dataflow::Root root;
        dataflow::HavocId havoc;
        Assumptions::Id assumed;
        dataflow::Transfer::MachineTime time;
        friend bool operator==(const Step&, const Step&) = default;
    };
    friend std::uint64_t hash_local(const Step& step) { return hash_mixed(step); }
    friend std::uint64_t hash_mixed(const Step& step);
    /// What `take` makes of the point, asked once for the same.
    template<class Take>
    [[nodiscard]] std::optional<Point> remembered(Step::Kind kind, std::uint32_t id, const Point& before,
                                                  const Take& take);
    [[nodiscard]] Point run_now(flow::NodeId node, Point point);
    [[nodiscard]] std::optional<Point> along_now(flow::EdgeId id, const Point& after);
    [[nodiscard]] dataflow::Root unknown_after(const Changes& changes);
    [[nodiscard]] Point change(const Changes& changes, Point point);
    [[nodiscard]] bool may_store_in_machine(const flow::Node& node) const;
    [[nodiscard]] bool assume_is(Point& point, dataflow::SymbolId subject, bool holds);
    [[nodiscard]] bool assume_switches(Point& point, const Switches& switches);
    [[nodiscard]] bool assume_outcome(Point& point, const dataflow::State& before, ExpressionId condition,
                                      bool holds);
    [[nodiscard]] bool assume(Point& point, const dataflow::State& before, ExpressionId condition,
                              bool holds);
    [[nodiscard]] bool assume_some(Point& point, const dataflow::State& before,
                                   std::span<const ExpressionId> operands, bool holds);
    [[nodiscard]] bool assume_one(Point& point, const Assumptions::Found& found);
    /// The comparison or vacancy test that a condition is, where that turned out so; NOT is looked through.
    [[nodiscard]] std::optional<Assumptions::Found> comparison_in(const dataflow::State& before,
                                                                  ExpressionId condition, bool holds);
    /// What a decision can ask of the value with this number in the table.
    [[nodiscard]] std::uint64_t print_of(std::uint32_t value);
    /// As the value of the variable at that place of a list; returns the place where it was seen first.
    std::uint32_t see(dataflow::SymbolId id, std::uint32_t place);
    [[nodiscard]] bool is_seen(dataflow::SymbolId id) const {
        return id < seen_.size() && seen_[id].in == fingerprints_;
    }
    [[nodiscard]] bool can_be_seen(dataflow::SymbolId id) const;
    [[nodiscard]] bool counts(const Assumptions::Assumption& assumption) const;
    void print_assumption(std::uint64_t& print, const Assumptions::Assumption& assumption) const;

    const Program& program_;
    const flow::Graph& graph_;
    SearchWork& work_;
    dataflow::States states_; ///< of its own: rules ask on several threads
    dataflow::Transfer transfer_;
    Assumptions assumptions_;
    Skips skips_;
    dataflow::Interner<Step> steps_;
    struct Taken {
        std::optional<Point> after;
        std::size_t work;
    };
    std::vector<Taken> taken_; ///< what came of each step
    std::size_t most_of_a_step_;
    std::unordered_map<std::uint32_t, dataflow::Root> unknown_; ///< by id of changes, see unknown_after
    std::vector<GroupId> asked_groups_;                         ///< that the program reads somewhere
    bool reads_by_index_ = false;                               ///< #[#1]
    std::vector<std::uint64_t> prints_;                         ///< of values, see print_of; 0: not asked for
    /// The last fingerprint that counts a symbol, and the place of its first variable there.
    struct Seen {
        std::uint32_t in = 0, place = 0;
    };
    std::vector<Seen> seen_;         ///< of each symbol
    std::uint32_t fingerprints_ = 0; ///< how many were asked for
};

} // namespace maclint::execution
