//! What is wrong with single nodes of a block that the parser could read.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/fanuc/diagnose.hpp"
#include "analyzer/dialect/fanuc/keywords.hpp"
#include "analyzer/dialect/fanuc/letter_o.hpp"
#include "analyzer/dialect/fanuc/lexer.hpp"
#include "analyzer/dialect/fanuc/lowering.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"
#include "analyzer/program/faults.hpp"

#include <algorithm>

namespace maclint::fanuc {
namespace {

/// Where `O1002` begins in `X10.O1002`; 0: there is none.
std::size_t begin_of_program_number(std::string_view word) {
    const std::size_t o = word.find_first_of("Oo");
    if (o < 2 || o == std::string_view::npos || (!is_digit(word[o - 1]) && word[o - 1] != '.')) return 0;
    const std::string_view number = word.substr(o + 1);
    return number.size() >= digits_of_program && std::ranges::all_of(number, is_digit) ? o : 0;
}

} // namespace

void BlockLowering::report_unreadable(Span span, std::string expected, std::string_view fault) {
    report(SyntaxErrorKind::unreadable, span, std::move(expected));
    syntax_errors_.back().fault = fault;
}

/// Nearly all blocks are sound, and one look at their nodes shows it.
void BlockLowering::check_tokens() {
    const bool has_points = program_->slice(block_).find('.') != std::string_view::npos;
    bool has_foreign_words = false;
    const Node* empty_word = nullptr;
    int brackets = 0;
    for (const Node& node : tree_->nodes) {
        switch (kind_of(node)) {
        case Kind::symbolic_operator:
        case Kind::foreign_keyword: has_foreign_words = true; break;
        case Kind::empty_word:
            if (empty_word == nullptr) empty_word = &node;
            break;
        case Kind::letter_o_word: check_letter_o(node); break;
        case Kind::literal_word:
        case Kind::address:
            if (text(node).front() == '&' || text(node).front() == '@')
                refuse_form({span(node).begin, span(node).begin + 1}, "", faults::character);
            break;
        case Kind::variable:
            if (has_points) check_number_of(node);
            break;
        case Kind::malformed_word:
            report_unreadable(span(node), "a number with at most one sign and one decimal point",
                              std::ranges::count(text(node), '.') > 1 ? faults::two_points
                                                                      : faults::two_signs);
            break;
        case Kind::computed_sequence_number: // [1.3]
            report_unreadable(span(node), "the digits of a sequence number", faults::no_sequence_number);
            break;
        case Kind::computed_program_number: // [1.2]
            report_unreadable(span(node), "the digits of a program number", faults::no_program_number);
            break;
        case Kind::double_sharp: check_double_sharp(node); break;
        case Kind::bracket:
        case Kind::argument_list:
        case Kind::condition: ++brackets; break;
        default: break;
        }
    }
    if (has_foreign_words) check_words();
    if (brackets > program_->control->limits.bracket_levels) check_depth(tree_->nodes.front(), 0);
    if (empty_word != nullptr) check_empty_word(*empty_word);
}

/// `#504.`, `#30003.036`
void BlockLowering::check_number_of(const Node& variable) {
    const std::string_view written = text(variable);
    const std::size_t point = written.find('.');
    if (point == std::string_view::npos) return;
    if (point + 1 == written.size())
        report(SyntaxErrorKind::point_in_variable_number, span(variable),
               std::string(written.substr(0, point)));
    else if (!has_variables_with_decimals(*program_->control))
        report(SyntaxErrorKind::fraction_in_variable_number, span(variable), "");
}

/// Operators and keywords of other languages.
void BlockLowering::check_words() {
    std::vector<bool> in_condition(tree_->nodes.size(), false);
    for (std::size_t i = 0; i < tree_->nodes.size(); ++i) {
        const Node& node = tree_->nodes[i];
        const Kind kind = kind_of(node);
        const bool here = in_condition[i] || kind == Kind::condition || kind == Kind::compound_condition ||
                          kind == Kind::unbracketed_condition;
        for (syntax::NodeIndex c = node.first_child; c != syntax::no_node; c = tree_->nodes[c].next_sibling)
            in_condition[c] = here;
        if (kind == Kind::symbolic_operator && here)
            report(SyntaxErrorKind::symbolic_comparison, span(node),
                   std::string(comparison_word(text(node))));
        else if (kind == Kind::symbolic_operator) // [3: comparisons give no value]
            report_unreadable(span(node), "a calculation, because only IF and WHILE compare",
                              faults::expression);
        else if (kind == Kind::foreign_keyword && program_->control->has_block_if &&
                 is_word_of_block_if(node))
            check_word_of_block_if(node);
        else if (kind == Kind::foreign_keyword && !is_of_block_if(node))
            syntax_errors_.push_back(unknown_word(program_->text, span(node)));
    }
}

/// ELSE, ELSEIF and ENDIF where the control has blocks of IF.
void BlockLowering::check_word_of_block_if(const Node& keyword) {
    const std::string word = in_capitals(text(keyword));
    if (word != "ELSE" && word != "ENDIF")
        report(SyntaxErrorKind::unreadable, span(keyword), "ELSE, and the IF in a block of its own");
    else if (block_ifs_.empty())
        report(SyntaxErrorKind::unreadable, span(keyword), "an IF ... THEN before it");
    else if (word == "ELSE" && block_ifs_.back().has_else)
        report(SyntaxErrorKind::unreadable, span(keyword), "one ELSE for an IF");
}

/// The first address without a value; in `X(#1+2)` a comment is meant to be one.
void BlockLowering::check_empty_word(const Node& word) {
    if (std::optional<SyntaxError> found = find_parenthesis_as_bracket(program_->text, block_)) {
        syntax_errors_.push_back(std::move(*found));
        return;
    }
    Span address = span(word);
    while (is_blank(program_->text[address.end - 1])) --address.end;
    refuse(SyntaxErrorKind::missing_value, address, "");
}

/// `GO1`, `XO`: the letter O where a figure 0 belongs.
void BlockLowering::check_letter_o(const Node& word) {
    const Span all = with_rest_of_number(word);
    if (const std::size_t o = begin_of_program_number(text(word))) {
        const Span number{span(word).begin + static_cast<Offset>(o), span(word).end};
        report_unreadable(number, "a program number at the head of a block", faults::number_misplaced);
        return;
    }
    const std::optional<Span> jump = find_jump_with_zero(program_->text, all);
    if (jump && holds_if()) {
        const std::string_view number = program_->slice(*jump).substr(std::string_view("G0TO").size());
        report(SyntaxErrorKind::unknown_keyword, *jump, "GOTO" + std::string(number));
        return;
    }
    if (const std::optional<Span> typed = find_jump_misspelt(all)) {
        report(SyntaxErrorKind::unknown_keyword, *typed, "GOTO");
        return;
    }
    const std::string_view written = program_->slice(all);
    std::string mended(written);
    Remedy remedy{"Write the figure 0 for the letter O", !may_be_jump(all)};
    for (std::size_t i = 0; i < written.size(); ++i) {
        if (to_capital(written[i]) != 'O') continue;
        mended[i] = '0';
        const Offset at = all.begin + static_cast<Offset>(i);
        remedy.changes.push_back({{at, at + 1}, "0"});
    }
    const SyntaxErrorKind kind =
        remedy.certain ? SyntaxErrorKind::letter_o : SyntaxErrorKind::letter_o_or_jump;
    refuse(kind, all, std::move(mended), std::move(remedy));
}

bool BlockLowering::holds_if() const {
    return std::ranges::any_of(items_,
                               [&](const Node* item) { return kind_of(*item) == Kind::if_statement; });
}

/// `GOT 5`, `GTO5`: letters of GOTO before a number, which read as words with O for 0.
std::optional<Span> BlockLowering::find_jump_misspelt(Span word) const {
    const std::string_view text = program_->text;
    Offset begin = word.begin;
    while (begin > block_.begin && is_letter(text[begin - 1])) --begin;
    Offset end = word.begin;
    while (end < block_.end && is_letter(text[end])) ++end;
    const bool is_meant = is_misspelt_goto(in_capitals(text.substr(begin, end - begin)), holds_if());
    Offset next = end;
    while (next < block_.end && is_blank(text[next])) ++next;
    if (!is_meant || next == block_.end || (!is_digit(text[next]) && text[next] != '#')) return std::nullopt;
    return Span{begin, end};
}

/// The word, with a number that goes on behind a blank: `GO 1`.
Span BlockLowering::with_rest_of_number(const Node& word) const {
    const auto item = std::ranges::find(items_, &word);
    if (item == items_.end() || item + 1 == items_.end() || kind_of(**(item + 1)) != Kind::bare_value)
        return span(word);
    return join(span(word), span(**(item + 1)));
}

/// `GO5` alone in its block.
bool BlockLowering::may_be_jump(Span word) const {
    const auto other = std::ranges::find_if(items_, [&](const Node* item) {
        return !word.contains(span(*item).begin) && kind_of(*item) != Kind::sequence_number &&
               kind_of(*item) != Kind::skip;
    });
    const std::string written = without_blanks(program_->slice(word));
    return other == items_.end() && written.size() > 2 && written.starts_with("GO") &&
           std::ranges::all_of(std::string_view(written).substr(2), is_digit);
}

/// [2.3]
void BlockLowering::check_double_sharp(const Node& variable) {
    const Node* index = child(variable, Field::index);
    if (index == nullptr) return;
    const Span inner = span(*index);
    refuse(SyntaxErrorKind::double_sharp, span(variable), "#[" + std::string(text(*index)) + "]",
           {"Put the inner variable in [ ]",
            true,
            {{{inner.begin, inner.begin}, "["}, {{inner.end, inner.end}, "]"}}});
}

/// Reports the first bracket of the block that opens one level too many.
void BlockLowering::check_depth(const Node& node, int depth) {
    if (depth_reported_) return;
    const Kind kind = kind_of(node);
    if (kind == Kind::bracket || kind == Kind::argument_list || kind == Kind::condition) {
        if (++depth > program_->control->limits.bracket_levels) {
            depth_reported_ = true;
            const Offset begin = span(node).begin;
            report(SyntaxErrorKind::bracket_depth, {begin, begin + 1}, "");
            return;
        }
    }
    for (syntax::NodeIndex i = node.first_child; i != syntax::no_node; i = tree_->nodes[i].next_sibling)
        check_depth(tree_->nodes[i], depth);
}

} // namespace maclint::fanuc
