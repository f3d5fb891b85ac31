//! Names, types and sizes, held against the tables and against what the program defines.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/dialect/sinumerik/functions.hpp"
#include "analyzer/dialect/sinumerik/g_codes.hpp"
#include "analyzer/dialect/sinumerik/limits.hpp"
#include "analyzer/dialect/sinumerik/lowering.hpp"
#include "analyzer/dialect/sinumerik/system_variables.hpp"
#include "analyzer/dialect/sinumerik/words.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace maclint::sinumerik {
namespace {

constexpr std::string_view text_type = "STRING";

bool is_number_type(std::string_view type) { return type == "REAL" || type == "INT" || type == "BOOL"; }

/// Characters of a text in UTF-8.
std::size_t characters_in(std::string_view text) {
    constexpr unsigned char mask = 0xC0, follows = 0x80;
    return static_cast<std::size_t>(std::ranges::count_if(
        text, [](char c) { return (static_cast<unsigned char>(c) & mask) != follows; }));
}

/// What a name is already; empty: nothing. Those of cycles and of parts of a frame may be used again, as
/// programs show.
std::string_view meaning_of(std::string_view capitals) {
    if (find_g_code(capitals) != nullptr) return "a G code";
    const WordRow* row = find_word(capitals);
    if (row == nullptr) return {};
    switch (row->kind) {
    case WordKind::keyword: return "a keyword";
    case WordKind::procedure:
    case WordKind::command: return "a command";
    case WordKind::function: return "a function";
    case WordKind::address: return "an address";
    case WordKind::constant: return "a constant";
    case WordKind::cycle:
    case WordKind::attribute:
    case WordKind::part: break;
    }
    return {};
}

std::string count_of(std::size_t number, std::string_view one, std::string_view many) {
    return std::to_string(number) + " " + std::string(number == 1 ? one : many);
}

} // namespace

/// Of a variable, a parameter or a program.
void BlockLowering::check_name(const Node& name, std::size_t longest) {
    const std::size_t length = text(name).size();
    if (kind_of(name) == Kind::axis_name || kind_of(name) == Kind::malformed_name)
        report(SyntaxErrorKind::malformed_name, span(name), "its first two characters are not letters or _");
    else if (length > longest)
        report(SyntaxErrorKind::malformed_name, span(name),
               "it has " + std::to_string(length) + " characters, and " + std::to_string(longest) +
                   " are the most");
}

/// A name stands for one thing alone [NCP19 p.45].
void BlockLowering::check_taken(const Node& name) {
    if (kind_of(name) != Kind::name) return;
    const std::string capitals = upper_text(name);
    if (const std::string_view meaning = meaning_of(capitals); !meaning.empty())
        return report(SyntaxErrorKind::taken_name, span(name), std::string(meaning));
    const bool defined = variable_named(capitals) != nullptr || open_->arrays.contains(capitals);
    if (defined || open_->macros.contains(capitals))
        report(SyntaxErrorKind::taken_name, span(name), defined ? "a variable" : "a macro");
}

/// Whether the name of a file is the program's with something before or behind it that people add to files:
/// the folder that it came from ("CMA__DRESS", "4711-DRESS"), or what marks a copy ("DRESS (2)",
/// "DRESS-OLD"). On the control it bears the program's name again.
bool is_decorated(std::string_view file, std::string_view program) {
    constexpr std::string_view before = "_-. ";
    constexpr std::string_view behind = "-. (~";
    if (file.size() <= program.size()) return false;
    if (file.ends_with(program))
        return before.find(file[file.size() - program.size() - 1]) != std::string_view::npos;
    return file.starts_with(program) && behind.find(file[program.size()]) != std::string_view::npos;
}

/// A program's name is that of its file [NCP23 p.490].
void BlockLowering::check_program_name(const Node& name) {
    check_name(name, limits::program_name);
    if (!open_->has_file_name) return;
    std::string capitals = upper_text(name);
    if (capitals.starts_with("_N_")) capitals.erase(0, 3);
    if (capitals.ends_with("_SPF") || capitals.ends_with("_MPF")) capitals.resize(capitals.size() - 4);
    const std::string file = in_capitals(program_->name);
    if (capitals == file || is_decorated(file, capitals)) return;
    // A longer name no control gives: whoever stored the file has put its folders before it.
    std::string_view given = program_->name;
    if (given.size() > limits::program_name) {
        const std::size_t folders = given.rfind("__");
        if (folders == std::string_view::npos) return;
        given.remove_prefix(folders + 2);
    }
    report(SyntaxErrorKind::other_program_name, span(name), std::string(given));
}

namespace {

/// `$R[10]`, `$R10`, `$RG[1]`: R parameters in synchronised actions have no row [PGA p.344].
bool is_r_parameter_of_actions(std::string_view capitals) {
    if (!capitals.starts_with("$R")) return false;
    capitals.remove_prefix(capitals.starts_with("$RG") ? 3 : 2);
    return std::ranges::all_of(capitals, is_digit);
}

} // namespace

void BlockLowering::check_system_variable(const Node& node) {
    const Node* name = child(node, Field::name);
    if (name == nullptr) return;
    std::string capitals = upper_text(*name);
    if (capitals.starts_with("$$")) capitals.erase(0, 1);
    if (is_r_parameter_of_actions(capitals) || is_control_data(capitals) || find_system_variable(capitals))
        return;
    report(SyntaxErrorKind::unknown_system_variable, span(*name), "");
}

void BlockLowering::check_may_be_stored(const Node& system_variable) {
    const Node* name = child(system_variable, Field::name);
    if (name == nullptr) return;
    const std::string_view held = held_by_read_only(upper_text(*name));
    if (!held.empty()) report(SyntaxErrorKind::read_only_variable, span(system_variable), std::string(held));
}

void BlockLowering::lower_index(const Node& node, Span whole) {
    const Node* list = child(node, Field::index);
    const Node* name = child(node, Field::name);
    if (name != nullptr) note_unknown(*name, true);
    // POS[LOADER]=5: a word of the language takes axes there.
    const bool of_axes = name == nullptr || find_word(upper_text(*name)) != nullptr;
    const bool around = std::exchange(names_axes_, names_axes_ || of_axes);
    const std::vector<ExpressionId> indices = values_of(list);
    names_axes_ = around;
    check_index(node, indices);
    if (list != nullptr) evaluate(apply(Operation::unknown, indices, span(*list)), whole);
}

/// How many indices an array takes, and how far they go. A text takes one more, for a character of it, and
/// a frame has parts.
void BlockLowering::check_index(const Node& node, std::span<const ExpressionId> indices) {
    const Node* name = child(node, Field::name);
    if (name == nullptr) return;
    const std::string capitals = upper_text(*name);
    const auto array = open_->arrays.find(capitals);
    if (array == open_->arrays.end()) {
        const Variable* variable = variable_named(capitals);
        const Declaration* declared = variable == nullptr ? nullptr : program_->declaration_of(*variable);
        if (declared != nullptr && is_number_type(declared->type_name))
            report(SyntaxErrorKind::wrong_dimensions, span(node), "no index");
        else if (variable == nullptr && kind_of(*name) == Kind::name && find_word(capitals) == nullptr)
            builder_->add_foreign_element(capitals, indices, span(node));
        return;
    }
    const auto& sizes = array->second.sizes;
    const bool one_more = !is_number_type(array->second.type);
    if (indices.size() != sizes.size() && !(one_more && indices.size() >= sizes.size()))
        return report(SyntaxErrorKind::wrong_dimensions, span(node),
                      count_of(sizes.size(), "index", "indices"));
    for (std::size_t i = 0; i < sizes.size(); ++i)
        if (sizes[i]) builder_->add_array_index({indices[i], *sizes[i], span(node), array->second.declared});
}

/// The values of `SET(1,2,3)` or `(1,2,3)`; nullptr: there is no such list.
const syntax::Node* BlockLowering::values_listed(const Node& value) const {
    if (kind_of(value) == Kind::value_list) return &value;
    const Node* function = kind_of(value) == Kind::function_call ? child(value, Field::function) : nullptr;
    const bool is_set = function != nullptr && upper_text(*function) == "SET";
    return is_set ? child(value, Field::arguments) : nullptr;
}

/// `DEF INT ROW[3]=SET(1,2,3,4)`
void BlockLowering::check_initial_values(const Node& declarator) {
    const Node* size = child(declarator, Field::size);
    const Node* value = child(declarator, Field::value);
    if (size == nullptr || value == nullptr) return;
    double places = 1;
    for_each_child(*size,
                   [&](const Node& part) { places *= literal_value(lower_expression(part)).value_or(0); });
    if (places > 0) check_values_fit(*value, places, "that the array has");
}

/// `ROW[2]=SET(1,2)` of an array of three.
void BlockLowering::check_stored_values(const Node& element, const Node& value) {
    const Node* name = child(element, Field::name);
    const Node* list = child(element, Field::index);
    if (name == nullptr || list == nullptr || values_listed(value) == nullptr) return;
    const auto array = open_->arrays.find(upper_text(*name));
    if (array == open_->arrays.end()) return;
    const std::vector<ExpressionId> indices = values_of(list);
    const auto& sizes = array->second.sizes;
    if (indices.size() != sizes.size()) return;
    double places = 1, before = 0; // the last index runs first
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const auto index = literal_value(indices[i]);
        if (!sizes[i] || !index || *index < 0 || *index >= *sizes[i]) return;
        places *= *sizes[i];
        before = before * *sizes[i] + *index;
    }
    check_values_fit(value, places - before, "from there on");
}

void BlockLowering::check_values_fit(const Node& value, double places, std::string_view where) {
    const Node* list = values_listed(value);
    if (list == nullptr) return;
    std::size_t values = 1; // gaps count, too
    for_each_below(*list, [&](const Node& part) { values += !part.named && text(part) == "," ? 1U : 0U; });
    if (static_cast<double>(values) > places)
        report(SyntaxErrorKind::too_many_initial_values, span(value),
               count_of(static_cast<std::size_t>(places), "place ", "places ").append(where));
}

/// Characters between the quotation marks.
std::size_t BlockLowering::length_of_text(const Node& text_node) const {
    constexpr std::size_t quotes = 2;
    return characters_in(text(text_node)) - quotes;
}

/// STRING[20]
void BlockLowering::note_length_of_text(const std::string& variable, const Node& type) {
    const std::string written = without_blanks(text(type));
    const std::size_t open = written.find('[');
    if (open == std::string::npos || type_name(type) != text_type) return;
    if (const auto length = read_integer(written.substr(open + 1, written.find(']') - open - 1)))
        open_->text_lengths.insert_or_assign(variable, static_cast<std::size_t>(*length));
}

void BlockLowering::check_length_of_text(std::string_view variable, const Node& value) {
    const auto known = open_->text_lengths.find(variable);
    if (known == open_->text_lengths.end() || kind_of(value) != Kind::string) return;
    const std::size_t length = length_of_text(value);
    if (length > known->second && length <= limits::text)
        report(SyntaxErrorKind::text_too_long, span(value), std::to_string(known->second));
}

void BlockLowering::check_text(const Node& node) {
    const std::size_t length = length_of_text(node);
    if (length > limits::text)
        report(SyntaxErrorKind::text_too_long, span(node), std::to_string(limits::text));
}

/// What the machine's maker or another file defines, or a slip: the program's end shows whether all else is
/// defined. Names with `_` in front are those of SIEMENS's cycles [T].
void BlockLowering::note_unknown(const Node& name, bool is_read) {
    if (kind_of(name) != Kind::name || names_axes_) return;
    const std::string capitals = upper_text(name);
    if (capitals.starts_with('_') || find_word(capitals) != nullptr || find_g_code(capitals) != nullptr ||
        open_->macros.contains(capitals) || open_->arrays.contains(capitals))
        return;
    Uses& uses = open_->unknown.try_emplace(capitals, Uses{.first = span(name)}).first->second;
    ++uses.count;
    uses.is_read |= is_read;
}

/// How many arguments a function takes, and of which type. A name that the program does not define may be a
/// macro, and hold several.
void BlockLowering::check_arguments(const FunctionRow& function, Span call, const Node& list) {
    std::size_t places = 1, values = 0;
    bool may_be_more = false;
    for_each_below(list, [&](const Node& part) {
        if (!part.named && text(part) == ",") ++places;
        if (!part.named || is_remark(part)) return;
        ++values;
        may_be_more |= kind_of(part) == Kind::name && variable_named(upper_text(part)) == nullptr;
    });
    const bool are_too_few = places < function.least || values == 0;
    if (places <= function.most && (may_be_more || !are_too_few))
        return places == values ? check_types(function, list) : void();
    std::string cure = count_of(function.least, "argument", "arguments");
    if (function.least != function.most)
        cure = std::to_string(function.least) + " or " + count_of(function.most, "argument", "arguments");
    report(SyntaxErrorKind::argument_count, call, std::move(cure));
}

void BlockLowering::check_types(const FunctionRow& function, const Node& list) {
    std::string_view wanted = function.takes;
    for_each_child(list, [&](const Node& value) {
        if (wanted.empty()) return;
        check_stored(wanted.front() == FunctionRow::takes_text     ? text_type
                     : wanted.front() == FunctionRow::takes_number ? "REAL"
                                                                   : "",
                     value);
        wanted.remove_prefix(1);
    });
}

// ---- types

/// "STRING" or a type of numbers; empty: not known, or another one.
std::string_view BlockLowering::type_of_value(const Node& node) const {
    switch (kind_of(node)) {
    case Kind::string:
    case Kind::concatenation: return text_type;
    case Kind::number: return "REAL";
    case Kind::function_call: {
        const Node* name = child(node, Field::function);
        const FunctionRow* function = name == nullptr ? nullptr : find_function(upper_text(*name));
        return function != nullptr && function->gives == VariableType::text ? text_type : std::string_view{};
    }
    case Kind::name: {
        const Variable* variable = variable_named(upper_text(node));
        const Declaration* declared = variable == nullptr ? nullptr : program_->declaration_of(*variable);
        return declared == nullptr ? std::string_view{} : declared->type_name;
    }
    default: return {};
    }
}

/// Texts are joined by `<<` and compared with each other, and nothing else [NCP19 p.444].
void BlockLowering::check_operands(const Node& calculation) {
    const Node* left = child(calculation, Field::left);
    const Node* right = child(calculation, Field::right);
    if (left == nullptr || right == nullptr) return;
    const bool texts[] = {type_of_value(*left) == text_type, type_of_value(*right) == text_type};
    const bool numbers[] = {is_number_type(type_of_value(*left)), is_number_type(type_of_value(*right))};
    const bool compares = kind_of(calculation) == Kind::comparison;
    if (compares ? (texts[0] && numbers[1]) || (numbers[0] && texts[1]) : texts[0] || texts[1])
        report(SyntaxErrorKind::text_in_calculation, span(calculation), "");
}

/// A CHAR takes a text of one character.
void BlockLowering::check_stored(std::string_view type, const Node& value) {
    const std::string_view given = type_of_value(value);
    if (is_number_type(type) && given == text_type)
        report(SyntaxErrorKind::text_for_number, span(value), std::string(type));
    if (type == "INT" && kind_of(value) == Kind::number) {
        const auto number = literal_value(lower_expression(value));
        if (number && *number > limits::last_integer)
            report(SyntaxErrorKind::integer_overflow, span(value), "2147483647");
        else if (number && *number != std::floor(*number))
            report(SyntaxErrorKind::fraction_for_integer, span(value), "");
    }
    if (type == text_type && is_number_type(given))
        report(SyntaxErrorKind::number_for_text, span(value), std::string(type));
}

} // namespace maclint::sinumerik
