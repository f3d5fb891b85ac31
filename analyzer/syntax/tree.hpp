//! A parse tree as a flat list of nodes, copied out of tree-sitter so that nothing else has to know it.
#pragma once

#include "analyzer/source/span.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

struct TSLanguage;

namespace maclint::syntax {

/// The function that a generated grammar exports.
using Grammar = const TSLanguage* (*)();

using NodeIndex = std::uint32_t;
constexpr NodeIndex no_node = UINT32_MAX;

/// One node. `symbol` and `field` are the grammar's numbers; 0 is no field.
struct Node {
    std::uint16_t symbol;
    std::uint16_t field;
    bool named;
    bool missing; ///< the parser put it in where the text has nothing
    Span span;    ///< in bytes from the start of the parsed text
    NodeIndex first_child = no_node;
    NodeIndex next_sibling = no_node;
};

/// The symbol of an ERROR node in every grammar.
constexpr std::uint16_t error_symbol = UINT16_MAX;

/// A parsed text. The root is node 0; parents stand before their children.
struct Tree {
    std::vector<Node> nodes;
    bool has_error = false; ///< some node is ERROR or missing
};

/// Says what is called, on any thread, when tree-sitter gets no memory. It must end the process: C cannot be
/// left by an exception. Without it tree-sitter calls exit(1). To be called before the first parse.
void set_out_of_memory(void (*end)() noexcept);

/// Parses `text` into `tree`, whose memory is used again. Every thread has its own parser.
/// The text must be short (a block): nodes of more than 65,000 children crash the runtime 0.20.7.
void parse(Grammar grammar, std::string_view text, Tree& tree);

/// The grammar's name of a symbol: "block", "GOTO".
[[nodiscard]] std::string_view symbol_name(Grammar grammar, std::uint16_t symbol);
[[nodiscard]] std::string_view field_name(Grammar grammar, std::uint16_t field);
/// How many symbols the grammar has, aliases included.
[[nodiscard]] std::uint16_t symbol_count(Grammar grammar);
[[nodiscard]] bool symbol_is_named(Grammar grammar, std::uint16_t symbol);
/// The number of a field, 0 when the grammar has none of that name.
[[nodiscard]] std::uint16_t field_number(Grammar grammar, std::string_view name);

/// The tree as tree-sitter's own tests print it, fields included: `(file (block (word (address) ...)))`.
[[nodiscard]] std::string s_expression(Grammar grammar, const Tree& tree);

} // namespace maclint::syntax
