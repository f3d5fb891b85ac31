//! Words of a letter and a number may touch; names, and what `=` stands in, stand apart [NCP19 p.52]. The `=`
//! of a word (`X=R1`) and that of a variable look alike, so that it stays as it is written.
#include "analyzer/dialect/sinumerik/kinds.hpp"
#include "analyzer/dialect/spacing_tables.hpp"

namespace maclint::sinumerik {
namespace {

using namespace spacing_words;

// clang-format off
constexpr SpacingRow rows[] = {
    {"block",              row,       apart},
    {"if_statement",       row,       apart},
    {"while_statement",    row,       apart},
    {"literal_word",       kept,      touches},
    {"block_number",       kept,      touches},
    {"assignment",         kept,      apart},
    {"command",            kept,      apart},
    {"indexed_command",    kept,      apart},
    {"program_number",     kept,      apart},
    {"call",               kept,      apart},
    {"goto_statement",     kept,      apart},
    {"binary",             operation, apart},
    {"comparison",         operation, apart},
    {"logical",            operation, apart},
    {"concatenation",      operation, apart},
    {"parenthesis",        enclosed,  apart},
    {"argument_list",      enclosed,  apart},
    {"index_list",         enclosed,  apart},
    {"unary",              kept,      apart},
    {"function_call",      kept,      apart},
    {"number",             kept,      apart},
    {"based_number",       kept,      apart},
    {"string",             kept,      apart},
    {"name",               kept,      apart},
    {"r_parameter",        kept,      apart},
    {"axis_name",          kept,      apart},
    {"indexed_name",       kept,      apart},
    {"indexed_address",    kept,      apart},
    {"system_variable",    kept,      apart},
    {"operator",           kept,      apart},
};
// clang-format on

} // namespace

const SpacingTable spacing{grammar, rows, false};

} // namespace maclint::sinumerik
