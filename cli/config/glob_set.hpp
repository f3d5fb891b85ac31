//! Many globs, asked of many paths: the names of a path lead to the globs that may take it.
#pragma once

#include "analyzer/source/text_hash.hpp"
#include "cli/config/glob.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace maclint::cli {

/// Patterns of single names, each with a number that its owner gives it. Those without wildcards are looked
/// up, others by the longer of their literal ends; only `*a*` and its like are tried one after the other.
class NamePatterns {
  public:
    /// The number of a pattern, which is `next` when it is a new one.
    std::uint32_t add(const std::string& pattern, std::uint32_t next);
    /// Adds the numbers of those that match the name.
    void find(std::string_view name, std::vector<std::uint32_t>& numbers) const;

  private:
    template<class Value>
    using ByText = std::unordered_map<std::string, Value, TextHash, std::equal_to<>>;
    struct Pattern {
        std::string text;
        std::uint32_t number;
    };
    /// Patterns by an end that has no wildcards, and how long these ends are.
    struct ByEnd {
        ByText<std::vector<Pattern>> patterns;
        std::vector<std::size_t> lengths;
    };
    static void put(ByEnd& index, std::string_view end, Pattern pattern);
    static void try_all(const std::vector<Pattern>& patterns, std::string_view name,
                        std::vector<std::uint32_t>& numbers);

    ByText<std::uint32_t> known_; ///< those without wildcards among them
    ByEnd by_head_, by_tail_;
    std::vector<Pattern> others_;
};

/// The globs of a configuration's key, in its order.
class GlobSet {
  public:
    GlobSet();
    explicit GlobSet(const std::vector<Glob>& globs);

    /// Which of them take a path, in their order. It may be absolute or relative to the current folder. A
    /// glob without '/' is tried on every name of the path below its folder, so that "old" and "*.bak" hold
    /// at any depth; one that takes a folder takes all that is in it.
    [[nodiscard]] std::vector<std::size_t> that_take(const std::string& path) const;
    [[nodiscard]] bool takes(const std::string& path) const { return !that_take(path).empty(); }

  private:
    struct OfFolder;
    std::vector<std::shared_ptr<const OfFolder>> folders_;
};

} // namespace maclint::cli
