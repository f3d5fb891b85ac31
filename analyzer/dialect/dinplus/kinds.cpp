//! The names of the grammar's nodes and fields.
#include "analyzer/dialect/dinplus/kinds.hpp"

#include "analyzer/dialect/kind_table.hpp"

extern "C" const TSLanguage* tree_sitter_dinplus();

namespace maclint::dinplus {
namespace {

constexpr std::pair<std::string_view, Kind> kinds[] = {
    {"file", Kind::file},
    {"program_name_line", Kind::program_name_line},
    {"header_entry", Kind::header_entry},
    {"section", Kind::section},
    {"section_name", Kind::section_name},
    {"axis", Kind::axis},
    {"block", Kind::block},
    {"comment", Kind::comment},
    {"description_mark", Kind::description_mark},
    {"unclosed_comment", Kind::unclosed_comment},
    {"foreign_comment", Kind::foreign_comment},
    {"slide", Kind::slide},
    {"skip", Kind::skip},
    {"block_number", Kind::block_number},
    {"computed_block_number", Kind::computed_block_number},
    {"literal_word", Kind::literal_word},
    {"word", Kind::word},
    {"extended_word", Kind::extended_word},
    {"empty_word", Kind::empty_word},
    {"malformed_word", Kind::malformed_word},
    {"letter_o_word", Kind::letter_o_word},
    {"lower_case_word", Kind::lower_case_word},
    {"bare_value", Kind::bare_value},
    {"stray_parenthesis", Kind::stray_parenthesis},
    {"stray_bracket", Kind::stray_bracket},
    {"address", Kind::address},
    {"incremental", Kind::incremental},
    {"assignment", Kind::assignment},
    {"equality_sign", Kind::equality_sign},
    {"declaration", Kind::declaration},
    {"call", Kind::call},
    {"if_statement", Kind::if_statement},
    {"then_statement", Kind::then_statement},
    {"else_statement", Kind::else_statement},
    {"endif_statement", Kind::endif_statement},
    {"while_statement", Kind::while_statement},
    {"endwhile_statement", Kind::endwhile_statement},
    {"switch_statement", Kind::switch_statement},
    {"case_statement", Kind::case_statement},
    {"default_statement", Kind::default_statement},
    {"break_statement", Kind::break_statement},
    {"endswitch_statement", Kind::endswitch_statement},
    {"return_statement", Kind::return_statement},
    {"output_statement", Kind::output_statement},
    {"unit_start", Kind::unit_start},
    {"unit_end", Kind::unit_end},
    {"group_start", Kind::group_start},
    {"group_end", Kind::group_end},
    {"unknown_statement", Kind::unknown_statement},
    {"unknown_keyword", Kind::unknown_keyword},
    {"number", Kind::number},
    {"string", Kind::string},
    {"unclosed_string", Kind::unclosed_string},
    {"typographic_string", Kind::typographic_string},
    {"parenthesis", Kind::parenthesis},
    {"function_call", Kind::function_call},
    {"function", Kind::function},
    {"unknown_function", Kind::unknown_function},
    {"argument_list", Kind::argument_list},
    {"vacancy_test", Kind::vacancy_test},
    {"unary", Kind::unary},
    {"binary", Kind::binary},
    {"comparison", Kind::comparison},
    {"logical", Kind::logical},
    {"operator", Kind::operation},
    {"assignment_sign", Kind::assignment_sign},
    {"foreign_operator", Kind::foreign_operator},
    {"unknown_coordinate", Kind::unknown_coordinate},
    {"variable", Kind::variable},
    {"selected_variable", Kind::selected_variable},
    {"indirect_variable", Kind::indirect_variable},
    {"variable_kind", Kind::variable_kind},
    {"selector_list", Kind::selector_list},
    {"selector", Kind::selector},
    {"named_variable", Kind::named_variable},
    {"transfer_variable", Kind::transfer_variable},
    {"constant", Kind::constant},
    {"internal_constant", Kind::internal_constant},
    {"double_sharp", Kind::double_sharp},
    {"foreign_variable", Kind::foreign_variable},
};

constexpr std::pair<std::string_view, Field> fields[] = {
    {"address", Field::address},     {"argument", Field::argument},
    {"arguments", Field::arguments}, {"axis", Field::axis},
    {"check", Field::check},         {"condition", Field::condition},
    {"function", Field::function},   {"incremental", Field::incremental},
    {"keyword", Field::keyword},     {"kind", Field::kind},
    {"left", Field::left},           {"name", Field::name},
    {"number", Field::number},       {"operand", Field::operand},
    {"operator", Field::operation},  {"parameter", Field::parameter},
    {"place", Field::place},         {"right", Field::right},
    {"selectors", Field::selectors}, {"value", Field::value},
    {"variable", Field::variable},   {"version", Field::version},
};

} // namespace

const TSLanguage* grammar() { return tree_sitter_dinplus(); }

bool is_word(Kind kind) {
    switch (kind) {
    case Kind::literal_word:
    case Kind::word:
    case Kind::extended_word:
    case Kind::empty_word:
    case Kind::malformed_word:
    case Kind::letter_o_word:
    case Kind::lower_case_word: return true;
    default: return false;
    }
}

bool is_remark(const syntax::Node& node) {
    const Kind kind = kind_of(node);
    return kind == Kind::comment || kind == Kind::unclosed_comment || kind == Kind::description_mark ||
           kind == Kind::foreign_comment;
}

bool is_head(Kind kind) {
    switch (kind) {
    case Kind::slide:
    case Kind::skip:
    case Kind::block_number:
    case Kind::computed_block_number: return true;
    default: return false;
    }
}

Kind kind_of(const syntax::Node& node) {
    static const std::vector<Kind> table = kinds_by_symbol<Kind>(grammar, kinds, Kind::token);
    if (node.symbol == syntax::error_symbol) return Kind::error;
    return node.symbol < table.size() ? table[node.symbol] : Kind::token;
}

Field field_of(const syntax::Node& node) {
    static const std::array<Field, 256> table = fields_by_number<Field>(grammar, fields);
    return node.field < table.size() ? table[node.field] : Field::none;
}

} // namespace maclint::dinplus
