//! The same words for all languages.
#include "analyzer/program/language_words.hpp"

namespace maclint {

std::string_view name_of(WordUse use) {
    switch (use) {
    case WordUse::keyword: return "keyword";
    case WordUse::function: return "function";
    case WordUse::comparison: return "comparison or logic";
    case WordUse::statement: return "statement";
    case WordUse::cycle: return "cycle";
    case WordUse::address: return "address";
    case WordUse::attribute: return "attribute of a program";
    case WordUse::constant: return "constant";
    case WordUse::part: return "part of a value";
    }
    return {};
}

std::string_view what_it_computes(Operation operation) {
    switch (operation) {
    case Operation::modulo: return "rest of a division";
    case Operation::power: return "power";
    case Operation::bit_and: return "AND, bit by bit";
    case Operation::bit_or: return "OR, bit by bit";
    case Operation::bit_xor: return "exclusive OR, bit by bit";
    case Operation::sine: return "sine";
    case Operation::cosine: return "cosine";
    case Operation::tangent: return "tangent";
    case Operation::arc_sine: return "angle of a sine";
    case Operation::arc_cosine: return "angle of a cosine";
    case Operation::arc_tangent: return "angle of a tangent";
    case Operation::arc_tangent_of_two: return "angle of two sides";
    case Operation::square_root: return "square root";
    case Operation::absolute: return "number without its sign";
    case Operation::round: return "nearest whole number";
    case Operation::truncate: return "whole number without what stands behind the point";
    case Operation::round_up: return "next whole number away from 0";
    case Operation::logarithm: return "natural logarithm";
    case Operation::exponential: return "power of e";
    case Operation::to_binary: return "number of a decimal code (BCD)";
    case Operation::to_decimal_code: return "decimal code (BCD) of a number";
    case Operation::add_point: return "number that was passed without a point, with one";
    default: return {};
    }
}

} // namespace maclint
