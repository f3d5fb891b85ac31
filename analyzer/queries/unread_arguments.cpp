//! Compares what calls pass with what is live at the start of the called program.
#include "analyzer/queries/unread_arguments.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/queries/callers.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace maclint::queries {
namespace {

/// Whether what it reads of its arguments stands in its text.
bool reads_by_name(const Program& program) {
    const auto through_index = [](const Expression& expression) {
        return std::holds_alternative<LoadAt>(expression.node);
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
           program.text[argument.span.begin] != *letter;
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

bool is_named(const Program& program, Variable variable) {
    return std::ranges::any_of(program.expressions, [&](const Expression& expression) {
        const auto* load = std::get_if<Load>(&expression.node);
        return load != nullptr && program.meant_by(load->variable) == variable;
    });
}

/// #18 in the text, which no expression reads: a remark on an option.
bool is_told_of(const Program& program, Variable variable) {
    const std::string_view text = program.slice(program.span);
    const std::string name = program.spell(variable);
    const auto goes_on = [&](std::size_t at) {
        return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
    };
    for (auto at = text.find(name); at != text.npos; at = text.find(name, at + 1))
        if (!goes_on(at + name.size())) return true;
    return false;
}

/// The arguments that it may read as they were passed.
std::vector<Variable> arguments_read(const ProgramAnalysis& called) {
    std::vector<Variable> live = called.liveness().live_before(0);
    const auto& formals = called.control().formals;
    std::erase_if(live,
                  [&](Variable variable) { return std::ranges::find(formals, variable) == formals.end(); });
    return live;
}

bool passes(const ProgramAnalysis& analysis, const Caller& caller, Variable variable) {
    const Program& program = calling_program(analysis, caller).program();
    const decltype(Argument::given) given = variable;
    const auto arguments = program.arguments_of(call_of(program, caller.effect));
    return std::ranges::find(arguments, given, &Argument::given) != arguments.end();
}

/// The calls that pass it, those of files that somebody asked for.
std::vector<Caller> all_that_pass(const ProgramAnalysis& called, Variable variable) {
    std::vector<Caller> found;
    for (const Caller& caller : called.callers())
        if (calling_program(called, caller).asked() && passes(called, caller, variable))
            found.push_back(caller);
    return found;
}

/// The arguments that a called program reads, and those that were looked at.
struct Looked {
    std::vector<Variable>
        read; ///< none: nothing is known, or it stands in for one that is still to be written
    std::vector<Variable> at = {};
};

Looked look_at(const ProgramAnalysis& called) {
    return {reads_by_name(called.program()) ? arguments_read(called) : std::vector<Variable>{}};
}

/// What becomes of an argument that is not read as it was passed; nothing where a remark tells of it, or
/// where a block reads it that no path reaches.
std::optional<std::optional<EffectId>> fate_of(const Program& called, Variable variable) {
    const auto store = first_store(called, variable);
    if (!store && (is_named(called, variable) || is_told_of(called, variable))) return std::nullopt;
    return store;
}

} // namespace

std::vector<UnreadArgument> unread_arguments(const ProgramAnalysis& analysis) {
    std::vector<UnreadArgument> found;
    std::map<ProgramIndex, Looked> programs;
    const Program& program = analysis.program();
    for (const CallSite& site : analysis.calls()) {
        const ProgramAnalysis* called = called_program(analysis, site);
        const Call& call = call_of(program, site.effect);
        if (called == nullptr || site.in_cycle || analysis.control().calls[call.kind].frame != Frame::fresh)
            continue;
        auto known = programs.find(*site.target);
        if (known == programs.end()) known = programs.emplace(*site.target, look_at(*called)).first;
        Looked& looked = known->second;
        if (looked.read.empty()) continue;
        for (const Argument& argument : program.arguments_of(call)) {
            const auto* variable = std::get_if<Variable>(&argument.given);
            if (variable == nullptr || std::ranges::find(looked.read, *variable) != looked.read.end() ||
                std::ranges::find(looked.at, *variable) != looked.at.end())
                continue;
            looked.at.push_back(*variable);
            if (is_of_a_series(called->control(), *variable, analysis.program(), argument)) continue;
            const auto fate = fate_of(called->program(), *variable);
            std::vector<Caller> callers = fate ? all_that_pass(*called, *variable) : std::vector<Caller>{};
            if (callers.empty() || callers.front().effect != site.effect ||
                callers.front().program != analysis.index())
                continue;
            callers.erase(callers.begin());
            found.push_back({site.effect, called, &argument, *variable, *fate, std::move(callers)});
        }
    }
    return found;
}

} // namespace maclint::queries
