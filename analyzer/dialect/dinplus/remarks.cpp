//! Looks for the few remarks that begin with a mark; all others are passed over.
#include "analyzer/dialect/dinplus/remarks.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/dinplus/tables.hpp"
#include "analyzer/dialect/dinplus/value_tables.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace maclint::dinplus {
namespace {

constexpr std::string_view list_mark = "[//]";

std::string_view trim(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

std::size_t count_characters(std::string_view utf8) {
    return static_cast<std::size_t>(
        std::ranges::count_if(utf8, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// A description `[la=1; s=Diameter]`.
struct Description {
    std::string_view letters; ///< la
    std::string_view unit;    ///< 1
    std::string_view text;    ///< Diameter
};

/// The description that the remark is; nothing for any other remark.
std::optional<Description> read_description(std::string_view remark) {
    const std::size_t sign = remark.find('=');
    if (sign == std::string_view::npos) return std::nullopt;
    Description found{trim(remark.substr(0, sign)), {}, {}};
    const auto is_name = [](char c) { return is_letter(c) || is_digit(c); };
    if (found.letters.empty() || found.letters.size() > 3 || !std::ranges::all_of(found.letters, is_name))
        return std::nullopt;
    const std::string_view rest = remark.substr(sign + 1);
    const std::size_t end = std::min(rest.find(';'), rest.size());
    found.unit = trim(rest.substr(0, end));
    const std::size_t text = rest.find("s=", end);
    if (text != std::string_view::npos) found.text = trim(rest.substr(text + 2));
    return found;
}

/// The lists of a file, one after the other.
class Descriptions {
  public:
    Descriptions(const Source& source, std::vector<SyntaxError>& syntax_errors)
        : source_(source)
        , text_(source.bytes())
        , syntax_errors_(syntax_errors) {}

    /// `marks`: the places of [//].
    void check(const std::vector<std::size_t>& marks) {
        for (std::size_t i = 0; i + 1 < marks.size(); i += 2) {
            const std::size_t inside = marks[i] + list_mark.size();
            check_list(text_.substr(inside, marks[i + 1] - inside));
        }
        if (marks.size() % 2 != 0)
            report(SyntaxErrorKind::description_unbalanced, text_.substr(marks.back(), list_mark.size()), "");
    }

  private:
    void check_list(std::string_view list) {
        for (std::size_t open = list.find('['); open != std::string_view::npos; open = list.find('[', open)) {
            const std::size_t close = list.find(']', open);
            if (close == std::string_view::npos) return;
            check_remark(list.substr(open + 1, close - open - 1));
            open = close;
        }
    }

    void check_remark(std::string_view remark) {
        const auto description = read_description(remark);
        if (!description) return;
        constexpr SyntaxErrorKind wrong = SyntaxErrorKind::wrong_description;
        if (++count_ == limits::descriptions + 1)
            report(wrong, remark, "a subprogram has at most " + std::to_string(limits::descriptions));
        const std::string name = in_capitals(description->letters);
        if (!transfer_variable(name))
            report(wrong, description->letters, "no word of a call passes it");
        else if (!seen_.insert(name).second)
            report(wrong, description->letters, "it has another description before");
        const bool is_unit = description->unit.size() == 1 && is_digit(description->unit.front()) &&
                             description->unit.front() - '0' <= limits::last_unit;
        if (!is_unit && !description->unit.empty())
            report(wrong, description->unit,
                   "units have the numbers 0 to " + std::to_string(limits::last_unit));
        const std::size_t length = count_characters(source_.to_utf8(description->text));
        if (length > limits::description_text)
            report(wrong, description->text,
                   "it has " + std::to_string(length) + " characters, and at most " +
                       std::to_string(limits::description_text) + " are shown");
    }

    void report(SyntaxErrorKind kind, std::string_view part, std::string cure) {
        const auto begin = static_cast<Offset>(part.data() - text_.data());
        syntax_errors_.push_back(
            {kind, {begin, begin + static_cast<Offset>(part.size())}, std::string(part), std::move(cure)});
    }

    const Source& source_;
    std::string_view text_;
    std::vector<SyntaxError>& syntax_errors_;
    std::set<std::string> seen_;
    std::size_t count_ = 0;
};

/// Whether the text begins with a block: `N120 G81`, `G81`, `T1`.
bool begins_with_block(std::string_view text) {
    text = trim(text);
    const auto word = [&](std::string_view letters) {
        return text.size() > 1 && letters.find(text.front()) != std::string_view::npos && is_digit(text[1]);
    };
    if (word("N")) {
        text.remove_prefix(std::min(text.find_first_not_of("0123456789", 1), text.size()));
        text = trim(text);
    }
    return word("GMT") || text.starts_with('#') || text.starts_with("L\"");
}

/// The converter of older programs writes a block that it cannot translate as a remark with a word of warning
/// before it [l.10446].
void check_leftover(std::string_view text, std::size_t open, std::vector<SyntaxError>& syntax_errors) {
    const std::string_view remark = text.substr(open, text.find(']', open) - open + 1);
    for (const std::string_view word : {"[WARNING", "[WARNUNG", "[VAROITUS"}) {
        if (!remark.starts_with(word)) continue;
        std::string_view rest = remark.substr(word.size());
        rest.remove_prefix(std::min(rest.find_first_not_of(": \t"), rest.size()));
        if (!begins_with_block(rest)) return;
        const auto begin = static_cast<Offset>(open);
        syntax_errors.push_back({SyntaxErrorKind::converted_leftover,
                                 {begin, begin + static_cast<Offset>(remark.size())},
                                 std::string(remark),
                                 ""});
    }
}

} // namespace

void check_remarks(const Source& source, std::vector<SyntaxError>& syntax_errors) {
    const std::string_view text = source.bytes();
    std::vector<std::size_t> marks;
    for (std::size_t open = text.find('['); open != std::string_view::npos; open = text.find('[', open + 1)) {
        const char next = open + 1 < text.size() ? text[open + 1] : '\0';
        if (next == '/' && text.substr(open).starts_with(list_mark)) marks.push_back(open);
        if (next == 'W' || next == 'V') check_leftover(text, open, syntax_errors);
    }
    Descriptions(source, syntax_errors).check(marks);
}

} // namespace maclint::dinplus
