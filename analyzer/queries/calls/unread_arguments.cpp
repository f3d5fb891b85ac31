//! Compares what calls pass with what is live at the start of the called program.
#include "analyzer/queries/calls/unread_arguments.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/dataflow/solver/index_reach.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/call_words.hpp"
#include "analyzer/queries/calls/callers.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace maclint::queries {
namespace {

/// Whether what it reads of its arguments stands in its text: no index can reach them by the custom of
/// programmers (IndexCustom).
bool reads_by_name(const ProgramAnalysis& analysis) {
    const Program& program = analysis.program();
    dataflow::IndexReaches reaches(program, analysis.graph());
    const auto through_index = [&](const Expression& expression) {
        const auto* load = std::get_if<LoadAt>(&expression.node);
        if (load == nullptr) return false;
        // What callers put into a variable that all share is theirs to say.
        const auto index = dataflow::variables_of(program, load->index).variables;
        const bool is_own = std::ranges::all_of(index, [&](Variable variable) {
            return analysis.control().spaces[variable.space].scope == Scope::frame;
        });
        if (!is_own) return true;
        const flow::NodeId node = analysis.graph().node_of(expression.span).value_or(0);
        return reaches.of(load->family, load->index, {}, node).locals;
    };
    bool by_name = std::ranges::none_of(program.expressions, through_index);
    for_each_effect(program, [&](EffectId id) {
        const auto& what = program.effects[id].what;
        const auto* call = std::get_if<Call>(&what);
        by_name &= !std::holds_alternative<UnreadableBlock>(what) &&
                   (call == nullptr || program.control->calls[call->kind].frame != Frame::shared);
    });
    return by_name;
}

/// `K1.I2.`: whether I begins another set of I, J and K, and means #7, depends on their order and on a
/// parameter of the control.
bool is_of_a_series(const ControlModel& control, Variable variable, const Program& program,
                    const Argument& argument) {
    const auto holds = [&](const auto& set) { return std::ranges::find(set, variable) != set.end(); };
    const auto letter = control.letter_of(variable);
    return letter && std::ranges::any_of(control.series, holds) &&
           to_capital(program.text[argument.span.begin]) != *letter;
}

/// The first store of the variable, when no block before it in the text reads it.
std::optional<EffectId> first_store(const Program& program, Variable variable) {
    std::optional<EffectId> store;
    for_each_effect(program, [&](EffectId id) {
        const auto* assign = std::get_if<Assign>(&program.effects[id].what);
        const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
        if (target != nullptr && *target == variable && !store) store = id;
    });
    if (!store) return std::nullopt;
    const Offset at = program.effects[*store].span.begin;
    const bool read_before = std::ranges::any_of(program.expressions, [&](const Expression& expression) {
        const auto* load = std::get_if<Load>(&expression.node);
        return load != nullptr && load->variable == variable && expression.span.begin < at;
    });
    return read_before ? std::nullopt : store;
}

/// Whether a block names the variable to read it.
bool names(const Program& program, Variable variable) {
    return std::ranges::any_of(program.expressions, [&](const Expression& expression) {
        const auto* load = std::get_if<Load>(&expression.node);
        return load != nullptr && program.meant_by(load->variable) == variable;
    });
}

/// The arguments that it may read as they were passed, of a program that reads them by name. What data flow
/// says of indices is more than that: it does not count on what programmers mean by them.
std::vector<Variable> arguments_read(const ProgramAnalysis& called) {
    std::vector<Variable> live = called.liveness().live_before(0);
    std::erase_if(live, [&](Variable variable) {
        return !can_be_passed(called.control(), variable) || !names(called.program(), variable);
    });
    return live;
}

/// Whether the call passes the variable, and somebody asked for its file. Calls within a cycle and those that
/// may mean another variable do not count.
bool passes(const ProgramAnalysis& called, const Caller& caller, Variable variable) {
    const ProgramAnalysis& calling = calling_program(called, caller);
    const Argument* argument = argument_for(called, caller, variable);
    const CallSite* site = calling.call_at(caller.effect);
    // M#0 passes nothing.
    const auto* value = argument == nullptr ? nullptr : &calling.program().expressions[argument->value].node;
    return value != nullptr && !std::holds_alternative<Vacant>(*value) && site != nullptr &&
           !site->in_cycle && calling.asked() && opens_locals(called, caller) &&
           !is_of_a_series(called.control(), variable, calling.program(), *argument);
}

/// Whether no call that stands before it passes the variable.
bool is_first_that_passes(const ProgramAnalysis& called, const Caller& call, Variable variable) {
    const auto first = std::ranges::find_if(
        called.callers(), [&](const Caller& caller) { return passes(called, caller, variable); });
    return first != called.callers().end() && first->program == call.program && first->effect == call.effect;
}

std::vector<Caller> others_that_pass(const ProgramAnalysis& called, const Caller& call, Variable variable) {
    std::vector<Caller> found;
    for (const Caller& caller : called.callers())
        if ((caller.program != call.program || caller.effect != call.effect) &&
            passes(called, caller, variable))
            found.push_back(caller);
    return found;
}

/// A called program: which arguments were looked at, and which of them it reads.
class Called {
  public:
    explicit Called(const ProgramAnalysis& analysis)
        : analysis_(analysis) {}

    /// Whether this is the first call, of those that were asked about, that passes the variable.
    bool takes(const Caller& call, Variable variable) {
        if (std::ranges::find(looked_at_, variable) != looked_at_.end() || !passes(analysis_, call, variable))
            return false;
        looked_at_.push_back(variable);
        return true;
    }
    /// Whether it certainly does not read it. A program that reads no argument may stand in for one that is
    /// still to be written.
    bool leaves_unread(Variable variable) {
        if (!by_name_) by_name_ = reads_by_name(analysis_);
        if (!*by_name_) return false;
        if (!read_) read_ = arguments_read(analysis_);
        if (read_->empty() && exemptions::program_to_be_written.is_on()) return false;
        return std::ranges::find(*read_, variable) == read_->end();
    }

  private:
    using Variables = std::vector<Variable>;
    const ProgramAnalysis& analysis_;
    Variables looked_at_;
    std::optional<bool> by_name_; ///< nothing: nobody has asked
    std::optional<Variables> read_;
};

} // namespace

std::vector<UnreadArgument> unread_arguments(const ProgramAnalysis& analysis) {
    std::vector<UnreadArgument> found;
    std::map<ProgramIndex, Called> programs;
    const Program& program = analysis.program();
    for (const CallSite& site : analysis.calls()) {
        const ProgramAnalysis* called = called_program(analysis, site);
        if (called == nullptr) continue;
        Called& known = programs.try_emplace(*site.target, *called).first->second;
        const Caller here{analysis.index(), site.effect};
        for (const Argument& argument : program.arguments_of(call_of(program, site.effect))) {
            const auto* variable = std::get_if<Variable>(&argument.given);
            if (variable == nullptr || !known.takes(here, *variable) ||
                !is_first_that_passes(*called, here, *variable) || !known.leaves_unread(*variable))
                continue;
            found.push_back({site.effect, called, &argument, *variable,
                             first_store(called->program(), *variable),
                             others_that_pass(*called, here, *variable)});
        }
    }
    return found;
}

} // namespace maclint::queries
