//! Trial runs, whose unknowns are the same for both outcomes of the test.
#include "rules/variables/zero_test_misses_vacant_trials_finder.hpp"

#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace maclint::rules {
namespace {

using execution::Content;

constexpr std::uint64_t most_trials = 40;
constexpr execution::Bounds bounds{.steps = 1500, .depth = 4};
/// Blocks that are run for one program, whatever is asked.
constexpr std::size_t most_blocks = 400'000;
/// Numbers of the program's text that are tried.
constexpr std::size_t most_numbers = 60;

/// The numbers that unknowns get: usual ones, and those that the program is written with and greater ones, as
/// it may compare with them.
std::vector<double> numbers_for(const Program& program) {
    std::vector<double> numbers{0, 1, 2, -1, 0.5, 5, 100};
    const auto add = [&](double number) {
        if (numbers.size() < most_numbers && std::ranges::find(numbers, number) == numbers.end())
            numbers.push_back(number);
    };
    for (const Expression& expression : program.expressions)
        if (const auto* literal = std::get_if<Literal>(&expression.node)) {
            add(literal->value);
            add(literal->value + 1);
        }
    return numbers;
}

/// The same for the same question in the same trial.
std::uint64_t chance_of(std::string_view question, std::uint64_t trial) {
    std::uint64_t hash = 14695981039346656037U ^ (trial * 0x9E3779B97F4A7C15U);
    for (const char c : question) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    return hash ^ (hash >> 29U);
}

std::vector<Variable> locals_read_in(const Program& program) {
    std::vector<Variable> locals;
    for (const Expression& expression : program.expressions) {
        const auto* load = std::get_if<Load>(&expression.node);
        if (load != nullptr && program.control->spaces[load->variable.space].scope == Scope::frame &&
            std::ranges::find(locals, load->variable) == locals.end())
            locals.push_back(load->variable);
    }
    return locals;
}

} // namespace

VacancyTrials::VacancyTrials(const ProgramAnalysis& analysis)
    : analysis_(analysis)
    , unset_(analysis)
    , outputs_(texts_) {}

/// In every other trial nothing is vacant: many programs refuse to run without one of their letters.
Content VacancyTrials::content_of(std::string_view question) const {
    const bool is_vacant = number_ % 2 == 0 && chance_of(question, number_) % 4 == 0;
    return is_vacant ? Content{} : Content{number_of(question)};
}

double VacancyTrials::number_of(std::string_view question) const {
    return numbers_[chance_of(question, number_) / 4 % numbers_.size()];
}

/// Everything that the text does not tell.
execution::Environment VacancyTrials::environment() {
    execution::Environment environment;
    environment.at_start = [this](const Program& program, Variable asked) {
        return asked == variable_ ? content_ : content_of(program.spell(asked));
    };
    environment.code_at_start = [this](GroupId id) {
        const ModalGroup& group = analysis_.control().groups[id];
        if (group.members.empty()) return group.reset.value_or(number_of(group.name));
        const auto at = static_cast<std::size_t>(std::abs(number_of(group.name)));
        return group.members[at % group.members.size()].number;
    };
    environment.value_of = [this](const Program& program, ExpressionId id) {
        return Content{number_of(program.slice(program.expressions[id].span))};
    };
    environment.typed_in = [this](const Program& program, Variable asked) {
        return Content{number_of(program.spell(asked))};
    };
    environment.skips = [](const BlockView&) { return false; };
    environment.unknown_call = [](const Program&, CallKindId) { return execution::UnknownEffects{}; };
    return environment;
}

/// The variable is 0 while the test is computed, and vacant again when it has been.
void VacancyTrials::observe(execution::Stepper& stepper, const execution::Event& event) {
    outputs_.observe(stepper, event);
    blocks_ += std::holds_alternative<execution::BlockBegins>(event) ? 1U : 0U;
    const auto* compared = std::get_if<execution::Compared>(&event);
    if (compared == nullptr || !content_ || compared->expression != test_ || stepper.depth() != 0) return;
    content_.reset();
    stepper.set(variable_, {});
}

VacancyTrials::Trial VacancyTrials::run(const dataflow::Comparison& test, Variable variable,
                                        std::uint64_t number, Taken taken) {
    number_ = number;
    variable_ = variable;
    test_ = test.expression;
    content_ = taken == Taken::for_zero ? Content{0.0} : Content{};
    outputs_ = execution::Outputs(texts_);
    const Program& program = analysis_.program();
    execution::Start start{analysis_.index(), {}, test.effect};
    for (const Local& local : locals_) {
        const std::string name = program.spell(local.variable);
        start.variables.emplace_back(local.variable, local.variable == variable ? content_
                                                     : local.may_be_vacant      ? content_of(name)
                                                                                : number_of(name));
    }
    const execution::Leaving how = stepper_->run(start);
    return {std::move(outputs_), how == execution::Leaving::alarm, how >= execution::Leaving::fault};
}

std::optional<bool> VacancyTrials::are_alike(const dataflow::Comparison& test, Variable variable,
                                             Refused refused) {
    if (!stepper_) {
        environment_ = environment();
        stepper_.emplace(
            analysis_.workspace(), environment_,
            [this](execution::Stepper& at, const execution::Event& event) { observe(at, event); }, bounds);
        numbers_ = numbers_for(analysis_.program());
        for (const Variable local : locals_read_in(analysis_.program())) locals_.push_back({local, false});
    }
    for (Local& local : locals_) local.may_be_vacant = unset_.leads_to(local.variable, test.node);
    std::optional<bool> alike;
    for (std::uint64_t number = 0; number < most_trials; ++number) {
        if (blocks_ > most_blocks) return std::nullopt;
        const Trial vacant = run(test, variable, number, Taken::for_vacant);
        const Trial zero = run(test, variable, number, Taken::for_zero);
        if (vacant.is_refused && zero.is_refused) continue; // for something else, or too late to tell
        const bool passes =
            vacant.is_refused &&
            (refused == Refused::is_alike ||
             (refused == Refused::at_once && vacant.outputs.gives_no_more_than(zero.outputs)));
        if (vacant.is_broken_off && zero.is_broken_off && vacant.outputs.begins_like(zero.outputs)) continue;
        const bool is_alike = passes || vacant.outputs == zero.outputs;
        if (!is_alike) return false;
        alike = true;
    }
    return alike;
}

} // namespace maclint::rules
