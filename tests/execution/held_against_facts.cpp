//! One function a kind of event: which facts speak of it, and whether they allow it.
#include "tests/execution/held_against_facts.hpp"

#include "analyzer/dataflow/facts/application.hpp"
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/computed_jump.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_read.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/execution/path_search.hpp"
#include "analyzer/program/overloaded.hpp"
#include "analyzer/program/tables.hpp"
#include "tests/support/analysed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <ranges>
#include <utility>

namespace maclint::test {
namespace {

using dataflow::Symbol;
using dataflow::Vacancy;
using execution::Leaving;

/// Paths of whole programs are looked at up to so many edges.
constexpr std::size_t longest_path = 500;

std::string spell(semantics::Content content) { return content ? std::to_string(*content) : "vacant"; }

/// The facts about an expression of an effect.
template<class Fact>
auto about(const dataflow::Facts& facts, EffectId effect, ExpressionId expression) {
    return facts.at<Fact>(effect) |
           std::views::filter([expression](const Fact& fact) { return fact.expression == expression; });
}

bool is_binary(Operation operation) {
    switch (operation) {
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::divide:
    case Operation::modulo:
    case Operation::power:
    case Operation::bit_and:
    case Operation::bit_or:
    case Operation::bit_xor:
    case Operation::arc_tangent_of_two: return true;
    default: return false;
    }
}

/// Nothing can happen there that an event tells of.
bool is_silent(const flow::Node& node) { return node.effects.count == 0 && !node.is_run; }

/// CASE and ELSE: who has run the branch before passes the block by.
bool divides(const Program& program, const BlockView& block) {
    return std::ranges::any_of(program.effects_in(block.effects), [](const Effect& effect) {
        const auto* mark = std::get_if<RegionMark>(&effect.what);
        return mark != nullptr && mark->part == RegionMark::Part::middle;
    });
}

bool within(double low, double high, bool integer, double number) {
    return low <= number && number <= high && !(integer && std::floor(number) != number);
}

} // namespace

HeldAgainstFacts::HeldAgainstFacts(const Workspace& workspace)
    : workspace_(workspace) {
    for (const ProgramAnalysis& analysis : workspace.programs()) {
        watched_[&analysis] = watched_in(analysis);
        claims_by_block_[&analysis] = claims_of(analysis);
    }
}

HeldAgainstFacts::ClaimsByBlock HeldAgainstFacts::claims_of(const ProgramAnalysis& analysis) {
    ClaimsByBlock claims;
    queries::for_each_block_with_modes(
        analysis, [&](const BlockView& block, const queries::BlockModes& modes) {
            BlockClaims& here = claims[block.span.begin];
            here.reached = modes.reached();
            here.falls_through = divides(analysis.program(), block);
            for (std::size_t group = 0; group < analysis.control().groups.size(); ++group) {
                here.before.push_back(modes.before(static_cast<GroupId>(group)));
                here.with_words.push_back(modes.with_words(static_cast<GroupId>(group)));
            }
        });
    return claims;
}

/// All that some program names, and a few that an index may reach.
Watched HeldAgainstFacts::watched_in(const ProgramAnalysis& analysis) const {
    Watched watched;
    const auto& spaces = analysis.control().spaces;
    const auto add = [&](Variable variable) {
        if (std::ranges::find(watched, variable) == watched.end()) watched.push_back(variable);
    };
    for (const ProgramAnalysis& other : workspace_.programs()) {
        const auto add_from = [&](Variable variable) {
            if (!spaces[variable.space].named || &other == &analysis) add(variable);
        };
        for (const Expression& expression : other.program().expressions)
            if (const auto* load = std::get_if<Load>(&expression.node)) add_from(load->variable);
        for (const Effect& effect : other.program().effects)
            if (const auto* assign = std::get_if<Assign>(&effect.what))
                if (const auto* variable = std::get_if<Variable>(&assign->target)) add_from(*variable);
    }
    constexpr std::array<std::int32_t, 12> reached_by_index{1, 2, 3, 4, 5, 6, 8, 100, 101, 102, 103, 104};
    for (const VariableFamily& family : analysis.control().families)
        for (const std::int32_t number : reached_by_index)
            if (const VariableRange* range = family.find(number);
                range != nullptr && range->meaning == Meaning::variable)
                add({range->space, number});
    return watched;
}

void HeldAgainstFacts::begin() {
    levels_.clear();
    left_.clear();
}

void HeldAgainstFacts::observe(execution::Stepper& stepper, const execution::Event& event) {
    if (!refuted_) std::visit([&](const auto& what) { on(stepper, what); }, event);
}

void HeldAgainstFacts::claim(bool holds, const std::string& kind, const std::string& what) {
    ++held_[kind];
    if (holds || refuted_) return;
    const Level& level = levels_.back();
    std::string where = level.analysis->program().name;
    if (level.node) {
        const Offset offset = level.effect ? level.analysis->program().effects[*level.effect].span.begin
                                           : level.analysis->graph().nodes[*level.node].part.begin;
        where += ", line " + std::to_string(line_of(*level.analysis, offset));
    }
    refuted_ = where + ": " + kind + ": " + what;
}

// ---- what values and modal values allow

/// What a symbol stands for in this run of the program, where that is known.
std::optional<HeldAgainstFacts::Content> HeldAgainstFacts::value_of(dataflow::SymbolId id) const {
    const Level& level = levels_.back();
    const dataflow::ValueTable& table = level.analysis->data().table();
    const Symbol& symbol = table.symbols[id];
    switch (symbol.kind()) {
    case Symbol::Kind::constant: return Content{table.number_of(id)};
    case Symbol::Kind::vacant: return Content{};
    case Symbol::Kind::entry_group: return Content{level.codes[symbol.group()]};
    case Symbol::Kind::entry: {
        const Watched& watched = watched_.at(level.analysis);
        const auto variable = std::ranges::find(watched, dataflow::variable_of(symbol.key()));
        if (variable == watched.end()) return std::nullopt;
        return level.variables[static_cast<std::size_t>(variable - watched.begin())];
    }
    case Symbol::Kind::if_set: { // otherwise what was in force before
        const auto asked_for = value_of(symbol.word_value());
        return asked_for && *asked_for ? asked_for : std::nullopt;
    }
    case Symbol::Kind::result: {
        const Operation operation = symbol.operation();
        const auto left = value_of(symbol.first());
        const auto right = is_binary(operation) ? value_of(symbol.second()) : Content{};
        if (!left || !right) return std::nullopt;
        const std::array operands{*left, *right};
        const auto result = semantics::compute(
            operation, std::span<const Content>(operands).first(is_binary(operation) ? 2 : 1));
        const auto* number = std::get_if<double>(&result);
        return number == nullptr ? std::nullopt : std::optional<Content>(*number);
    }
    default: return std::nullopt;
    }
}

bool HeldAgainstFacts::allows(const dataflow::Value& value, Content content) const {
    if (const auto known = value_of(value.symbol); known && *known != content) return false;
    if (!content) // which counts as 0
        return value.vacancy != Vacancy::set && within(value.low, value.high, value.integer, 0) &&
               !value.nonzero;
    return value.vacancy != Vacancy::vacant && within(value.low, value.high, value.integer, *content) &&
           !(value.nonzero && *content == 0);
}

bool HeldAgainstFacts::allows(const dataflow::ModalValue& value, double code) const {
    return value.unknown || std::ranges::any_of(value.parts, [&](const dataflow::ModalPart& part) {
               const auto known = value_of(part.symbol);
               return !known || *known == Content{code};
           });
}

bool HeldAgainstFacts::allows(const queries::Modes& modes, GroupId group, double code) const {
    return modes.unknown || std::ranges::any_of(modes.possible, [&](const queries::Mode& mode) {
               const bool is_callers = mode.set_by == queries::Mode::SetBy::nobody && !mode.code;
               return is_callers ? levels_.back().codes[group] == code : mode.code.value_or(code) == code;
           });
}

void HeldAgainstFacts::check_modes(execution::Stepper& stepper, const std::vector<queries::Modes>& modes,
                                   const std::string& kind) {
    const ControlModel& control = levels_.back().analysis->control();
    for (std::size_t i = 0; i < modes.size(); ++i) {
        const auto group = static_cast<GroupId>(i);
        const double code = stepper.code(group);
        const std::string what = std::string(control.groups[i].name) + " is " + std::to_string(code);
        claim(allows(modes[i], group, code), kind, what);
        if (const auto sure = modes[i].sure_code()) claim(*sure == code, kind + ", surely", what);
    }
}

// ---- programs

void HeldAgainstFacts::on(execution::Stepper& stepper, const execution::ProgramBegins&) {
    const ProgramAnalysis& analysis = stepper.program();
    levels_.push_back({&analysis, {}, {}, {}, {}, {}, 0, {}, {}, {}, 0});
    Level& level = levels_.back();
    for (const Variable variable : watched_[&analysis]) {
        level.variables.push_back(stepper.content(variable));
        claim(!analysis.data().is_vacant_at_entry(variable) || !level.variables.back(), "vacant at entry",
              analysis.program().spell(variable) + " is set");
    }
    for (std::size_t group = 0; group < analysis.control().groups.size(); ++group)
        level.codes.push_back(stepper.code(static_cast<GroupId>(group)));
}

void HeldAgainstFacts::on(execution::Stepper& stepper, const execution::CallBegins&) {
    Level& level = levels_.back();
    if (!level.before_call.empty()) check_changes(stepper, *stepper.effect());
    level.before_call.clear();
    for (const Variable variable : watched_[level.analysis])
        level.before_call.push_back(stepper.content(variable));
}

void HeldAgainstFacts::on(execution::Stepper& stepper, const execution::CallEnds& event) {
    Level& level = levels_.back();
    check_changes(stepper, event.call);
    level.before_call.clear();
    const bool known =
        std::ranges::any_of(facts().at<dataflow::CallMade>(event.call), [&](const dataflow::CallMade& call) {
            return call.node == level.node && (!call.known || event.target);
        });
    claim(known, "calls", event.target ? "no call is made there" : "the program is not there");
}

/// What the caller sees changed, the call may change.
void HeldAgainstFacts::check_changes(execution::Stepper& stepper, EffectId call) {
    const Level& level = levels_.back();
    const Watched& watched = watched_[level.analysis];
    for (std::size_t i = 0; i < watched.size(); ++i) {
        if (stepper.content(watched[i]) == level.before_call[i]) continue;
        const bool known =
            std::ranges::any_of(facts().at<dataflow::Clobber>(call), [&](const dataflow::Clobber& clobber) {
                return clobber.node == level.node && clobber.space == watched[i].space &&
                       (!clobber.variable || *clobber.variable == watched[i]);
            });
        claim(known, "changes by calls", level.analysis->program().spell(watched[i]) + " is changed");
        for (const dataflow::Loop& loop : level.analysis->loops())
            claim(!loop.holds(*level.node) || loop.changes.may_change(watched[i]), "changes in loops",
                  level.analysis->program().spell(watched[i]) + " is changed by a call");
    }
}

// ---- the path through the program

void HeldAgainstFacts::on(execution::Stepper& stepper, const execution::EffectBegins& event) {
    const auto node = levels_.back().analysis->graph().node_of(event.effect);
    if (!node) return claim(false, "nodes", "an effect without a node runs");
    Level& level = levels_.back();
    come_to(*node, level.node == node && level.effect && *level.effect < event.effect);
    level.effect = event.effect;
    const Program& program = level.analysis->program();
    const auto claims = claims_by_block_[level.analysis].find(level.block);
    const bool moves = std::holds_alternative<Motion>(program.effects[event.effect].what);
    if (moves && claims != claims_by_block_[level.analysis].end())
        check_modes(stepper, claims->second.with_words, "modes with the words of a block");
}

void HeldAgainstFacts::on(execution::Stepper& stepper, const execution::BlockBegins& event) {
    levels_.back().block = event.span.begin;
    const auto& claims = claims_by_block_[levels_.back().analysis].at(event.span.begin);
    if (!claims.falls_through) {
        claim(claims.reached, "reached blocks", "it runs");
        check_modes(stepper, claims.before, "modes before a block");
    }
    if (event.has_effects) return; // they say where it is
    Level& level = levels_.back();
    const auto& nodes = level.analysis->graph().nodes;
    for (flow::NodeId id = 0; id < nodes.size(); ++id) {
        const flow::Node& node = nodes[id];
        if (event.span.begin < node.part.begin || node.part.end < event.span.end) continue;
        come_to(id, level.node == id && node.is_run && level.offset < event.span.begin);
        level.effect.reset();
        level.offset = event.span.begin;
        return;
    }
    claim(false, "nodes", "a block without a node runs");
}

void HeldAgainstFacts::come_to(flow::NodeId node, bool goes_on) {
    Level& level = levels_.back();
    if (goes_on) return;
    const ProgramAnalysis& analysis = *level.analysis;
    const auto jumped_to = std::exchange(level.jumped_to, std::nullopt);
    const auto path = level.node  ? this->path(analysis, *level.node, node, jumped_to)
                      : node == 0 ? std::optional<std::vector<flow::EdgeId>>(std::vector<flow::EdgeId>{})
                                  : this->path(analysis, 0, node);
    const auto before = level.node;
    level.node = node;
    level.effect.reset();
    claim(analysis.data().reached(node), "reached nodes", "it runs");
    claim(path.has_value(), "passable edges",
          before ? "it comes from node " + std::to_string(*before) + " to " + std::to_string(node)
                 : "the program begins at node " + std::to_string(node));
    if (path && level.path.size() < longest_path)
        level.path.insert(level.path.end(), path->begin(), path->end());
    const auto& inescapable_cycles = analysis.inescapable_cycles();
    if (level.cycle) {
        claim(inescapable_cycles[*level.cycle].holds(node), "inescapable cycles", "it is left");
    } else {
        for (std::size_t i = 0; i < inescapable_cycles.size() && !level.cycle; ++i)
            if (inescapable_cycles[i].holds(node)) level.cycle = i;
    }
}

/// A shortest path over edges that can be taken and nodes of which no event tells: a jump may come to the
/// same node by way of a block that is skipped.
std::optional<std::vector<flow::EdgeId>> HeldAgainstFacts::path(const ProgramAnalysis& analysis,
                                                                flow::NodeId from, flow::NodeId to,
                                                                std::optional<double> jumped_to) {
    const auto [entry, fresh] = paths_.try_emplace({&analysis, from, to, jumped_to});
    if (!fresh) return entry->second;
    const flow::Graph& graph = analysis.graph();
    std::map<flow::NodeId, std::vector<flow::EdgeId>> met{{from, {}}};
    std::deque<flow::NodeId> queue{from};
    while (!queue.empty()) {
        const flow::NodeId at = queue.front();
        queue.pop_front();
        for (const flow::EdgeId id : graph.out[at]) {
            if (!analysis.data().passable(id)) continue;
            if (const auto label = graph.edges[id].label; label && jumped_to) {
                const auto* number = std::get_if<std::int64_t>(&graph.labels[*label].label);
                if (number != nullptr && static_cast<double>(*number) != *jumped_to) continue;
            }
            const flow::NodeId next = graph.edges[id].to;
            auto edges = met[at];
            edges.push_back(id);
            if (next == to) return entry->second = edges;
            if (is_silent(graph.nodes[next]) && met.try_emplace(next, edges).second) queue.push_back(next);
        }
    }
    return entry->second;
}

// ---- reads, conditions, stores

void HeldAgainstFacts::on(execution::Stepper& stepper, const execution::VariableRead& event) {
    const auto effect = stepper.effect();
    if (!effect) return;
    const Program& program = stepper.program().program();
    bool recorded = std::holds_alternative<Return>(program.effects[*effect].what) ||
                    !std::holds_alternative<Load>(program.expressions[event.expression].node);
    for (const dataflow::Read& read : about<dataflow::Read>(facts(), *effect, event.expression)) {
        if (!(read.variable == event.variable)) continue;
        recorded = true;
        claim(allows(read.value, event.content), "reads",
              program.spell(event.variable) + " is " + spell(event.content));
    }
    claim(recorded, "reads recorded", program.spell(event.variable) + " is read");
}

void HeldAgainstFacts::on(execution::Stepper& stepper, const execution::GroupRead& event) {
    const Level& level = levels_.back();
    if (!level.node) return;
    for (const dataflow::ModalRead& read : facts().in<dataflow::ModalRead>(*level.node))
        claim(read.expression != event.expression || read.group != event.group ||
                  allows(read.value, event.code),
              "modal reads",
              stepper.program().control().groups[event.group].name.data() + (" is " + spell(event.code)));
}

void HeldAgainstFacts::on(execution::Stepper& stepper, const execution::Applied& event) {
    const EffectId effect = *stepper.effect();
    const Program& program = stepper.program().program();
    const auto& apply = std::get<Apply>(program.expressions[event.expression].node);
    bool recorded = std::holds_alternative<Return>(program.effects[effect].what) ||
                    !semantics::may_have_no_value(apply.operation);
    for (const dataflow::Application& fact :
         about<dataflow::Application>(facts(), effect, event.expression)) {
        recorded = true;
        claim(allows(fact.left, event.left), "left operands", "it is " + spell(event.left));
        claim(allows(fact.right, event.right), "right operands", "it is " + spell(event.right));
    }
    claim(recorded, "applications recorded", "an operator is applied");
}

void HeldAgainstFacts::on(execution::Stepper& stepper, const execution::Compared& event) {
    for (const dataflow::Comparison& fact :
         about<dataflow::Comparison>(facts(), *stepper.effect(), event.expression)) {
        claim(event.truth ? fact.truth.can_hold : fact.truth.can_fail, "truth of comparisons",
              event.truth ? "it is true" : "it is false");
        claim(allows(fact.left, event.left), "left sides", "it is " + spell(event.left));
        claim(allows(fact.right, event.right), "right sides", "it is " + spell(event.right));
    }
}

void HeldAgainstFacts::on(execution::Stepper& stepper, const execution::Decided& event) {
    bool recorded = false;
    for (const dataflow::Condition& fact :
         about<dataflow::Condition>(facts(), *stepper.effect(), event.condition)) {
        recorded = true;
        claim(event.truth ? fact.truth.can_hold : fact.truth.can_fail, "truth of conditions",
              event.truth ? "it is true" : "it is false");
    }
    claim(recorded, "conditions recorded", "a condition is decided");
}

void HeldAgainstFacts::on(execution::Stepper& stepper, const execution::Stored& event) {
    if (!levels_.back().before_call.empty()) return; // by an unknown program: see check_changes
    const EffectId effect = *stepper.effect();
    const Program& program = stepper.program().program();
    bool recorded = false;
    for (const dataflow::Store& store : facts().at<dataflow::Store>(effect)) {
        if (!(store.variable == event.variable)) continue;
        recorded = true;
        claim(allows(store.value, event.content), "stores",
              program.spell(event.variable) + " becomes " + spell(event.content));
        claim(allows(store.old, event.old), "old values",
              program.spell(event.variable) + " was " + spell(event.old));
    }
    for (const dataflow::Clobber& clobber : facts().at<dataflow::Clobber>(effect))
        recorded |= clobber.space == event.variable.space &&
                    (!clobber.variable || *clobber.variable == event.variable);
    claim(recorded, "stores recorded", program.spell(event.variable) + " becomes " + spell(event.content));
    for (const dataflow::Loop& loop : stepper.program().loops())
        claim(!loop.holds(*levels_.back().node) || loop.changes.may_change(event.variable),
              "changes in loops", program.spell(event.variable) + " is changed");
}

void HeldAgainstFacts::on(execution::Stepper& stepper, const execution::GroupSet& event) {
    if (!stepper.effect()) return;
    for (const dataflow::ModalWrite& write : facts().at<dataflow::ModalWrite>(*stepper.effect())) {
        claim(!write.group || *write.group == event.group, "groups set", "another group is set");
        claim(allows(write.value, event.code), "codes set", "it is " + spell(event.code));
    }
}

void HeldAgainstFacts::on(execution::Stepper& stepper, const execution::JumpComputed& event) {
    levels_.back().jumped_to = event.target;
    for (const dataflow::ComputedJump& jump : facts().at<dataflow::ComputedJump>(*stepper.effect()))
        claim(event.target == 0 ? jump.target.can_be(0) || jump.target.vacancy == Vacancy::unknown
                                : allows(jump.target, event.target),
              "computed jumps", "it goes to " + spell(event.target));
}

// ---- the end of programs

void HeldAgainstFacts::on(execution::Stepper& stepper, const execution::ProgramLeft& event) {
    if (event.how == Leaving::fault || event.how == Leaving::cut_off || event.how == Leaving::unreadable)
        return;
    const bool of_unknown_program = !levels_.back().before_call.empty();
    if (!of_unknown_program) {
        check_exit(stepper, event);
        check_summary(stepper, event);
    }
    if (event.how != Leaving::returns && event.how != Leaving::runs_off) return check_stop();
    left_.push_back(std::move(levels_.back()));
    levels_.pop_back();
}

void HeldAgainstFacts::check_exit(execution::Stepper& stepper, const execution::ProgramLeft& left) {
    const Level& level = levels_.back();
    const ProgramAnalysis& analysis = *level.analysis;
    for (const auto& loop : analysis.inescapable_cycles())
        claim(!level.node || !loop.holds(*level.node), "inescapable cycles", "the program ends there");
    for (const dataflow::Loop& loop : analysis.loops())
        claim(left.how == Leaving::runs_off || !loop.holds(*level.node) || loop.can_stop,
              "loops that cannot stop", "the program ends there");
    const flow::NodeId last = level.node.value_or(0);
    bool recorded = false;
    bool allowed = false;
    std::string wrong;
    for (const dataflow::ExitState& exit : analysis.facts().all<dataflow::ExitState>()) {
        const bool is_it =
            left.how == Leaving::runs_off
                ? exit.exit.kind == flow::ExitKind::runs_off &&
                      (exit.exit.node == last || (is_silent(analysis.graph().nodes[exit.exit.node]) &&
                                                  path(analysis, last, exit.exit.node)))
                : left.effect && exit.exit.effect == left.effect;
        if (!is_it) continue;
        recorded = true;
        bool all = true;
        for (std::size_t group = 0; group < analysis.control().groups.size(); ++group) {
            const double code = stepper.code(static_cast<GroupId>(group));
            if (allows(analysis.data().modal(exit, static_cast<GroupId>(group)), code)) continue;
            all = false;
            wrong = std::string(analysis.control().groups[group].name) + " is " + spell(code);
        }
        allowed |= all;
    }
    claim(recorded, "exits", "the program is left there");
    claim(allowed, "modal groups at exits", wrong);
}

void HeldAgainstFacts::check_summary(execution::Stepper& stepper, const execution::ProgramLeft& left) {
    const Level& level = levels_.back();
    const ProgramAnalysis& analysis = *level.analysis;
    const dataflow::Summary& summary = analysis.summary();
    if (left.how != Leaving::returns && left.how != Leaving::runs_off)
        return claim(summary.may_stop, "summary: stops", "it stops");
    if (!left.label) claim(summary.returns, "summary: returns", "it returns behind the call");
    if (left.label) {
        const auto& labels = summary.resume_labels;
        const Label label = static_cast<std::int64_t>(*left.label);
        claim(labels != nullptr && std::ranges::binary_search(*labels, label), "summary: labels",
              "it returns to " + spell(left.label));
    }
    const Watched& watched = watched_[&analysis];
    for (std::size_t i = 0; i < watched.size(); ++i) {
        const Content now = stepper.content(watched[i]);
        const auto change =
            std::ranges::find(summary.variables, watched[i], &dataflow::VariableChange::variable);
        const bool havoc = std::ranges::find(summary.havoc, watched[i].space) != summary.havoc.end();
        const std::string what = analysis.program().spell(watched[i]) + " was " + spell(level.variables[i]) +
                                 " and is " + spell(now);
        if (change != summary.variables.end())
            claim(now ? change->vacancy != Vacancy::vacant &&
                            within(change->low, change->high, change->integer, *now)
                      : change->vacancy != Vacancy::set &&
                            within(change->low, change->high, change->integer, 0),
                  "summary: values", what);
        else
            claim(havoc || now == level.variables[i], "summary: variables", what);
    }
    for (std::size_t group = 0; group < level.codes.size(); ++group) {
        const double now = stepper.code(static_cast<GroupId>(group));
        const auto change = std::ranges::find(summary.groups, group, &dataflow::GroupChange::group);
        const bool may_be = change == summary.groups.end()
                                ? now == level.codes[group]
                                : change->other || (change->may_keep && now == level.codes[group]) ||
                                      std::ranges::find(change->codes, now) != change->codes.end();
        claim(may_be, "summary: groups",
              std::string(analysis.control().groups[group].name) + " was " + spell(level.codes[group]) +
                  " and is " + spell(now));
    }
}

/// Who called a program that stops made a call that may stop.
void HeldAgainstFacts::check_stop() {
    for (std::size_t i = levels_.size(); i-- > 0;) {
        const Level& level = levels_[i];
        if (level.before_call.empty()) continue;
        claim(level.analysis->summary().may_stop, "summary: stops", "a program called there stops");
        for (const dataflow::Loop& loop : level.analysis->loops())
            if (loop.holds(*level.node) && in_a_later_round(level, loop))
                claim(loop.can_stop, "loops that cannot stop", "a program called there stops");
    }
}

/// Whether the run has come to its node again without leaving the loop. Of the first round a loop claims
/// nothing.
bool HeldAgainstFacts::in_a_later_round(const Level& level, const dataflow::Loop& loop) {
    if (level.path.size() >= longest_path) return true;
    const flow::Graph& graph = level.analysis->graph();
    for (const flow::EdgeId id : level.path | std::views::reverse) {
        const flow::Edge& edge = graph.edges[id];
        if (!loop.holds(edge.from)) return false;
        if (edge.from == *level.node) return true;
    }
    return false;
}

void HeldAgainstFacts::end(bool machine_stood_still) {
    if (refuted_) return;
    for (Level& level : levels_) left_.push_back(std::move(level));
    levels_.clear();
    for (Level& level : left_) {
        levels_ = {level};
        if (machine_stood_still && level.node) check_path(level);
    }
    levels_.clear();
}

/// Where a run has come, a search comes, too, over the nodes that the run met alone, and by way of any of
/// them. A path may end where a program called from there has stopped for good.
void HeldAgainstFacts::check_path(const Level& level) {
    const flow::Graph& graph = level.analysis->graph();
    const bool whole = level.path.size() < longest_path;
    std::vector<bool> met(graph.nodes.size(), false);
    met[0] = true;
    bool twice = false;
    for (const flow::EdgeId edge : level.path) {
        twice = twice || met[graph.edges[edge].to];
        met[graph.edges[edge].to] = true;
    }
    std::vector<flow::NodeId> barred;
    for (flow::NodeId node = 0; node < graph.nodes.size() && whole && !twice; ++node)
        if (!met[node]) barred.push_back(node);
    execution::PathSearch search(*level.analysis);
    const std::string where = "no path leads to node " + std::to_string(*level.node) + ", where it has come";
    const auto expect = [&](std::span<const execution::Leg> legs, const char* kind, const std::string& what) {
        const execution::PathFound found = search.find(legs);
        claim(found.path.has_value() || found.gave_up, kind, what);
    };
    const execution::Leg last{*level.node, barred};
    expect(std::array{last}, twice ? "paths with loops" : "paths", where);
    if (!whole || level.path.empty()) return;
    const flow::NodeId between = graph.edges[level.path[level.path.size() / 2]].to;
    expect(std::array{execution::Leg{between, barred}, last},
           twice ? "paths by way of a node, with loops" : "paths by way of a node",
           where + " by way of node " + std::to_string(between));
}

} // namespace maclint::test
