//! Runs programs of the model block by block, with numbers: what the control would do with the program text
//! alone, everything else told by an Environment.
//!
//! A modal call (G66) acts on the moves of the program that made it and, when that one has returned, of its
//! caller; not on those of programs called from there. The analysis assumes the same.
#pragma once

#include "analyzer/execution/environment.hpp"
#include "analyzer/execution/events.hpp"
#include "analyzer/execution/layout.hpp"
#include "analyzer/program/names.hpp"
#include "analyzer/workspace/workspace.hpp"

#include <memory>
#include <unordered_map>
#include <vector>

namespace maclint::execution {

struct Bounds {
    std::size_t steps; ///< blocks and effects together
    std::size_t depth; ///< of calls, below the program that is started
};

/// A program to be started, and what its variables hold that a caller has set.
struct Start {
    ProgramIndex program;
    std::vector<std::pair<Variable, Content>> variables;
    std::optional<EffectId> from = {}; ///< an effect in whose block the run begins instead of the first one
};

class Stepper {
  public:
    /// The references must outlive the stepper.
    Stepper(const Workspace& workspace, const Environment& environment, Observer observer, Bounds bounds);

    /// Runs the program to its end, or until the bounds are met.
    Leaving run(const Start& start);

    // ---- for the observer

    /// The program that runs.
    [[nodiscard]] const ProgramAnalysis& program() const { return *levels_.back().analysis; }
    /// How many calls are open.
    [[nodiscard]] std::size_t depth() const { return levels_.size() - 1; }
    /// The effect that runs; nothing at the head of a block and in plain ones.
    [[nodiscard]] std::optional<EffectId> effect() const { return effect_; }
    /// What a variable of the running program holds.
    [[nodiscard]] Content content(Variable variable);
    [[nodiscard]] double code(GroupId id);
    /// From now on the variable of the running program holds this, whatever is being computed with it.
    void set(Variable variable, Content content) { content_of(variable) = content; }

  private:
    using Variables = std::unordered_map<Variable, Content, VariableHash>;

    struct Passed {
        Variable formal;
        Content content;
    };
    /// A call that is under way.
    struct Pending {
        EffectId effect; ///< the call; of a modal call that a called program has made, the call of that one
        CallKindId kind;
        std::optional<ProgramIndex> target;
        std::vector<Passed> arguments;
        std::int64_t times; ///< still to come
        bool modal = false; ///< after a move
    };
    struct Level {
        const ProgramAnalysis* analysis;
        const Layout* layout;
        std::shared_ptr<Variables> variables;
        Position at;
        std::optional<Pending> pending;
        std::optional<Pending> modal_call; ///< in force
    };

    void enter(ProgramIndex program, std::shared_ptr<Variables> variables);
    void leave(Leaving how, std::optional<EffectId> effect, std::optional<double> label);
    void resume(std::optional<double> label);
    void call_again();
    void call_unknown();
    [[nodiscard]] const Layout& layout_of(const ProgramAnalysis& analysis);

    void step();
    void run_effect(EffectId id);
    void go_to(EffectId after);
    void assign(const Assign& assign);
    void store_at(const StoreAt& target, Content content);
    void set_modal(const SetModal& set);
    void set_group(GroupId changed, Content content);
    void set_code(GroupId changed, double code);
    void stop(EffectId id, const Stop& stop);
    void pass_mark(EffectId id, const RegionMark& mark);
    void open(EffectId id, const flow::Region& region);
    void select(const flow::Region& region);
    void jump(const Jump& jump);
    void call(EffectId id, const Call& call);
    void return_to_caller(EffectId id, const Return& what);
    void exchange(const Exchange& exchange);
    void set_modal_call_code(CallKindId kind);
    void end_modal_call();
    void move();

    Content take(ExpressionId id);
    [[nodiscard]] Content evaluate(ExpressionId id);
    [[nodiscard]] Content load(ExpressionId id, Variable variable);
    [[nodiscard]] Content load_at(ExpressionId id, const LoadAt& load);
    [[nodiscard]] Content load_group(ExpressionId id, GroupId group);
    [[nodiscard]] Content apply(ExpressionId id, const Apply& apply);
    [[nodiscard]] bool truth(ExpressionId id);
    [[nodiscard]] bool compare(ExpressionId id, const Apply& apply);
    [[nodiscard]] bool decide(ExpressionId condition);

    void store(Variable variable, Content content);
    [[nodiscard]] Content& content_of(Variable variable);
    [[nodiscard]] Content& shared_content_of(Variable variable);
    [[nodiscard]] std::pair<Level*, Variable> owner_of(Variable variable);
    [[nodiscard]] std::optional<double>& group(GroupId id);

    [[nodiscard]] Level& top() { return levels_.back(); }
    [[nodiscard]] const Program& text() const { return levels_.back().analysis->program(); }
    [[nodiscard]] const ControlModel& control() const { return *text().control; }
    [[nodiscard]] bool done() const { return left_.has_value(); }
    void fault() { leave(Leaving::fault, effect_, std::nullopt); }
    void report(const Event& event) { observer_(*this, event); }

    const Workspace& workspace_;
    const Environment& environment_;
    Observer observer_;
    Bounds bounds_;
    std::size_t steps_ = 0;
    std::vector<Level> levels_;
    Variables shared_;
    Names shared_names_; ///< of variables that have names instead of numbers, which are the programs' own
    std::vector<std::optional<double>> codes_; ///< of modal groups, where they were asked for or set
    std::unordered_map<const ProgramAnalysis*, std::unique_ptr<Layout>> layouts_;
    std::optional<EffectId> effect_;
    std::optional<Leaving> left_;
};

} // namespace maclint::execution
