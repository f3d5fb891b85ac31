//! Looks at the tokens of a block that the parser could not read.
#include "analyzer/dialect/fanuc/find_faults.hpp"

#include "analyzer/dialect/fanuc/block_tokens.hpp"
#include "analyzer/dialect/fanuc/keywords.hpp"
#include "analyzer/dialect/fanuc/letter_o.hpp"
#include "analyzer/program/faults.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace maclint::fanuc {
namespace {

using Kind = Token::Kind;

bool is_operand_end(const BlockTokens& tokens, std::size_t i) {
    return tokens.is(i, Kind::close) || tokens.is(i, Kind::variable) || tokens.is(i, Kind::number);
}

/// Whether the bracket opens the arguments of a function that has two.
bool takes_two(const BlockTokens& tokens, std::size_t open) {
    const std::string function = open == 0 ? std::string() : tokens.capitals(open - 1);
    return function.ends_with("ATAN") || function.ends_with("POW");
}

/// Signs that mean something at other places: the mark of the tape, the end of a comment.
constexpr std::string_view meant_elsewhere = "%)";

/// The words of output and naming statements.
constexpr std::string_view output_words[] = {"DPRNT", "BPRNT", "SETVN"};

} // namespace

bool begins_statement(std::string_view text, std::span<const Token> block) {
    const BlockTokens tokens(text, block);
    const std::size_t first = tokens.after_head();
    if (tokens.after_variable(first) != first) return true;
    return first < tokens.size() && !split_keywords(tokens.capitals(first)).empty();
}

std::optional<SyntaxError> find_missing_number(std::string_view text, std::span<const Token> block) {
    const BlockTokens tokens(text, block);
    const std::size_t first = tokens.after_marks();
    const std::string letter = tokens.capitals(first);
    if (letter != "N" && letter != "O") return std::nullopt;
    const bool ends = first + 1 >= tokens.size();
    if (!ends && !tokens.is(first + 1, Kind::letters) && !tokens.is(first + 1, Kind::comment))
        return std::nullopt;
    return letter == "N" ? tokens.error(tokens.span(first), "the number of the block after 'N'",
                                        faults::no_sequence_number)
                         : tokens.error(tokens.span(first), "the number of the program after 'O'",
                                        faults::no_program_number);
}

std::optional<SyntaxError> find_misplaced_program_number(std::string_view text,
                                                         std::span<const Token> block) {
    const BlockTokens tokens(text, block);
    for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
        if (tokens.capitals(i) != "O" || !is_operand_end(tokens, i - 1)) continue;
        if (!tokens.is(i + 1, Kind::number) || !tokens.touch(i)) continue;
        const std::string_view number = tokens.written(i + 1);
        if (!std::ranges::all_of(number, is_digit)) continue;
        if (number.size() < digits_of_program && tokens.touch(i - 1)) continue; // a letter for the figure 0
        return tokens.error(join(tokens.span(i), tokens.span(i + 1)),
                            "a program number at the head of a block", faults::number_misplaced);
    }
    return std::nullopt;
}

std::optional<SyntaxError> find_missing_equals(std::string_view text, std::span<const Token> block) {
    const BlockTokens tokens(text, block);
    const std::size_t first = tokens.after_head();
    const std::size_t next = tokens.after_variable(first);
    if (next == first || next >= tokens.size()) return std::nullopt;
    const bool goes_on = tokens.is(next, Kind::sign) || tokens.is(next, Kind::operation) ||
                         tokens.is(next, Kind::open) || tokens.is(next, Kind::number) ||
                         tokens.is(next, Kind::variable) || is_operator_word(tokens.capitals(next)) ||
                         is_function(tokens.capitals(next));
    // `#1+2=5`: something is stored, but not in a variable.
    if (!goes_on || std::ranges::find(block, Kind::equals, &Token::kind) != block.end()) return std::nullopt;
    const Span variable = join(tokens.span(first), tokens.span(next - 1));
    const std::string written(text.substr(variable.begin, variable.length()));
    return tokens.error(join(variable, tokens.span(next)), "'=' after '" + written + "'", faults::no_equals);
}

std::optional<SyntaxError> find_missing_operator(std::string_view text, std::span<const Token> block) {
    const BlockTokens tokens(text, block);
    bool calculates = false;
    std::vector<std::size_t> open;
    std::size_t last_opened = 0; // of the bracket that was closed last
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens.is(i, Kind::equals)) calculates = true;
        const bool begins = tokens.is(i, Kind::open) || tokens.is(i, Kind::variable);
        if (i > 0 && begins && (calculates || !open.empty()) && is_operand_end(tokens, i - 1)) {
            const std::size_t list = tokens.is(i - 1, Kind::close) ? last_opened
                                     : open.empty()                ? 0
                                                                   : open.back();
            return takes_two(tokens, list)
                       ? tokens.error(tokens.span(i), "',' or '/' before the second argument",
                                      faults::no_comma)
                       : tokens.error(tokens.span(i), "an operator before it", faults::expression);
        }
        if (tokens.is(i, Kind::open)) open.push_back(i);
        if (tokens.is(i, Kind::close) && !open.empty()) {
            last_opened = open.back();
            open.pop_back();
        }
        if (tokens.is(i, Kind::comma) && tokens.is(i + 1, Kind::close))
            return tokens.error(tokens.span(i), "a second argument after it", faults::argument);
    }
    return std::nullopt;
}

std::optional<SyntaxError> find_output_fault(std::string_view text, std::span<const Token> block) {
    const BlockTokens tokens(text, block);
    const std::size_t first = tokens.after_head();
    const std::string word = tokens.capitals(first);
    const auto* known =
        std::ranges::find_if(output_words, [&](std::string_view w) { return word.starts_with(w); });
    if (known == std::end(output_words)) return std::nullopt;
    const Span rest = join(tokens.span(first), tokens.span(tokens.size() - 1));
    if (*known != "SETVN" && word == *known && tokens.is(first + 1, Kind::open)) return std::nullopt;
    if (*known != "SETVN")
        return tokens.error(rest, std::string(*known) + "[text#1[53]]", faults::output_form);
    const std::size_t open = first + 2;
    const bool has_names = word == *known && tokens.is(first + 1, Kind::number) &&
                           tokens.is(open, Kind::open) && tokens.is(tokens.size() - 1, Kind::close) &&
                           tokens.size() > open + 2;
    if (!has_names) return tokens.error(rest, "SETVN500[NAME]", faults::naming_form);
    for (std::size_t i = open + 1; i + 1 < tokens.size(); ++i)
        if (!tokens.is(i, Kind::letters) && !tokens.is(i, Kind::number) && !tokens.is(i, Kind::comma))
            return tokens.error(tokens.span(i), "letters, figures and '_' in a name", faults::name_character);
    return std::nullopt;
}

std::optional<SyntaxError> find_foreign_character(std::string_view text, std::span<const Token> block) {
    const BlockTokens tokens(text, block);
    const auto is_foreign = [&](std::size_t i) {
        return tokens.is(i, Kind::other) && meant_elsewhere.find(tokens.written(i)) == std::string_view::npos;
    };
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (!is_foreign(i)) continue;
        std::size_t last = i; // a character may have several bytes
        while (is_foreign(last + 1) && tokens.touch(last)) ++last;
        return tokens.error(join(tokens.span(i), tokens.span(last)), "", faults::character);
    }
    return std::nullopt;
}

} // namespace maclint::fanuc
