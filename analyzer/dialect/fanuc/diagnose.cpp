//! Finds the cause of a syntax error in a block's text; the parser's recovery is only asked where the text
//! ran out.
#include "analyzer/dialect/fanuc/diagnose.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/cut_block.hpp"
#include "analyzer/dialect/fanuc/find_faults.hpp"
#include "analyzer/dialect/fanuc/keywords.hpp"
#include "analyzer/dialect/fanuc/kinds.hpp"
#include "analyzer/dialect/fanuc/letter_o.hpp"
#include "analyzer/dialect/fanuc/lexer.hpp"
#include "analyzer/dialect/fanuc/remarks.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/dialect/shown_text.hpp"
#include "analyzer/dialect/wide_signs.hpp"
#include "analyzer/program/faults.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::fanuc {
namespace {

using TokenKind = Token::Kind;

/// `WH[` is WHILE: both letters are enough for the control.
bool begins_condition(std::string_view word, const Token* next) {
    return word == "WH" && next != nullptr && next->kind == TokenKind::open;
}

/// The tokens of a block and questions about them.
class ErrorExplainer : public CutBlock<Token> {
  public:
    ErrorExplainer(std::string_view text, Span block)
        : CutBlock(text, tokens_of(text, block))
        , block_(block) {}

    [[nodiscard]] std::string capitals(const Token& token) const { return without_blanks(text(token)); }

    [[nodiscard]] std::optional<SyntaxError> parenthesis_as_bracket() const;
    [[nodiscard]] std::optional<SyntaxError> bracket_mismatch() const;
    [[nodiscard]] std::optional<SyntaxError> letter_o() const { return find_letter_o(text_, tokens_); }
    [[nodiscard]] std::optional<SyntaxError> output() const { return find_output_fault(text_, tokens_); }
    [[nodiscard]] std::optional<SyntaxError> misplaced_number() const {
        return find_misplaced_program_number(text_, tokens_);
    }
    [[nodiscard]] std::optional<SyntaxError> block_without_number() const {
        return find_missing_number(text_, tokens_);
    }
    [[nodiscard]] std::optional<SyntaxError> missing_equals() const {
        return find_missing_equals(text_, tokens_);
    }
    [[nodiscard]] std::optional<SyntaxError> missing_operator() const {
        return find_missing_operator(text_, code());
    }
    [[nodiscard]] std::optional<SyntaxError> foreign_character() const {
        return find_foreign_character(text_, code());
    }
    [[nodiscard]] std::optional<SyntaxError> misspelt_jump() const;
    [[nodiscard]] std::optional<SyntaxError> unknown_keyword() const;
    [[nodiscard]] std::optional<SyntaxError> symbolic_comparison() const;
    [[nodiscard]] std::optional<SyntaxError> missing_value() const;
    [[nodiscard]] std::optional<SyntaxError> decimal_comma() const;
    [[nodiscard]] std::optional<SyntaxError> sharp_without_number() const;
    [[nodiscard]] std::optional<SyntaxError> missing_address() const;
    [[nodiscard]] std::optional<SyntaxError> bare_remark() const;
    [[nodiscard]] std::optional<SyntaxError> remark() const;
    [[nodiscard]] std::optional<SyntaxError> wide_sign() const;

  private:
    /// Keywords at the end of a row of letters: "GOTO" of THENGOTO, "SIN" of XSIN.
    [[nodiscard]] std::string last_keyword(const Token& token) const;
    [[nodiscard]] bool wants_value(const Token& token) const;
    [[nodiscard]] bool gives_value(const Token* token) const;
    /// `XY10.`: two addresses, of which the first has no value. An I as second one makes an increment on some
    /// controls: the tree tells.
    [[nodiscard]] bool lacks_value(const Token& token, const Token* next) const;
    [[nodiscard]] bool looks_like_expression(const Token& comment) const;
    [[nodiscard]] bool is_known(const Token& token, const Token* next, int depth) const;
    [[nodiscard]] bool has_word(std::string_view keyword) const;
    /// The words of output and naming statements are text.
    [[nodiscard]] bool begins_free_text(const Token& token) const {
        const std::string word = capitals(token);
        return word == "DPRNT" || word == "BPRNT" || word == "SETVN";
    }
    /// The tokens before such a statement.
    [[nodiscard]] std::span<const Token> code() const {
        const auto text = std::ranges::find_if(tokens_, [&](const Token& token) {
            return token.kind == TokenKind::letters && begins_free_text(token);
        });
        return {tokens_.begin(), text};
    }
    /// Whether a '/' divides nothing: at the head of a block, after another one, before a word.
    [[nodiscard]] bool marks_skip(std::size_t index, const Token* next) const {
        return index == 0 || text(tokens_[index - 1]) == "/" ||
               (next != nullptr && next->kind == TokenKind::letters);
    }
    [[nodiscard]] SyntaxError make(SyntaxErrorKind kind, Span span, std::string_view subject,
                                   std::string cure, std::string_view fault = {}) const {
        SyntaxError error{kind, span, shown(subject), std::move(cure)};
        error.fault = fault;
        return error;
    }

    /// Where a value of a calculation is wrong, that is what the control stops at.
    [[nodiscard]] std::string_view fault_of_calculation() const {
        return begins_statement(text_, tokens_) ? faults::expression : std::string_view();
    }
    /// Whether a person wrote it for persons: it has a word that no control could mean.
    [[nodiscard]] bool is_prose() const;
    [[nodiscard]] std::string in_square_brackets(Offset open) const;

    Span block_;
};

std::string ErrorExplainer::last_keyword(const Token& token) const {
    if (token.kind != TokenKind::letters) return {};
    const std::string word = capitals(token);
    if (const std::vector<std::string_view> words = split_keywords(word); !words.empty())
        return std::string(words.back());
    // An address letter before a function: XSIN[30].
    if (word.size() > 2 && is_function(std::string_view(word).substr(1))) return word.substr(1);
    return word.size() == 1 ? word : std::string();
}

/// Whether an operand must follow: after `=`, an operator, a function, IF.
bool ErrorExplainer::wants_value(const Token& token) const {
    switch (token.kind) {
    case TokenKind::equals:
    case TokenKind::comparison:
    case TokenKind::sign:
    case TokenKind::operation:
    case TokenKind::open: return true;
    case TokenKind::letters: {
        const std::string word = last_keyword(token);
        return is_function(word) || is_operator_word(word) || word == "IF" || word == "WHILE";
    }
    default: return false;
    }
}

bool ErrorExplainer::lacks_value(const Token& token, const Token* next) const {
    const std::string word = capitals(token);
    const auto is_address = [](char c) { return c >= 'A' && c <= 'Z' && c != 'N' && c != 'O'; };
    return word.size() == 2 && word[1] != 'I' && std::ranges::all_of(word, is_address) && !is_keyword(word) &&
           !begins_condition(word, next) && gives_value(next) && next->kind != TokenKind::letters &&
           token.span.end == next->span.begin;
}

bool ErrorExplainer::gives_value(const Token* token) const {
    if (token == nullptr) return false;
    switch (token->kind) {
    case TokenKind::number:
    case TokenKind::variable:
    case TokenKind::foreign_name:
    case TokenKind::sharp:
    case TokenKind::sign:
    case TokenKind::open: return true;
    case TokenKind::letters: return is_function(last_keyword(*token)) || last_keyword(*token) == "NOT";
    default: return false;
    }
}

/// Whether the text in ( ) could stand in [ ]: numbers, variables, operators and functions only.
bool ErrorExplainer::looks_like_expression(const Token& comment) const {
    Span inside{comment.span.begin + 1, comment.span.end};
    if (is_closed(text(comment))) --inside.end;
    bool operand = false;
    for (const Token& token : tokens_of(text_, inside)) {
        switch (token.kind) {
        case TokenKind::number:
        case TokenKind::variable: operand = true; break;
        case TokenKind::letters:
            if (split_keywords(in_capitals(text_.substr(token.span.begin, token.span.length()))).empty())
                return false;
            break;
        case TokenKind::other:
        case TokenKind::comma: return false;
        default: break;
        }
    }
    return operand;
}

/// What the round brackets at `open` hold, all of them square; empty when they do not pair in the block. The
/// control ends a comment at its first ')', but that is not what was meant.
std::string ErrorExplainer::in_square_brackets(Offset open) const {
    std::string square;
    int depth = 0;
    for (Offset at = open; at < block_.end && square.size() < longest_shown; ++at) {
        const char c = text_[at];
        if (c == '(') ++depth;
        if (c == ')') --depth;
        square += c == '(' ? '[' : c == ')' ? ']' : c;
        if (depth == 0) return square;
    }
    return {};
}

std::optional<SyntaxError> ErrorExplainer::parenthesis_as_bracket() const {
    for (std::size_t i = 1; i < tokens_.size(); ++i) {
        const Token& comment = tokens_[i];
        if (comment.kind != TokenKind::comment) continue;
        const Token& before = tokens_[i - 1];
        const std::string word = last_keyword(before);
        const Token* next = at(i + 1);
        const bool sign_follows = next != nullptr && next->kind == TokenKind::sign;
        if (gives_value(next) && !(is_function(word) && sign_follows)) continue;
        const bool touches = before.span.end == comment.span.begin;
        const bool certain =
            is_function(word) || ((word == "IF" || word == "WHILE") && looks_like_expression(comment));
        const bool operand = (wants_value(before) || before.kind == TokenKind::sharp || word == "GOTO" ||
                              word == "DO" || word == "END") &&
                             looks_like_expression(comment);
        const bool address =
            word.size() == 1 && touches && looks_like_expression(comment) && word != "N" && word != "O";
        if (!certain && !operand && !address) continue;
        std::string cure = in_square_brackets(comment.span.begin);
        const bool number = word == "DO" || word == "END"; // it stands without brackets
        if (number && !cure.empty()) cure = cure.substr(1, cure.size() - 2);
        const std::string_view subject = text(before);
        return make(SyntaxErrorKind::parenthesis_as_bracket, comment.span,
                    word.empty() ? subject
                                 : subject.substr(subject.size() - std::min(word.size(), subject.size())),
                    cure, certain || operand ? faults::expression : std::string_view());
    }
    return std::nullopt;
}

std::optional<SyntaxError> ErrorExplainer::bracket_mismatch() const {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
        if (tokens_[i].kind == TokenKind::open) open.push_back(i);
        if (tokens_[i].kind != TokenKind::close) continue;
        if (open.empty())
            return make(SyntaxErrorKind::bracket_mismatch, tokens_[i].span, "]", "a '[' is missing before it",
                        faults::opening_bracket);
        open.pop_back();
    }
    if (open.empty()) return std::nullopt;
    // The bracket is missing before the word that ends the condition, or at the end of the block.
    for (std::size_t i = open.back() + 1; i < tokens_.size(); ++i) {
        if (tokens_[i].kind != TokenKind::letters) continue;
        const std::string word = capitals(tokens_[i]);
        if (word.starts_with("GOTO") || word.starts_with("THEN") || word.starts_with("DO"))
            return make(SyntaxErrorKind::bracket_mismatch, tokens_[open.back()].span, "[",
                        "a ']' is missing before '" + shown(text(tokens_[i])) + "'", faults::closing_bracket);
    }
    return make(SyntaxErrorKind::bracket_mismatch, tokens_[open.back()].span, "[", "its ']' is missing",
                faults::closing_bracket);
}

bool ErrorExplainer::is_known(const Token& token, const Token* next, int depth) const {
    std::string word = capitals(token);
    if (word.size() == 1) return true;
    if (!split_keywords(word).empty()) return true;
    const std::string_view after_first = std::string_view(word).substr(1);
    if (begins_condition(word, next)) return true;
    const bool value_follows = depth == 0 && gives_value(next);
    // An address before a function, a label after GOTO: XSIN[30], GOTON800.
    if (value_follows && (is_function(after_first) || word.ends_with("GOTON") || word.ends_with("GOTOO")))
        return true;
    if (explain(word).known || depth > 0) return false;
    // Letters before a keyword or after one are addresses when a value follows: THENG1.
    if (value_follows && !split_keywords(std::string_view(word).substr(0, word.size() - 1)).empty())
        return true;
    if (is_function(after_first)) return true;
    // Abbreviations of functions, and addresses left without a value.
    return word.size() == 2;
}

std::optional<SyntaxError> ErrorExplainer::unknown_keyword() const {
    int depth = 0;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
        const Token& token = tokens_[i];
        if (token.kind == TokenKind::open) ++depth;
        if (token.kind == TokenKind::close) --depth;
        if (token.kind != TokenKind::letters) continue;
        if (i > 0 && tokens_[i - 1].kind == TokenKind::sharp) continue; // a name
        const std::string word = capitals(token);
        if (begins_free_text(token)) return std::nullopt;
        const Token* next = at(i + 1);
        if (is_operator_word(word) && next != nullptr && next->kind == TokenKind::letters &&
            (capitals(*next) == "THEN" || capitals(*next) == "GOTO"))
            return make(SyntaxErrorKind::unknown_keyword, join(token.span, next->span),
                        text_.substr(token.span.begin, next->span.end - token.span.begin), capitals(*next));
        if (is_known(token, next, depth)) continue;
        SyntaxError error = unknown_word(text_, token.span);
        // A function has an argument: `T3 TAP M10` is no TAN.
        if (is_function(error.cure) && !gives_value(next)) error.cure.clear();
        // Among words the letters are addresses without a number.
        if (!begins_statement(text_, tokens_)) error.fault = {};
        return error;
    }
    return std::nullopt;
}

bool ErrorExplainer::has_word(std::string_view keyword) const {
    return std::ranges::any_of(code(), [&](const Token& token) {
        if (token.kind != TokenKind::letters) return false;
        const std::string word = capitals(token);
        const std::vector<std::string_view> words = split_keywords(word);
        return word == keyword || std::ranges::find(words, keyword) != words.end();
    });
}

std::optional<SyntaxError> ErrorExplainer::symbolic_comparison() const {
    if (!has_word("IF") && !has_word("WHILE") && !has_word("WH")) return std::nullopt;
    for (const Token& token : code()) {
        if (token.kind != TokenKind::comparison) continue;
        const std::string_view sign = text(token);
        return make(SyntaxErrorKind::symbolic_comparison, token.span, sign,
                    std::string(comparison_word(sign)));
    }
    return std::nullopt;
}

std::optional<SyntaxError> ErrorExplainer::missing_value() const {
    int depth = 0;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
        const Token& token = tokens_[i];
        const Token* next = at(i + 1);
        if (token.kind == TokenKind::open) ++depth;
        if (token.kind == TokenKind::close) --depth;
        if (next != nullptr && next->kind == TokenKind::comment) next = at(i + 2);
        if (text(token) == "/" && marks_skip(i, next)) continue;
        if (token.kind == TokenKind::letters) {
            if (begins_free_text(token)) return std::nullopt;
            const bool named = i > 0 && tokens_[i - 1].kind == TokenKind::sharp;
            if (depth == 0 && !named && lacks_value(token, next))
                return make(SyntaxErrorKind::missing_value, {token.span.begin, token.span.begin + 1},
                            text(token).substr(0, 1), "");
            const std::string word = last_keyword(token);
            std::string expected;
            std::string_view fault = faults::statement;
            const bool number_word = next != nullptr && (capitals(*next) == "N" || capitals(*next) == "O");
            if (word == "GOTO" && !gives_value(next) && !number_word)
                expected = "a sequence number after 'GOTO'";
            if ((word == "DO" || word == "END") && !gives_value(next))
                expected = "a loop number 1 to 3 after '" + word + "'";
            if ((word == "IF" || word == "WHILE") && !gives_value(next)) {
                expected = "a condition in [ ] after '" + word + "'";
                fault = word == "IF" ? faults::if_form : faults::while_form;
            }
            if (!expected.empty())
                return make(SyntaxErrorKind::unreadable, token.span, text(token), std::move(expected), fault);
        }
        if (!wants_value(token) || gives_value(next)) continue;
        if (next != nullptr && next->kind == TokenKind::other) continue;
        return make(SyntaxErrorKind::unreadable, token.span, text(token),
                    "a value after '" + shown(text(token)) + "'", fault_of_calculation());
    }
    return std::nullopt;
}

/// `GTO5`
std::optional<SyntaxError> ErrorExplainer::misspelt_jump() const {
    for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
        const TokenKind next = tokens_[i + 1].kind;
        const bool has_target = next == TokenKind::number || next == TokenKind::variable;
        if (tokens_[i].kind == TokenKind::letters && has_target &&
            is_misspelt_goto(capitals(tokens_[i]), has_word("IF")))
            return make(SyntaxErrorKind::unknown_keyword, tokens_[i].span, text(tokens_[i]), "GOTO");
    }
    return std::nullopt;
}

/// `X1,5`
std::optional<SyntaxError> ErrorExplainer::decimal_comma() const {
    int depth = 0;
    for (std::size_t i = 0; i + 2 < tokens_.size(); ++i) {
        const Token& whole = tokens_[i];
        const Token& comma = tokens_[i + 1];
        const Token& decimals = tokens_[i + 2];
        if (whole.kind == TokenKind::open) ++depth;
        if (whole.kind == TokenKind::close) --depth;
        const auto is_whole = [&](const Token& token) {
            return token.kind == TokenKind::number && text(token).find('.') == std::string_view::npos;
        };
        if (depth > 0 || !is_whole(whole) || comma.kind != TokenKind::comma || !is_whole(decimals)) continue;
        const bool has_address = i > 0 && tokens_[i - 1].kind == TokenKind::letters;
        const Offset begin = has_address ? tokens_[i - 1].span.begin : whole.span.begin;
        const Span span{begin, decimals.span.end};
        SyntaxError error =
            make(SyntaxErrorKind::unreadable, span, text_.substr(begin, span.length()),
                 without_blanks(text(whole)) + "." + without_blanks(text(decimals)), faults::decimal_comma);
        error.remedy = {"Write a decimal point", false, {{{whole.span.end, decimals.span.begin}, "."}}};
        return error;
    }
    return std::nullopt;
}

/// `#ABS[#1]`
std::optional<SyntaxError> ErrorExplainer::sharp_without_number() const {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
        if (tokens_[i].kind != TokenKind::sharp) continue;
        const Token* next = at(i + 1);
        if (next != nullptr && (next->kind != TokenKind::letters || !is_function(capitals(*next)))) continue;
        const Span span = next == nullptr ? tokens_[i].span : join(tokens_[i].span, next->span);
        return make(SyntaxErrorKind::unreadable, span, text_.substr(span.begin, span.length()),
                    "the number of the variable after '#'", fault_of_calculation());
    }
    return std::nullopt;
}

/// The letter that stands before the variable in all other places of the program; 0: none, or several do.
char address_elsewhere(std::string_view text, std::string_view variable, Offset not_here) {
    constexpr Offset looked_at = 64 * 1024;
    const Offset first = not_here > looked_at ? not_here - looked_at : 0;
    text = text.substr(0, std::min<std::size_t>(text.size(), std::size_t{not_here} + looked_at));
    char letter = 0;
    for (std::size_t at = text.find(variable, first); at != std::string_view::npos;
         at = text.find(variable, at + 1)) {
        const std::size_t end = at + variable.size();
        if (at == 0 || (end < text.size() && is_digit(text[end])) || !is_letter(text[at - 1])) continue;
        if (at > 1 && is_letter(text[at - 2])) continue; // the end of a keyword
        const char before = to_capital(text[at - 1]);
        if (letter != 0 && letter != before) return 0;
        letter = before;
    }
    return letter;
}

/// `H31 #675`: a variable behind a word that has its value.
std::optional<SyntaxError> ErrorExplainer::missing_address() const {
    for (std::size_t i = 1; i < tokens_.size(); ++i) {
        const Token& variable = tokens_[i];
        const Token& before = tokens_[i - 1];
        if (before.kind == TokenKind::open || before.kind == TokenKind::close) return std::nullopt;
        if (variable.kind != TokenKind::variable ||
            (before.kind != TokenKind::number && before.kind != TokenKind::variable))
            continue;
        const Token* next = at(i + 1);
        if (next != nullptr && next->kind == TokenKind::equals) continue; // a statement
        const std::string_view written = text(variable);
        const char letter = address_elsewhere(text_, written, variable.span.begin);
        return make(SyntaxErrorKind::unreadable, variable.span, written,
                    letter == 0
                        ? std::string("an address before the variable")
                        : std::string("an address before the variable, which is ") + letter + " elsewhere");
    }
    return std::nullopt;
}

bool ErrorExplainer::is_prose() const {
    return std::ranges::any_of(tokens_, [&](const Token& token) {
        constexpr unsigned char last_of_ascii = 0x7F;
        const std::string_view written = text(token);
        if (token.kind == TokenKind::other)
            return static_cast<unsigned char>(written.front()) > last_of_ascii;
        const std::string word = token.kind == TokenKind::letters ? capitals(token) : std::string();
        return word.size() > 2 && split_keywords(word).empty() && !explain(word).known;
    });
}

/// Text after `//`, after `#`, or after a `;` within the line, which ends a block here and begins a remark
/// elsewhere.
std::optional<SyntaxError> ErrorExplainer::bare_remark() const {
    std::size_t first = 0;
    if (tokens_.size() > 1 && capitals(tokens_[0]) == "N" && tokens_[1].kind == TokenKind::number) first = 2;
    Offset before = block_.begin;
    while (before > 0 && is_blank(text_[before - 1])) --before;
    Span sign{before, before};
    if (before > 0 && text_[before - 1] == ';')
        sign.begin = before - 1;
    else if (begins_sharp_remark(text_, block_.begin))
        sign = {block_.begin, block_.begin + 1};
    else if (first + 1 < tokens_.size() && text(tokens_[first]) == "/" && text(tokens_[first + 1]) == "/")
        sign = join(tokens_[first].span, tokens_[first + 1].span);
    const bool has_brackets =
        first < tokens_.size() && tokens_[first].kind == TokenKind::comment; // and others in it
    if (sign.empty() || has_brackets || !is_prose()) return std::nullopt;
    return make(SyntaxErrorKind::bare_remark, {sign.begin, block_.end},
                text_.substr(sign.begin, block_.end - sign.begin),
                "'" + std::string(text_.substr(sign.begin, sign.length())) + "'");
}

/// Words that are no code: somebody wrote a remark without parentheses, or with parentheses in it.
std::optional<SyntaxError> ErrorExplainer::remark() const {
    for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
        if (tokens_[i].kind != TokenKind::comment) continue;
        if (i > 0 && is_function(last_keyword(tokens_[i - 1]))) return std::nullopt; // ATAN(ABS(#1)/#2)
        if (text(tokens_[i]).find('(', 1) == std::string_view::npos) continue;
        const Span tail{tokens_[i + 1].span.begin, tokens_.back().span.end};
        if (text_[tail.end - 1] == ')' && tail.length() > 1)
            return make(SyntaxErrorKind::nested_comment, tail, text_.substr(tail.begin, tail.length()),
                        "nothing after the first ')', because comments do not nest");
    }
    std::size_t words = 0;
    std::size_t codes = 0;
    for (const Token& token : code()) {
        if (token.kind == TokenKind::letters) {
            const std::string word = capitals(token);
            const bool plain = word.size() > 2 && split_keywords(word).empty() && !explain(word).known;
            (plain ? words : codes) += 1;
        }
        if (token.kind == TokenKind::variable || token.kind == TokenKind::open ||
            token.kind == TokenKind::equals)
            codes += 2;
    }
    if (words < 2 || words * 2 < codes) return std::nullopt;
    const Span all{tokens_.front().span.begin, tokens_.back().span.end};
    return make(SyntaxErrorKind::unreadable, all, text_.substr(all.begin, all.length()),
                "( ) around a remark");
}

std::optional<SyntaxError> ErrorExplainer::wide_sign() const {
    for (const Token& token : code()) {
        const auto sign =
            token.kind == TokenKind::other ? wide_sign_at(text_, token.span.begin) : std::nullopt;
        if (!sign) continue;
        const Span span{token.span.begin, token.span.begin + static_cast<Offset>(sign->length)};
        return make(SyntaxErrorKind::wide_sign, span, text_.substr(span.begin, span.length()),
                    std::string(1, sign->meant));
    }
    return std::nullopt;
}

/// The first node of the tree that stands for an error.
const syntax::Node* first_error(const syntax::Tree& tree) {
    for (const syntax::Node& node : tree.nodes)
        if (node.missing || kind_of(node) == Kind::error) return &node;
    return nullptr;
}

/// The words that the span cuts into, whole.
Span whole_words(std::string_view text, Span block, Span span) {
    while (span.begin > block.begin && is_letter(text[span.begin]) && is_letter(text[span.begin - 1]))
        --span.begin;
    while (span.end < block.end && is_letter(text[span.end - 1]) && is_letter(text[span.end])) ++span.end;
    return span;
}

/// What is called so in the grammar, in the user's words; empty where these would help nobody.
std::string expected_node(Kind kind) {
    switch (kind) {
    case Kind::variable:
    case Kind::indirect_variable:
    case Kind::named_variable: return "a variable";
    case Kind::number: return "a number";
    case Kind::literal_word:
    case Kind::word: return "an address and its value";
    case Kind::bracket: return "a value in [ ]";
    case Kind::condition: return "a condition in [ ]";
    case Kind::comment: return "a remark in ( )";
    default: return {};
    }
}

/// What the parser put in, in the user's words.
std::string expected_word(const syntax::Node& node) {
    if (node.named) return expected_node(kind_of(node));
    return "'" + std::string(syntax::symbol_name(grammar, node.symbol)) + "'";
}

void sort_unique(std::vector<std::int64_t>& numbers) {
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

} // namespace

SyntaxError unknown_word(std::string_view text, Span word) {
    const std::string_view written = text.substr(word.begin, word.length());
    Misspelling misspelling = explain(in_capitals(written));
    const bool construct = !misspelling.advice.empty();
    SyntaxError error{construct ? SyntaxErrorKind::missing_construct : SyntaxErrorKind::unknown_keyword, word,
                      shown(written),
                      construct ? std::string(misspelling.advice) : std::move(misspelling.meant)};
    error.fault = is_operator_word(error.cure) ? faults::operation : faults::keyword;
    return error;
}

std::optional<SyntaxError> find_parenthesis_as_bracket(std::string_view text, Span block) {
    return ErrorExplainer(text, block).parenthesis_as_bracket();
}

bool is_bare_remark(std::string_view text, Span block) {
    return ErrorExplainer(text, block).bare_remark().has_value();
}

std::optional<SyntaxError> find_cause(std::string_view text, Span block) {
    const ErrorExplainer explainer(text, block);
    for (const auto cause :
         {&ErrorExplainer::bare_remark, &ErrorExplainer::remark, &ErrorExplainer::wide_sign,
          &ErrorExplainer::parenthesis_as_bracket, &ErrorExplainer::bracket_mismatch, &ErrorExplainer::output,
          &ErrorExplainer::misspelt_jump, &ErrorExplainer::misplaced_number, &ErrorExplainer::letter_o,
          &ErrorExplainer::decimal_comma, &ErrorExplainer::sharp_without_number,
          &ErrorExplainer::missing_equals, &ErrorExplainer::unknown_keyword,
          &ErrorExplainer::symbolic_comparison, &ErrorExplainer::missing_value,
          &ErrorExplainer::missing_operator, &ErrorExplainer::missing_address,
          &ErrorExplainer::block_without_number})
        if (std::optional<SyntaxError> found = (explainer.*cause)()) return found;
    return std::nullopt;
}

SyntaxError find_parse_error(std::string_view text, Span block, const syntax::Tree& tree) {
    if (std::optional<SyntaxError> foreign = ErrorExplainer(text, block).foreign_character())
        return *std::move(foreign);
    Span span = block;
    std::string expected;
    if (const syntax::Node* error = first_error(tree)) {
        if (error->missing)
            expected = expected_word(*error);
        else if (!error->span.empty())
            span = whole_words(text, block, {block.begin + error->span.begin, block.begin + error->span.end});
    }
    return unreadable(text, span, std::move(expected));
}

NamedInBlock names_in(const Program& program, Span block) {
    const ErrorExplainer explainer(program.text, block);
    const std::span<const Token> tokens = explainer.tokens();
    const VariableFamily& family = program.control->families[numbered];
    NamedInBlock names;
    std::vector<std::int64_t> named, labels;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const Token& token = tokens[i];
        const Token* next = i + 1 < tokens.size() ? &tokens[i + 1] : nullptr;
        if (token.kind == TokenKind::variable)
            if (const std::optional<std::int64_t> number = read_integer(explainer.text(token)))
                named.push_back(*number);
        if (token.kind != TokenKind::letters) continue;
        const std::string word = explainer.capitals(token);
        const Token* value = next;
        if (value != nullptr && (explainer.capitals(*value) == "N" || explainer.capitals(*value) == "O"))
            value = i + 2 < tokens.size() ? &tokens[i + 2] : nullptr;
        if (word.ends_with("GOTO") && value != nullptr && value->kind == TokenKind::number)
            if (const std::optional<std::int64_t> label = read_integer(explainer.text(*value)))
                labels.push_back(*label);
        std::vector<std::string_view> words = split_keywords(word);
        const std::string meant = words.empty() ? explain(word).meant : std::string();
        words.push_back(meant);
        for (const std::string_view keyword : words)
            names.may_open_or_close |=
                keyword == "IF" || keyword == "WHILE" || keyword == "DO" || keyword == "END";
        names.may_open_or_close |= word == "ELSE" || word == "ENDIF" || word == "WH";
        if (next == nullptr || next->kind != TokenKind::number) continue;
        const double code = read_number(explainer.text(*next)).value;
        if (word.back() == 'G')
            names.may_call_or_return |= std::floor(code) == 65 || std::floor(code) == 66 || code == 67;
        if (word.back() == 'M')
            names.may_call_or_return |= code == 2 || code == 30 || (code >= 96 && code <= 99) || code == 198;
    }
    sort_unique(labels);
    sort_unique(named);
    names.labels.assign(labels.begin(), labels.end());
    for (const std::int64_t number : named) {
        const VariableRange* range = family.find(number);
        if (range != nullptr && range->meaning == Meaning::variable)
            names.variables.push_back({range->space, static_cast<std::int32_t>(number)});
    }
    return names;
}

} // namespace maclint::fanuc
