//! Ways of writing that not every control of the family takes: what stands beside what in a block, and what
//! conditions and calculations leave out.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/fanuc/keywords.hpp"
#include "analyzer/dialect/fanuc/lowering.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace maclint::fanuc {
namespace {

/// A longer cure says no more than the words around it.
constexpr std::size_t longest_cure = 60;

bool is_statement(Kind kind) {
    switch (kind) {
    case Kind::assignment:
    case Kind::goto_statement:
    case Kind::if_statement:
    case Kind::while_statement:
    case Kind::do_statement:
    case Kind::end_statement: return true;
    default: return false;
    }
}

Span at(Offset place) { return {place, place}; }

} // namespace

/// A macro call is a statement, too [6].
bool calls_macro(std::string_view word) {
    return !word.empty() && (word.front() == 'G' || word.front() == 'g') &&
           (word.ends_with("65") || word.ends_with("66") || word.ends_with("66.1"));
}

/// The control's table of forms has the last word.
void BlockLowering::refuse(SyntaxErrorKind form, Span span, std::string cure, Remedy remedy,
                           std::string_view fault) {
    const ControlModel& control = *program_->control;
    const Reading reading = reading_of(control, form);
    if (reading == Reading::takes || reading == Reading::unknown) return;
    SyntaxError error{form, span, std::string(program_->slice(span)), std::move(cure)};
    if (error.cure.size() > longest_cure) error.cure.clear();
    if (control.assumed) error.elsewhere = controls_that_take(form);
    if (reading == Reading::doubtful)
        error.answer = Answer::unknown;
    else if (!error.elsewhere.empty())
        error.answer = Answer::stops_if_assumed;
    error.remedy = std::move(remedy);
    error.fault = fault;
    syntax_errors_.push_back(std::move(error));
}

/// Words and statements that stand in one block, or behind one IF.
void BlockLowering::check_row(std::span<const Node* const> items) {
    const Node* first = nullptr;
    const Node* second = nullptr;
    for (const Node* item : items) {
        const Kind kind = kind_of(*item);
        // A word of another language has been told; what stands behind a '/' may be left out.
        if (kind == Kind::foreign_keyword || kind == Kind::skip) return;
        if (!is_statement(kind) && !is_word(kind)) continue;
        if (first == nullptr)
            first = item;
        else if (second == nullptr && (is_statement(kind) || is_statement(kind_of(*first))))
            second = item;
    }
    if (second == nullptr) return;
    const bool first_is_statement = is_statement(kind_of(*first));
    const Span rest = join(span(*second), span(*items.back()));
    if (kind_of(*first) == Kind::goto_statement)
        refuse(SyntaxErrorKind::words_after_jump, rest, "");
    else if (is_jump_for_do(*first, *second))
        return; // its DO is missing
    else if (first_is_statement && kind_of(*second) == Kind::goto_statement)
        refuse(SyntaxErrorKind::jump_beside_statement, rest, "");
    else if (first_is_statement && is_statement(kind_of(*second)))
        refuse(SyntaxErrorKind::statement_beside_statement, rest, "");
    else
        refuse(SyntaxErrorKind::words_beside_statement, rest, "");
}

/// `IF[#1EQ2]N3`: the jump is missing, and the control reads the number of a block in the middle of one.
void BlockLowering::refuse_number_for_jump(const Node& number) {
    const Span all = span(number);
    const std::string_view written = text(number);
    const std::size_t digits = written.find_first_of("0123456789");
    const Span letter{all.begin, all.begin + static_cast<Offset>(digits)};
    refuse(SyntaxErrorKind::consequence_without_then, all, "GOTO" + std::string(written.substr(digits)),
           {"Write GOTO for N", true, {{letter, "GOTO"}}});
}

/// [4: IF takes a GOTO, or THEN and one statement]
void BlockLowering::check_consequences(const Node& if_statement, std::span<const Node* const> consequences) {
    const bool has_then = child(if_statement, Field::then) != nullptr;
    const Span whole = span(if_statement);
    if (consequences.empty()) {
        if (!has_then) refuse(SyntaxErrorKind::condition_alone, whole, "");
        return;
    }
    const Kind first = kind_of(*consequences.front());
    if (first == Kind::letter_o_word && find_jump_misspelt(span(*consequences.front()))) return; // IF[..]GOT5
    const bool foreign = std::ranges::any_of(
        consequences, [](const Node* node) { return kind_of(*node) == Kind::foreign_keyword; });
    if (first == Kind::sequence_number && !has_then && !foreign)
        return refuse_number_for_jump(*consequences.front());
    if (foreign || (!is_statement(first) && !is_word(first))) return;
    const Span rest = join(span(*consequences.front()), span(*consequences.back()));
    if (first == Kind::goto_statement || (first == Kind::if_statement && has_then)) {
        check_row(consequences);
    } else if (!has_then) {
        const bool assigns = first == Kind::assignment;
        refuse(SyntaxErrorKind::consequence_without_then, rest,
               assigns ? "THEN " + std::string(program_->slice(rest)) : std::string(),
               assigns ? Remedy{"Write THEN before it", true, {{at(rest.begin), "THEN "}}} : Remedy{});
    } else if (is_word(first)) {
        if (!calls_macro(text(*consequences.front()))) refuse(SyntaxErrorKind::words_after_then, rest, "");
    } else if (consequences.size() > 1) {
        const Span more{span(*consequences[1]).begin, rest.end};
        refuse(SyntaxErrorKind::more_after_then, more, "");
    }
}

/// The condition of an IF or a WHILE.
void BlockLowering::check_condition(const Node& condition, std::string_view fault) {
    const Kind kind = kind_of(condition);
    if (kind != Kind::unbracketed_condition && kind != Kind::compound_condition) return;
    const Span all = span(condition);
    const bool open = kind == Kind::compound_condition;
    refuse(open ? SyntaxErrorKind::logic_outside_brackets : SyntaxErrorKind::condition_without_brackets, all,
           "[" + std::string(text(condition)) + "]",
           {"Put the whole condition in [ ]", true, {{at(all.begin), "["}, {at(all.end), "]"}}}, fault);
}

/// `GOTO N5`
void BlockLowering::check_label(const Node& label) {
    const Span all = span(label);
    const std::string_view written = text(label);
    const std::string_view digits = written.substr(written.find_first_of("0123456789"));
    refuse(
        SyntaxErrorKind::letter_in_jump, all, std::string(digits),
        {"Leave only the number", true, {{{all.begin, all.end - static_cast<Offset>(digits.size())}, ""}}});
}

/// `SIN 30`, `ABS#2`. Only where nothing goes on behind it is it certain what belongs to the function.
void BlockLowering::check_argument(const Node& function, const Node& argument) {
    const Span operand = span(argument);
    const std::string_view text = program_->text.substr(0, block_.end);
    const std::size_t next = text.find_first_not_of(" \t", operand.end);
    const bool ends = next == std::string_view::npos || text[next] == ']' || text[next] == '(';
    refuse(SyntaxErrorKind::function_without_brackets, join(span(function), operand),
           std::string(this->text(function)) + "[" + std::string(this->text(argument)) + "]",
           {"Put the argument in [ ]", ends, {{at(operand.begin), "["}, {at(operand.end), "]"}}});
}

/// `#2--#3`: behind a sign, an operand that begins with one.
void BlockLowering::check_sign(const Node& operand) {
    const Node* signed_one = &operand;
    while (kind_of(*signed_one) == Kind::binary) {
        const Node* left = child(*signed_one, Field::left);
        if (left == nullptr) return;
        signed_one = left;
    }
    const Node* sign = kind_of(*signed_one) == Kind::unary ? child(*signed_one, Field::operation) : nullptr;
    if (sign == nullptr || (text(*sign) != "+" && text(*sign) != "-")) return;
    const Span all = span(*signed_one);
    refuse(SyntaxErrorKind::sign_after_sign, all, "[" + std::string(text(*signed_one)) + "]",
           {"Put the second sign and its value in [ ]", false, {{at(all.begin), "["}, {at(all.end), "]"}}});
}

/// [3: comparisons give no value]. Of several in a block the first one is told.
void BlockLowering::check_comparison(const Node& comparison) {
    if (comparison_reported_) return;
    comparison_reported_ = true;
    refuse(SyntaxErrorKind::comparison_as_value, span(comparison), "");
}

/// `ZI5`: where the I makes no increment, the Z has no value.
void BlockLowering::check_increment(Span address) {
    const ControlModel& control = *program_->control;
    if (has_incremental_words(control)) return;
    refuse(SyntaxErrorKind::missing_value, address, "");
    if (!control.assumed) return;
    syntax_errors_.back().answer = Answer::stops_if_assumed;
    syntax_errors_.back().elsewhere = controls_with_incremental_words();
}

/// What the control lacks by the table of that.
void BlockLowering::check_lacking(Extra extra, Span span, std::string_view subject) {
    const ControlModel& control = *program_->control;
    const Lacking* lacking = lacking_on(control, extra);
    if (lacking == nullptr) return;
    SyntaxError error{SyntaxErrorKind::missing_construct, span, std::string(subject),
                      std::string(lacking->cure)};
    error.fault = lacking->fault;
    error.elsewhere = control.assumed ? lacking->elsewhere : "";
    if (!lacking->documented)
        error.answer = Answer::unknown;
    else if (!error.elsewhere.empty())
        error.answer = Answer::stops_if_assumed;
    syntax_errors_.push_back(std::move(error));
}

void BlockLowering::check_function(std::string_view name, std::size_t operands, bool has_divisor, Span span) {
    struct Row {
        std::string_view name;
        Extra extra;
    };
    static constexpr Row rows[] = {{"POW", Extra::power},
                                   {"PRM", Extra::parameter},
                                   {"LN", Extra::logarithm},
                                   {"EXP", Extra::logarithm},
                                   {"EX", Extra::logarithm},
                                   {"BIN", Extra::code_of_decimals},
                                   {"BCD", Extra::code_of_decimals},
                                   {"ADP", Extra::code_of_decimals}};
    const std::string capitals = in_capitals(name);
    const auto* row = std::ranges::find(rows, capitals, &Row::name);
    if (row != std::end(rows)) check_lacking(row->extra, span, capitals);
    if (has_divisor || !capitals.starts_with("AT")) return;
    check_lacking(operands == 1 ? Extra::angle_of_one : Extra::angle_of_two, span, program_->slice(span));
}

/// `G65 H02 P#102 Q100.0 R0`: H, the code of an operation, comes first, P is the variable for its result, and
/// Q and R are what it works on. `G65 H81 P50 Q#530 R25`: P is the number of a block, or of an alarm. A call
/// of macro B has P first, as a rule, and a program of more figures.
std::optional<Extra> BlockLowering::macro_a_of(std::span<const NcWord> words) const {
    struct Operations {
        double first, last;
        std::size_t fewest, most; ///< words
        bool of_variable;         ///< P is one
        Extra extra;
    };
    static constexpr Operations rows[] = {
        {1, 5, 4, 5, true, Extra::macro_a},         {11, 13, 4, 5, true, Extra::macro_a},
        {21, 28, 4, 5, true, Extra::macro_a},       {31, 34, 4, 5, true, Extra::macro_a},
        {80, 80, 3, 3, false, Extra::macro_a_jump}, {81, 86, 5, 5, false, Extra::macro_a_test},
        {99, 99, 3, 3, false, Extra::macro_a_alarm}}; // T
    constexpr std::string_view letters = "GHPQR";
    constexpr std::size_t fewest = 3;
    constexpr double first_long_number = 1000;
    if (words.size() < fewest || words.size() > letters.size()) return std::nullopt;
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i].letter != letters[i] || words[i].comma || !words[i].value) return std::nullopt;
    const NcWord& code = words[1];
    const NcWord& place = words[2];
    if (!code.literal || text(*code.node).find('.') != std::string_view::npos) return std::nullopt;
    const auto row = std::ranges::find_if(rows, [&](const Operations& candidate) {
        return *code.literal >= candidate.first && *code.literal <= candidate.last;
    });
    if (row == std::end(rows) || words.size() < row->fewest || words.size() > row->most) return std::nullopt;
    const bool fits = row->of_variable
                          ? !place.literal && std::holds_alternative<Load>(expression(*place.value).node)
                          : place.literal && *place.literal < first_long_number;
    return fits ? std::optional(row->extra) : std::nullopt;
}

} // namespace maclint::fanuc
