//! Two neighbours in the tree have one place between them: below the node that both are parts of.
#include "analyzer/dialect/spacing.hpp"

#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/spacing_tables.hpp"

#include <algorithm>
#include <utility>

namespace maclint {
namespace {

using Parts = SpacingRow::Parts;
using Beside = SpacingRow::Beside;
using syntax::Node;
using syntax::NodeIndex;

constexpr int deepest = 200; ///< below it nothing is changed

constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }
constexpr bool is_of_operator(char c) {
    return std::string_view("+-*/<>=!:").find(c) != std::string_view::npos;
}

class GapFinder {
  public:
    /// `block` begins at `begin` in its file and has the tree.
    GapFinder(std::span<const SpacingRow* const> rows, bool blanks_say_nothing, const syntax::Tree& tree,
              std::string_view block, Offset begin)
        : rows_(rows)
        , blanks_say_nothing_(blanks_say_nothing)
        , tree_(tree)
        , block_(block)
        , begin_(begin) {}

    [[nodiscard]] std::vector<Gap> run() {
        if (!tree_.has_error && !tree_.nodes.empty()) look_below(tree_.nodes.front(), false, 0);
        std::ranges::sort(gaps_, {}, [](const Gap& gap) { return gap.span.begin; });
        return std::move(gaps_);
    }

  private:
    [[nodiscard]] const SpacingRow* row_of(const Node& node) const {
        return node.named && node.symbol < rows_.size() ? rows_[node.symbol] : nullptr;
    }
    [[nodiscard]] Parts parts_of(const Node& node) const {
        const SpacingRow* row = row_of(node);
        return row == nullptr ? Parts::kept : row->parts;
    }
    /// Keywords, signs and brackets have no row.
    [[nodiscard]] Beside beside(const Node& node) const {
        if (!node.named) return Beside::apart;
        const SpacingRow* row = row_of(node);
        return row == nullptr ? Beside::kept : row->beside;
    }
    [[nodiscard]] std::string_view text(const Node& node) const {
        return block_.substr(node.span.begin, node.span.length());
    }

    void look_below(const Node& node, bool tight, int depth) {
        if (depth > deepest) return;
        const Parts parts = parts_of(node);
        tight = parts == Parts::tight || (tight && parts != Parts::enclosed);
        const Node* before = nullptr;
        for (NodeIndex i = node.first_child; i != syntax::no_node; i = tree_.nodes[i].next_sibling) {
            const Node& child = tree_.nodes[i];
            if (child.span.empty()) continue;
            if (before != nullptr && !tight) look_between(parts, *before, child);
            look_below(child, tight, depth + 1);
            before = &child;
        }
    }

    void look_between(Parts parts, const Node& left, const Node& right) {
        const std::string_view between = block_.substr(left.span.end, right.span.begin - left.span.end);
        if (!std::ranges::all_of(between, is_blank) || is_blank(text(left).back())) return;
        if (beside(left) == Beside::kept || beside(right) == Beside::kept) return;
        const char last = text(left).back(), first = text(right).front();
        const Span span{begin_ + left.span.end, begin_ + right.span.begin};
        if (parts == Parts::row)
            gaps_.push_back({GapKind::words, span, may_touch(left, right)});
        else if (parts == Parts::operation)
            gaps_.push_back({GapKind::operators, span, may_be_operand(last, first)});
        else if (parts == Parts::enclosed && (is_alone(left, "[(") || is_alone(right, "])")))
            gaps_.push_back({GapKind::brackets, span, true});
    }

    [[nodiscard]] bool may_touch(const Node& left, const Node& right) const {
        return blanks_say_nothing_ || (beside(left) == Beside::touches && beside(right) == Beside::touches);
    }
    /// `1- -#1` is another thing than `1--#1`, and `R1 DIV R2` no longer one.
    [[nodiscard]] bool may_be_operand(char last, char first) const {
        if (is_of_operator(last) || is_of_operator(first))
            return is_of_operator(last) != is_of_operator(first);
        return blanks_say_nothing_;
    }
    [[nodiscard]] bool is_alone(const Node& node, std::string_view brackets) const {
        return !node.named && text(node).size() == 1 &&
               brackets.find(text(node).front()) != std::string_view::npos;
    }

    std::span<const SpacingRow* const> rows_;
    bool blanks_say_nothing_;
    const syntax::Tree& tree_;
    std::string_view block_;
    Offset begin_;
    std::vector<Gap> gaps_;
};

bool are_the_same(const Node& one, const Node& other) {
    return one.symbol == other.symbol && one.field == other.field && one.missing == other.missing &&
           one.first_child == other.first_child && one.next_sibling == other.next_sibling;
}

} // namespace

const SpacingTable& spacing_of(const Dialect& dialect) {
    if (dialect.name == "dinplus") return dinplus::spacing;
    if (dialect.name == "sinumerik") return sinumerik::spacing;
    return fanuc::spacing;
}

SpacingReader::SpacingReader(const SpacingTable& table)
    : table_(table)
    , rows_(syntax::symbol_count(table.grammar), nullptr) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const auto symbol = static_cast<std::uint16_t>(i);
        if (!syntax::symbol_is_named(table.grammar, symbol)) continue;
        const auto found =
            std::ranges::find(table.rows, syntax::symbol_name(table.grammar, symbol), &SpacingRow::node);
        if (found != table.rows.end()) rows_[i] = &*found;
    }
}

std::vector<Gap> SpacingReader::gaps_in(std::string_view text, Span block) {
    const std::string_view bytes = text.substr(block.begin, block.length());
    syntax::parse(table_.grammar, bytes, tree_);
    return GapFinder(rows_, table_.blanks_say_nothing, tree_, bytes, block.begin).run();
}

bool SpacingReader::read_the_same(std::string_view one, std::string_view other) {
    syntax::parse(table_.grammar, one, tree_);
    syntax::parse(table_.grammar, other, other_);
    if (tree_.has_error || other_.has_error || tree_.nodes.size() != other_.nodes.size()) return false;
    for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
        const Node &a = tree_.nodes[i], &b = other_.nodes[i];
        if (!are_the_same(a, b)) return false;
        if (a.first_child == syntax::no_node &&
            one.substr(a.span.begin, a.span.length()) != other.substr(b.span.begin, b.span.length()))
            return false;
    }
    return true;
}

} // namespace maclint
