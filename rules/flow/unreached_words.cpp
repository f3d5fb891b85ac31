//! Chooses the message for blocks that no path reaches.
#include "rules/flow/unreached_words.hpp"

#include "analyzer/program/model.hpp"
#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/tables.hpp"
#include "rules/path.hpp"

#include <algorithm>
#include <variant>

namespace maclint::rules {
namespace {

/// Whether nobody begins in the middle of the program: in a language without jumps it is one piece, as long
/// as it does not begin again at a block.
bool begins_at_its_head(const ProgramAnalysis& analysis) {
    return !analysis.control().has(Capability::jumps) &&
           std::ranges::none_of(find_block_users(analysis.program()), &BlockUser::restarts);
}

/// Whether a section begins between the two: one that stands twice says so itself.
bool is_parted(const Program& program, const Effect& ender, Span work) {
    return std::ranges::any_of(program.sections, [&](const Section& section) {
        return section.heading.begin > ender.span.begin && section.heading.begin < work.begin;
    });
}

/// Whether the program comes to an end, or returns, where a path leads.
bool ends_elsewhere(const ProgramAnalysis& analysis) {
    return std::ranges::any_of(analysis.graph().exits, [&](const flow::Exit& exit) {
        return exit.kind != flow::ExitKind::alarm && analysis.data().reached(exit.node);
    });
}

/// Whether the first block jumps back, to one that paths lead to.
bool jumps_back(const ProgramAnalysis& analysis, const queries::UnreachedRegion& region) {
    return std::ranges::any_of(analysis.graph().jumps, [&](const flow::ResolvedJump& jump) {
        return jump.target && region.head.contains(analysis.program().effects[jump.jump].span.begin) &&
               jump.target->node < region.first &&
               analysis.graph().order[jump.target->node] != flow::Graph::no_order;
    });
}

/// Whether the region ends as a subprogram does, and nowhere else.
bool region_returns(const ProgramAnalysis& analysis, const queries::UnreachedRegion& region) {
    bool returns = false;
    for (flow::NodeId node = region.first; node <= region.last; ++node)
        for (const Effect& effect : analysis.program().effects_in(analysis.graph().nodes[node].effects)) {
            if (std::holds_alternative<Stop>(effect.what)) return false;
            returns |= std::holds_alternative<Return>(effect.what);
        }
    return returns;
}

/// Whether the blocks go on right behind the end, with no number, remark or free line that would make a part
/// of its own of them, nor a tool: `M30`, `G55 G0 X0`; or with a jump back into what is run: `M30`,
/// `IF[#1LT3]GOTO2`.
bool goes_right_on(const ProgramAnalysis& analysis, const queries::UnreachedRegion& region,
                   const Effect& ender) {
    const auto* stop = std::get_if<Stop>(&ender.what);
    const bool ends =
        (stop != nullptr && stop->kind == Stop::Kind::end) || std::holds_alternative<Return>(ender.what);
    if (!ends || region.number || !region.moves) return false;
    // A program that repeats itself, with another one behind it.
    const bool returns = std::holds_alternative<Return>(ender.what);
    if (returns && !region_returns(analysis, region)) return false;
    const Program& program = analysis.program();
    const std::string_view between = program.slice({ender.span.end, region.head.begin});
    const bool has_more = between.find_first_not_of(" \t\r\n;") != std::string_view::npos;
    const std::uint32_t lines = analysis.source()->position(region.head.begin).line -
                                analysis.source()->position(ender.span.end).line;
    if (has_more || lines > 1 || (region.head != region.work && !jumps_back(analysis, region))) return false;
    const auto changes_tool = [](const Effect& effect) {
        return std::holds_alternative<ToolChange>(effect.what);
    };
    bool has_tool = program.slice(*region.work).find('T') != std::string_view::npos;
    for (flow::NodeId node = region.first; node <= region.last; ++node)
        has_tool |=
            std::ranges::any_of(program.effects_in(analysis.graph().nodes[node].effects), changes_tool);
    return !has_tool;
}

} // namespace

std::optional<UnreachedWords> words_for(const ProgramAnalysis& analysis,
                                        const queries::UnreachedRegion& region, bool another_is_raised) {
    if (region.is_meant || region.is_explained) return std::nullopt;
    const Program& program = analysis.program();
    const Effect& ender = program.effects[*region.ender];
    const std::string number = region.number ? std::to_string(*region.number) : "";
    const std::string before = quoted(program, ender.span);
    const std::string line = line_number(analysis.file(), ender.span.begin);
    if (region.number && region.is_alarm) {
        const Span alarm = program.effects[region.alarms.front()].span;
        // An alarm that retracts first was written for this program.
        if (exemptions::no_alarm_is_raised.is_on() && !another_is_raised && !region.moves)
            return std::nullopt;
        return UnreachedWords{"alarm",
                              region.head,
                              {number, quoted(program, alarm)},
                              region.is_named,
                              std::span(region.alarms).subspan(1)};
    }
    if (region.leaves && region.number && !ends_elsewhere(analysis))
        return UnreachedWords{"only-end", region.head, {number, before, line}, true};
    const auto* stop = std::get_if<Stop>(&ender.what);
    const bool ends = stop != nullptr && stop->kind != Stop::Kind::alarm;
    if (!region.work) return std::nullopt;
    if (region.leaves && goes_right_on(analysis, region, ender))
        return UnreachedWords{"middle", *region.work, {quoted(program, *region.work), before, line}, false};
    const bool may_begin_there = !begins_at_its_head(analysis) || is_parted(program, ender, *region.work);
    if (exemptions::leads_to_an_end.is_on() && region.leaves && may_begin_there) return std::nullopt;
    if (exemptions::switches_behind_end.is_on() && ends && region.only_switches)
        return std::nullopt; // the end of a program switches off as well
    if (!region.number || ends || !analysis.control().has(Capability::jumps)) {
        // Who puts a GOTO in front of blocks switches them off for a while.
        const bool is_sure = !std::holds_alternative<Jump>(ender.what);
        return UnreachedWords{is_sure ? "after" : "passed",
                              *region.work,
                              {quoted(program, *region.work), before, line},
                              is_sure};
    }
    if ((exemptions::block_without_moves.is_on() && !region.moves) || region.is_alarm) return std::nullopt;
    return UnreachedWords{"block", region.head, {number, before, line}, false};
}

} // namespace maclint::rules
