//! A world of chance around the stepper.
#include "tests/execution/soundness.hpp"

#include "analyzer/execution/stepper.hpp"
#include "analyzer/program/tables.hpp"
#include "tests/execution/held_against_facts.hpp"
#include "tests/execution/live_stores.hpp"

#include <array>
#include <utility>

namespace maclint::test {
namespace {

using execution::Content;

/// A world in which everything that no program tells is thrown.
class RandomEnvironment {
  public:
    explicit RandomEnvironment(Dice& dice)
        : dice_(dice) {}

    /// `main`: modal groups have their codes of reset. `still`: the machine's values stay as they are during
    /// a run, and all numbers are whole: so whoever writes a program thinks of them.
    execution::Environment in_front_of(const ControlModel& control, bool main, bool still) {
        still_ = still;
        machine_.clear();
        execution::Environment environment;
        environment.at_start = [&](const Program&, Variable variable) {
            const bool may_be_vacant = control.spaces[variable.space].scope != Scope::machine;
            return may_be_vacant ? content() : Content{number()};
        };
        environment.code_at_start = [&, main](GroupId group) { return code(control, group, main); };
        environment.value_of = [this](const Program& program, ExpressionId id) {
            return value_of(program, program.expressions[id]);
        };
        environment.typed_in = [this](const Program&, Variable) { return Content{number()}; };
        // The switches stay as they are during a run.
        const std::uint32_t switches = dice_.one_in(2) ? 1U << 1U : 0;
        environment.skips = [switches](const BlockView& block) {
            return (block.skip_levels & switches) != 0;
        };
        environment.unknown_call = [this](const Program& program, CallKindId kind) {
            return unknown_call(program, kind);
        };
        return environment;
    }

    Content content() { return dice_.one_in(4) ? Content{} : Content{number()}; }

  private:
    double number() {
        constexpr std::array numbers{0.0, 1.0, 2.0, 3.0, 4.0, -2.0, 0.5, 2.25, 90.0, 91.0, 7.0, -0.1, 100.0};
        constexpr std::array whole{0.0, 1.0, 2.0, 3.0, 4.0, -2.0, 90.0, 91.0, 7.0, 100.0};
        return still_ ? dice_.one_of(whole) : dice_.one_of(numbers);
    }

    double code(const ControlModel& control, GroupId id, bool main) {
        const ModalGroup& group = control.groups[id];
        if (group.reset && (main || group.members.empty())) return *group.reset;
        return group.members.empty() ? static_cast<double>(dice_.between(0, 3))
                                     : dice_.one_of(group.members).number;
    }

    Content value_of(const Program& program, const Expression& expression) {
        const auto* owned = std::get_if<LoadMachine>(&expression.node);
        if (owned == nullptr) return Content{number()};
        if (!still_) return thrown(program, *owned);
        const auto [known, fresh] = machine_.try_emplace({owned->family, owned->number});
        if (fresh) known->second = thrown(program, *owned);
        return known->second;
    }

    Content thrown(const Program& program, const LoadMachine& owned) {
        const VariableRange* range = program.control->families[owned.family].find(owned.number);
        if (range != nullptr && range->is_bit) return Content{static_cast<double>(dice_.below(2))};
        return range != nullptr && range->may_be_vacant ? content() : Content{number()};
    }

    execution::UnknownEffects unknown_call(const Program& program, CallKindId kind) {
        const ControlModel& control = *program.control;
        execution::UnknownEffects effects;
        const bool shares = control.calls[kind].frame == Frame::shared;
        for (const VariableFamily& family : control.families)
            for (const std::int32_t number : {1, 2, 3, 100, 101, 500}) {
                const VariableRange* range = family.find(number);
                if (range == nullptr || range->meaning != Meaning::variable || !dice_.one_in(3)) continue;
                if (shares || control.spaces[range->space].scope != Scope::frame)
                    effects.stores.push_back({{range->space, number}, content()});
            }
        for (const Variable variable : program.handed_down)
            if (dice_.one_in(2) && !control.spaces[variable.space].written_once)
                effects.stores.emplace_back(program.meant_by(variable), content());
        for (std::size_t i = 0; i < control.groups.size(); ++i)
            if (control.groups[i].role != ModalRole::macro_call && dice_.one_in(4))
                effects.codes.emplace_back(static_cast<GroupId>(i),
                                           code(control, static_cast<GroupId>(i), false));
        effects.stops = dice_.one_in(10);
        return effects;
    }

    Dice& dice_;
    bool still_ = false;
    std::map<std::pair<FamilyId, std::int32_t>, Content> machine_; ///< what was asked for in this run
};

/// Whether a run may begin with the program: by hand, or by a caller that is not in the workspace.
bool may_be_started(const ProgramAnalysis& analysis) {
    return analysis.is_main() || analysis.callers().empty() ||
           (!analysis.complete() && !analysis.program().local);
}

execution::Start start_of(const ProgramAnalysis& analysis, RandomEnvironment& world) {
    execution::Start start{analysis.index(), {}};
    if (!analysis.is_main())
        for (const Variable formal : analysis.control().formals)
            if (const Content content = world.content()) start.variables.emplace_back(formal, content);
    return start;
}

constexpr execution::Bounds bounds{.steps = 250, .depth = 4};

} // namespace

std::optional<std::string> refuted(const std::vector<NamedText>& files, Dice& dice,
                                   std::map<std::string, std::size_t>& held) {
    const auto workspace = analyse_files(files, {.complete = dice.one_in(2), .jobs = 1});
    HeldAgainstFacts claims(*workspace);
    RandomEnvironment world(dice);
    constexpr int runs = 10;
    for (const ProgramAnalysis& analysis : workspace->programs()) {
        if (!may_be_started(analysis)) continue;
        for (int i = 0; i < runs && !claims.refuted(); ++i) {
            const bool still = i % 2 == 0;
            const execution::Environment environment =
                world.in_front_of(analysis.control(), analysis.is_main(), still);
            LiveStores live;
            execution::Stepper stepper(
                *workspace, environment,
                [&](execution::Stepper& at, const execution::Event& event) {
                    claims.observe(at, event);
                    live.observe(at, event);
                },
                bounds);
            claims.begin();
            const execution::Leaving how = stepper.run(start_of(analysis, world));
            ++held["runs"];
            if (how == execution::Leaving::fault) ++held["runs that end with a fault"];
            if (how == execution::Leaving::cut_off) ++held["runs that are cut off"];
            claims.end(still);
            held["reads of stored values"] += live.held();
            if (live.refuted()) return live.refuted();
        }
    }
    for (const auto& [kind, times] : claims.held()) held[kind] += times;
    return claims.refuted();
}

} // namespace maclint::test
