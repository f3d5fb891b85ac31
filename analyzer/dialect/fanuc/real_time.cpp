//! The statements are read token by token: nothing else of maclint wants to know what they do.
#include "analyzer/dialect/fanuc/real_time.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/fanuc/block_tokens.hpp"
#include "analyzer/dialect/fanuc/diagnose.hpp"
#include "analyzer/dialect/fanuc/keywords.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/program/faults.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <vector>

namespace maclint::fanuc {
namespace {

using Kind = Token::Kind;

// T: of the manual of the 30i; the list of alarms says only that there are others.
constexpr std::string_view model = "fanuc-30i";
constexpr std::string_view own_words[] = {"ZONCE", "ZEDGE", "ZWHILE", "ZDO", "ZEND"};
constexpr std::string_view own_variables[] = {"RV", "RP"};
constexpr std::string_view not_there[] = {"IF",  "THEN", "GOTO", "WHILE", "DO",   "END", "SIN", "COS",
                                          "TAN", "ASIN", "ACOS", "ATAN",  "SQRT", "LN",  "EXP", "POW"};
constexpr std::array codes = {0.0, 1.0, 4.0, 28.0, 31.0, 65.0, 90.0, 91.0, 94.0, 95.0};
constexpr std::string_view refused_addresses = "DHST";

/// Behind the `//`, and the number of the statement; 0 where none begins.
std::size_t begin_of_statement(const BlockTokens& tokens) {
    std::size_t at = tokens.capitals(0) == "N" && tokens.is(1, Kind::number) ? 2 : 0;
    if (at + 1 >= tokens.size() || tokens.written(at) != "/" || tokens.written(at + 1) != "/") return 0;
    at += 2;
    return tokens.is(at, Kind::number) ? at + 1 : at;
}

bool has_own_word(const BlockTokens& tokens, std::size_t begin) {
    for (std::size_t i = begin; i < tokens.size(); ++i) {
        const std::string word = tokens.capitals(i);
        const bool variable = i > 0 && tokens.is(i - 1, Kind::sharp);
        if (variable ? std::ranges::find(own_variables, word) != std::end(own_variables)
                     : std::ranges::find(own_words, word) != std::end(own_words))
            return true;
    }
    return false;
}

/// A statement, its words one by one.
class Statement {
  public:
    Statement(const BlockTokens& tokens, std::size_t begin, const ControlModel& control)
        : tokens_(tokens)
        , begin_(begin)
        , control_(control) {}

    [[nodiscard]] std::optional<SyntaxError> fault() const {
        for (std::size_t i = begin_; i < tokens_.size(); ++i) {
            if (is_slash(i) && is_slash(i + 1))
                return tokens_.error(join(tokens_.span(i), tokens_.span(i + 1)), "one statement in a block",
                                     faults::real_time_slashes);
            if (auto found = fault_of_variable(i)) return found;
            if (auto found = fault_of_letters(i)) return found;
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] bool is_slash(std::size_t i) const {
        return i < tokens_.size() && tokens_.written(i) == "/";
    }

    [[nodiscard]] std::optional<SyntaxError> fault_of_variable(std::size_t i) const {
        if (!tokens_.is(i, Kind::variable) || !tokens_.is(i + 1, Kind::equals)) return std::nullopt;
        const auto number = read_integer(tokens_.written(i));
        const VariableRange* range = number ? control_.families[numbered].find(*number) : nullptr;
        if (range == nullptr || range->on_write != OnWrite::forbidden) return std::nullopt;
        return tokens_.error(tokens_.span(i), "a variable that can be written", faults::real_time_variable);
    }

    [[nodiscard]] std::optional<SyntaxError> fault_of_letters(std::size_t i) const {
        const std::string word = tokens_.capitals(i);
        if (word.empty() || (i > 0 && tokens_.is(i - 1, Kind::sharp))) return std::nullopt;
        for (const std::string_view part : split_keywords(word))
            if (std::ranges::find(not_there, part) != std::end(not_there))
                return tokens_.error(tokens_.span(i),
                                     "ZONCE, ZEDGE or ZWHILE, and calculations without functions",
                                     faults::real_time_token);
        if (word.size() != 1) return std::nullopt;
        const Span whole =
            i + 1 < tokens_.size() ? join(tokens_.span(i), tokens_.span(i + 1)) : tokens_.span(i);
        if (word == "G") return fault_of_code(i, whole);
        if (word == "P" && calls() && !tokens_.is(i + 1, Kind::number))
            return tokens_.error(whole, "the number of the program", faults::real_time_program);
        if (calls_macro_ && word == "L")
            return tokens_.error(whole, "a call without L", faults::real_time_repeat);
        if (calls_macro_) return std::nullopt;
        if (refused_addresses.find(word) != std::string_view::npos)
            return tokens_.error(whole, "axes and their feed", faults::real_time_address);
        return std::nullopt;
    }

    [[nodiscard]] std::optional<SyntaxError> fault_of_code(std::size_t i, Span whole) const {
        if (!tokens_.is(i + 1, Kind::number)) return std::nullopt;
        const double code = read_number(tokens_.written(i + 1)).value;
        if (calls_macro_ && code != 65)
            return tokens_.error(whole, "arguments without G", faults::real_time_argument);
        if (code == 90) return tokens_.error(whole, "G91", faults::real_time_absolute);
        if (std::ranges::find(codes, code) == codes.end())
            return tokens_.error(whole, "G00, G01 or a call", faults::real_time_code);
        return std::nullopt;
    }

    [[nodiscard]] bool holds(std::string_view address, double code) const {
        for (std::size_t i = begin_; i + 1 < tokens_.size(); ++i)
            if (tokens_.capitals(i) == address && tokens_.is(i + 1, Kind::number) &&
                read_number(tokens_.written(i + 1)).value == code)
                return true;
        return false;
    }
    [[nodiscard]] bool calls() const { return calls_macro_ || holds("M", 98); }

    const BlockTokens& tokens_;
    std::size_t begin_;
    const ControlModel& control_;
    bool calls_macro_ = holds("G", 65);
};

} // namespace

bool is_real_time(std::string_view text, Span block, const ControlModel& control) {
    Offset at = block.begin; // nearly all blocks end here
    if (to_capital(text[at]) == 'N')
        for (++at; at < block.end && (is_digit(text[at]) || is_blank(text[at]));) ++at;
    if (at + 1 >= block.end || text[at] != '/' || text[at + 1] != '/') return false;
    const std::vector<Token> found = tokens_of(text, block);
    const BlockTokens tokens(text, found);
    const std::size_t begin = begin_of_statement(tokens);
    if (begin == 0 || begin >= tokens.size()) return false;
    if (has_own_word(tokens, begin)) return true;
    return control.model == model && !is_bare_remark(text, block);
}

std::optional<SyntaxError> find_real_time_fault(std::string_view text, Span block,
                                                const ControlModel& control) {
    if (control.model != model && !control.assumed) return std::nullopt;
    const std::vector<Token> found = tokens_of(text, block);
    const BlockTokens tokens(text, found);
    std::optional<SyntaxError> fault = Statement(tokens, begin_of_statement(tokens), control).fault();
    if (fault && control.assumed) fault->answer = Answer::stops_if_assumed;
    return fault;
}

} // namespace maclint::fanuc
