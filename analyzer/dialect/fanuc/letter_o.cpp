//! Looks at what stands before and after the letter.
#include "analyzer/dialect/fanuc/letter_o.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/fanuc/keywords.hpp"

#include <algorithm>
#include <string>

namespace maclint::fanuc {
namespace {

using Kind = Token::Kind;

/// Addresses that a letter O after them makes no keyword of; the grammar reads the others by itself.
constexpr std::string_view addresses = "ABELQUVW";
/// Those that make the short name of a function: CO, RO.
constexpr std::string_view beginnings_of_functions = "CR";

class LetterOFinder {
  public:
    LetterOFinder(std::string_view text, std::span<const Token> tokens)
        : text_(text)
        , tokens_(tokens) {}

    [[nodiscard]] std::optional<SyntaxError> find() const {
        int depth = 0;
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            depth += tokens_[i].kind == Kind::open ? 1 : tokens_[i].kind == Kind::close ? -1 : 0;
            if (tokens_[i].kind != Kind::letters) continue;
            const std::string word = capitals(i);
            if (word == "DPRNT" || word == "BPRNT" || word == "SETVN") return std::nullopt; // free text
            const std::size_t stem = word.find('O');
            if (stem == std::string::npos || is(i, -1, Kind::sharp)) continue;
            const std::size_t after = std::min(word.find_first_not_of('O', stem), word.size());
            if (!may_go_on(i, word, after)) continue;
            if (stem == 0 ? is_figure(i) : ends_in_figure(i, word.substr(0, stem), depth))
                return told(i, stem, after);
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] std::string_view written(std::size_t i) const {
        return text_.substr(tokens_[i].span.begin, tokens_[i].span.length());
    }
    [[nodiscard]] std::string capitals(std::size_t i) const { return without_blanks(written(i)); }
    [[nodiscard]] bool is(std::size_t i, int step, Kind kind) const {
        const std::size_t other = i + static_cast<std::size_t>(step);
        return other < tokens_.size() && tokens_[other].kind == kind;
    }
    /// No blank stands between the token and the one after it.
    [[nodiscard]] bool touches_next(std::size_t i) const {
        return i + 1 < tokens_.size() && tokens_[i].span.end == tokens_[i + 1].span.begin;
    }

    /// Whether the token ends after the letters O, or goes on with one more address: the F of `AOF100`.
    [[nodiscard]] bool may_go_on(std::size_t i, const std::string& word, std::size_t after) const {
        if (after == word.size()) return true;
        return after + 1 == word.size() && split_keywords(word).empty() && touches_next(i) &&
               (is(i, 1, Kind::number) || is(i, 1, Kind::variable));
    }

    /// A token that begins with O: among figures, or where a value has to be.
    [[nodiscard]] bool is_figure(std::size_t i) const {
        if (i == 0) return false;
        const bool heads_program =
            touches_next(i) && is(i, 1, Kind::number) && written(i + 1).size() >= digits_of_program;
        if (touches_next(i - 1) && (is(i, -1, Kind::number) || is(i, -1, Kind::variable)))
            return !heads_program;
        return is(i, -1, Kind::equals) || is(i, -1, Kind::comparison) || is(i, -1, Kind::operation) ||
               is(i, -1, Kind::sign) || (is(i, -1, Kind::letters) && ends_in_operator(capitals(i - 1)));
    }

    [[nodiscard]] bool ends_in_figure(std::size_t i, const std::string& stem, int depth) const {
        if (ends_in_operator(stem)) return true;
        const bool in_value = is(i, -1, Kind::equals) || is(i, -1, Kind::sign) || is(i, -1, Kind::operation);
        if (stem.size() != 1 || depth > 0 || in_value) return false;
        if (addresses.find(stem) != std::string_view::npos) return true;
        const bool has_argument = is(i, 1, Kind::open) || is(i, 1, Kind::variable) || is(i, 1, Kind::comment);
        return beginnings_of_functions.find(stem) != std::string_view::npos && !has_argument;
    }

    [[nodiscard]] static bool ends_in_operator(std::string_view word) {
        const std::vector<std::string_view> words = split_keywords(word);
        return !words.empty() && is_operator_word(words.back());
    }

    /// The number or the word with the letter, and how it is with the figure.
    [[nodiscard]] SyntaxError told(std::size_t i, std::size_t stem, std::size_t after) const {
        const Offset o = tokens_[i].span.begin + static_cast<Offset>(stem);
        Span whole{stem == 1 ? tokens_[i].span.begin : o, tokens_[i].span.begin + static_cast<Offset>(after)};
        if (stem == 0 && i > 0 && touches_next(i - 1)) {
            const bool number = is(i, -1, Kind::number);
            if (number || is(i, -1, Kind::variable)) whole.begin = tokens_[i - 1].span.begin;
            const bool addressed = i > 1 && touches_next(i - 2) && is(i, -2, Kind::letters);
            if (number && addressed && written(i - 2).size() == 1) --whole.begin;
        }
        const bool ends = after == tokens_[i].span.length();
        for (std::size_t next = i; ends && touches_next(next); ++next) {
            const bool all_o = capitals(next + 1).find_first_not_of('O') == std::string::npos;
            if (!is(next, 1, Kind::number) && !all_o) break;
            whole.end = tokens_[next + 1].span.end;
        }
        std::string mended(text_.substr(whole.begin, whole.length()));
        Remedy remedy{"Write the figure 0 for the letter O", true};
        for (Offset at = o; at < whole.end; ++at) {
            if (to_capital(text_[at]) != 'O') continue;
            mended[at - whole.begin] = '0';
            remedy.changes.push_back({{at, at + 1}, "0"});
        }
        SyntaxError error{SyntaxErrorKind::letter_o, whole,
                          std::string(text_.substr(whole.begin, whole.length())), std::move(mended)};
        error.remedy = std::move(remedy);
        return error;
    }

    std::string_view text_;
    std::span<const Token> tokens_;
};

} // namespace

std::optional<Span> find_jump_with_zero(std::string_view text, Span word) {
    constexpr std::string_view written = "G0TO";
    constexpr Offset before = 2; // G0
    if (word.begin < before) return std::nullopt;
    const Offset begin = word.begin - before;
    if (in_capitals(text.substr(begin, written.size())) != written) return std::nullopt;
    return Span{begin, word.end};
}

std::optional<SyntaxError> find_letter_o(std::string_view text, std::span<const Token> tokens) {
    return LetterOFinder(text, tokens).find();
}

} // namespace maclint::fanuc
