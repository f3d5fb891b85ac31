//! The names of the grammar's nodes and fields.
#include "analyzer/dialect/fanuc/kinds.hpp"

#include "analyzer/dialect/kind_table.hpp"

#include <algorithm>
#include <cassert>
#include <vector>

extern "C" const TSLanguage* tree_sitter_fanuc();

namespace maclint::fanuc {
namespace {

constexpr std::pair<std::string_view, Kind> kinds[] = {
    {"file", Kind::file},
    {"block", Kind::block},
    {"comment", Kind::comment},
    {"tape_mark", Kind::tape_mark},
    {"skip", Kind::skip},
    {"program_number", Kind::program_number},
    {"computed_program_number", Kind::computed_program_number},
    {"named_program", Kind::named_program},
    {"program_name", Kind::program_name},
    {"sequence_number", Kind::sequence_number},
    {"computed_sequence_number", Kind::computed_sequence_number},
    {"literal_word", Kind::literal_word},
    {"word", Kind::word},
    {"comma_word", Kind::comma_word},
    {"empty_word", Kind::empty_word},
    {"bare_value", Kind::bare_value},
    {"malformed_word", Kind::malformed_word},
    {"letter_o_word", Kind::letter_o_word},
    {"stray_parenthesis", Kind::stray_parenthesis},
    {"block_condition", Kind::block_condition},
    {"address", Kind::address},
    {"incremental", Kind::incremental},
    {"assignment", Kind::assignment},
    {"goto_statement", Kind::goto_statement},
    {"label", Kind::label},
    {"if_statement", Kind::if_statement},
    {"while_statement", Kind::while_statement},
    {"do_statement", Kind::do_statement},
    {"end_statement", Kind::end_statement},
    {"output_statement", Kind::output_statement},
    {"output_text", Kind::output_text},
    {"output_variable", Kind::output_variable},
    {"naming_statement", Kind::naming_statement},
    {"variable_name", Kind::variable_name},
    {"foreign_keyword", Kind::foreign_keyword},
    {"condition", Kind::condition},
    {"compound_condition", Kind::compound_condition},
    {"unbracketed_condition", Kind::unbracketed_condition},
    {"variable", Kind::variable},
    {"indirect_variable", Kind::indirect_variable},
    {"double_sharp", Kind::double_sharp},
    {"named_variable", Kind::named_variable},
    {"foreign_variable", Kind::foreign_variable},
    {"system_name", Kind::system_name},
    {"user_name", Kind::user_name},
    {"number", Kind::number},
    {"bracket", Kind::bracket},
    {"call", Kind::call},
    {"argument_list", Kind::argument_list},
    {"function", Kind::function},
    {"unary", Kind::unary},
    {"binary", Kind::binary},
    {"comparison", Kind::comparison},
    {"operator", Kind::operation},
    {"symbolic_operator", Kind::symbolic_operator},
};

constexpr std::pair<std::string_view, Field> fields[] = {
    {"address", Field::address},     {"argument", Field::argument},
    {"condition", Field::condition}, {"consequence", Field::consequence},
    {"divisor", Field::divisor},     {"format", Field::format},
    {"function", Field::function},   {"incremental", Field::incremental},
    {"index", Field::index},         {"left", Field::left},
    {"loop", Field::loop},           {"name", Field::name},
    {"number", Field::number},       {"operand", Field::operand},
    {"operator", Field::operation},  {"right", Field::right},
    {"target", Field::target},       {"then", Field::then},
    {"value", Field::value},         {"variable", Field::variable},
};

} // namespace

const TSLanguage* grammar() { return tree_sitter_fanuc(); }

const GrammarNumbers& grammar_numbers() {
    static const GrammarNumbers numbers = [] {
        GrammarNumbers all{{}, fields_by_number<Field>(grammar, fields)};
        const std::vector<Kind> by_symbol = kinds_by_symbol<Kind>(grammar, kinds, Kind::token);
        assert(by_symbol.size() <= all.kinds.size() && "the grammar has more symbols than the table");
        std::ranges::copy(by_symbol, all.kinds.begin());
        return all;
    }();
    return numbers;
}

bool is_word(Kind kind) {
    switch (kind) {
    case Kind::literal_word:
    case Kind::word:
    case Kind::comma_word:
    case Kind::empty_word:
    case Kind::malformed_word:
    case Kind::letter_o_word:
    case Kind::program_name: return true;
    default: return false;
    }
}

} // namespace maclint::fanuc
