//! Lowering of output, and what is wrong with names, formats and numbers.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/fanuc/lowering.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/program/faults.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

namespace maclint::fanuc {
namespace {

/// Of a name that SETVN gives, without its `#` [GH-ALM 1142].
constexpr std::size_t longest_name = 8;
/// Positions, one for each axis [GH-ALM 1099; T: their names].
constexpr std::string_view positions[] = {"#_ABSIO", "#_ABSMT", "#_ABSOT", "#_ABSKP"};
constexpr std::int64_t most_axes = 40;
/// Of one that the control has [T: they are much shorter].
constexpr std::size_t longest_system_name = 16;

} // namespace

void BlockLowering::lower_output(const Node& node) {
    const bool decimal = in_capitals(text(node).substr(0, 1)) == "D";
    std::vector<ExpressionId> out;
    for_each_child(node, [&](const Node& part) {
        if (kind_of(part) != Kind::output_variable) return;
        check_format(part, decimal);
        if (const Node* variable = child(part, Field::variable)) out.push_back(lower_expression(*variable));
    });
    builder_->add_exchange(out, {}, span(node));
}

/// Behind the variable stand in [ ] how many figures are printed: `#1[53]` of DPRNT before and behind the
/// point, `#1[3]` of BPRNT behind it.
void BlockLowering::check_format(const Node& printed, bool decimal) {
    const Node* format = child(printed, Field::format);
    const std::size_t wanted = decimal ? 2 : 1;
    const std::string_view figures = format == nullptr ? std::string_view() : text(*format);
    if (figures.size() == wanted && figures.find('.') == std::string_view::npos) return;
    const Node* variable = child(printed, Field::variable);
    const std::string name(variable == nullptr ? std::string_view() : text(*variable));
    refuse_form(span(printed),
                name +
                    (decimal ? "[53], figures before and behind the point" : "[3], figures behind the point"),
                faults::output_form);
}

void BlockLowering::check_names(const Node& naming) {
    for_each_child(naming, [&](const Node& part) {
        if (kind_of(part) == Kind::variable_name && text(part).size() > longest_name)
            refuse_form(span(part), "a name of eight characters or less", faults::long_name);
    });
}

/// `[#NAME]`; names of the control itself begin with `#_`.
void BlockLowering::check_name(const Node& variable) {
    const Node* name = child(variable, Field::name);
    if (name == nullptr) return;
    const std::size_t length = without_blanks(text(*name)).size() - 1;
    if (kind_of(*name) == Kind::user_name && length > longest_name)
        refuse_form(span(variable), "a name of eight characters or less", faults::long_variable_name);
    if (kind_of(*name) == Kind::system_name && length > longest_system_name)
        refuse_form(span(variable), "a name that the control has", faults::long_variable_name);
    const std::string written = without_blanks(text(*name));
    if (std::ranges::find(positions, written) == std::end(positions)) return;
    const Node* axis = child(variable, Field::index);
    const auto number =
        axis == nullptr || kind_of(*axis) != Kind::number ? std::nullopt : read_integer(text(*axis));
    if (axis == nullptr || (number && (*number < 1 || *number > most_axes)))
        refuse_form(span(variable), "the number of an axis in [ ] behind the name", faults::suffix);
}

/// `#1=1234567890`
void BlockLowering::check_digits(const Node& number) {
    constexpr std::ptrdiff_t most = 8;
    const std::string_view written = text(number);
    const std::size_t first = written.find_first_of("123456789");
    if (first == std::string_view::npos) return;
    if (std::ranges::count_if(written.substr(first), is_digit) > most)
        refuse_form(span(number), "a number of eight figures or less", faults::digits);
}

/// `POW[#1]`, `SIN[#1,#2]`: a function with more or fewer arguments than it takes.
void BlockLowering::check_count(const Node& function, Operation operation) {
    if (operation == Operation::unknown) return;
    const bool two = operation == Operation::power || operation == Operation::arc_tangent;
    refuse_form(span(function), two ? "two values, with a comma between them" : "one value in the [ ]",
                two ? faults::argument : faults::expression);
}

/// A form that has no kind of its own; the control's table has the last word.
void BlockLowering::refuse_form(Span span, std::string expected, std::string_view fault) {
    const Reading reading = reading_of(*program_->control, fault);
    if (reading == Reading::takes || reading == Reading::unknown) return;
    report_unreadable(span, std::move(expected), fault);
    if (reading == Reading::doubtful) syntax_errors_.back().answer = Answer::unknown;
}

} // namespace maclint::fanuc
