//! What is wrong in a block that the parser could read.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/dialect/sinumerik/diagnose.hpp"
#include "analyzer/dialect/sinumerik/keywords.hpp"
#include "analyzer/dialect/sinumerik/lexer.hpp"
#include "analyzer/dialect/sinumerik/limits.hpp"
#include "analyzer/dialect/sinumerik/lowering.hpp"
#include "analyzer/program/faults.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace maclint::sinumerik {
namespace {

/// Comparisons of other languages, and what they are here.
constexpr std::pair<std::string_view, std::string_view> foreign_signs[] = {
    {"EQ", "=="}, {"NE", "<>"}, {"GT", ">"},  {"GE", ">="}, {"LT", "<"},
    {"LE", "<="}, {"=<", "<="}, {"=>", ">="}, {"!=", "<>"}, {"><", "<>"}};

Span first_byte(Span span) { return {span.begin, span.begin + 1}; }
Span last_byte(Span span) { return {span.end - 1, span.end}; }

} // namespace

void BlockLowering::report_expected(Span here, std::string_view expected) {
    report(SyntaxErrorKind::unreadable, here, std::string(expected));
}

void BlockLowering::report_with(SyntaxErrorKind kind, Span here, std::string cure, Remedy remedy) {
    report(kind, here, std::move(cure));
    syntax_errors_.back().remedy = std::move(remedy);
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
    const auto trimmed = [this](Span part) {
        while (part.length() != 0 && program_->text[part.end - 1] == ' ') --part.end;
        while (part.length() != 0 && program_->text[part.begin] == ' ') ++part.begin;
        return part;
    };
    const Span whole = span(comparison);
    Offset done = whole.begin;
    std::string cure;
    Remedy remedy{"Put each comparison in brackets", false, {}};
    const auto add_part = [&](Span part) {
        part = trimmed(part);
        cure.append("(").append(program_->slice(part)).append(")");
        remedy.changes.push_back({{part.begin, part.begin}, "("});
        remedy.changes.push_back({{part.end, part.end}, ")"});
    };
    for (const Node* word : words) {
        add_part({done, span(*word).begin});
        cure.append(" ").append(text(*word)).append(" ");
        done = span(*word).end;
    }
    add_part({done, whole.end});
    report_with(SyntaxErrorKind::logic_outside_brackets, whole, std::move(cure), std::move(remedy));
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
    case Kind::comparison:
        check_logic(node);
        check_operands(node);
        break;
    case Kind::foreign_operator: {
        const auto* sign = std::ranges::find(foreign_signs, upper_text(node),
                                             &std::pair<std::string_view, std::string_view>::first);
        if (sign == std::end(foreign_signs)) break;
        report_with(SyntaxErrorKind::symbolic_comparison, here, std::string(sign->second),
                    {"Write the comparison of this control", true, {{here, sign->second}}});
        break;
    }
    case Kind::then_statement:
        report_with(SyntaxErrorKind::foreign_keyword, here,
                    "the branch alone, which begins with the next block",
                    {"Remove THEN", true, {{here, ""}}});
        break;
    case Kind::foreign_keyword:
        report(SyntaxErrorKind::foreign_keyword, here, "ELSE, and an IF with its ENDIF of its own in it");
        break;
    case Kind::remark:
        report_with(SyntaxErrorKind::remark_without_sign, here, "", remark_remedy(here.begin));
        break;
    case Kind::foreign_comment: report_parentheses(node); break;
    case Kind::literal_word:
        if (to_capital(text(node).front()) == 'R') report_radius_of_another_control(node, parent);
        break;
    case Kind::unassigned_word: report_missing_equals(node); break;
    case Kind::indexed_command: check_bracketed_value(node); break;
    case Kind::string: check_text(node); break;
    case Kind::binary: check_operands(node); break;
    case Kind::system_variable: check_system_variable(node); break;
    case Kind::empty_word: {
        const bool in_remark =
            node.next_sibling != syntax::no_node && kind_of(tree_->nodes[node.next_sibling]) == Kind::remark;
        if (in_remark || report_letter_o_in_number(node)) break;
        report(SyntaxErrorKind::missing_value, here, "a number, or = and a value");
        break;
    }
    case Kind::malformed_word: check_number(node); break;
    case Kind::malformed_name: // that of a variable or a program is looked at with its length
        if (parent == nullptr ||
            (kind_of(*parent) != Kind::declarator && kind_of(*parent) != Kind::program_definition))
            report(SyntaxErrorKind::malformed_name, here, "its first two characters are not letters or _");
        break;
    case Kind::declarator: // a parameter may have one letter
        if (const Node* name = child(node, Field::name)) check_name(*name, limits::variable_name);
        break;
    case Kind::unclosed_string: report_expected(here, "a '\"' at the end of the text"); break;
    case Kind::typographic_string: report_quotes(here); break;
    case Kind::square_parenthesis:
        report_with(SyntaxErrorKind::unreadable, here, "'(' and ')' around a calculation",
                    {"Write ( ) around it", true, {{first_byte(here), "("}, {last_byte(here), ")"}}});
        break;
    case Kind::foreign_variable: report_expected(here, "an R parameter or a variable with a name"); break;
    case Kind::label:
        if (parent != nullptr && kind_of(*parent) == Kind::goto_statement)
            report_colon_in_jump(node);
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
    report_with(SyntaxErrorKind::wide_sign, colon, ":", {"Write ':'", true, {{colon, ":"}}});
}

/// Whether ( ) are arguments that stand in a wrong place: those of a declaration or a modal call, and
/// numbers.
bool BlockLowering::are_arguments(Span parentheses) const {
    constexpr std::array takers = {"PROC ", "EXTERN ", "MCALL "};
    const std::size_t line = program_->text.rfind('\n', parentheses.begin) + 1; // 0 in the first line
    const std::string before = in_capitals(program_->slice({static_cast<Offset>(line), parentheses.begin}));
    return std::ranges::none_of(program_->slice(parentheses), is_letter) ||
           std::ranges::any_of(takers,
                               [&](const char* word) { return before.find(word) != std::string::npos; });
}

/// `(text)` at the end of a block.
void BlockLowering::report_parentheses(const Node& remark) {
    const Span here = span(remark);
    if (are_arguments(here)) return report_expected(here, "( ) right behind the name that they belong to");
    bool last = true;
    for (auto next = remark.next_sibling; next != syntax::no_node; next = tree_->nodes[next].next_sibling)
        last &= is_remark(tree_->nodes[next]);
    std::string cure = "; ";
    cure.append(program_->slice({here.begin + 1, here.end - 1}));
    report(SyntaxErrorKind::foreign_remark, here, last ? std::move(cure) : "");
}

/// `Z-DEPTH`, `T"DRILL"`
void BlockLowering::report_missing_equals(const Node& word) {
    const Node* address = child(word, Field::address);
    if (address == nullptr) return;
    const Offset behind = span(*address).end;
    std::string cure(text(*address));
    cure.append("=").append(program_->slice({behind, span(word).end}));
    report_with(SyntaxErrorKind::missing_equals, span(word), std::move(cure),
                {"Write = behind the address", true, {{{behind, behind}, "="}}});
}

/// `X[R1]`, as other controls write a value.
void BlockLowering::check_bracketed_value(const Node& command) {
    constexpr std::string_view take_values = "XYZABCUVWIJKFS";
    const Node* element = only_child(command);
    const Node* address = element == nullptr || kind_of(*element) != Kind::indexed_address
                              ? nullptr
                              : child(*element, Field::address);
    const Node* index = element == nullptr ? nullptr : child(*element, Field::index);
    if (address == nullptr || index == nullptr || kind_of(*address) != Kind::address) return;
    const Node* value = only_child(*index);
    if (value == nullptr || take_values.find(to_capital(text(*address).front())) == std::string_view::npos)
        return;
    const Span brackets = span(*index);
    std::string cure(text(*address));
    cure.append("=").append(text(*value));
    report_with(SyntaxErrorKind::missing_equals, span(command), std::move(cure),
                {"Write = and the value", true, {{first_byte(brackets), "="}, {last_byte(brackets), ""}}});
}

void BlockLowering::report_colon_in_jump(const Node& label) {
    const Span here = span(label);
    const std::string_view name = label_in(text(label));
    const Span colon{here.begin + static_cast<Offset>(name.size()), here.end};
    report_with(SyntaxErrorKind::colon_in_jump, here, std::string(name),
                {"Remove the colon", true, {{colon, ""}}});
}

/// The quotation marks of a text processor, each of two or three bytes.
void BlockLowering::report_quotes(Span here) {
    const std::string_view written = program_->slice(here);
    const auto continues = [&](std::size_t at) {
        constexpr unsigned char mask = 0xC0, follows = 0x80;
        return at < written.size() && (static_cast<unsigned char>(written[at]) & mask) == follows;
    };
    Offset first = 1;
    while (continues(first)) ++first;
    Offset last = here.length() - 1;
    while (last > first && continues(last)) --last;
    report_with(SyntaxErrorKind::unreadable, here, "straight quotation marks '\"'",
                {"Write straight quotation marks",
                 true,
                 {{{here.begin, here.begin + first}, "\""}, {{here.begin + last, here.end}, "\""}}});
}

/// The word that a statement begins with.
Span BlockLowering::keyword_of(const Node& statement) const {
    const Span whole = span(statement);
    const std::string_view written = program_->slice(whole);
    const auto end = std::ranges::find_if_not(written, begins_name);
    return {whole.begin, whole.begin + static_cast<Offset>(end - written.begin())};
}

/// A block without a number for the next one lost its line end; what stands behind the condition of an IF
/// that opens a branch, or beside ELSE and the like, is no block.
void BlockLowering::check_alone(std::span<const Node* const> items, const Block& head) {
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
        if (kind_of(*item) == Kind::block_number)
            report_with(SyntaxErrorKind::second_block, span(*item), "",
                        {"Begin a new line", true, {{{span(*item).begin, span(*item).begin}, "\n"}}});
    const bool remarks = std::ranges::any_of(items, [](const Node* item) {
        return kind_of(*item) == Kind::remark || kind_of(*item) == Kind::foreign_comment;
    });
    const auto structure = std::ranges::find_if(items, is_structure);
    const auto branch = std::ranges::find_if(items, [&](const Node* item) {
        return kind_of(*item) == Kind::if_statement && child(*item, Field::jump) == nullptr;
    });
    const bool opens = !items.empty() && (kind_of(*items.front()) == Kind::while_statement ||
                                          kind_of(*items.front()) == Kind::for_statement ||
                                          kind_of(*items.front()) == Kind::until_statement);
    if (head.name && (opens || structure != items.end() || branch != items.end()))
        report(SyntaxErrorKind::head_at_structure, head.name_span, "");
    else if (head.skip_levels != 0 && (opens || structure != items.end() || branch != items.end()))
        report(SyntaxErrorKind::head_at_structure, first_byte(block_), "");
    if (items.size() < 2 || remarks) return;
    const bool slip = std::ranges::any_of(items, [&](const Node* item) { // IF R1==1 GOTFO NEXT
        return kind_of(*item) == Kind::then_statement ||
               (kind_of(*item) == Kind::command &&
                (!jump_meant_by(upper_text(*item)).empty() || is_foreign_loop_word(upper_text(*item))));
    });
    if (slip) return;
    if (opens) return report(SyntaxErrorKind::not_alone, keyword_of(*items.front()), "");
    if (branch != items.end() && structure == items.end()) {
        return report(SyntaxErrorKind::not_alone, keyword_of(**branch), "");
    }
    if (structure != items.end()) report(SyntaxErrorKind::not_alone, span(**structure), "");
}

/// What counts are the characters of the code: whether remarks count no document tells.
void BlockLowering::check_length(std::span<const Node* const> items) {
    const auto last = std::find_if_not(items.rbegin(), items.rend(), [](const Node* item) {
        return kind_of(*item) == Kind::remark || kind_of(*item) == Kind::foreign_comment;
    });
    if (last == items.rend() || span(**last).end - block_.begin <= limits::block_length) return;
    const Span behind{block_.begin + static_cast<Offset>(limits::block_length), span(**last).end};
    report(SyntaxErrorKind::block_too_long, behind, std::to_string(limits::block_length));
}

void BlockLowering::check_functions(std::span<const Node* const> items) {
    struct Counted {
        char letter;
        std::size_t most, found = 0;
    };
    Counted functions[] = {{'M', limits::block_functions_m},
                           {'S', limits::block_functions_sh},
                           {'H', limits::block_functions_sh}};
    const auto letter_of = [this](const Node& item) {
        if (kind_of(item) == Kind::literal_word) return to_capital(text(item).front());
        const Node* left = kind_of(item) == Kind::assignment ? child(item, Field::left) : nullptr;
        const bool is_address =
            left != nullptr && (kind_of(*left) == Kind::address || kind_of(*left) == Kind::numbered_address);
        const std::string name = is_address ? upper_text(*left) : "";
        // SF=30, HR=5: other words than M1=3, S2=500
        return !name.empty() && (name.size() == 1 || is_digit(name[1])) ? name.front() : '\0';
    };
    for (const Node* item : items)
        for (Counted& function : functions)
            if (letter_of(*item) == function.letter && ++function.found == function.most + 1)
                report(SyntaxErrorKind::too_many_functions, span(*item),
                       std::to_string(function.most) + " " + function.letter);
}

/// SETAL(65000, "X")
void BlockLowering::check_alarm_number(const Node& arguments) {
    const Node* number = nullptr;
    for_each_child(arguments, [&](const Node& argument) {
        if (number == nullptr) number = &argument;
    });
    if (number == nullptr || kind_of(*number) != Kind::number) return;
    const double value = read_number(text(*number)).value;
    if (value < limits::first_alarm || value > limits::last_alarm)
        report(SyntaxErrorKind::alarm_number, span(*number),
               std::to_string(limits::first_alarm) + " to " + std::to_string(limits::last_alarm));
}

} // namespace maclint::sinumerik
