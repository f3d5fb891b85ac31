//! What statements may hold: how many conditions, what a call passes, what INPUT and WINDOW take.
#include "analyzer/dialect/dinplus/lowering.hpp"
#include "analyzer/dialect/dinplus/value_tables.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::dinplus {
namespace {

bool is_place(Kind kind) {
    switch (kind) {
    case Kind::variable:
    case Kind::selected_variable:
    case Kind::indirect_variable:
    case Kind::named_variable:
    case Kind::transfer_variable: return true;
    default: return false;
    }
}

/// Values that say nothing of their own; what a function gives may be a truth.
bool compares_nothing(Kind kind) {
    return is_place(kind) || kind == Kind::number || kind == Kind::binary || kind == Kind::unary ||
           kind == Kind::string || kind == Kind::constant;
}

bool is_whole(double number) { return number == std::floor(number); }

/// Whether a word of a call passes a value. The list prints some letters without their L [l.19937].
bool passes_a_value(std::string_view address) {
    constexpr std::string_view printed_alone = "IJKOPRSUWXYZ";
    if (address.size() == 1 && printed_alone.find(address) == std::string_view::npos) return false;
    return transfer_variable(address).has_value();
}

/// The name of a file without its extension.
std::string_view without_extension(std::string_view name) { return name.substr(0, name.find('.')); }

} // namespace

void BlockLowering::check_statement(const Node& node) {
    switch (kind_of(node)) {
    case Kind::if_statement:
    case Kind::while_statement: check_conditions(node); break;
    case Kind::switch_statement: check_selection(node); break;
    case Kind::output_statement: check_output(node); break;
    case Kind::call: check_call(node); break;
    case Kind::group_start:
    case Kind::group_end: check_group(node); break;
    default: break;
    }
}

/// At most two conditions are linked [l.19669, l.19800], and each compares [l.19643, l.19774].
void BlockLowering::check_conditions(const Node& statement) {
    const Node* condition = child(statement, Field::condition);
    if (condition == nullptr) return;
    const Node* asked = condition;
    while (asked != nullptr && kind_of(*asked) == Kind::parenthesis) asked = only_child(*asked);
    if (asked != nullptr && compares_nothing(kind_of(*asked)))
        return report(SyntaxErrorKind::no_condition, span(*condition), "");
    std::size_t links = 0;
    Nodes waiting{condition};
    while (!waiting.empty()) {
        const Node* node = waiting.back();
        waiting.pop_back();
        links += kind_of(*node) == Kind::logical ? 1 : 0;
        for_each_child(*node, [&](const Node& below) { waiting.push_back(&below); });
    }
    if (links + 1 > limits::conditions)
        report(SyntaxErrorKind::too_many_conditions, span(*condition), std::to_string(links + 1));
}

/// SWITCH is followed by a variable [l.19850].
void BlockLowering::check_selection(const Node& statement) {
    const Node* value = child(statement, Field::value);
    while (value != nullptr && kind_of(*value) == Kind::parenthesis) value = only_child(*value);
    if (value != nullptr && !is_place(kind_of(*value)) && kind_of(*value) != Kind::constant)
        report(SyntaxErrorKind::selection_of_calculation, span(*value), "");
}

void BlockLowering::check_output(const Node& statement) {
    const Node* function = child(statement, Field::function);
    const Node* list = child(statement, Field::arguments);
    if (function == nullptr || list == nullptr) return;
    Nodes arguments;
    for_each_child(*list, [&](const Node& argument) { arguments.push_back(&argument); });
    const std::string name = upper_text(*function);
    if (name == "INPUT") check_input(statement, arguments);
    if (name == "WINDOW") check_window(statement, arguments);
}

/// INPUT(text, variable) [l.19615].
void BlockLowering::check_input(const Node& statement, const Nodes& arguments) {
    if (arguments.size() != 2)
        return report(SyntaxErrorKind::argument_count, span(statement), "two arguments");
    const Node& target = *arguments.back();
    if (!is_place(kind_of(target))) return report(SyntaxErrorKind::input_into_no_variable, span(target), "");
    check_target(target);
}

/// WINDOW(lines) or WINDOW(lines, name) [l.19568, l.19587].
void BlockLowering::check_window(const Node& statement, const Nodes& arguments) {
    if (arguments.empty() || arguments.size() > 2)
        return report(SyntaxErrorKind::argument_count, span(statement), "one or two arguments");
    const auto rows = plain_number(*arguments.front());
    if (rows && (*rows < 0 || *rows > limits::window_lines || !is_whole(*rows)))
        report(SyntaxErrorKind::window_out_of_range, span(*arguments.front()), "");
}

void BlockLowering::check_call(const Node& call) {
    bool external = false;
    std::size_t passed = 0;
    for_each_child(call, [&](const Node& word) {
        if (!is_word(kind_of(word))) return;
        const std::string_view address = address_of(word);
        const std::optional<double> number = number_of_word(word);
        if (address == "V") {
            external = number.value_or(0) != 0;
        } else if (address == "Q") {
            if (number && (*number < 1 || !is_whole(*number)))
                report(SyntaxErrorKind::repeat_count, span(word), "a whole number from 1 on");
        } else if (passes_a_value(address)) {
            check_argument(word, address);
            if (address != "ID" && address != "AT" && ++passed == limits::arguments + 1)
                report(SyntaxErrorKind::too_many_arguments, span(word), std::to_string(limits::arguments));
        } else if (!address.empty()) {
            report(SyntaxErrorKind::unknown_call_word, span(word), "");
        }
    });
    const Node* name = child(call, Field::name);
    if (name == nullptr || kind_of(*name) != Kind::string) return;
    const std::string_view written = program_->slice(characters(*name));
    const std::size_t most = external ? limits::external_name : limits::local_name;
    if (without_extension(written).size() > most)
        report(SyntaxErrorKind::long_program_name, span(*name), std::to_string(most));
}

/// BLOCKSTART and BLOCKEND hold units together; groups may stand in groups [l.2406].
void BlockLowering::check_group(const Node& node) {
    if (kind_of(node) == Kind::group_start)
        open_->groups.push_back(span(node));
    else if (!open_->groups.empty())
        open_->groups.pop_back();
    else
        report(SyntaxErrorKind::group_unbalanced, span(node), "BLOCKSTART");
}

/// Texts are passed by ID and AT alone [l.19940]; LN passes the number of a block [l.19948].
void BlockLowering::check_argument(const Node& word, std::string_view address) {
    const Node* value = kind_of(word) == Kind::literal_word ? nullptr : child(word, Field::value);
    const bool takes_text = address == "ID" || address == "AT";
    if (value != nullptr && !takes_text && holds(*value) == Holds::text)
        report(SyntaxErrorKind::text_for_number, span(word), std::string(address));
    const auto number = number_of_word(word);
    if (address == "LN" && number && (*number < 0 || !is_whole(*number)))
        report(SyntaxErrorKind::number_for_block, span(word), "the number of a block");
}

} // namespace maclint::dinplus
