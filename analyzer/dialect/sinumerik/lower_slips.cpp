//! Words of the language that are misspelt: the grammar takes them for names.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/near_names.hpp"
#include "analyzer/dialect/sinumerik/diagnose.hpp"
#include "analyzer/dialect/sinumerik/g_codes.hpp"
#include "analyzer/dialect/sinumerik/keywords.hpp"
#include "analyzer/dialect/sinumerik/lexer.hpp"
#include "analyzer/dialect/sinumerik/lowering.hpp"
#include "analyzer/dialect/sinumerik/words.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

namespace maclint::sinumerik {

std::size_t BlockLowering::words_in_block() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(items_, [](const Node* item) { return !is_head(kind_of(*item)); }));
}

/// `GO X5`, `MO`: the letter for the figure. Alone in its block only what a program would hardly be named.
bool BlockLowering::report_letter_o(std::string_view capitals, Span here) {
    constexpr std::string_view addresses = "GXYZIJKFSM";
    const bool code = capitals.size() > 1 && addresses.find(capitals.front()) != std::string_view::npos &&
                      capitals.find_first_not_of("O0123456789", 1) == std::string_view::npos;
    if (!code) return false;
    constexpr std::string_view often_alone[] = {"GO", "XO", "YO", "ZO", "MO"};
    const bool alone = words_in_block() < 2;
    if (alone && std::ranges::find(often_alone, capitals) == std::end(often_alone)) return false;
    std::string meant(capitals);
    std::ranges::replace(meant, 'O', '0');
    report(SyntaxErrorKind::letter_o, here, meant);
    return true;
}

/// `X8O`: what stands behind the figure is a word of its own.
bool BlockLowering::report_letter_o_in_number(const Node& letter) {
    const Span here = span(letter);
    const std::string_view before = std::string_view(program_->text).substr(0, here.begin);
    const auto is_of_number = [](char c) { return is_digit(c) || c == '.' || c == '-' || c == '+'; };
    const auto address = std::find_if_not(before.rbegin(), before.rend(), is_of_number);
    const auto length = static_cast<Offset>(address - before.rbegin());
    const bool is_zero = upper_text(letter) == "O" && length != 0 && is_digit(before.back());
    if (!is_zero || address == before.rend() || !is_letter(*address)) return false;
    const Span word{here.begin - length - 1, here.end};
    std::string meant(program_->slice(word));
    meant.back() = '0';
    report(SyntaxErrorKind::letter_o, word, std::move(meant));
    return true;
}

/// How many characters the address has where the name is one and its value, without the = between them:
/// `XR1`, `LIMS2000`, `XLENGTH` of a variable LENGTH, `XIC(5)`. 0: it is none.
std::size_t BlockLowering::address_without_equals(std::string_view capitals, bool has_arguments) const {
    constexpr std::string_view addresses = "XYZABCUVWIJKFS", figures = "0123456789";
    constexpr std::string_view of_axes = "XYZABCUVWIJK";
    constexpr std::string_view ways[] = {"AC", "ACN", "ACP", "DC", "IC"};
    const bool is_axis = of_axes.find(capitals.front()) != std::string_view::npos;
    if (has_arguments)
        return is_axis && std::ranges::find(ways, capitals.substr(1)) != std::end(ways) ? 1 : 0;
    const bool is_letter = addresses.find(capitals.front()) != std::string_view::npos;
    if (is_letter && capitals.size() > 2 && variable_named(capitals.substr(1)) != nullptr) return 1;
    const std::size_t figures_from = capitals.find_last_not_of(figures) + 1;
    if (figures_from == capitals.size()) return 0;
    const std::string_view name = capitals.substr(0, figures_from);
    const WordRow* row = find_word(name); // CR10 is CR=10 rather than C=R10
    if (row != nullptr && row->kind == WordKind::address) return name.size();
    return name.size() == 2 && name[1] == 'R' && is_letter ? 1 : 0;
}

/// `G0 XR1`, `G96 S200 LIMS2000`: the = before the value is gone. Alone it may be a program.
bool BlockLowering::report_value_behind_address(std::string_view capitals, bool has_arguments, Span here) {
    const std::size_t address = words_in_block() < 2 ? 0 : address_without_equals(capitals, has_arguments);
    if (address == 0) return false;
    std::string cure(capitals.substr(0, address));
    cure.append("=").append(program_->slice({here.begin + static_cast<Offset>(address), here.end}));
    const Offset behind = here.begin + static_cast<Offset>(address);
    report_with(SyntaxErrorKind::missing_equals, here, std::move(cure),
                {"Write = behind the address", true, {{{behind, behind}, "="}}});
    return true;
}

/// `ENDI` alone in its block, `GOTFO NEXT`: what stands there may open or close something, or jump.
bool BlockLowering::report_slip(std::string_view capitals, Span here) {
    const std::size_t content = words_in_block();
    const auto is_name = [](const Node* item) { return kind_of(*item) == Kind::command; };
    const auto is_if = [](const Node* item) { return kind_of(*item) == Kind::if_statement; };
    const auto names = static_cast<std::size_t>(std::ranges::count_if(items_, is_name));
    const auto ifs = static_cast<std::size_t>(std::ranges::count_if(items_, is_if));
    constexpr std::size_t word_and_label = 2;
    std::string_view meant;
    if (content == 1) meant = closer_meant_by(capitals);
    if (content == 1 && meant.empty()) meant = bare_opener_meant_by(capitals);
    if (names == word_and_label && content == names + ifs) meant = jump_meant_by(capitals);
    if (names >= word_and_label && ifs == 0 && here.begin == span(*items_[items_.size() - content]).begin &&
        opener_meant_by(capitals) == "REPEAT")
        meant = "REPEAT"; // of a part of the program
    if (meant.empty()) return false;
    report(SyntaxErrorKind::unknown_keyword, here, std::string(meant));
    builder_->add_unreadable({{}, {}, true, true}, here);
    return true;
}

/// `TRNAS X40`, `STOPPRE`: a program of the shop may have the name, so that the rule looks for it.
void BlockLowering::note_misspelt_word(std::string_view capitals, Span here, bool has_arguments) {
    const auto is_count = [this](const Node* item) { // NAME P3: how often
        return kind_of(*item) == Kind::literal_word && to_capital(text(*item).front()) == 'P';
    };
    const auto counts = static_cast<std::size_t>(std::ranges::count_if(items_, is_count));
    std::string_view meant = command_meant_by(capitals, words_in_block() - counts == 1);
    if (meant.empty() && has_arguments) meant = cycle_meant_by(capitals);
    if (!meant.empty())
        return builder_->add_unknown_name({std::string(capitals), here, std::string(meant), false});
    for (const ExternalDeclaration& declared : program_->externals)
        if (is_typing_slip(capitals, declared.name))
            return builder_->add_unknown_name({std::string(capitals), here, declared.name, true});
}

/// `ISNUMER(SIZE_)` in a calculation, where no program can stand.
void BlockLowering::note_misspelt_function(const Node& name) {
    const std::string capitals = upper_text(name);
    if (find_word(capitals) != nullptr || open_->macros.contains(capitals)) return;
    if (const std::string_view meant = function_meant_by(capitals); !meant.empty())
        builder_->add_unknown_name({capitals, span(name), std::string(meant), false});
}

/// `DFE INT COUNT`, `PORC SLOT(REAL DEPTH)`: the block declares something, and nobody knows what.
bool BlockLowering::lower_misspelt_declaration(std::span<const Node* const> items) {
    if (items.size() < 2 || kind_of(*items.front()) != Kind::command) return false;
    const std::string first = upper_text(*items.front());
    if (find_word(first) != nullptr || find_g_code(first) != nullptr || variable_named(first) != nullptr ||
        open_->macros.contains(first))
        return false;
    const std::string_view meant =
        declaration_meant_by(first, upper_text(*items[1]), open_->first_code.empty());
    if (meant.empty()) return false;
    report(SyntaxErrorKind::unknown_keyword, span(*items.front()), std::string(meant));
    pass_over_names(block_, meant == "PROC");
    return true;
}

/// What the names in the block stand for nobody knows. A PROC that cannot be read has parameters that are not
/// known, and may say SAVE.
void BlockLowering::pass_over_names(Span block, bool of_the_program) {
    bool saves = false;
    const std::string_view file = program_->text;
    for (const Token& token : tokens_of(file, block)) {
        if (token.kind != Token::Kind::name) continue;
        std::string name = in_capitals(file.substr(token.span.begin, token.span.length()));
        saves |= name == "SAVE";
        open_->unread.insert(std::move(name));
    }
    if (!of_the_program) return;
    builder_->set_parameters_unknown();
    if (saves) save_modes(block);
}

} // namespace maclint::sinumerik
