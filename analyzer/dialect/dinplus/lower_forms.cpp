//! Forms of other languages, and slips of typing, that the grammar reads and the control does not.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/dinplus/lowering.hpp"

#include <algorithm>

namespace maclint::dinplus {
namespace {

bool is_compared(Kind kind) { return kind == Kind::comparison || kind == Kind::logical; }

/// What begins with a word of the language, or is one.
bool begins_with_keyword(Kind kind) {
    switch (kind) {
    case Kind::if_statement:
    case Kind::then_statement:
    case Kind::else_statement:
    case Kind::endif_statement:
    case Kind::while_statement:
    case Kind::endwhile_statement:
    case Kind::switch_statement:
    case Kind::case_statement:
    case Kind::default_statement:
    case Kind::break_statement:
    case Kind::endswitch_statement:
    case Kind::return_statement:
    case Kind::output_statement:
    case Kind::unit_start:
    case Kind::unit_end:
    case Kind::group_start:
    case Kind::group_end:
    case Kind::lower_case_word:
    case Kind::function: return true;
    default: return false;
    }
}

/// `(TEXT)`, `; TEXT` and `// TEXT` as a remark of this language.
std::string in_square_brackets(std::string_view remark) {
    constexpr std::string_view signs = "();/ \t";
    const std::size_t begin = remark.find_first_not_of(signs);
    if (begin == std::string_view::npos || remark.find(']') != std::string_view::npos) return {};
    const std::size_t end = remark.find_last_not_of(signs);
    return '[' + std::string(remark.substr(begin, end - begin + 1)) + ']';
}

} // namespace

/// The node above; nullptr of the root.
const syntax::Node* BlockLowering::parent_of(const Node& node) const {
    return parents_[static_cast<std::size_t>(&node - tree_->nodes.data())];
}

void BlockLowering::check_form(const Node& node) {
    const Kind kind = kind_of(node);
    switch (kind) {
    case Kind::letter_o_word: {
        std::string meant(text(node));
        std::ranges::replace(meant, 'O', '0');
        report(SyntaxErrorKind::letter_o, span(node), std::move(meant));
        break;
    }
    case Kind::empty_word:
        if (const std::string_view address = text(node); address.size() == 2 && address.back() == 'O')
            return report(SyntaxErrorKind::letter_o, span(node), std::string(1, address.front()) + '0'); // QO
        report(SyntaxErrorKind::missing_value, span(node), "a number, a variable or a calculation in ( )");
        break;
    case Kind::foreign_comment:
        report(SyntaxErrorKind::foreign_remark, span(node), in_square_brackets(text(node)));
        break;
    default: break;
    }
    if (is_compared(kind)) check_comparison(node);
    if (begins_with_keyword(kind)) check_capitals(node);
}

/// Only IF and WHILE compare: `#l1=#g1==5` has no value [l.19643, l.19774].
void BlockLowering::check_comparison(const Node& node) {
    const Node* above = parent_of(node);
    if (above != nullptr && is_compared(kind_of(*above))) return; // the whole is told
    while (above != nullptr && kind_of(*above) == Kind::parenthesis) above = parent_of(*above);
    if (above == nullptr || is_compared(kind_of(*above))) return;
    const Kind kind = kind_of(*above);
    if (kind == Kind::if_statement || kind == Kind::while_statement || kind == Kind::unknown_statement)
        return;
    const Node* sign = child(node, Field::operation);
    if (sign != nullptr && kind_of(*sign) == Kind::assignment_sign) return; // told as such
    report(SyntaxErrorKind::comparison_as_value, span(node), "");
}

/// Of a keyword the word alone, of an NC word the whole.
void BlockLowering::check_capitals(const Node& node) {
    const std::string_view written = text(node);
    const auto end = std::ranges::find_if_not(written, [](char c) { return is_letter(c) || c == '_'; });
    const std::string_view word = kind_of(node) == Kind::lower_case_word
                                      ? written
                                      : written.substr(0, static_cast<std::size_t>(end - written.begin()));
    std::string capitals = in_capitals(word);
    if (capitals == word) return;
    const Offset begin = span(node).begin;
    report(SyntaxErrorKind::small_letters, {begin, begin + static_cast<Offset>(word.size())},
           std::move(capitals));
}

} // namespace maclint::dinplus
