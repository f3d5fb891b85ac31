//! Blanks say nothing on a Fanuc: `G65P8002X-100` [SEED-001:858], `#112 =-1` [NCT 187].
#include "analyzer/dialect/fanuc/kinds.hpp"
#include "analyzer/dialect/spacing_tables.hpp"

namespace maclint::fanuc {
namespace {

using namespace spacing_words;

// clang-format off
constexpr SpacingRow rows[] = {
    {"block",              row,       apart},
    {"if_statement",       row,       apart},
    {"while_statement",    row,       apart},
    {"literal_word",       kept,      touches},
    {"word",               kept,      apart},
    {"sequence_number",    kept,      touches},
    {"program_number",     kept,      touches},
    {"assignment",         operation, apart},
    {"binary",             operation, apart},
    {"comparison",         operation, apart},
    {"compound_condition", operation, apart},
    {"bracket",            enclosed,  apart},
    {"condition",          enclosed,  apart},
    {"block_condition",    enclosed,  apart},
    {"argument_list",      enclosed,  apart},
    {"unary",              kept,      apart},
    {"call",               kept,      apart},
    {"number",             kept,      apart},
    {"variable",           kept,      apart},
    {"indirect_variable",  kept,      apart},
    {"double_sharp",       kept,      apart},
    {"named_variable",     kept,      apart},
    {"operator",           kept,      apart},
    {"symbolic_operator",  kept,      apart},
    {"goto_statement",     kept,      apart},
    {"do_statement",       kept,      apart},
    {"end_statement",      kept,      apart},
};
// clang-format on

} // namespace

const SpacingTable spacing{grammar, rows, true};

} // namespace maclint::fanuc
