//! What is wrong in a block that the parser could read.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/sinumerik/diagnose.hpp"
#include "analyzer/dialect/sinumerik/keywords.hpp"
#include "analyzer/dialect/sinumerik/lowering.hpp"
#include "analyzer/program/faults.hpp"

#include <algorithm>
#include <utility>

namespace maclint::sinumerik {
namespace {

/// Comparisons of other languages, and what they are here.
constexpr std::pair<std::string_view, std::string_view> foreign_signs[] = {
    {"EQ", "=="}, {"NE", "<>"}, {"GT", ">"},  {"GE", ">="}, {"LT", "<"},
    {"LE", "<="}, {"=<", "<="}, {"=>", ">="}, {"!=", "<>"}, {"><", "<>"}};

/// The first two characters are letters or `_` [FUND04 p.60].
constexpr std::string_view name_form = "a name that begins with two letters";

} // namespace

void BlockLowering::report_expected(Span here, std::string_view expected) {
    report(SyntaxErrorKind::unreadable, here, std::string(expected));
}

/// What is wrong with single nodes. Parents stand before their children.
void BlockLowering::check_tokens() {
    parents_.assign(tree_->nodes.size(), nullptr);
    for (const Node& node : tree_->nodes) {
        for (syntax::NodeIndex c = node.first_child; c != syntax::no_node; c = tree_->nodes[c].next_sibling)
            parents_[c] = &node;
        check_token(node, parent_of(node));
    }
}

const syntax::Node* BlockLowering::parent_of(const Node& node) const {
    return parents_[static_cast<std::size_t>(&node - tree_->nodes.data())];
}

/// Comparisons bind looser than AND and OR [NCP19 p.444]: `A==1 AND B<>0` compares A with `1 AND B`. The
/// words between comparisons, in text order.
void BlockLowering::words_between_comparisons(const Node& comparison, Nodes& words) const {
    const Node* left = child(comparison, Field::left);
    if (left != nullptr && kind_of(*left) == Kind::comparison) words_between_comparisons(*left, words);
    const std::size_t before = words.size();
    const Node* logic = child(comparison, Field::right);
    for (; logic != nullptr && kind_of(*logic) == Kind::logical; logic = child(*logic, Field::left))
        if (const Node* word = child(*logic, Field::operation)) words.push_back(word);
    std::reverse(words.begin() + static_cast<std::ptrdiff_t>(before), words.end());
}

void BlockLowering::check_logic(const Node& comparison) {
    const Node* above = parent_of(comparison);
    if (above != nullptr && kind_of(*above) == Kind::comparison) return; // told there
    Nodes words;
    words_between_comparisons(comparison, words);
    if (words.empty()) return;
    const auto trimmed = [](std::string_view part) {
        while (part.ends_with(' ')) part.remove_suffix(1);
        while (part.starts_with(' ')) part.remove_prefix(1);
        return part;
    };
    const Span whole = span(comparison);
    Offset done = whole.begin;
    std::string cure = "(";
    for (const Node* word : words) {
        cure.append(trimmed(program_->slice({done, span(*word).begin})));
        cure.append(") ").append(text(*word)).append(" (");
        done = span(*word).end;
    }
    cure.append(trimmed(program_->slice({done, whole.end}))).append(")");
    report(SyntaxErrorKind::logic_outside_brackets, whole, std::move(cure));
}

void BlockLowering::check_token(const Node& node, const Node* parent) {
    const Span here = span(node);
    switch (kind_of(node)) {
    case Kind::assignment_sign:
    case Kind::equality_sign: {
        const bool comparison = kind_of(node) == Kind::assignment_sign;
        const Span whole = parent == nullptr ? here : span(*parent);
        report(comparison ? SyntaxErrorKind::assignment_in_condition
                          : SyntaxErrorKind::comparison_as_assignment,
               here,
               std::string(program_->slice({whole.begin, here.begin})) + (comparison ? "==" : "=") +
                   std::string(program_->slice({here.end, whole.end})));
        break;
    }
    case Kind::comparison: check_logic(node); break;
    case Kind::foreign_operator: {
        const auto* sign = std::ranges::find(foreign_signs, upper_text(node),
                                             &std::pair<std::string_view, std::string_view>::first);
        report(SyntaxErrorKind::unknown_keyword, here,
               sign == std::end(foreign_signs) ? "" : std::string(sign->second));
        break;
    }
    case Kind::then_statement:
    case Kind::foreign_keyword: report(SyntaxErrorKind::unknown_keyword, here, ""); break;
    case Kind::remark:
    case Kind::foreign_comment: report_expected(here, "a ';' before a remark"); break;
    case Kind::unassigned_word:
        if (const Node* address = child(node, Field::address))
            report(SyntaxErrorKind::unreadable, here, "a '=' after '" + upper_text(*address) + "'");
        break;
    case Kind::empty_word: {
        const bool in_remark =
            node.next_sibling != syntax::no_node && kind_of(tree_->nodes[node.next_sibling]) == Kind::remark;
        if (!in_remark) report(SyntaxErrorKind::missing_value, here, "a number, or = and a value");
        break;
    }
    case Kind::malformed_word: check_number(node); break;
    case Kind::malformed_name: report_expected(here, name_form); break;
    case Kind::declarator: // DEF REAL L1; a parameter may have one letter
        if (const Node* name = child(node, Field::name); name != nullptr && kind_of(*name) == Kind::axis_name)
            report_expected(span(*name), name_form);
        break;
    case Kind::unclosed_string: report_expected(here, "a '\"' at the end of the text"); break;
    case Kind::typographic_string: report_expected(here, "straight quotation marks '\"'"); break;
    case Kind::square_parenthesis: report_expected(here, "'(' and ')' around a calculation"); break;
    case Kind::foreign_variable: report_expected(here, "an R parameter or a variable with a name"); break;
    case Kind::label:
        if (parent != nullptr && kind_of(*parent) == Kind::goto_statement)
            report_expected(here, "the label without its colon");
        else if (text(node).ends_with(wide_colon))
            file_wide_colon(node);
        break;
    default: break;
    }
}

void BlockLowering::check_number(const Node& word) {
    const std::string_view written = text(word);
    const std::size_t comma = written.find(',');
    if (comma == std::string_view::npos)
        return report_expected(span(word), "one number with one sign and one decimal point");
    std::string cure(written);
    cure[comma] = '.';
    SyntaxError error{SyntaxErrorKind::unreadable, span(word), std::string(written), std::move(cure)};
    error.fault = faults::decimal_comma;
    syntax_errors_.push_back(std::move(error));
}

/// The block that the colon ends is none that a jump finds, and none that the control can read.
void BlockLowering::file_wide_colon(const Node& label) {
    const Span whole = span(label);
    const Span colon{whole.end - static_cast<Offset>(wide_colon.size()), whole.end};
    report(SyntaxErrorKind::wide_sign, colon, ":");
}

/// A block without a number for the next one lost its line end; what stands behind the condition of an IF
/// that opens a branch, or beside ELSE and the like, is no block.
void BlockLowering::check_alone(std::span<const Node* const> items) {
    const auto is_structure = [](const Node* item) {
        switch (kind_of(*item)) {
        case Kind::else_statement:
        case Kind::endif_statement:
        case Kind::endwhile_statement:
        case Kind::endfor_statement:
        case Kind::loop_statement:
        case Kind::endloop_statement:
        case Kind::repeat_statement: return true;
        default: return false;
        }
    };
    for (const Node* item : items)
        if (kind_of(*item) == Kind::block_number) report_expected(span(*item), "a new line before it");
    const bool remarks = std::ranges::any_of(items, [](const Node* item) {
        return kind_of(*item) == Kind::remark || kind_of(*item) == Kind::foreign_comment;
    });
    if (items.size() < 2 || remarks) return;
    const auto structure = std::ranges::find_if(items, is_structure);
    const auto branch = std::ranges::find_if(items, [&](const Node* item) {
        return kind_of(*item) == Kind::if_statement && child(*item, Field::jump) == nullptr;
    });
    const bool slip = std::ranges::any_of(items, [&](const Node* item) { // IF R1==1 GOTFO NEXT
        return kind_of(*item) == Kind::then_statement ||
               (kind_of(*item) == Kind::command && !jump_meant_by(upper_text(*item)).empty());
    });
    if (slip) return;
    if (branch != items.end() && structure == items.end()) {
        const Span whole = span(**branch);
        constexpr Offset length_of_if = 2;
        return report_expected({whole.begin, whole.begin + length_of_if}, "a block of its own for it");
    }
    if (structure != items.end()) report_expected(span(**structure), "a block of its own for it");
}

} // namespace maclint::sinumerik
