//! Persistent maps from 64-bit keys to ids: copies share what they have in common, so a state costs what
//! changed. Big-endian Patricia trees after Okasaki and Gill, "Fast Mergeable Integer Maps" (1998), with
//! neighbouring keys side by side in one leaf: variables and modal groups are numbered in rows.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace maclint::dataflow {

using Key = std::uint64_t;
using Root = std::uint32_t; ///< 0: the empty map

class PersistentMap {
  public:
    /// In a list of values: none. No value of a map.
    static constexpr std::uint32_t absent = std::numeric_limits<std::uint32_t>::max();

    PersistentMap()
        : nodes_(1) {}

    [[nodiscard]] std::optional<std::uint32_t> find(Root root, Key key) const {
        if (root == 0) return std::nullopt;
        const Key place = key / row;
        const Node* node = &nodes_[root];
        // Where the branches have other places the leaf has another, too.
        while (node->bit != 0) node = &nodes_[(place & node->bit) == 0 ? node->left : node->right];
        if (node->place != place) return std::nullopt;
        const std::uint32_t value = rows_[node->left][key % row];
        return value == absent ? std::nullopt : std::optional(value);
    }

    [[nodiscard]] Root set(Root root, Key key, std::uint32_t value) {
        return change_row(root, key / row, [&](Row& values) { values[key % row] = value; });
    }

    /// With values[i] under the key `first` + i wherever that is not absent.
    [[nodiscard]] Root set_all(Root root, Key first, std::span<const std::uint32_t> values) {
        for (std::size_t done = 0; done < values.size();) {
            const Key key = first + done;
            const std::size_t count = std::min<std::size_t>(row - key % row, values.size() - done);
            const auto some = values.subspan(done, count);
            done += count;
            if (std::ranges::count(some, absent) == std::ssize(some)) continue;
            root = change_row(root, key / row, [&](Row& all) {
                for (std::size_t i = 0; i < count; ++i)
                    if (some[i] != absent) all[key % row + i] = some[i];
            });
        }
        return root;
    }

    /// Without the keys from `first` to `last`.
    [[nodiscard]] Root without(Root root, Key first, Key last) {
        if (root == 0) return 0;
        const Node node = nodes_[root];
        const Key low = node.place * row;
        const Key high = (node.place | span_of(node.bit)) * row + (row - 1);
        if (low > last || high < first) return root;
        if (low >= first && high <= last) return 0;
        if (node.bit != 0)
            return branch(root, without(node.left, first, last), without(node.right, first, last));
        Row left = rows_[node.left];
        for (Key i = 0; i < row; ++i)
            if (low + i >= first && low + i <= last) left[i] = absent;
        return std::ranges::count(left, absent) == row ? 0 : leaf_like(root, left);
    }

    /// Whether the maps hold the same; what they share is not looked at.
    [[nodiscard]] bool equal(Root a, Root b) const {
        if (a == b) return true;
        const Node& s = nodes_[a];
        const Node& t = nodes_[b];
        if (a == 0 || b == 0 || s.place != t.place || s.bit != t.bit) return false;
        return s.bit == 0 ? rows_[s.left] == rows_[t.left] : equal(s.left, t.left) && equal(s.right, t.right);
    }

    /// Forgets every map but those that `roots` name; they stand elsewhere afterwards.
    void keep_only(std::span<Root* const> roots) {
        const std::vector<Node> all = std::exchange(nodes_, std::vector<Node>(1));
        const std::vector<Row> all_rows = std::exchange(rows_, {});
        std::vector<Root> moved(roots.empty() ? 0 : all.size(), 0);
        for (Root* root : roots) *root = keep(*root, all, all_rows, moved);
        nodes_.shrink_to_fit();
        rows_.shrink_to_fit();
    }

    template<class Visit>
    void for_each(Root root, const Visit& visit) const {
        if (root == 0) return;
        const Node& node = nodes_[root];
        if (node.bit != 0) {
            for_each(node.left, visit);
            for_each(node.right, visit);
            return;
        }
        const Row& values = rows_[node.left];
        for (Key i = 0; i < row; ++i)
            if (values[i] != absent) visit(node.place * row + i, values[i]);
    }

    /// Every key of both: `both(key, a, b)` where the values differ, `only_a(key, a)`, `only_b(key, b)` where
    /// one lacks the key.
    template<class Both, class OnlyA, class OnlyB>
    [[nodiscard]] Root merge(Root a, Root b, const Both& both, const OnlyA& only_a, const OnlyB& only_b) {
        if (a == b) return a;
        if (a == 0) return map(b, only_b);
        if (b == 0) return map(a, only_a);
        const Node s = nodes_[a];
        const Node t = nodes_[b];
        if (s.bit == 0 && t.bit == 0 && s.place == t.place) {
            Row values = rows_[s.left];
            const Row others = rows_[t.left];
            for (Key i = 0; i < row; ++i) {
                const Key key = s.place * row + i;
                if (values[i] == others[i]) continue;
                if (values[i] == absent)
                    values[i] = only_b(key, others[i]);
                else
                    values[i] =
                        others[i] == absent ? only_a(key, values[i]) : both(key, values[i], others[i]);
            }
            return values == others ? b : leaf_like(a, values);
        }
        if (s.bit != 0 && s.bit == t.bit && s.place == t.place) {
            const Root left = merge(s.left, t.left, both, only_a, only_b);
            const Root right = merge(s.right, t.right, both, only_a, only_b);
            return left == t.left && right == t.right ? b : branch(a, left, right);
        }
        if (s.bit > t.bit && matches(t.place, s)) {
            if ((t.place & s.bit) == 0) {
                const Root left = merge(s.left, b, both, only_a, only_b);
                return branch(a, left, map(s.right, only_a));
            }
            const Root left = map(s.left, only_a);
            return branch(a, left, merge(s.right, b, both, only_a, only_b));
        }
        if (t.bit > s.bit && matches(s.place, t)) {
            if ((s.place & t.bit) == 0) {
                const Root left = merge(a, t.left, both, only_a, only_b);
                return branch(b, left, map(t.right, only_b));
            }
            const Root left = map(t.left, only_b);
            return branch(b, left, merge(a, t.right, both, only_a, only_b));
        }
        const Root left = map(a, only_a);
        return link(s.place, left, t.place, map(b, only_b));
    }

    /// The keys of both, with the value of `a` where it has the key. What they share is not looked at.
    [[nodiscard]] Root united(Root a, Root b) {
        if (a == b || b == 0) return a;
        if (a == 0) return b;
        const Node s = nodes_[a];
        const Node t = nodes_[b];
        if (s.bit == 0) {
            const Row values = rows_[s.left];
            const Root all = change_row(b, s.place, [&](Row& to) { fill(to, values, to); });
            return equal(all, a) ? a : all;
        }
        if (t.bit == 0) {
            const Row values = rows_[t.left];
            return change_row(a, t.place, [&](Row& to) { fill(to, to, values); });
        }
        if (s.bit == t.bit && s.place == t.place) {
            const Root left = united(s.left, t.left);
            const Root right = united(s.right, t.right);
            return left == t.left && right == t.right ? b : branch(a, left, right);
        }
        const bool a_above = s.bit > t.bit;
        const Node& upper = a_above ? s : t;
        const Key below = a_above ? t.place : s.place;
        if (s.bit == t.bit || !matches(below, upper)) return link(s.place, a, t.place, b);
        const bool to_left = (below & upper.bit) == 0;
        const Root inner = to_left ? upper.left : upper.right;
        const Root joined = a_above ? united(inner, b) : united(a, inner);
        return branch(a_above ? a : b, to_left ? joined : upper.left, to_left ? upper.right : joined);
    }

  private:
    static constexpr Key row = 8;
    using Row = std::array<std::uint32_t, row>; ///< values of neighbouring keys, at least one of them present

    struct Node {
        Key place = 0;          ///< leaf: its first key / row; branch: the bits above `bit`
        Key bit = 0;            ///< 0: leaf
        std::uint32_t left = 0; ///< leaf: the row
        std::uint32_t right = 0;
    };

    /// The bit and all below it; none for a leaf.
    static Key span_of(Key bit) { return bit == 0 ? 0 : bit | (bit - 1); }
    static Key prefix(Key place, Key bit) { return place & ~(bit | (bit - 1)); }
    static bool matches(Key place, const Node& branch) { return prefix(place, branch.bit) == branch.place; }

    /// The values of `first`, and those of `second` where it has none.
    static void fill(Row& to, const Row& first, const Row& second) {
        for (std::size_t i = 0; i < row; ++i) to[i] = first[i] == absent ? second[i] : first[i];
    }

    Root keep(Root root, const std::vector<Node>& all, const std::vector<Row>& all_rows,
              std::vector<Root>& moved) {
        if (root == 0 || moved[root] != 0) return root == 0 ? 0 : moved[root];
        Node node = all[root];
        if (node.bit == 0) return moved[root] = leaf(node.place, all_rows[node.left]);
        node.left = keep(node.left, all, all_rows, moved);
        node.right = keep(node.right, all, all_rows, moved);
        return moved[root] = add(node);
    }

    Root add(const Node& node) {
        nodes_.push_back(node);
        return static_cast<Root>(nodes_.size() - 1);
    }
    Root leaf(Key place, const Row& values) {
        rows_.push_back(values);
        return add({place, 0, static_cast<std::uint32_t>(rows_.size() - 1), 0});
    }
    /// The leaf itself where it holds these values.
    Root leaf_like(Root old, const Row& values) {
        const Node node = nodes_[old];
        return rows_[node.left] == values ? old : leaf(node.place, values);
    }

    Root branch(Root old, Root left, Root right) {
        if (left == 0) return right;
        if (right == 0) return left;
        const Node node = nodes_[old];
        return node.left == left && node.right == right ? old : add({node.place, node.bit, left, right});
    }

    /// With what `change(row)` makes of the values at one place.
    template<class Change>
    Root change_row(Root root, Key place, const Change& change) {
        std::array<Root, 64> above; // as many branches as bits at most
        std::size_t depth = 0;
        Root at = root;
        while (at != 0 && nodes_[at].bit != 0 && matches(place, nodes_[at])) {
            above[depth++] = at;
            at = (place & nodes_[at].bit) == 0 ? nodes_[at].left : nodes_[at].right;
        }
        const Node found = nodes_[at];
        const bool there = at != 0 && found.bit == 0 && found.place == place;
        Row values;
        if (there)
            values = rows_[found.left];
        else
            values.fill(absent);
        change(values);
        if (there && values == rows_[found.left]) return root;
        Root changed = leaf(place, values);
        if (!there) changed = link(place, changed, found.place, at);
        while (depth > 0) {
            Node node = nodes_[above[--depth]];
            ((place & node.bit) == 0 ? node.left : node.right) = changed;
            changed = add(node);
        }
        return changed;
    }

    /// Joins two trees whose places part at some bit.
    Root link(Key p, Root a, Key q, Root b) {
        if (a == 0) return b;
        if (b == 0) return a;
        const Key bit = Key{1} << (63 - std::countl_zero(p ^ q));
        const bool a_left = (p & bit) == 0;
        return add({prefix(p, bit), bit, a_left ? a : b, a_left ? b : a});
    }

    template<class Change>
    Root map(Root root, const Change& change) {
        if (root == 0) return 0;
        const Node node = nodes_[root];
        if (node.bit != 0) {
            const Root left = map(node.left, change);
            return branch(root, left, map(node.right, change));
        }
        Row values = rows_[node.left];
        for (Key i = 0; i < row; ++i)
            if (values[i] != absent) values[i] = change(node.place * row + i, values[i]);
        return leaf_like(root, values);
    }

    std::vector<Node> nodes_;
    std::vector<Row> rows_; ///< of the leaves
};

} // namespace maclint::dataflow
