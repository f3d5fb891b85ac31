//! Persistent maps from 64-bit keys to ids: copies share what they have in common, so a state costs what
//! changed. Big-endian Patricia trees after Okasaki and Gill, "Fast Mergeable Integer Maps" (1998).
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace maclint::dataflow {

using Key = std::uint64_t;
using Root = std::uint32_t; ///< 0: the empty map

class PersistentMap {
  public:
    PersistentMap()
        : nodes_(1) {}

    [[nodiscard]] std::optional<std::uint32_t> find(Root root, Key key) const {
        while (root != 0) {
            const Node& node = nodes_[root];
            if (node.bit == 0) return node.key == key ? std::optional(node.left) : std::nullopt;
            if (!matches(key, node)) return std::nullopt;
            root = (key & node.bit) == 0 ? node.left : node.right;
        }
        return std::nullopt;
    }

    [[nodiscard]] Root set(Root root, Key key, std::uint32_t value) {
        if (root == 0) return leaf(key, value);
        const Node node = nodes_[root];
        if (node.bit == 0) {
            if (node.key == key) return node.left == value ? root : leaf(key, value);
            return link(key, leaf(key, value), node.key, root);
        }
        if (!matches(key, node)) return link(key, leaf(key, value), node.key, root);
        if ((key & node.bit) == 0) return branch(root, set(node.left, key, value), node.right);
        return branch(root, node.left, set(node.right, key, value));
    }

    /// Without the keys from `first` to `last`.
    [[nodiscard]] Root without(Root root, Key first, Key last) {
        if (root == 0) return 0;
        const Node node = nodes_[root];
        if (node.bit == 0) return node.key >= first && node.key <= last ? 0 : root;
        const Key low = node.key;
        const Key high = node.key | (node.bit | (node.bit - 1));
        if (low > last || high < first) return root;
        if (low >= first && high <= last) return 0;
        return branch(root, without(node.left, first, last), without(node.right, first, last));
    }

    /// Whether the maps hold the same; what they share is not looked at.
    [[nodiscard]] bool equal(Root a, Root b) const {
        if (a == b) return true;
        const Node& s = nodes_[a];
        const Node& t = nodes_[b];
        if (a == 0 || b == 0 || s.key != t.key || s.bit != t.bit) return false;
        return s.bit == 0 ? s.left == t.left : equal(s.left, t.left) && equal(s.right, t.right);
    }

    /// Forgets every map but those that `roots` name; they stand elsewhere afterwards.
    void keep_only(std::span<Root* const> roots) {
        const std::vector<Node> all = std::exchange(nodes_, std::vector<Node>(1));
        std::vector<Root> moved(all.size(), 0);
        for (Root* root : roots) *root = keep(*root, all, moved);
        nodes_.shrink_to_fit();
    }

    template<class Visit>
    void for_each(Root root, const Visit& visit) const {
        if (root == 0) return;
        const Node& node = nodes_[root];
        if (node.bit == 0) return visit(node.key, node.left);
        for_each(node.left, visit);
        for_each(node.right, visit);
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
        if (s.bit == 0 && t.bit == 0 && s.key == t.key) {
            const std::uint32_t value = s.left == t.left ? s.left : both(s.key, s.left, t.left);
            return value == s.left ? a : leaf(s.key, value);
        }
        if (s.bit != 0 && s.bit == t.bit && s.key == t.key) {
            const Root left = merge(s.left, t.left, both, only_a, only_b);
            const Root right = merge(s.right, t.right, both, only_a, only_b);
            return branch(a, left, right);
        }
        if (s.bit > t.bit && matches(t.key, s)) {
            if ((t.key & s.bit) == 0) {
                const Root left = merge(s.left, b, both, only_a, only_b);
                return branch(a, left, map(s.right, only_a));
            }
            const Root left = map(s.left, only_a);
            return branch(a, left, merge(s.right, b, both, only_a, only_b));
        }
        if (t.bit > s.bit && matches(s.key, t)) {
            if ((s.key & t.bit) == 0) {
                const Root left = merge(a, t.left, both, only_a, only_b);
                return branch(b, left, map(t.right, only_b));
            }
            const Root left = map(t.left, only_b);
            return branch(b, left, merge(a, t.right, both, only_a, only_b));
        }
        const Root left = map(a, only_a);
        return link(s.key, left, t.key, map(b, only_b));
    }

    /// The keys of both, with the value of `a` where it has the key. What they share is not looked at.
    [[nodiscard]] Root united(Root a, Root b) {
        if (a == b || b == 0) return a;
        if (a == 0) return b;
        const Node s = nodes_[a];
        const Node t = nodes_[b];
        if (s.bit == 0 && t.bit == 0 && s.key == t.key) return a;
        if (s.bit == 0) return set(b, s.key, s.left);
        if (t.bit == 0) return find(a, t.key) ? a : set(a, t.key, t.left);
        if (s.bit == t.bit && s.key == t.key) {
            const Root left = united(s.left, t.left);
            const Root right = united(s.right, t.right);
            return left == t.left && right == t.right ? b : branch(a, left, right);
        }
        const bool a_above = s.bit > t.bit;
        const Node& upper = a_above ? s : t;
        const Key below = a_above ? t.key : s.key;
        if (s.bit == t.bit || !matches(below, upper)) return link(s.key, a, t.key, b);
        const bool to_left = (below & upper.bit) == 0;
        const Root inner = to_left ? upper.left : upper.right;
        const Root joined = a_above ? united(inner, b) : united(a, inner);
        return branch(a_above ? a : b, to_left ? joined : upper.left, to_left ? upper.right : joined);
    }

  private:
    struct Node {
        Key key = 0;            ///< leaf: the key; branch: the bits above `bit`
        Key bit = 0;            ///< 0: leaf
        std::uint32_t left = 0; ///< leaf: the value
        std::uint32_t right = 0;
    };

    static Key prefix(Key key, Key bit) { return key & ~(bit | (bit - 1)); }
    static bool matches(Key key, const Node& branch) { return prefix(key, branch.bit) == branch.key; }

    Root keep(Root root, const std::vector<Node>& all, std::vector<Root>& moved) {
        if (root == 0 || moved[root] != 0) return moved[root];
        Node node = all[root];
        if (node.bit != 0) {
            node.left = keep(node.left, all, moved);
            node.right = keep(node.right, all, moved);
        }
        return moved[root] = add(node);
    }

    Root add(const Node& node) {
        nodes_.push_back(node);
        return static_cast<Root>(nodes_.size() - 1);
    }
    Root leaf(Key key, std::uint32_t value) { return add({key, 0, value, 0}); }

    Root branch(Root old, Root left, Root right) {
        if (left == 0) return right;
        if (right == 0) return left;
        const Node node = nodes_[old];
        return node.left == left && node.right == right ? old : add({node.key, node.bit, left, right});
    }

    /// Joins two trees whose keys part at some bit.
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
        if (node.bit == 0) {
            const std::uint32_t value = change(node.key, node.left);
            return value == node.left ? root : leaf(node.key, value);
        }
        const Root left = map(node.left, change);
        return branch(root, left, map(node.right, change));
    }

    std::vector<Node> nodes_;
};

} // namespace maclint::dataflow
