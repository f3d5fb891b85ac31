//! The names of the grammar's nodes and fields.
#include "analyzer/dialect/sinumerik/kinds.hpp"

#include "analyzer/dialect/kind_table.hpp"

extern "C" const TSLanguage* tree_sitter_sinumerik();

namespace maclint::sinumerik {
namespace {

constexpr std::pair<std::string_view, Kind> kinds[] = {
    {"file", Kind::file},
    {"comment", Kind::comment},
    {"program_mark", Kind::program_mark},
    {"block", Kind::block},
    {"skip", Kind::skip},
    {"block_number", Kind::block_number},
    {"main_block_number", Kind::main_block_number},
    {"label", Kind::label},
    {"remark", Kind::remark},
    {"literal_word", Kind::literal_word},
    {"malformed_word", Kind::malformed_word},
    {"malformed_name", Kind::malformed_name},
    {"program_number", Kind::program_number},
    {"assignment", Kind::assignment},
    {"equality_sign", Kind::equality_sign},
    {"value_list", Kind::value_list},
    {"command", Kind::command},
    {"indexed_command", Kind::indexed_command},
    {"call", Kind::call},
    {"unassigned_word", Kind::unassigned_word},
    {"empty_word", Kind::empty_word},
    {"address", Kind::address},
    {"numbered_address", Kind::numbered_address},
    {"foreign_comment", Kind::foreign_comment},
    {"definition", Kind::definition},
    {"type", Kind::type},
    {"modifier", Kind::modifier},
    {"declarator", Kind::declarator},
    {"redefinition", Kind::redefinition},
    {"macro_definition", Kind::macro_definition},
    {"macro_body", Kind::macro_body},
    {"program_definition", Kind::program_definition},
    {"parameter_list", Kind::parameter_list},
    {"parameter", Kind::parameter},
    {"attribute", Kind::attribute},
    {"external_declaration", Kind::external_declaration},
    {"if_statement", Kind::if_statement},
    {"else_statement", Kind::else_statement},
    {"endif_statement", Kind::endif_statement},
    {"while_statement", Kind::while_statement},
    {"endwhile_statement", Kind::endwhile_statement},
    {"for_statement", Kind::for_statement},
    {"endfor_statement", Kind::endfor_statement},
    {"loop_statement", Kind::loop_statement},
    {"endloop_statement", Kind::endloop_statement},
    {"repeat_statement", Kind::repeat_statement},
    {"until_statement", Kind::until_statement},
    {"then_statement", Kind::then_statement},
    {"elseif_statement", Kind::elseif_statement},
    {"foreign_keyword", Kind::foreign_keyword},
    {"repetition", Kind::repetition},
    {"case_statement", Kind::case_statement},
    {"case_arm", Kind::case_arm},
    {"default_arm", Kind::default_arm},
    {"goto_statement", Kind::goto_statement},
    {"direction", Kind::direction},
    {"restart_statement", Kind::restart_statement},
    {"synchronised_action", Kind::synchronised_action},
    {"frequency", Kind::frequency},
    {"modal_call", Kind::modal_call},
    {"indirect_call", Kind::indirect_call},
    {"path_call", Kind::path_call},
    {"path", Kind::path},
    {"iso_call", Kind::iso_call},
    {"number", Kind::number},
    {"based_number", Kind::based_number},
    {"string", Kind::string},
    {"unclosed_string", Kind::unclosed_string},
    {"typographic_string", Kind::typographic_string},
    {"parenthesis", Kind::parenthesis},
    {"macro_operand", Kind::macro_operand},
    {"square_parenthesis", Kind::square_parenthesis},
    {"function_call", Kind::function_call},
    {"function", Kind::function},
    {"argument_list", Kind::argument_list},
    {"unary", Kind::unary},
    {"binary", Kind::binary},
    {"logical", Kind::logical},
    {"comparison", Kind::comparison},
    {"assignment_sign", Kind::assignment_sign},
    {"foreign_operator", Kind::foreign_operator},
    {"concatenation", Kind::concatenation},
    {"frame_chain", Kind::frame_chain},
    {"indexed_name", Kind::indexed_name},
    {"indexed_address", Kind::indexed_address},
    {"system_variable", Kind::system_variable},
    {"system_name", Kind::system_name},
    {"index_list", Kind::index_list},
    {"r_parameter", Kind::r_parameter},
    {"foreign_variable", Kind::foreign_variable},
    {"name", Kind::name},
    {"axis_name", Kind::axis_name},
    {"operator", Kind::operation},
};

constexpr std::pair<std::string_view, Field> fields[] = {
    {"action", Field::action},
    {"address", Field::address},
    {"alternative", Field::alternative},
    {"arguments", Field::arguments},
    {"attribute", Field::attribute},
    {"body", Field::body},
    {"condition", Field::condition},
    {"counter", Field::counter},
    {"direction", Field::direction},
    {"first", Field::first},
    {"frequency", Field::frequency},
    {"function", Field::function},
    {"index", Field::index},
    {"jump", Field::jump},
    {"keyword", Field::keyword},
    {"last", Field::last},
    {"left", Field::left},
    {"length", Field::length},
    {"macro", Field::macro},
    {"name", Field::name},
    {"operand", Field::operand},
    {"operator", Field::operation},
    {"parameters", Field::parameters},
    {"program", Field::program},
    {"reference", Field::reference},
    {"right", Field::right},
    {"size", Field::size},
    {"target", Field::target},
    {"type", Field::type},
    {"units", Field::units},
    {"value", Field::value},
    {"again", Field::again},
};

} // namespace

const TSLanguage* grammar() { return tree_sitter_sinumerik(); }

bool is_remark(const syntax::Node& node) { return kind_of(node) == Kind::comment; }

bool is_head(Kind kind) {
    switch (kind) {
    case Kind::skip:
    case Kind::block_number:
    case Kind::main_block_number:
    case Kind::label: return true;
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

} // namespace maclint::sinumerik
