//! One pass over a line parts code, comments and remarks; plain code is also read word by word.
#include "analyzer/dialect/detect/line.hpp"

#include "analyzer/dialect/fanuc/lexer.hpp"

#include <algorithm>

namespace maclint::detect {

std::string_view trim(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

bool starts_with_any(std::string_view text, std::span<const std::string_view> heads) {
    return std::ranges::any_of(heads, [&](std::string_view head) { return text.starts_with(head); });
}

std::string_view after_number(std::string_view line) {
    std::size_t at = !line.empty() && line.front() == 'N' ? 1 : 0;
    while (at < line.size() && is_blank(line[at])) ++at;
    const std::size_t digits = at;
    while (at < line.size() && is_digit(line[at])) ++at;
    return at == digits ? line : trim(line.substr(at));
}

void Line::read(std::string_view text) {
    as_written_ = trim(text);
    whole_.assign(as_written_);
    std::ranges::transform(whole_, whole_.begin(), [](char c) { return to_capital(c); });
    characters_ = characters_of(whole_);
    split();
    read_words();
}

void Line::split() {
    comment_ = {};
    remark_ = {};
    without_comments_.clear();
    const std::string_view whole = whole_;
    if ((characters_ & characters_of("(;")) == 0) {
        code_ = after_number(whole);
        return;
    }
    for (std::size_t at = 0; at < whole.size();) {
        if (whole[at] == ';') {
            remark_ = trim(whole.substr(at + 1));
            break;
        }
        if (whole[at] != '(') {
            const std::size_t code = at;
            while (at < whole.size() && whole[at] != '(' && whole[at] != ';') ++at;
            without_comments_ += whole.substr(code, at - code);
            continue;
        }
        const Offset end = fanuc::after_comment(whole, static_cast<Offset>(at));
        std::string_view comment = whole.substr(at + 1, end - at - 1);
        if (fanuc::is_closed(whole.substr(at, end - at))) comment.remove_suffix(1);
        if (comment_.empty()) comment_ = comment;
        at = end;
    }
    code_ = after_number(trim(without_comments_));
}

namespace {

/// After the remark of DIN PLUS at `at`, where one stands: between words no other language has brackets
/// without a variable.
std::size_t after_remark(std::string_view code, std::size_t at) {
    if (code[at] != '[') return at;
    const std::size_t close = code.find_first_of("]#", at);
    if (close == std::string_view::npos || code[close] == '#') return at;
    const std::string_view next = trim(code.substr(close + 1));
    return next.empty() || is_capital(next.front()) ? close + 1 : at;
}

} // namespace

void Line::read_words() {
    word_count_ = 0;
    plain_ = false;
    constexpr std::int32_t largest = 1'000'000;
    std::size_t at = 0;
    const auto skip_blanks = [&] {
        while (at < code_.size() && is_blank(code_[at])) ++at;
    };
    for (; at < code_.size(); skip_blanks()) {
        if (const std::size_t after = after_remark(code_, at); after != at) {
            at = after;
            continue;
        }
        Word word{code_[at], 0, 0};
        if (!is_capital(word.letter)) return;
        ++at;
        skip_blanks();
        const bool minus = at < code_.size() && code_[at] == '-';
        if (at < code_.size() && (minus || code_[at] == '+')) ++at;
        const std::size_t number = at;
        for (; at < code_.size() && is_digit(code_[at]); ++at, ++word.digits)
            word.tenths = std::min(word.tenths * 10 + (code_[at] - '0'), largest);
        word.tenths *= 10;
        if (at < code_.size() && code_[at] == '.') {
            ++at;
            if (at < code_.size() && is_digit(code_[at])) word.tenths += code_[at] - '0';
            while (at < code_.size() && is_digit(code_[at])) ++at;
        }
        if (at == number) return;
        if (minus) word.tenths = -word.tenths;
        if (word_count_ < words_.size()) words_[word_count_++] = word;
    }
    plain_ = true;
}

const Word* Line::word(char letter) const {
    const auto all = words();
    const auto found = std::ranges::find(all, letter, &Word::letter);
    return found == all.end() ? nullptr : &*found;
}

bool Line::has(char letter, std::int32_t first_tenths, std::int32_t last_tenths) const {
    return std::ranges::any_of(words(), [&](const Word& word) {
        return word.letter == letter && word.tenths >= first_tenths && word.tenths <= last_tenths;
    });
}

bool looks_like_block(std::string_view whole) {
    while (!whole.empty() && (whole.front() == '/' || whole.front() == ' ')) whole.remove_prefix(1);
    constexpr std::string_view beginnings = "(%;:<";
    if (whole.empty() || beginnings.find(whole.front()) != std::string_view::npos) return true;
    const std::string_view code = after_number(whole);
    constexpr std::string_view code_beginnings = "#(/;";
    if (code.empty() || code_beginnings.find(code.front()) != std::string_view::npos) return true;
    if (code.front() == '[') return trim(code.substr(1)).starts_with('#'); // [#_NAME]=1
    if (!is_capital(code.front())) return false;
    const std::string_view value = trim(code.substr(1));
    constexpr std::string_view values = "0123456789+-.#[<";
    if (value.empty() || values.find(value.front()) != std::string_view::npos) return true;
    if (code.starts_with("IF") && trim(code.substr(2)).starts_with('[')) return true;
    static constexpr std::string_view keywords[] = {"WHILE", "GOTO",  "END",   "DO",   "POPEN",
                                                    "PCLOS", "DPRNT", "BPRNT", "SETVN"};
    return starts_with_any(code, keywords);
}

} // namespace maclint::detect
