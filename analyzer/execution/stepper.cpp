//! Blocks and effects: where a run goes and what it changes.
#include "analyzer/execution/stepper.hpp"

#include "analyzer/program/overloaded.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/program/whole_number.hpp"
#include "analyzer/workspace/bind.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace maclint::execution {
namespace {

constexpr std::int64_t most_times = 9999; // L of a call [T]

} // namespace

Stepper::Stepper(const Workspace& workspace, const Environment& environment, Observer observer, Bounds bounds)
    : workspace_(workspace)
    , environment_(environment)
    , observer_(std::move(observer))
    , bounds_(bounds) {}

Leaving Stepper::run(const Start& start) {
    steps_ = 0;
    levels_.clear();
    shared_.clear();
    codes_.clear();
    left_.reset();
    auto variables = std::make_shared<Variables>();
    for (const auto& [variable, content] : start.variables) (*variables)[variable] = content;
    enter(start.program, std::move(variables));
    if (start.from) top().at = {top().layout->step_of(*start.from), {}};
    while (!done()) step();
    return *left_;
}

const Layout& Stepper::layout_of(const ProgramAnalysis& analysis) {
    auto& layout = layouts_[&analysis];
    if (!layout) layout = std::make_unique<Layout>(analysis.program(), analysis.regions());
    return *layout;
}

// ---- programs

void Stepper::enter(ProgramIndex program, std::shared_ptr<Variables> variables) {
    const ProgramAnalysis& analysis = workspace_.programs()[program];
    levels_.push_back({&analysis, &layout_of(analysis), std::move(variables), {0, {}}, {}, {}});
    codes_.resize(std::max(codes_.size(), analysis.control().groups.size()));
    effect_.reset();
    report(ProgramBegins{});
}

/// Leaves the program: back to its caller, or for good.
void Stepper::leave(Leaving how, std::optional<EffectId> effect, std::optional<double> label) {
    if (done()) return;
    report(ProgramLeft{how, effect, label});
    const bool goes_on = (how == Leaving::returns || how == Leaving::runs_off) && levels_.size() > 1;
    if (!goes_on) {
        left_ = how;
        return;
    }
    std::optional<Pending> modal_call = std::move(top().modal_call);
    levels_.pop_back();
    Pending& pending = *top().pending;
    if (modal_call && !pending.modal) { // it stays in force for the caller
        modal_call->effect = pending.effect;
        top().modal_call = std::move(modal_call);
    }
    resume(label);
}

/// Goes on in the caller, or calls again.
void Stepper::resume(std::optional<double> label) {
    Pending& pending = *top().pending;
    effect_ = pending.effect;
    if (!label && pending.times > 0) return call_again();
    const Pending ended = std::exchange(top().pending, std::nullopt).value();
    if (ended.modal) set_modal_call_code(ended.kind);
    std::optional<std::int64_t> number;
    if (label) {
        number = whole_number(*label);
        const auto target = number && !ended.modal
                                ? top().layout->find(*number, 0, LabelSearch::forward_then_top)
                                : std::nullopt;
        if (!target) return fault();
        top().at = {*target, {}};
    }
    report(CallEnds{ended.effect, ended.target, number});
}

void Stepper::call_again() {
    Pending& pending = *top().pending;
    --pending.times;
    const bool shares_locals = control().calls[pending.kind].frame == Frame::shared;
    report(CallBegins{pending.effect, pending.target, shares_locals});
    if (!pending.target) return call_unknown();
    if (levels_.size() > bounds_.depth) return leave(Leaving::cut_off, effect_, std::nullopt);
    std::shared_ptr<Variables> variables = top().variables;
    if (!shares_locals) {
        variables = std::make_shared<Variables>();
        for (const Passed& passed : pending.arguments) (*variables)[passed.formal] = passed.content;
    }
    enter(*pending.target, std::move(variables));
}

/// As often as the call asks for, at once.
void Stepper::call_unknown() {
    Pending& pending = *top().pending;
    for (; pending.times >= 0; --pending.times) {
        const UnknownEffects unknown = environment_.unknown_call(text(), pending.kind);
        for (const auto& [variable, content] : unknown.stores) store(variable, content);
        for (const auto& [changed, code] : unknown.codes) group(changed) = code;
        if (unknown.stops) return leave(Leaving::ends, effect_, std::nullopt);
    }
    resume(std::nullopt);
}

// ---- blocks

void Stepper::step() {
    if (++steps_ > bounds_.steps) return leave(Leaving::cut_off, std::nullopt, std::nullopt);
    Level& level = top();
    if (level.at.effect) return run_effect(*level.at.effect);
    effect_.reset();
    if (level.at.step == level.layout->steps().size())
        return leave(Leaving::runs_off, std::nullopt, std::nullopt);
    const Step& step = level.layout->steps()[level.at.step];
    if (step.block.skip_levels != 0 && environment_.skips(step.block)) {
        ++level.at.step;
        return;
    }
    report(BlockBegins{step.block.span, step.block.effects.count != 0});
    if (step.block.effects.count != 0) {
        level.at.effect = step.block.effects.first;
        return;
    }
    ++level.at.step;
    for (const ModalSetting& setting : step.settings) set_code(setting.group, setting.value);
    if (step.block.moves) move();
}

void Stepper::run_effect(EffectId id) {
    effect_ = id;
    const Effect& effect = text().effects[id];
    const flow::Region* region = top().layout->region_of(id);
    const auto* mark = std::get_if<RegionMark>(&effect.what);
    // A CASE is reached by the tests before it; from the branch above the control falls through it.
    const bool falls_through = region != nullptr && region->region_kind == RegionKind::selection &&
                               mark != nullptr && mark->part == RegionMark::Part::middle;
    if (falls_through) return go_to(id);
    report(EffectBegins{id});
    go_to(id);
    std::visit(overloaded{
                   [&](const Assign& what) { assign(what); }, [&](const SetModal& what) { set_modal(what); },
                   [&](const EvaluateWords& what) {
                       for (const ExpressionId value : text().values_of(what)) take(value);
                   },
                   [&](const Motion&) { move(); }, [&](const Stop& what) { stop(id, what); },
                   [&](const RegionMark& what) { pass_mark(id, what); },
                   [&](const Jump& what) { jump(what); }, [&](const Call& what) { call(id, what); },
                   [&](const Return& what) { return_to_caller(id, what); },
                   [&](const Exchange& what) { exchange(what); },
                   [&](const Guarded& what) {
                       if (decide(what.condition) && !done() && what.effects.count != 0)
                           top().at = {top().layout->step_of(id), what.effects.first};
                   },
                   [&](const UnreadableBlock&) { leave(Leaving::unreadable, id, std::nullopt); },
                   [](const auto&) {}, // look-ahead, tool changes, references to contours
               },
               effect.what);
}

/// What comes when the effect is done.
void Stepper::go_to(EffectId after) { top().at = top().layout->after(after); }

// ---- effects

void Stepper::assign(const Assign& assign) {
    const Content content = take(assign.value);
    if (done()) return;
    std::visit(overloaded{
                   [&](const Variable& variable) { store(variable, content); },
                   [&](const StoreAt& target) { store_at(target, content); },
                   [](const StoreMachine&) {},
               },
               assign.target);
}

void Stepper::store_at(const StoreAt& target, Content content) {
    const double index = take(target.index).value_or(0);
    if (done()) return;
    const auto number = semantics::variable_number(index);
    const VariableRange* range = number ? control().families[target.family].find(*number) : nullptr;
    if (range == nullptr) return fault();
    switch (range->on_write) {
    case OnWrite::alarm: return leave(Leaving::alarm, effect_, std::nullopt);
    case OnWrite::pause: return;
    case OnWrite::set_modal: return set_group(range->group, content);
    case OnWrite::forbidden: return fault();
    case OnWrite::store: break;
    }
    if (range->meaning == Meaning::variable) store({range->space, *number}, content);
}

void Stepper::set_modal(const SetModal& set) {
    const Content content = take(set.value);
    if (done() || !content) return; // a word with a vacant variable is ignored [SEED-001:187-195]
    if (set.group) return set_group(*set.group, content);
    if (const auto member = control().member_of(set.letter, *content)) set_group(member->group, member->code);
}

void Stepper::set_group(GroupId changed, Content content) {
    if (!content) return;
    set_code(changed, *content);
    if (control().group_with(ModalRole::macro_call) == changed) end_modal_call();
    report(GroupSet{changed, *content});
}

void Stepper::set_code(GroupId changed, double code) {
    group(changed) = code;
    for (const EndedGroup& ended : control().ended_groups)
        if (ended.by == changed) group(ended.group) = ended.code;
}

void Stepper::stop(EffectId id, const Stop& stop) {
    if (stop.number) take(*stop.number);
    if (done()) return;
    switch (stop.kind) {
    case Stop::Kind::pause: return;
    case Stop::Kind::alarm: return leave(Leaving::alarm, id, std::nullopt);
    case Stop::Kind::end: return leave(Leaving::ends, id, std::nullopt);
    case Stop::Kind::restart: return leave(Leaving::restarts, id, std::nullopt);
    }
}

void Stepper::pass_mark(EffectId id, const RegionMark& mark) {
    const flow::Region* region = top().layout->region_of(id);
    if (region == nullptr) {
        if (mark.condition) (void)truth(*mark.condition);
        return;
    }
    switch (mark.part) {
    case RegionMark::Part::begin: return;
    case RegionMark::Part::open: return open(id, *region);
    case RegionMark::Part::middle: // the branch above ends
    case RegionMark::Part::leave: return go_to(*region->close);
    case RegionMark::Part::close:
        if (region->region_kind == RegionKind::until_loop && mark.condition) {
            if (decide(*mark.condition) || done()) return;
        }
        if (is_loop(region->region_kind)) top().at = {top().layout->step_of(region->open), region->open};
        return;
    }
}

void Stepper::open(EffectId, const flow::Region& region) {
    if (region.region_kind == RegionKind::selection) return select(region);
    if (!region.condition || decide(*region.condition) || done()) return;
    // Where the condition is false: the ELSE, else the end.
    const auto otherwise = std::ranges::find_if(region.parts, [&](EffectId part) {
        return std::get<RegionMark>(text().effects[part].what).part == RegionMark::Part::middle;
    });
    go_to(otherwise == region.parts.end() ? *region.close : *otherwise);
}

/// The tests in text order; DEFAULT, wherever it stands, when none is true.
void Stepper::select(const flow::Region& region) {
    std::optional<EffectId> fallback;
    for (const EffectId part : region.parts) {
        const auto& mark = std::get<RegionMark>(text().effects[part].what);
        if (mark.part != RegionMark::Part::middle) continue;
        if (!mark.condition) {
            fallback = part;
            continue;
        }
        effect_ = part;
        report(EffectBegins{part});
        const bool taken = decide(*mark.condition);
        if (done()) return;
        if (taken) return go_to(part);
    }
    if (fallback) report(EffectBegins{*fallback});
    go_to(fallback.value_or(*region.close));
}

void Stepper::jump(const Jump& jump) {
    std::optional<Label> label = flow::constant_target(text(), jump.target);
    const bool is_name = label && std::holds_alternative<BlockName>(*label);
    if (!is_name) {
        const Content content = evaluate(jump.target);
        if (done()) return;
        const double target = content.value_or(0);
        if (!label) report(JumpComputed{target});
        label = whole_number(target);
    }
    const auto step =
        label ? top().layout->find(*label, top().layout->step_of(*effect_), jump.search) : std::nullopt;
    if (!step && jump.missing == MissingLabel::skip) return;
    if (!step) return fault(); // alarm 128
    top().at = {*step, {}};
}

void Stepper::call(EffectId id, const Call& call) {
    const CallKind& kind = control().calls[call.kind];
    const CallSite* site = top().analysis->call_at(id);
    Pending pending{id, call.kind, site == nullptr ? std::nullopt : site->target, {}, 1, false};
    const Program* callee =
        pending.target ? &top().analysis->workspace().programs()[*pending.target].program() : nullptr;
    for (const Argument& argument : text().arguments_of(call)) {
        const Content content = take(argument.value);
        if (const auto formal = bound_to(argument, callee)) pending.arguments.push_back({*formal, content});
    }
    if (call.repeat) {
        // A word with a vacant variable is ignored.
        const double times = std::round(take(*call.repeat).value_or(1));
        pending.times = static_cast<std::int64_t>(std::clamp<double>(times, 0, most_times));
    }
    if (const auto* number = std::get_if<ExpressionId>(&call.program)) take(*number);
    if (done()) return;
    if (kind.trigger != CallTrigger::once) {
        end_modal_call();
        set_modal_call_code(call.kind);
        pending.modal = true;
        top().modal_call = std::move(pending);
        return;
    }
    if (pending.times == 0) return;
    top().pending = std::move(pending);
    call_again();
}

/// It is the same after the called program, whatever that one does (T).
void Stepper::set_modal_call_code(CallKindId kind) {
    if (const auto modal = control().group_with(ModalRole::macro_call))
        group(*modal) = control().calls[kind].modal_code;
}

/// Ends the modal calls of this program and of those that have called it; what a modal call runs does not end
/// it.
void Stepper::end_modal_call() {
    for (std::size_t i = levels_.size(); i-- > 0;) {
        levels_[i].modal_call.reset();
        if (i != 0 && levels_[i - 1].pending->modal) return;
    }
}

/// Moving while a modal call is in force runs its program [SEED-001:466].
void Stepper::move() {
    const auto& modal = top().modal_call;
    if (!modal || modal->times == 0) return;
    top().pending = modal;
    effect_ = modal->effect;
    call_again();
}

void Stepper::return_to_caller(EffectId id, const Return& what) {
    if (what.value) take(*what.value);
    const Content label = what.resume_label ? take(*what.resume_label) : Content{};
    if (!done()) leave(Leaving::returns, id, label);
}

void Stepper::exchange(const Exchange& exchange) {
    for (const ExpressionId out : text().values_of(exchange)) take(out);
    if (done()) return;
    for (const Variable in : text().variables_of(exchange)) store(in, environment_.typed_in(text(), in));
}

// ---- variables and groups

void Stepper::store(Variable variable, Content content) {
    if (content) content = semantics::stored_in(text().type_of(variable), *content);
    Content& there = content_of(variable);
    const Content old = std::exchange(there, content);
    report(Stored{variable, old, content});
}

/// What a program hands down is that of the nearest program further up that does so [l.18979, l.19491].
std::pair<Stepper::Level*, Variable> Stepper::owner_of(Variable variable) {
    const auto& own = text().handed_down;
    if (!control().spaces[variable.space].handed_down || std::ranges::find(own, variable) != own.end())
        return {&top(), variable};
    const std::string name = text().spell(variable);
    for (std::size_t i = levels_.size() - 1; i-- > 0;) {
        const Program& giver = levels_[i].analysis->program();
        for (const Variable given : giver.handed_down)
            if (giver.spell(given) == name) return {&levels_[i], giver.meant_by(given)};
    }
    return {&top(), variable};
}

Content& Stepper::content_of(Variable variable) {
    const VariableSpace& space = control().spaces[variable.space];
    if (space.scope != Scope::frame) return shared_content_of(variable);
    const auto [level, owned] = owner_of(variable);
    const Content start = space.initial_value == InitialValue::zero ? Content{0} : Content{};
    return level->variables->try_emplace(owned, start).first->second;
}

Content& Stepper::shared_content_of(Variable variable) {
    Variable known = variable;
    if (control().spaces[variable.space].named)
        known.number = shared_names_.number_of(text().spell(variable));
    const auto [found, fresh] = shared_.try_emplace(known);
    if (fresh) found->second = environment_.at_start(text(), variable);
    return found->second;
}

std::optional<double>& Stepper::group(GroupId id) {
    if (!codes_[id]) codes_[id] = environment_.code_at_start(id);
    return codes_[id];
}

Content Stepper::content(Variable variable) { return content_of(variable); }
double Stepper::code(GroupId id) { return *group(id); }

} // namespace maclint::execution
