//! Holds the texts of statements against each other, number by number.
#include "rules/variables/crossed_axes_rows_finder.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/source/budget.hpp"

#include <charconv>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>

namespace maclint::rules {
namespace {

/// A statement as it is written: its text with the numbers of variables left out, and these.
struct Statement {
    EffectId effect;
    std::string shape; ///< "#=#+#"
    std::vector<std::int64_t> numbers;
};

struct Row {
    std::vector<Statement> statements;
    std::optional<ExpressionId> condition; ///< of the IFs that they stand behind
    flow::NodeId node;                     ///< of the first
};

constexpr std::int64_t first_shared = 100; ///< smaller ones are the program's own

/// Nothing where a variable is no plain number.
std::optional<Statement> read(const Program& program, EffectId effect) {
    const std::string text = without_blanks(program.slice(program.effects[effect].span));
    Statement statement{effect, {}, {}};
    for (std::size_t at = 0; at < text.size();) {
        statement.shape += text[at];
        if (text[at++] != '#') continue;
        std::int64_t number = 0;
        const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), number);
        if (error != std::errc()) return std::nullopt;
        at = static_cast<std::size_t>(end - text.data());
        statement.numbers.push_back(number);
    }
    const bool is_shared = !statement.numbers.empty() && statement.numbers.front() >= first_shared;
    return is_shared ? std::optional(statement) : std::nullopt;
}

class Rows {
  public:
    explicit Rows(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , program_(analysis.program()) {
        for (flow::NodeId node = 0; node < analysis.graph().nodes_in_text; ++node) take(node);
        end_row();
    }

    [[nodiscard]] std::vector<StoreOfAnotherCase> find() const {
        std::vector<StoreOfAnotherCase> found;
        for (std::size_t second = 1; second < rows_.size() && Budget::allows(); ++second)
            for (std::size_t first = second; first-- > 0;) {
                const auto odd = odd_one(rows_[first], rows_[second]);
                if (!odd || !are_cases(rows_[first], rows_[second])) continue;
                found.push_back(*odd);
                break;
            }
        return found;
    }

  private:
    void take(flow::NodeId node) {
        const Slice effects = analysis_.graph().nodes[node].effects;
        for (EffectId id = effects.first; id < effects.first + effects.count; ++id) {
            const auto& what = program_.effects[id].what;
            if (id >= behind_if_.first && id < behind_if_.first + behind_if_.count) continue; // it is taken
            if (const auto* guarded = std::get_if<Guarded>(&what)) {
                take_guarded(node, *guarded);
            } else if (std::holds_alternative<Assign>(what)) {
                if (!row_.statements.empty() && row_.condition) end_row();
                add(node, id, std::nullopt);
            } else {
                end_row();
            }
        }
    }

    void take_guarded(flow::NodeId node, const Guarded& guarded) {
        behind_if_ = guarded.effects;
        const bool sets = guarded.effects.count == 1 &&
                          std::holds_alternative<Assign>(program_.effects[guarded.effects.first].what);
        const bool goes_on = !row_.statements.empty() && row_.condition && sets &&
                             queries::same_expression(program_, *row_.condition, guarded.condition);
        if (!goes_on) end_row();
        if (sets) add(node, guarded.effects.first, guarded.condition);
    }

    void add(flow::NodeId node, EffectId effect, std::optional<ExpressionId> condition) {
        const bool begins = analysis_.graph().in[node].size() > 1; // a label
        if (begins && !condition && !row_.statements.empty() &&
            analysis_.graph().node_of(row_.statements.back().effect) != node)
            end_row();
        auto statement = read(program_, effect);
        if (!statement) return end_row();
        if (row_.statements.empty()) row_ = {{}, condition, node};
        row_.statements.push_back(std::move(*statement));
    }

    void end_row() {
        constexpr std::size_t fewest = 2, most_rows = 200;
        if (row_.statements.size() >= fewest && rows_.size() < most_rows) rows_.push_back(std::move(row_));
        row_ = {};
    }

    /// By how much the numbers of the second are greater, where it is one distance or none; else nothing.
    [[nodiscard]] static std::optional<std::int64_t> distance(const Statement& a, const Statement& b) {
        if (a.shape != b.shape || a.numbers.size() != b.numbers.size()) return std::nullopt;
        const std::int64_t by = b.numbers.front() - a.numbers.front();
        for (std::size_t i = 0; i < a.numbers.size(); ++i)
            if (b.numbers[i] != a.numbers[i] && b.numbers[i] - a.numbers[i] != by) return std::nullopt;
        return by;
    }

    [[nodiscard]] std::optional<StoreOfAnotherCase> odd_one(const Row& first, const Row& second) const {
        const std::size_t count = first.statements.size();
        // Two statements are few: IFs that ask the same keep them together.
        constexpr std::size_t enough = 3;
        if (second.statements.size() != count ||
            first.condition.has_value() != second.condition.has_value() ||
            (count < enough && !first.condition))
            return std::nullopt;
        std::optional<std::size_t> odd;
        std::optional<std::int64_t> by;
        for (std::size_t i = 0; i < count; ++i) {
            const auto here = distance(first.statements[i], second.statements[i]);
            if (!here) return std::nullopt;
            if (*here == 0) {
                if (odd) return std::nullopt;
                odd = i;
            } else if (by && *by != *here) {
                return std::nullopt;
            } else {
                by = here;
            }
        }
        if (!odd || !by || !is_like_the_others(second, *odd)) return std::nullopt;
        const Statement& statement = second.statements[*odd];
        const auto spell = [](std::int64_t number) { return "#" + std::to_string(number); };
        return StoreOfAnotherCase{statement.effect, spell(statement.numbers.front()),
                                  spell(statement.numbers.front() + *by), first.statements[*odd].effect};
    }

    /// Whether it is made as the others are, and stores where they do: a counter for both cases does not.
    [[nodiscard]] bool is_like_the_others(const Row& row, std::size_t odd) const {
        const Statement& statement = row.statements[odd];
        const Statement& other = row.statements[odd == 0 ? 1 : 0];
        const auto range_of = [&](const Statement& of) {
            const auto* store =
                std::get_if<StoreMachine>(&std::get<Assign>(program_.effects[of.effect].what).target);
            return store == nullptr ? nullptr : program_.control->families[store->family].find(store->number);
        };
        return statement.shape == other.shape && range_of(statement) == range_of(other);
    }

    [[nodiscard]] bool are_cases(const Row& first, const Row& second) const {
        if (first.condition) return ask_for_other_numbers(*first.condition, *second.condition);
        bool leads_there = false;
        flow::walk<flow::Direction::forward>(analysis_.graph(), {first.node},
                                             [&](flow::EdgeId, flow::NodeId to) {
                                                 leads_there |= to == second.node;
                                                 return leads_there ? flow::Step::end : flow::Step::go_on;
                                             });
        return !leads_there;
    }

    /// #30EQ2 and #30EQ4.
    [[nodiscard]] bool ask_for_other_numbers(ExpressionId a, ExpressionId b) const {
        const auto* first = std::get_if<Apply>(&program_.expressions[a].node);
        const auto* second = std::get_if<Apply>(&program_.expressions[b].node);
        if (first == nullptr || second == nullptr || first->operation != Operation::equal ||
            second->operation != Operation::equal)
            return false;
        const auto of_first = program_.operands_of(*first), of_second = program_.operands_of(*second);
        return queries::same_expression(program_, of_first[0], of_second[0]) &&
               !queries::same_expression(program_, of_first[1], of_second[1]) &&
               std::holds_alternative<Literal>(program_.expressions[of_first[1]].node) &&
               std::holds_alternative<Literal>(program_.expressions[of_second[1]].node);
    }

    const ProgramAnalysis& analysis_;
    const Program& program_;
    std::vector<Row> rows_;
    Row row_;
    Slice behind_if_ = {}; ///< what the last IF guards
};

} // namespace

std::vector<StoreOfAnotherCase> find_stores_of_other_cases(const ProgramAnalysis& analysis) {
    return Rows(analysis).find();
}

} // namespace maclint::rules
