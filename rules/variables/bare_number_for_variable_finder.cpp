//! Compares numbers with the variables that words of the same letter take.
#include "rules/variables/bare_number_for_variable_finder.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "rules/variables/bare_number_for_variable_calculations_finder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <variant>

namespace maclint::rules {
namespace {

/// The number, where it can be that of a variable.
std::optional<std::int64_t> as_number(const Literal& literal) {
    constexpr double most = 1e6;
    const bool is_number = literal.value >= 1 && literal.value <= most &&
                           literal.value == std::floor(literal.value) && !literal.decimal_point;
    return is_number ? std::optional(static_cast<std::int64_t>(literal.value)) : std::nullopt;
}

/// The letter of a word and the number of the variable that is all of its value: `X#18`, `F[#517]`.
using Letter = std::pair<std::string_view, std::int64_t>;
using VariableWords = std::map<Letter, Span>;

VariableWords words_of_variables(const Program& program) {
    VariableWords found;
    for (const Word& word : program.words) {
        const auto* id = std::get_if<ExpressionId>(&word.value);
        const auto* load = id == nullptr ? nullptr : std::get_if<Load>(&program.expressions[*id].node);
        if (load != nullptr) found.emplace(Letter{word.address, load->variable.number}, word.span);
    }
    return found;
}

/// The word in which a place of the text stands, or nullptr.
const Word* word_at(const Program& program, Offset at) {
    const auto after =
        std::ranges::upper_bound(program.words, at, {}, [](const Word& word) { return word.span.begin; });
    if (after == program.words.begin()) return nullptr;
    const Word& word = *(after - 1);
    return word.span.contains(at) ? &word : nullptr;
}

/// Whether it is the number of the argument that the word's own letter sets: `X[24]`.
bool is_argument_of_letter(const Program& program, const Word& word, std::int64_t number) {
    const ControlModel& control = *program.control;
    return std::ranges::any_of(control.formals, [&](Variable formal) {
        const auto letter = formal.number == number ? control.letter_of(formal) : std::nullopt;
        return letter && word.address == std::string_view(&*letter, 1);
    });
}

/// `[517]`. A small number is a number more often: then a word of the same letter takes the variable, or the
/// letter is that of the argument.
void find_in_brackets(const Program& program, const VariableWords& siblings, std::vector<BareNumber>& found) {
    constexpr std::int64_t first_common = 100;
    for (const Expression& expression : program.expressions) {
        const auto* literal = std::get_if<Literal>(&expression.node);
        if (literal == nullptr || !program.slice(expression.span).starts_with('[')) continue;
        const auto number = as_number(*literal);
        if (!number) continue;
        const Word* word = word_at(program, expression.span.begin);
        const auto sibling = word == nullptr ? siblings.end() : siblings.find({word->address, *number});
        if (sibling != siblings.end())
            found.push_back({*number, expression.span, sibling->second});
        else if ((*number >= first_common ||
                  (word != nullptr && is_argument_of_letter(program, *word, *number))) &&
                 names_variable(program, *number))
            found.push_back({*number, expression.span, {}});
    }
}

/// Where the program first reads the variable of that number.
std::optional<Span> first_read(const Program& program, std::int64_t number) {
    for (const Expression& expression : program.expressions)
        if (const auto* load = std::get_if<Load>(&expression.node);
            load != nullptr && load->variable.number == number)
            return expression.span;
    return std::nullopt;
}

/// The numbers of the common variables that the program sets.
std::set<std::int64_t> common_numbers_set(const Program& program) {
    constexpr std::int32_t first_common = 100;
    std::set<std::int64_t> numbers;
    for (const Effect& effect : program.effects)
        if (const auto* assign = std::get_if<Assign>(&effect.what))
            if (const auto* target = std::get_if<Variable>(&assign->target))
                if (target->number >= first_common) numbers.insert(target->number);
    return numbers;
}

bool reads(const Program& program, ExpressionId id, std::int64_t number) {
    const Expression& expression = program.expressions[id];
    if (const auto* load = std::get_if<Load>(&expression.node)) return load->variable.number == number;
    const auto* apply = std::get_if<Apply>(&expression.node);
    return apply != nullptr && std::ranges::any_of(program.operands_of(*apply), [&](ExpressionId operand) {
               return reads(program, operand, number);
           });
}

bool calculates_with(const Program& program, const Word& word, std::int64_t number) {
    const auto* id = std::get_if<ExpressionId>(&word.value);
    return id != nullptr && std::holds_alternative<Apply>(program.expressions[*id].node) &&
           reads(program, *id, number);
}

/// The sum or difference that the value of the word is.
const Apply* sum_in(const Program& program, const Word& word) {
    const auto* id = std::get_if<ExpressionId>(&word.value);
    const auto* apply = id == nullptr ? nullptr : std::get_if<Apply>(&program.expressions[*id].node);
    const bool is_sum =
        apply != nullptr && (apply->operation == Operation::add || apply->operation == Operation::subtract);
    return is_sum ? apply : nullptr;
}

bool adds_own_argument(const Program& program, const Word& word) {
    const Apply* sum = sum_in(program, word);
    return sum != nullptr && std::ranges::any_of(program.operands_of(*sum), [&](ExpressionId operand) {
               const auto* load = std::get_if<Load>(&program.expressions[operand].node);
               return load != nullptr && is_argument_of_letter(program, word, load->variable.number);
           });
}

/// `X[24+#1]` beside `Y[#25+#2]`.
void find_in_sums(const Program& program, std::vector<BareNumber>& found) {
    for (ItemId item = 0; item < program.items.size(); ++item) {
        const auto block = stored_block(program, item);
        if (!block) continue;
        const auto sibling = std::ranges::find_if(
            block->words, [&](const Word& word) { return adds_own_argument(program, word); });
        if (sibling == block->words.end()) continue;
        for (const Word& word : block->words) {
            const Apply* sum = sum_in(program, word);
            if (sum == nullptr) continue;
            for (const ExpressionId operand : program.operands_of(*sum)) {
                const auto number = number_of_a_variable(program, operand);
                if (number && is_argument_of_letter(program, word, *number))
                    found.push_back({*number, program.expressions[operand].span, sibling->span});
            }
        }
    }
}

/// `Q[17/2]` where the program reads #17, which Q passes: nobody has two numbers calculated. Of a small
/// number a word of the letter must take the variable as it is: `F#9`.
void find_in_words_of_numbers(const Program& program, const VariableWords& siblings,
                              std::vector<BareNumber>& found) {
    for (const Word& word : program.words) {
        const auto* id = std::get_if<ExpressionId>(&word.value);
        const auto* apply = id == nullptr ? nullptr : std::get_if<Apply>(&program.expressions[*id].node);
        if (apply == nullptr || !is_of_numbers(program, *apply)) continue;
        for (const ExpressionId operand : program.operands_of(*apply)) {
            const auto number = number_of_a_variable(program, operand);
            if (!number || !is_argument_of_letter(program, word, *number)) continue;
            const auto sibling = siblings.find({word.address, *number});
            const auto read =
                is_like_a_variable(program, *number) ? first_read(program, *number) : std::nullopt;
            const Span span = program.expressions[operand].span;
            if (sibling != siblings.end())
                found.push_back({*number, span, sibling->second});
            else if (read)
                found.push_back({*number, span, *read});
        }
    }
}

/// The numbers that a calculation holds.
void collect_numbers(const Program& program, ExpressionId id, std::vector<ExpressionId>& numbers) {
    const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
    if (apply == nullptr || !is_basic_arithmetic(apply->operation)) return;
    for (const ExpressionId operand : program.operands_of(*apply))
        if (number_of_a_variable(program, operand))
            numbers.push_back(operand);
        else
            collect_numbers(program, operand, numbers);
}

/// `X[#101*#4] Y[102+#5]`, where the program sets #101 and #102.
void find_beside_next_number(const Program& program, std::vector<BareNumber>& found) {
    const std::set<std::int64_t> set = common_numbers_set(program);
    if (set.size() < 2) return;
    for (ItemId item = 0; item < program.items.size(); ++item) {
        const auto block = stored_block(program, item);
        if (!block) continue;
        for (const Word& word : block->words) {
            const auto* value = std::get_if<ExpressionId>(&word.value);
            std::vector<ExpressionId> numbers;
            if (value != nullptr) collect_numbers(program, *value, numbers);
            for (const ExpressionId literal : numbers) {
                const std::int64_t number = *number_of_a_variable(program, literal);
                if (!set.contains(number) || !is_like_a_variable(program, number)) continue;
                const auto sibling = std::ranges::find_if(block->words, [&](const Word& other) {
                    return other.address != word.address &&
                           std::ranges::any_of(std::array{number - 1, number + 1}, [&](std::int64_t next) {
                               return set.contains(next) && calculates_with(program, other, next);
                           });
                });
                if (sibling != block->words.end())
                    found.push_back({number, program.expressions[literal].span, sibling->span});
            }
        }
    }
}

/// Whether the word moves an axis or gives a length, and its value is written as a number.
const Literal* length_in(const Word& word) {
    constexpr std::string_view lengths = "XYZUVWIJKR";
    const auto* literal = std::get_if<Literal>(&word.value);
    const bool is_length = word.address.size() == 1 && lengths.find(word.address) != std::string_view::npos;
    return is_length && literal != nullptr && literal->value != 0 ? literal : nullptr;
}

/// `X18` beside `X#18`, in a program that writes points.
void find_words(const Program& program, const VariableWords& siblings, std::vector<BareNumber>& found) {
    constexpr std::size_t enough_points = 3;
    if (siblings.empty()) return;
    std::vector<BareNumber> candidates;
    std::size_t with_point = 0, without = 0;
    const auto wanted = [](const WordSummary&) { return true; };
    for_each_block_with_words(
        program, wanted, [&](const BlockView&, std::span<const Word> words, const WordSummary*) {
            for (const Word& word : words) {
                const Literal* length = length_in(word);
                if (length == nullptr) continue;
                (length->decimal_point ? with_point : without)++;
                const auto number = as_number(*length);
                const auto sibling = number ? siblings.find({word.address, *number}) : siblings.end();
                if (sibling != siblings.end() && program.slice(word.span).find('[') == std::string_view::npos)
                    candidates.push_back({*number, word.span, sibling->second});
            }
        });
    if (with_point >= enough_points && without == candidates.size())
        found.insert(found.end(), candidates.begin(), candidates.end());
}

} // namespace

std::optional<std::int64_t> number_of_a_variable(const Program& program, ExpressionId id) {
    const auto* literal = std::get_if<Literal>(&program.expressions[id].node);
    return literal == nullptr ? std::nullopt : as_number(*literal);
}

bool names_variable(const Program& program, std::int64_t number) {
    const std::string_view text = program.slice(program.span);
    const std::string written = "#" + std::to_string(number);
    for (std::size_t at = text.find(written); at != std::string_view::npos; at = text.find(written, at + 1)) {
        const std::size_t end = at + written.size();
        if (end == text.size() || text[end] < '0' || text[end] > '9') return true;
    }
    return false;
}

std::vector<BareNumber> find_bare_numbers(const Program& program) {
    std::vector<BareNumber> found;
    const VariableWords siblings = words_of_variables(program);
    find_in_brackets(program, siblings, found);
    find_in_calculations(program, found);
    find_in_sums(program, found);
    find_in_words_of_numbers(program, siblings, found);
    find_beside_next_number(program, found);
    find_words(program, siblings, found);
    const auto begin = [](const BareNumber& bare) { return bare.span.begin; };
    std::ranges::stable_sort(found, {}, begin);
    const auto repeated = std::ranges::unique(found, {}, begin);
    found.erase(repeated.begin(), repeated.end());
    return found;
}

} // namespace maclint::rules
