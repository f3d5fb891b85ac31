//! Words such as "M50-M59" and parameters that make codes call programs.
#include "cli/config/machine_facts.hpp"

#include "analyzer/dialect/characters.hpp"
#include "analyzer/program/own_codes.hpp"
#include "cli/text/guess.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace maclint::cli {
namespace {

constexpr double highest_number = 99'999'999; ///< of a program; an M code, too, has eight digits at most

/// Parameters that make a code call a program: the first of them the first program [T].
struct CallParameters {
    int first, last;
    char letter;
    std::int64_t program;
};
constexpr std::array<CallParameters, 3> call_parameters{
    {{6050, 6059, 'G', 9010}, {6071, 6079, 'M', 9001}, {6080, 6089, 'M', 9020}}};
constexpr std::string_view parameters_known = "Known are 6050 to 6059, 6071 to 6079, 6080 to 6089 and 6001#5";
/// The bit of parameter 6001 (TCS) by which a T word calls O9000 [T; B-62093E, 3.1.1 on the program].
constexpr std::string_view tool_parameter = "6001#5";
constexpr OwnCode tool_call{tool_letter, 0, 9000};

std::optional<double> number_in(std::string_view digits) {
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool is_number = error == std::errc() && end == digits.data() + digits.size() && !digits.empty();
    return is_number && value >= 0 && value <= highest_number ? std::optional(value) : std::nullopt;
}

/// "G54.1"; a G code has one digit behind its point, an M code none.
std::optional<OwnCode> code_in(std::string_view word) {
    if (word.size() < 2) return std::nullopt;
    const char letter = to_capital(word.front());
    const auto number = number_in(word.substr(1));
    if ((letter != 'G' && letter != 'M') || !number) return std::nullopt;
    const double scaled = letter == 'G' ? *number * 10 : *number;
    if (std::abs(scaled - std::round(scaled)) > 1e-6) return std::nullopt;
    return OwnCode{letter, *number};
}

/// Of "M50-M59" all; nothing where the word is none.
std::vector<OwnCode> codes_in(std::string_view word) {
    constexpr double most = 10'000;
    const auto hyphen = word.find('-');
    const auto first = code_in(word.substr(0, hyphen));
    if (!first || hyphen == std::string_view::npos)
        return first ? std::vector{*first} : std::vector<OwnCode>();
    const auto last = code_in(word.substr(hyphen + 1));
    if (!last || last->letter != first->letter || last->number < first->number ||
        last->number - first->number > most || first->number != std::floor(first->number))
        return {};
    std::vector<OwnCode> codes;
    for (double number = first->number; number <= last->number; ++number)
        codes.push_back({first->letter, number});
    return codes;
}

WrongWord no_code(std::string_view word) {
    return {"'" + std::string(word) +
            "' is no G or M code. Write it as \"G310\", several in a row as \"M50-M59\""};
}

} // namespace

void MachineFacts::add(OwnCode code) {
    const auto at = std::ranges::lower_bound(codes_, code, in_order_of_codes);
    if (at == codes_.end() || in_order_of_codes(code, *at))
        codes_.insert(at, code);
    else if (code.program != 0)
        *at = code; // what it does says more than that it is there
}

std::optional<WrongWord> MachineFacts::add_codes(std::string_view word) {
    const auto codes = codes_in(word);
    if (codes.empty()) return no_code(word);
    for (const OwnCode& code : codes) add(code);
    if (const char letter = codes.front().letter; letters_.find(letter) == std::string::npos)
        letters_.push_back(letter);
    return std::nullopt;
}

std::optional<WrongWord> MachineFacts::add_missing(std::string_view word) {
    const auto codes = codes_in(word);
    if (codes.empty()) return no_code(word);
    for (const OwnCode& code : codes) add({code.letter, code.number, not_fitted});
    return std::nullopt;
}

std::optional<WrongWord> MachineFacts::add_option(std::string_view word, const ControlModel& control) {
    std::vector<std::string> known;
    for (const ControlOption& option : control.options) known.emplace_back(option.name);
    if (std::ranges::find(known, word) == known.end())
        return WrongWord{
            "'" + std::string(word) + "' is no option of " + std::string(control.model) + "." +
            did_you_mean(std::string(word), known, "'maclint controls " + control.name + "' lists them")};
    list_options();
    options_->emplace_back(word);
    return std::nullopt;
}

void MachineFacts::list_options() {
    if (!options_) options_.emplace();
}

std::optional<WrongWord> MachineFacts::set_axes(std::string_view letters) {
    constexpr std::string_view known = "XYZUVWABC";
    std::string axes;
    for (const char letter : letters) {
        const char capital = to_capital(letter);
        if (known.find(capital) == std::string_view::npos || axes.find(capital) != std::string::npos)
            return WrongWord{"'" + std::string(letters) +
                             "' does not name axes. Write the letter of each once, as \"XYZA\""};
        axes.push_back(capital);
    }
    if (axes.empty()) return WrongWord{"a machine has axes. Write the letter of each once, as \"XYZA\""};
    axes_ = std::move(axes);
    return std::nullopt;
}

std::optional<WrongWord> MachineFacts::add_call(std::string_view code, std::string_view program) {
    const bool tool = code == "T" || code == "t";
    const auto called = tool ? std::optional(tool_call) : code_in(code);
    if (!called) return no_code(code);
    const bool has_letter = !program.empty() && to_capital(program.front()) == 'O';
    const auto number = number_in(program.substr(has_letter ? 1 : 0));
    if (!number || *number < 1 || *number != std::floor(*number))
        return WrongWord{"'" + std::string(program) + "' is no program. Write its number as \"O9010\""};
    add({called->letter, called->number, static_cast<std::int64_t>(*number)});
    return std::nullopt;
}

std::optional<WrongWord> MachineFacts::add_parameter(std::string_view number, double value) {
    if (number == tool_parameter) {
        if (value != 0 && value != 1) return WrongWord{"a bit of a parameter is 0 or 1. Correct 6001#5"};
        if (value == 1) add(tool_call);
        return std::nullopt;
    }
    const auto parameter = number_in(number);
    const auto* const row = std::ranges::find_if(call_parameters, [&](const CallParameters& parameters) {
        return parameter && parameters.first <= *parameter && *parameter <= parameters.last;
    });
    if (row == call_parameters.end() || *parameter != std::floor(*parameter))
        return WrongWord{"'" + std::string(number) + "' is no parameter by which a code calls a program. " +
                         std::string(parameters_known)};
    const double code = row->letter == 'G' ? std::abs(value) : value;
    if (code < 0 || code > highest_number || code != std::floor(code))
        return WrongWord{"parameter " + std::string(number) + " is the number of a " + row->letter +
                         " code. Write a whole number"};
    if (code == 0) return std::nullopt;
    // A negative one calls after each move, as G66 does: that is not followed [T].
    const bool is_followed = value > 0;
    add({row->letter, code,
         is_followed ? row->program + static_cast<std::int64_t>(*parameter) - row->first : 0});
    return std::nullopt;
}

std::optional<WrongWord> MachineFacts::add_assignment(std::string_view word) {
    const auto sign = word.find('=');
    if (sign == std::string_view::npos)
        return WrongWord{"'" + std::string(word) + "' has no '='. Write it as \"G81=O9010\" or \"6050=81\""};
    const std::string_view left = word.substr(0, sign), right = word.substr(sign + 1);
    if (!number_in(left) && left != tool_parameter) return add_call(left, right);
    const bool is_negative = right.starts_with('-');
    const auto value = number_in(right.substr(is_negative ? 1 : 0));
    if (!value)
        return WrongWord{"'" + std::string(right) +
                         "' is no number. Write the code that the parameter holds"};
    return add_parameter(left, is_negative ? -*value : *value);
}

/// Of those that are not named. What is told of a code itself says more.
void MachineFacts::add_missing_options(const ControlModel& control) {
    const auto is_named = [&](const ControlOption& option) {
        return std::ranges::find(*options_, option.name) != options_->end();
    };
    const auto codes = [&](bool named) {
        std::vector<OwnCode> found;
        for (const ControlOption& option : control.options)
            if (option.is_for(control.machine) && is_named(option) == named)
                for (std::string_view rest = option.codes; !rest.empty();) {
                    const std::string_view word = rest.substr(0, rest.find(' '));
                    rest.remove_prefix(std::min(rest.size(), word.size() + 1));
                    found.push_back(*code_in(word));
                }
        return found;
    };
    const std::vector<OwnCode> fitted = codes(true);
    for (const OwnCode& code : codes(false)) {
        const auto same = [&](const OwnCode& other) {
            return other.letter == code.letter && other.number == code.number;
        };
        if (std::ranges::none_of(fitted, same) && std::ranges::none_of(codes_, same))
            add({code.letter, code.number, not_fitted});
    }
}

void MachineFacts::apply_to(ControlModel& control) const {
    MachineFacts all;
    for (const OwnCode& code : control.own_codes) all.add(code);
    for (const OwnCode& code : codes_) all.add(code);
    all.options_ = options_;
    if (options_) all.add_missing_options(control);
    if (!axes_.empty()) control.axes = axes_;
    if (calculator_input_) control.calculator_input = *calculator_input_;
    if (demands_ != nullptr) control.demands = demands_;
    control.own_codes = std::move(all.codes_);
    for (const char letter : letters_)
        if (!are_listed(control, letter)) control.letters_listed.push_back(letter);
}

} // namespace maclint::cli
