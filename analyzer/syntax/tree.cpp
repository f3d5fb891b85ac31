//! Runs tree-sitter and copies its trees.
#include "analyzer/syntax/tree.hpp"

#include "analyzer/source/platform/kept_by_thread.hpp"

#include <cassert>
#include <cstdlib>
#include <memory>

#include <tree_sitter/api.h>

namespace maclint::syntax {
namespace {

// ---- memory, as C takes it: NOLINTBEGIN(cppcoreguidelines-no-malloc)

void (*end_without_memory)() noexcept = nullptr;

/// Of no bytes there may be no memory.
void* there(void* memory, std::size_t size) {
    if (memory == nullptr && size > 0) end_without_memory();
    return memory;
}

void* allocate(std::size_t size) { return there(std::malloc(size), size); }
void* allocate_zeros(std::size_t count, std::size_t size) {
    return there(std::calloc(count, size), count * size);
}
void* reallocate(void* memory, std::size_t size) { return there(std::realloc(memory, size), size); }

// NOLINTEND(cppcoreguidelines-no-malloc)

// ---- trees

class Parser {
  public:
    Parser()
        : parser_(ts_parser_new()) {}
    Parser(const Parser&) = delete;
    Parser& operator=(const Parser&) = delete;
    ~Parser() { ts_parser_delete(parser_); }
    [[nodiscard]] TSParser* get() const { return parser_; }

  private:
    TSParser* parser_;
};
struct DeleteTree {
    void operator()(TSTree* tree) const { ts_tree_delete(tree); }
};

/// Walks a tree in document order and gives its memory back.
class Cursor {
  public:
    explicit Cursor(TSNode root)
        : cursor_(ts_tree_cursor_new(root)) {}
    Cursor(const Cursor&) = delete;
    Cursor& operator=(const Cursor&) = delete;
    ~Cursor() { ts_tree_cursor_delete(&cursor_); }

    [[nodiscard]] TSNode node() const { return ts_tree_cursor_current_node(&cursor_); }
    [[nodiscard]] TSFieldId field() const { return ts_tree_cursor_current_field_id(&cursor_); }
    bool to_first_child() { return ts_tree_cursor_goto_first_child(&cursor_); }
    bool to_next_sibling() { return ts_tree_cursor_goto_next_sibling(&cursor_); }
    bool to_parent() { return ts_tree_cursor_goto_parent(&cursor_); }

  private:
    TSTreeCursor cursor_;
};

Node copy(const Cursor& cursor) {
    const TSNode node = cursor.node();
    return {.symbol = ts_node_symbol(node),
            .field = cursor.field(),
            .named = ts_node_is_named(node),
            .missing = ts_node_is_missing(node),
            .span = {ts_node_start_byte(node), ts_node_end_byte(node)}};
}

/// Appends the nodes below `root` in document order and links them.
void copy_nodes(TSNode root, Tree& tree) {
    Cursor cursor(root);
    std::vector<NodeIndex> path;  // ancestors of the current node
    NodeIndex previous = no_node; // its elder sibling
    while (true) {
        const auto here = static_cast<NodeIndex>(tree.nodes.size());
        tree.nodes.push_back(copy(cursor));
        if (previous != no_node)
            tree.nodes[previous].next_sibling = here;
        else if (!path.empty())
            tree.nodes[path.back()].first_child = here;

        if (cursor.to_first_child()) {
            path.push_back(here);
            previous = no_node;
            continue;
        }
        previous = here;
        while (!cursor.to_next_sibling()) {
            if (path.empty()) return;
            cursor.to_parent();
            previous = path.back();
            path.pop_back();
        }
        if (path.empty()) return;
    }
}

void print(Grammar grammar, const Tree& tree, NodeIndex index, std::string& out) {
    const Node& node = tree.nodes[index];
    if (node.missing) {
        out += "(MISSING ";
        out += node.named ? std::string(symbol_name(grammar, node.symbol))
                          : '"' + std::string(symbol_name(grammar, node.symbol)) + '"';
        out += ')';
        return;
    }
    out += '(';
    out += node.symbol == error_symbol ? "ERROR" : symbol_name(grammar, node.symbol);
    for (NodeIndex child = node.first_child; child != no_node; child = tree.nodes[child].next_sibling) {
        const Node& below = tree.nodes[child];
        if (!below.named && !below.missing) continue;
        out += ' ';
        if (below.field != 0) {
            out += field_name(grammar, below.field);
            out += ": ";
        }
        print(grammar, tree, child, out);
    }
    out += ')';
}

} // namespace

void set_out_of_memory(void (*end)() noexcept) {
    end_without_memory = end;
    ts_set_allocator(&allocate, &allocate_zeros, &reallocate, &std::free);
}

void parse(Grammar grammar, std::string_view text, Tree& tree) {
    TSParser* parser = platform::KeptByThread<Parser>::get().get();
    const TSLanguage* language = grammar();
    if (ts_parser_language(parser) != language) {
        [[maybe_unused]] const bool fits = ts_parser_set_language(parser, language);
        assert(fits && "the grammar's ABI is not the runtime's");
    }
    const std::unique_ptr<TSTree, DeleteTree> parsed(
        ts_parser_parse_string(parser, nullptr, text.data(), static_cast<std::uint32_t>(text.size())));
    tree.nodes.clear();
    const TSNode root = ts_tree_root_node(parsed.get());
    tree.has_error = ts_node_has_error(root);
    copy_nodes(root, tree);
}

std::string_view symbol_name(Grammar grammar, std::uint16_t symbol) {
    return ts_language_symbol_name(grammar(), symbol);
}

std::string_view field_name(Grammar grammar, std::uint16_t field) {
    return ts_language_field_name_for_id(grammar(), field);
}

std::uint16_t symbol_count(Grammar grammar) {
    return static_cast<std::uint16_t>(ts_language_symbol_count(grammar()));
}

bool symbol_is_named(Grammar grammar, std::uint16_t symbol) {
    return ts_language_symbol_type(grammar(), symbol) == TSSymbolTypeRegular;
}

std::uint16_t field_number(Grammar grammar, std::string_view name) {
    return ts_language_field_id_for_name(grammar(), name.data(), static_cast<std::uint32_t>(name.size()));
}

std::string s_expression(Grammar grammar, const Tree& tree) {
    std::string out;
    print(grammar, tree, 0, out);
    return out;
}

} // namespace maclint::syntax
