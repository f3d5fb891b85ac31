//! Most lines are plain words, which need no second look.
#include "analyzer/dialect/detect/line_kinds.hpp"

#include "analyzer/dialect/detect/shapes.hpp"
#include "analyzer/dialect/fanuc/keywords.hpp"
#include "analyzer/dialect/fanuc/remarks.hpp"
#include "analyzer/dialect/wide_signs.hpp"

#include <algorithm>
#include <iterator>

namespace maclint::detect {
namespace {

constexpr bool is_word_byte(char c) {
    return is_capital(c) || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}

std::size_t after_blanks(std::string_view text, std::size_t at) {
    while (at < text.size() && is_blank(text[at])) ++at;
    return at;
}

std::size_t after_digits(std::string_view text, std::size_t at) {
    while (at < text.size() && is_digit(text[at])) ++at;
    return at;
}

/// After a number with its sign and point; `at` where none stands.
std::size_t after_number_at(std::string_view text, std::size_t at) {
    const std::size_t sign = at < text.size() && (text[at] == '-' || text[at] == '+') ? at + 1 : at;
    const std::size_t point = after_digits(text, sign);
    const bool has_point = point < text.size() && text[point] == '.';
    const std::size_t end = has_point ? after_digits(text, point + 1) : point;
    return end - sign > (has_point ? 1U : 0U) ? end : at;
}

/// After the word at `at`; a wide minus is no part of it: `Z–5`.
std::size_t after_word(std::string_view code, std::size_t at) {
    while (at < code.size() && is_word_byte(code[at]) && !wide_sign_at(code, at)) ++at;
    return at;
}

/// Statements whose words are free text.
bool holds_free_text(std::string_view code) {
    static constexpr std::string_view heads[] = {"DPRNT", "BPRNT", "POPEN", "PCLOS", "SETVN"};
    return starts_with_any(code, heads);
}

/// `H1=120.5`, `X = 10.01`: a row of a table of offsets or of what was measured.
bool is_named_value(std::string_view code) {
    if (code.empty() || !is_capital(code.front())) return false;
    const std::size_t sign = after_blanks(code, after_digits(code, 1));
    return sign < code.size() && code[sign] == '=';
}

/// `T1 M6<BR>`, `</TD>`
bool holds_tag(std::string_view code) {
    for (std::size_t at = code.find('<'); at != std::string_view::npos; at = code.find('<', at + 1)) {
        const std::string_view tag = code.substr(at + 1);
        if (tag.starts_with('/') || tag.starts_with("BR>") || tag.starts_with("BR ")) return true;
    }
    return false;
}

/// A word for people, a number behind a number, or a letter before a comma, as rows of tables have them.
bool reads_as_text(std::string_view code) {
    if (holds_free_text(code)) return false;
    if (is_named_value(code) || holds_tag(code)) return true;
    for (std::size_t at = 0; at < code.size();) {
        if (code.substr(at).starts_with("//") || fanuc::begins_sharp_remark(code, at)) return false;
        if (const auto sign = wide_sign_at(code, at)) {
            at += sign->length;
            continue;
        }
        if (is_word_byte(code[at])) {
            const std::size_t end = after_word(code, at);
            const bool is_name = at > 0 && (code[at - 1] == '#' || code[at - 1] == '<');
            if (!is_name && fanuc::is_for_people(code.substr(at, end - at))) return true;
            at = end;
            if (at < code.size() && code[at] == ',') return true;
            continue;
        }
        if (is_digit(code[at])) {
            at = std::min(code.find_first_not_of("0123456789.", at), code.size());
            const std::size_t next = after_blanks(code, at);
            if (next > at && next < code.size() && is_digit(code[next])) return true;
            continue;
        }
        ++at;
    }
    return false;
}

/// `1.0,2.0`, `=====`, `| T1 |`, `* remark`, "1;2;3": no block begins so.
bool is_row_or_rule(const Line& line) {
    const std::string_view whole = line.whole();
    constexpr std::string_view beginnings = "*=-|+!\"'{}@~^\\?,.";
    if (beginnings.find(whole.front()) != std::string_view::npos) return true;
    if (whole.front() == '[') return !looks_like_block(whole);
    const bool begins_with_number = is_digit(whole.front());
    const std::string_view code = line.code();
    if (begins_with_number && (code.empty() || !is_capital(code.front()))) return true;
    const std::string_view remark = line.remark(); // of a table with ';' between its columns
    return remark.find(';') != std::string_view::npos && remark.front() != '(' && !looks_like_block(remark);
}

/// `=`, blanks and a number, `#0` or nothing; what old controls punch, `[25283*65536+65536]/134217728`,
/// counts.
bool is_literal_value(std::string_view text) {
    text = trim(text);
    if (text.empty() || text == "#0") return true;
    if (text.front() == '[') {
        constexpr std::string_view scale = "/134217728";
        return text.ends_with(scale) &&
               text.find_first_not_of("0123456789*+-[]/. ") == std::string_view::npos;
    }
    return after_number_at(text, 0) == text.size();
}

/// System variables that act are no data: #3000 and its like.
bool is_stored_variable(std::string_view digits) {
    constexpr std::size_t longest = 6;
    return !digits.empty() && digits.size() <= longest && !(digits.size() == 4 && digits.front() == '3');
}

bool sets_variable(const Line& line) {
    const std::string_view code = line.code();
    if (code.starts_with("SETVN")) return true;
    if (code.starts_with('=')) return line.comment().starts_with('#') && is_literal_value(code.substr(1));
    if (!code.starts_with('#')) return false;
    const std::size_t digits = after_blanks(code, 1);
    const std::size_t end = after_digits(code, digits);
    const std::size_t sign = after_blanks(code, end);
    return is_stored_variable(code.substr(digits, end - digits)) && sign < code.size() && code[sign] == '=' &&
           is_literal_value(code.substr(sign + 1));
}

/// Only of numbers, and nothing that a macro computes.
bool sets_offset(const Line& line) {
    const std::string_view code = line.code();
    if (!code.starts_with("G10") || (code.size() > 3 && (is_digit(code[3]) || code[3] == '.'))) return false;
    return code.find('#') == std::string_view::npos && line.word('M') == nullptr;
}

/// `N0012A1P00000000A2P00000000`
bool sets_parameter(const Line& line) {
    constexpr std::string_view letters = "PQLATSKD";
    return line.whole().starts_with('N') && line.word('P') != nullptr &&
           std::ranges::all_of(line.words(), [&](const Word& word) {
               return letters.find(word.letter) != std::string_view::npos;
           });
}

/// `G90`, `G11`, `G21`, `M02`: between rows of data and after them, as controls put them out.
bool goes_with_data(const Line& line) {
    return line.words().size() == 1 && (line.has('G', 100, 110) || line.has('G', 200, 210) ||
                                        line.has('G', 900, 910) || line.has('M', 20, 20));
}

/// `X 10.001 Y 20.002`: programs have such rows, and so has what a probe measured.
bool is_position(const Line& line) {
    constexpr std::string_view axes = "XYZUVWABC";
    return !line.whole().starts_with('N') && std::ranges::all_of(line.words(), [&](const Word& word) {
        return axes.find(word.letter) != std::string_view::npos;
    });
}

LineKind kind_of_words(const Line& line) {
    const char first = line.words().front().letter;
    if (first == 'G' || first == 'M') {
        if (goes_with_data(line)) return LineKind::nothing;
        return sets_offset(line) ? LineKind::offset : LineKind::block;
    }
    if (sets_parameter(line)) return LineKind::parameter;
    return is_position(line) ? LineKind::position : LineKind::block;
}

} // namespace

LineKind kind_of(const Line& line) {
    const std::string_view whole = line.whole();
    constexpr std::string_view nothing = "%(;/";
    if (line.is_plain() && !line.words().empty()) return kind_of_words(line);
    if (sets_variable(line)) return LineKind::variable;
    if (sets_offset(line)) return LineKind::offset;
    if (nothing.find(whole.front()) != std::string_view::npos &&
        (whole.front() == '%' || line.code().empty()))
        return LineKind::nothing;
    if (whole.starts_with("//") || fanuc::begins_sharp_remark(whole, 0)) return LineKind::nothing;
    return is_row_or_rule(line) || reads_as_text(line.code()) ? LineKind::other : LineKind::block;
}

namespace {

bool is_head(std::string_view whole) {
    if (whole.starts_with('%')) return true;
    return whole.size() > 1 && (whole.front() == 'O' || whole.front() == ':') && is_digit(whole[1]);
}

bool is_end(const Line& line) {
    return line.has('M', 20, 20) || line.has('M', 300, 300) || line.has('M', 990, 990);
}

} // namespace

void LineCounts::add(const Line& line) {
    has_head_ = has_head_ || is_head(line.whole());
    has_end_ = has_end_ || (line.is_plain() && is_end(line));
    constexpr std::size_t plenty = 64;
    if (of(LineKind::block) >= plenty && of(LineKind::other) * 2 < of(LineKind::block))
        return; // it is decided
    const LineKind kind = kind_of(line);
    ++counts_[static_cast<std::size_t>(kind)];
    if (kind == LineKind::other && !looks_like_block(line.whole())) ++unlike_blocks_;
}

bool LineCounts::is_program_text() const {
    const std::size_t others = of(LineKind::other);
    std::size_t read =
        of(LineKind::block) + of(LineKind::offset) + of(LineKind::variable) + of(LineKind::parameter);
    if (of(LineKind::block) != 0) read += of(LineKind::position);
    if (others <= read) return true;
    // What begins and ends as a program is one, with whatever mistakes; a listing in a letter is not.
    constexpr std::size_t most_mistakes = 4;
    if (has_head_ && has_end_ && others <= most_mistakes * (read + 1)) return true;
    return others == 1 && unlike_blocks_ == 0;
}

std::optional<std::string_view> LineCounts::data() const {
    struct Row {
        LineKind kind;
        std::string_view name;
    };
    static constexpr Row rows[] = {{LineKind::parameter, "parameters"},
                                   {LineKind::variable, "values of variables"},
                                   {LineKind::offset, "offsets"}};
    const auto* const most = std::ranges::max_element(rows, {}, [&](const Row& row) { return of(row.kind); });
    std::size_t data = 0;
    for (const Row& row : rows) data += of(row.kind);
    if (data < 2 || of(LineKind::block) != 0 || of(LineKind::other) > data) return std::nullopt;
    return most->name;
}

} // namespace maclint::detect
