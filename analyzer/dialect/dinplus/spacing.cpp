//! Words may touch; names and keywords stand apart from each other, and a word's value stays as it is
//! written.
#include "analyzer/dialect/dinplus/kinds.hpp"
#include "analyzer/dialect/spacing_tables.hpp"

namespace maclint::dinplus {
namespace {

using namespace spacing_words;

// clang-format off
constexpr SpacingRow rows[] = {
    {"block",               row,       apart},
    {"if_statement",        row,       apart},
    {"while_statement",     row,       apart},
    {"then_statement",      kept,      apart},
    {"literal_word",        kept,      touches},
    {"word",                tight,     apart},
    {"extended_word",       tight,     apart},
    {"block_number",        kept,      touches},
    {"call",                kept,      apart},
    {"assignment",          operation, apart},
    {"binary",              operation, apart},
    {"comparison",          operation, apart},
    {"logical",             operation, apart},
    {"parenthesis",         enclosed,  apart},
    {"argument_list",       enclosed,  apart},
    {"selector_list",       enclosed,  apart},
    {"unary",               kept,      apart},
    {"function_call",       kept,      apart},
    {"number",              kept,      apart},
    {"variable",            kept,      apart},
    {"selected_variable",   kept,      apart},
    {"indirect_variable",   kept,      apart},
    {"named_variable",      kept,      apart},
    {"transfer_variable",   kept,      apart},
    {"constant",            kept,      apart},
    {"internal_constant",   kept,      apart},
    {"string",              kept,      apart},
    {"selector",            kept,      apart},
    {"operator",            kept,      apart},
};
// clang-format on

} // namespace

const SpacingTable spacing{grammar, rows, false};

} // namespace maclint::dinplus
