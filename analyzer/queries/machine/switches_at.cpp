//! Reads the switches of a node, and asks the callers what they leave.
#include "analyzer/queries/machine/switches_at.hpp"

#include "analyzer/program/channels.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/program/word_condition.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/structure/sections.hpp"

#include <algorithm>
#include <charconv>
#include <variant>

namespace maclint::queries {
namespace {

using machine::Switched;

constexpr std::size_t most_callers = 50; ///< of one program

void add(Switched& all, const Switched& more) {
    all.can_be = static_cast<std::uint8_t>(all.can_be | more.can_be);
    all.on_at = std::min(all.on_at, more.on_at);
    all.off_at = std::min(all.off_at, more.off_at);
}

Switched unknown() { return {Switched::unknown, Switched::nowhere, Switched::nowhere}; }

/// Whether channels share the switch, and nobody knows who is first.
bool is_shared(const ProgramAnalysis& analysis, std::size_t of) {
    return analysis.program().has_several_channels() &&
           analysis.control().switches[of].where == Switch::Where::machine;
}

/// Whether a code that acts on the switch may stand in the run.
bool may_change_in(const Program& program, const PlainRun& run, const Switch& one) {
    const syntax::PlainTables& tables = *program.plain_tables.at(run.tables);
    bool may = false;
    for (const std::string_view codes : {one.on, one.off, one.either})
        for_each_part(codes, ',', [&](std::string_view code) {
            double number = 0;
            const std::size_t end = std::min(code.find(' '), code.size());
            const bool is_code =
                std::from_chars(code.data() + 1, code.data() + end, number).ec == std::errc{};
            const auto& rows = tables.codes.front().rows;
            syntax::CodeSet kinds;
            if (code.front() == 'G' && is_code && number < static_cast<double>(rows.size())) {
                kinds.add(rows.at(static_cast<std::size_t>(number)).kind);
                may = may || run.words.codes.meets(kinds);
            } else {
                may = may || run.words.addresses.meets(addresses_named(program, code.substr(0, 1)));
            }
        });
    return may;
}

machine::SwitchState at_begin_of_section(const ControlModel& control) {
    machine::SwitchState state;
    state.is_reached = true;
    for (std::size_t i = 0; i < control.switches.size(); ++i) state.all[i].can_be = Switched::off;
    return state;
}

/// The blocks of the section that begin in the part.
void run_section(const Program& program, const Section& section, const machine::SwitchStepper& stepper,
                 Span part, machine::SwitchState& state) {
    for (ItemId item = section.items.first; item < section.items.first + section.items.count; ++item) {
        const Span span = program.span_of(item);
        if (span.end <= part.begin || span.begin >= part.end) continue;
        const Span common{std::max(span.begin, part.begin), std::min(span.end, part.end)};
        for_each_block_with_words(program, Stretch{item, common},
                                  [&](const BlockView& block, std::span<const Word> words) {
                                      if (part.begin <= block.span.begin && block.span.begin < part.end)
                                          stepper.run(block, words, state);
                                  });
    }
}

/// Whether a job is over there: not a part of one that a caller goes on with.
bool ends_job(const ProgramAnalysis& analysis, const flow::Exit& exit) {
    return exit.kind == flow::ExitKind::ends || exit.kind == flow::ExitKind::restarts ||
           (exit.kind == flow::ExitKind::runs_off && analysis.is_main());
}

} // namespace

std::optional<std::size_t> find_switch(const ControlModel& control, std::string_view name) {
    const auto found = std::ranges::find(control.switches, name, &Switch::name);
    if (found == control.switches.end()) return std::nullopt;
    return static_cast<std::size_t>(found - control.switches.begin());
}

SwitchesAt::SwitchesAt(const ProgramAnalysis& analysis)
    : analysis_(analysis) {}

/// With what the callers leave in place of what nobody has switched since the program began.
Switched SwitchesAt::resolved(const ProgramAnalysis& analysis, std::uint8_t channel, Switched here,
                              std::size_t of) {
    if ((here.can_be & Switched::callers) == 0) return here;
    here.can_be = static_cast<std::uint8_t>(here.can_be & ~unsigned{Switched::callers});
    add(here, at_entry(analysis, channel, of));
    return here;
}

/// What the program begins with. Blocks of its callers are no places in it.
Switched SwitchesAt::at_entry(const ProgramAnalysis& analysis, std::uint8_t channel, std::size_t of) {
    const Entry entry{analysis.index(), channel, of};
    if (const auto known = entries_.find(entry); known != entries_.end()) return known->second;
    Switched begins;
    if (analysis.is_main()) {
        // A program without a head, or a list of tools, may be a part of one.
        begins.can_be = has_section(analysis.program(), SectionKind::Role::information) ? Switched::off
                                                                                        : Switched::unknown;
    } else if (analysis.callers().empty() || analysis.callers().size() > most_callers ||
               analysis.has_possible_callers() || analysis.is_recursive() || analysis.is_too_deep()) {
        begins = unknown();
    } else {
        for (const Caller& caller : analysis.callers())
            add(begins, at_call(calling_program(analysis, caller), caller.effect, channel, of));
    }
    begins.on_at = begins.off_at = Switched::nowhere;
    return entries_[entry] = begins;
}

/// What the caller leaves in front of the call.
Switched SwitchesAt::at_call(const ProgramAnalysis& calling, EffectId call, std::uint8_t channel,
                             std::size_t of) {
    const auto* switches = calling.switches().of(channel);
    const auto node = calling.graph().node_of(call);
    if (switches == nullptr || !node) return unknown();
    machine::SwitchState state = switches->before(*node);
    if (!state.is_reached) return {};
    switches->run_part(*node, {0, Switched::nowhere}, state);
    return resolved(calling, channel, state.all[of], of);
}

const machine::SwitchState& SwitchesAt::state_at(std::uint8_t channel, flow::NodeId node, Offset place) {
    if (cursors_.size() <= channel) cursors_.resize(std::size_t{channel} + 1U);
    Cursor& cursor = cursors_[channel];
    const auto& switches = *analysis_.switches().of(channel);
    if (cursor.node != node || cursor.place > place) cursor = {node, {}, 0, switches.before(node)};
    if (cursor.state.is_reached) switches.run_part(node, {cursor.place, place}, cursor.state);
    cursor.place = place;
    return cursor.state;
}

const machine::SwitchState& SwitchesAt::state_in(const Section& section, Offset place, Cursor& cursor) {
    if (!of_sections_) of_sections_.emplace(analysis_.control(), true);
    if (cursor.section.first != section.items.first || cursor.place > place)
        cursor = {std::nullopt, section.items, 0, at_begin_of_section(analysis_.control())};
    run_section(analysis_.program(), section, *of_sections_, {cursor.place, place}, cursor.state);
    cursor.place = place;
    return cursor.state;
}

Switched SwitchesAt::before(const BlockView& block, const Section& section, std::size_t of) {
    if (analysis_.control().switches[of].where == Switch::Where::section)
        return section.executed != Section::Executed::when_reached
                   ? state_in(section, block.span.begin, in_section_).all[of]
                   : unknown();
    const auto node = analysis_.graph().node_of(block.span);
    if (!node) return {};
    if (is_shared(analysis_, of)) return unknown();
    Switched all;
    bool is_known = true;
    for_each_channel(analysis_.graph().channels_at(*node).running, [&](std::uint8_t channel) {
        is_known = is_known && analysis_.switches().of(channel) != nullptr;
        if (!is_known) return;
        const machine::SwitchState& state = state_at(channel, *node, block.span.begin);
        if (state.is_reached) add(all, resolved(analysis_, channel, state.all[of], of));
    });
    return is_known ? all : unknown();
}

bool SwitchesAt::may_hold_in(const PlainRun& run, const Section& section, std::string_view on,
                             std::string_view off) {
    const BlockView first{.span = {run.span.begin, run.span.begin + 1}};
    const auto may_be = [&](std::string_view name, bool wanted_on) {
        const auto of = find_switch(analysis_.control(), name);
        if (!of) return false;
        const Switched begins = before(first, section, *of);
        return (wanted_on ? begins.is_surely_on() : begins.is_surely_off()) ||
               may_change_in(analysis_.program(), run, analysis_.control().switches[*of]);
    };
    bool holds = on.empty() || may_be(on, true);
    for_each_part(off, ',', [&](std::string_view name) { holds = holds && may_be(name, false); });
    return holds;
}

Switched SwitchesAt::at_end_of(const Section& section, std::size_t of) {
    return state_in(section, Switched::nowhere, end_of_section_).all[of];
}

/// All that the switch can be in front of the node or behind it, in the channels that run it.
Switched SwitchesAt::around_node(flow::NodeId node, std::size_t of, bool behind) {
    Switched all;
    for_each_channel(analysis_.graph().channels_at(node).running, [&](std::uint8_t channel) {
        const auto* switches = analysis_.switches().of(channel);
        if (switches == nullptr) return add(all, unknown());
        machine::SwitchState state = switches->before(node);
        if (!state.is_reached) return;
        if (behind) switches->run(node, state);
        add(all, resolved(analysis_, channel, state.all[of], of));
    });
    return all;
}

const StillOn& SwitchesAt::still_on(std::size_t of) {
    const auto [known, fresh] = still_on_.try_emplace(of);
    if (fresh) known->second = find_still_on(of);
    return known->second;
}

StillOn SwitchesAt::find_still_on(std::size_t of) {
    StillOn found;
    if (is_shared(analysis_, of)) return found;
    const flow::Graph& graph = analysis_.graph();
    for (const flow::Exit& exit : graph.exits) {
        if (!ends_job(analysis_, exit)) continue;
        const Switched switched = around_node(exit.node, of, true);
        if (switched.is_surely_on()) found.at_end.insert(switched.on_at);
    }
    for (const flow::NodeId node : graph.with_effects) {
        const Slice effects = graph.nodes[node].effects;
        for (EffectId id = effects.first; id < effects.first + effects.count; ++id) {
            if (!std::holds_alternative<ToolChange>(analysis_.program().effects[id].what)) continue;
            const Switched switched = around_node(node, of, false);
            if (switched.is_surely_on()) found.at_tool_change.try_emplace(switched.on_at, id);
        }
    }
    return found;
}

} // namespace maclint::queries
