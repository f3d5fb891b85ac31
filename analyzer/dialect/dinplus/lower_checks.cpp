//! What is wrong in a block that the parser could read.
#include "analyzer/dialect/dinplus/keywords.hpp"
#include "analyzer/dialect/dinplus/lowering.hpp"
#include "analyzer/dialect/dinplus/sections.hpp"

#include <algorithm>

namespace maclint::dinplus {
namespace {

/// Comparisons of other languages, and what they are here.
constexpr std::pair<std::string_view, std::string_view> foreign_signs[] = {
    {"EQ", "=="}, {"NE", "<>"}, {"GT", ">"},  {"GE", ">="}, {"LT", "<"},
    {"LE", "<="}, {"=<", "<="}, {"=>", ">="}, {"!=", "<>"}, {"><", "<>"}};

/// Nodes that do nothing, and are reported or passed over elsewhere.
bool is_aside(Kind kind) {
    return is_head(kind) || kind == Kind::stray_parenthesis || kind == Kind::stray_bracket ||
           kind == Kind::foreign_comment;
}

/// Keywords that must be alone in their block [l.19668].
bool wants_to_be_alone(Kind kind) {
    return kind == Kind::if_statement || kind == Kind::then_statement || kind == Kind::else_statement ||
           kind == Kind::endif_statement;
}

bool opens_bracket(Kind kind) {
    return kind == Kind::parenthesis || kind == Kind::argument_list || kind == Kind::selector_list ||
           kind == Kind::vacancy_test;
}

} // namespace

/// IF, THEN, ELSE and ENDIF stand alone in their block [l.19668].
void BlockLowering::check_alone(std::span<const Node* const> items) {
    const auto content = std::ranges::count_if(items, [](const Node* n) { return !is_aside(kind_of(*n)); });
    if (content < 2 || !open_->effects) return;
    const auto wants = [](const Node* n) { return wants_to_be_alone(kind_of(*n)); };
    auto keyword = std::ranges::find_if(items, wants);
    if (keyword == items.end()) return;
    // The condition belongs to IF: in IF #l1>60 THEN it is THEN that has to move.
    if (kind_of(**keyword) == Kind::if_statement)
        if (const auto next = std::find_if(std::next(keyword), items.end(), wants); next != items.end())
            keyword = next;
    Span marked = span(**keyword);
    constexpr Offset length_of_if = 2;
    if (kind_of(**keyword) == Kind::if_statement) marked.end = marked.begin + length_of_if;
    report(SyntaxErrorKind::not_alone, marked, "");
}

/// An IF is followed by THEN: the next block, unless nobody can tell what that one is.
void BlockLowering::check_then(std::span<const Node* const> items) {
    for (const Node* item : items) {
        const Kind kind = kind_of(*item);
        if (is_aside(kind)) continue;
        if (open_->waiting_if && kind != Kind::then_statement && kind != Kind::unknown_statement)
            report(SyntaxErrorKind::then_missing, *open_->waiting_if, "THEN");
        open_->waiting_if.reset();
        if (kind == Kind::if_statement) open_->waiting_if = span(*item);
    }
}

/// What is wrong with single nodes of a block that the parser could read. Parents stand before their
/// children.
void BlockLowering::check_tokens() {
    check_depth();
    parents_.assign(tree_->nodes.size(), nullptr);
    for (const Node& node : tree_->nodes) {
        for (syntax::NodeIndex c = node.first_child; c != syntax::no_node; c = tree_->nodes[c].next_sibling)
            parents_[c] = &node;
        check_token(node);
        check_form(node);
        check_value(node);
        check_statement(node);
    }
}

void BlockLowering::check_token(const Node& node) {
    switch (kind_of(node)) {
    case Kind::assignment_sign:
    case Kind::equality_sign: check_sign(node); break;
    case Kind::foreign_operator: {
        const auto* sign = std::ranges::find(foreign_signs, upper_text(node),
                                             &std::pair<std::string_view, std::string_view>::first);
        report(SyntaxErrorKind::unknown_keyword, span(node),
               sign == std::end(foreign_signs) ? "" : std::string(sign->second));
        break;
    }
    case Kind::unknown_function:
        report(SyntaxErrorKind::unknown_keyword, span(node), meant_by(capitals_of(text(node))));
        break;
    case Kind::stray_parenthesis:
        report(SyntaxErrorKind::bracket_mismatch, span(node), "a '(' is missing before it");
        break;
    case Kind::stray_bracket:
        report(SyntaxErrorKind::bracket_mismatch, span(node), "no '[' opens a comment before it");
        break;
    case Kind::unclosed_string:
        report(SyntaxErrorKind::unreadable, span(node), "a '\"' at the end of the text");
        break;
    case Kind::typographic_string:
        report(SyntaxErrorKind::unreadable, span(node), "straight quotation marks '\"'");
        break;
    case Kind::malformed_word: check_number(node); break;
    case Kind::computed_block_number:
        report(SyntaxErrorKind::unreadable, span(node), "the digits of a block number");
        break;
    case Kind::double_sharp: report(SyntaxErrorKind::unreadable, span(node), "a single '#'"); break;
    case Kind::foreign_variable:
        report(SyntaxErrorKind::unreadable, span(node), "a letter after '#', as in #l1");
        break;
    default: break;
    }
}

/// `=` in a comparison, `==` in an assignment.
void BlockLowering::check_sign(const Node& node) {
    const bool comparison = kind_of(node) == Kind::assignment_sign;
    const Span whole = span(*parent_of(node));
    const Span sign = span(node);
    report(comparison ? SyntaxErrorKind::assignment_in_condition : SyntaxErrorKind::comparison_as_assignment,
           sign,
           std::string(program_->slice({whole.begin, sign.begin})) + (comparison ? "==" : "=") +
               std::string(program_->slice({sign.end, whole.end})));
}

/// Two signs in a row are passed over: they may be meant for a calculation.
void BlockLowering::check_number(const Node& word) {
    const std::string_view written = text(word);
    if (written.find(',') != std::string_view::npos)
        report(SyntaxErrorKind::unreadable, span(word), "a decimal point in the number");
    else if (written.find_first_of("0123456789") == std::string_view::npos) // G..., of manuals
        report(SyntaxErrorKind::unreadable, span(word), "a number");
    else if (written.find('.') != written.rfind('.'))
        report(SyntaxErrorKind::unreadable, span(word), "one decimal point in the number");
}

/// Reports the first bracket of the block that opens one level too many. Parents stand before their children.
void BlockLowering::check_depth() {
    std::vector<int> depths(tree_->nodes.size(), 0);
    for (std::size_t i = 0; i < tree_->nodes.size(); ++i) {
        const Node& node = tree_->nodes[i];
        if (opens_bracket(kind_of(node)) && ++depths[i] > program_->control->limits.bracket_levels) {
            const auto bracket = static_cast<Offset>(text(node).find('('));
            const Offset begin = span(node).begin + bracket;
            return report(SyntaxErrorKind::bracket_depth, {begin, begin + 1}, "");
        }
        for (syntax::NodeIndex c = node.first_child; c != syntax::no_node; c = tree_->nodes[c].next_sibling)
            depths[c] = depths[i];
    }
}

} // namespace maclint::dinplus
