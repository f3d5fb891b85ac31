//! Which of the files that are gone a new one was.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// What two texts are compared by: their lines, whatever their ends and their order.
class LineBag {
  public:
    explicit LineBag(std::string_view text);
    /// At most how many lines a text has; each takes 16 bytes in a bag.
    [[nodiscard]] static std::size_t count_lines(std::string_view text);

    /// The share of the larger text's bytes that stand in lines of both, from 0 to 1.
    [[nodiscard]] double share_with(const LineBag& other) const;
    /// Whether the sizes alone allow that half of it is in both.
    [[nodiscard]] bool may_share_half_with(const LineBag& other) const;
    [[nodiscard]] std::size_t lines() const { return lines_.size(); }

    /// By all lines.
    friend auto operator<=>(const LineBag&, const LineBag&) = default;

  private:
    struct Line {
        std::size_t hash, size;
        friend auto operator<=>(const Line&, const Line&) = default;
    };
    std::vector<Line> lines_; ///< sorted
    std::size_t bytes_ = 0;
};

struct NamedLines {
    std::string path;
    LineBag lines;
};

struct Renames {
    std::map<std::string, std::string> gone_by_new; ///< paths
    bool bound_was_met = false; ///< only files that are the same, or bear the same name, were paired
};

/// Pairs files that have at least half in common, those with most first, each with one other. Both lists in
/// the order of their paths.
[[nodiscard]] Renames find_renames(const std::vector<NamedLines>& gone, const std::vector<NamedLines>& added);

} // namespace maclint::cli
