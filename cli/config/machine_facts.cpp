//! Words such as "M50-M59" and parameters that make codes call programs.
#include "cli/config/machine_facts.hpp"

#include "analyzer/dialect/characters.hpp"
#include "analyzer/program/own_codes.hpp"

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
constexpr std::string_view parameters_known = "Known are 6050 to 6059, 6071 to 6079 and 6080 to 6089";

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

std::optional<WrongWord> MachineFacts::add_call(std::string_view code, std::string_view program) {
    const auto called = code_in(code);
    if (!called) return no_code(code);
    const bool has_letter = !program.empty() && to_capital(program.front()) == 'O';
    const auto number = number_in(program.substr(has_letter ? 1 : 0));
    if (!number || *number < 1 || *number != std::floor(*number))
        return WrongWord{"'" + std::string(program) + "' is no program. Write its number as \"O9010\""};
    add({called->letter, called->number, static_cast<std::int64_t>(*number)});
    return std::nullopt;
}

std::optional<WrongWord> MachineFacts::add_parameter(std::string_view number, double value) {
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
    if (!number_in(left)) return add_call(left, right);
    const bool is_negative = right.starts_with('-');
    const auto value = number_in(right.substr(is_negative ? 1 : 0));
    if (!value)
        return WrongWord{"'" + std::string(right) +
                         "' is no number. Write the code that the parameter holds"};
    return add_parameter(left, is_negative ? -*value : *value);
}

void MachineFacts::apply_to(ControlModel& control) const {
    MachineFacts all;
    for (const OwnCode& code : control.own_codes) all.add(code);
    for (const OwnCode& code : codes_) all.add(code);
    control.own_codes = std::move(all.codes_);
    for (const char letter : letters_)
        if (!are_listed(control, letter)) control.letters_listed.push_back(letter);
}

} // namespace maclint::cli
