//! Collects the numbers of variables from expressions and assignments.
#include "analyzer/queries/values/variable_numbers.hpp"

#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>

namespace maclint::queries {
namespace {

/// The number that an index of numbers alone is: `5000+1`.
std::optional<double> constant_in(const Program& program, ExpressionId id) {
    if (const auto* literal = std::get_if<Literal>(&program.expressions[id].node)) return literal->value;
    const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
    if (apply == nullptr || apply->operands.count != 2) return std::nullopt;
    const auto operands = program.operands_of(*apply);
    const auto left = constant_in(program, operands[0]), right = constant_in(program, operands[1]);
    if (!left || !right) return std::nullopt;
    switch (apply->operation) {
    case Operation::add: return *left + *right;
    case Operation::subtract: return *left - *right;
    case Operation::multiply: return *left * *right;
    default: return std::nullopt;
    }
}

/// What stands on the left of `=`.
Span target_of(const Program& program, Span assignment) {
    const std::string_view text = program.slice(assignment);
    const std::size_t end = text.substr(0, text.find('=')).find_last_not_of(" \t");
    return {assignment.begin, assignment.begin + static_cast<Offset>(end + 1)};
}

class Collector {
  public:
    explicit Collector(const Program& program)
        : program_(program) {}

    void add(FamilyId family, std::int64_t number, Span span, bool written) {
        found_.push_back({number, program_.control->families[family].find(number), span, written});
    }
    /// Of an index that is a number.
    void add_indexed(FamilyId family, ExpressionId index, Span span, bool written) {
        constexpr double most = 1e9; // no control has as many
        const std::optional<double> number = constant_in(program_, index);
        if (number && std::abs(*number) < most) add(family, std::llround(*number), span, written);
    }
    [[nodiscard]] std::vector<NumberUse> take() {
        std::ranges::stable_sort(found_, {}, [](const NumberUse& use) { return use.span.begin; });
        return std::move(found_);
    }

  private:
    const Program& program_;
    std::vector<NumberUse> found_;
};

} // namespace

std::vector<NumberUse> uses_of_numbers(const Program& program) {
    Collector numbers(program);
    for (const Expression& expression : program.expressions) {
        if (const auto* load = std::get_if<LoadMachine>(&expression.node))
            numbers.add(load->family, load->number, expression.span, false);
        else if (const auto* at = std::get_if<LoadAt>(&expression.node))
            numbers.add_indexed(at->family, at->index, expression.span, false);
    }
    for (const Effect& effect : program.effects) {
        const auto* assign = std::get_if<Assign>(&effect.what);
        if (assign == nullptr) continue;
        if (const auto* store = std::get_if<StoreMachine>(&assign->target))
            numbers.add(store->family, store->number, target_of(program, effect.span), true);
        else if (const auto* at = std::get_if<StoreAt>(&assign->target))
            numbers.add_indexed(at->family, at->index, target_of(program, effect.span), true);
    }
    return numbers.take();
}

bool rests_on_memory(const VariableRange& range) {
    const std::string_view source = range.source;
    return source == "T" || source.starts_with("T:") || source.starts_with("T;") ||
           source.starts_with("unknown");
}

std::string spell_number(const Program& program, std::int64_t number) {
    for (const VariableFamily& family : program.control->families)
        if (family.find(number) != nullptr) return std::string(family.name) + std::to_string(number);
    return "#" + std::to_string(number);
}

} // namespace maclint::queries
