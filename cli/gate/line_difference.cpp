//! Common beginning and end, then lines that both texts have once (Bram Cohen's patience diff), then Myers:
//! An O(ND) Difference Algorithm and Its Variations, 1986, in rounds of bounded work.
#include "cli/gate/line_difference.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace maclint::cli {
namespace {

using Line = std::uint32_t; ///< its number in a text or its place in a list, from 0
using Id = std::uint32_t;   ///< equal lines have the same
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

std::string_view without_return(std::string_view words, bool ends) {
    if (ends && words.ends_with('\r')) words.remove_suffix(1);
    return words;
}

struct LastLine {
    explicit LastLine(std::string_view text) {
        const bool ends = text.ends_with('\n');
        if (ends) text.remove_suffix(1);
        const auto before = text.rfind('\n');
        const std::string_view line = before == std::string_view::npos ? text : text.substr(before + 1);
        words = without_return(line, ends);
        size = line.size() + (ends ? 1 : 0);
    }

    std::string_view words;
    std::size_t size;
};

/// Takes the lines off that both texts begin with, and says how many they are.
Line take_common_beginning(std::string_view& before, std::string_view& after) {
    Line count = 0;
    for (; !before.empty() && !after.empty(); ++count) {
        const FirstLine one(before);
        const FirstLine other(after);
        if (one.words != other.words) break;
        before.remove_prefix(one.size);
        after.remove_prefix(other.size);
    }
    return count;
}

void take_common_end(std::string_view& before, std::string_view& after) {
    while (!before.empty() && !after.empty()) {
        const LastLine one(before);
        const LastLine other(after);
        if (one.words != other.words) return;
        before.remove_suffix(one.size);
        after.remove_suffix(other.size);
    }
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const FirstLine line(text);
        lines.push_back(line.words);
        text.remove_prefix(line.size);
    }
    return lines;
}

/// Numbers for different lines. A line that too many others stand in the way of gets none, so that nobody can
/// choose lines that make the search slow.
class LineIds {
  public:
    explicit LineIds(std::size_t most)
        : slots_(std::bit_ceil(most * 2 + 1), none) {}

    [[nodiscard]] Id find(std::string_view words) const {
        const auto slot = slot_of(words);
        return slot ? slots_[*slot] : none;
    }
    Id add(std::string_view words) {
        const auto slot = slot_of(words);
        if (!slot) return none;
        if (slots_[*slot] == none) {
            slots_[*slot] = static_cast<Id>(words_.size());
            words_.push_back(words);
        }
        return slots_[*slot];
    }
    [[nodiscard]] std::size_t count() const { return words_.size(); }

  private:
    /// Where it is, or may be put.
    [[nodiscard]] std::optional<std::size_t> slot_of(std::string_view words) const {
        constexpr std::size_t most_in_the_way = 256;
        const std::size_t begin = std::hash<std::string_view>{}(words);
        for (std::size_t i = 0; i < most_in_the_way; ++i) {
            const std::size_t slot = (begin + i) & (slots_.size() - 1);
            if (slots_[slot] == none || words_[slots_[slot]] == words) return slot;
        }
        return std::nullopt;
    }

    std::vector<Id> slots_;
    std::vector<std::string_view> words_;
};

/// The lines of one text that the other has as well.
struct SharedLines {
    std::vector<Id> ids;
    std::vector<Line> numbers;

    void add(Id id, Line number) {
        ids.push_back(id);
        numbers.push_back(number);
    }
};

struct Both {
    SharedLines before, after;
    std::size_t ids = 0; ///< how many
};

Both shared_lines(std::span<const std::string_view> before, std::string_view after) {
    LineIds ids(before.size());
    std::vector<Id> all;
    all.reserve(before.size());
    for (const std::string_view words : before) all.push_back(ids.add(words));
    Both both;
    both.ids = ids.count();
    std::vector<bool> is_shared(ids.count());
    for (Line number = 0; !after.empty(); ++number) {
        const FirstLine line(after);
        after.remove_prefix(line.size);
        const Id id = ids.find(line.words);
        if (id == none) continue;
        is_shared[id] = true;
        both.after.add(id, number);
    }
    for (Line number = 0; number < all.size(); ++number)
        if (all[number] != none && is_shared[all[number]]) both.before.add(all[number], number);
    return both;
}

/// Parts of both lists.
struct Parts {
    Line before, before_end, after, after_end;

    [[nodiscard]] bool is_one_empty() const { return before == before_end || after == after_end; }
};

struct Match {
    Line before, after;
};

/// Finds lines that are the same in both lists, in the order of both.
class Matching {
  public:
    explicit Matching(const Both& both)
        : before_(both.before.ids)
        , after_(both.after.ids)
        , seen_(both.ids)
        , work_left_(least_work + work_per_line * (before_.size() + after_.size())) {
        match({0, static_cast<Line>(before_.size()), 0, static_cast<Line>(after_.size())}, deepest);
        std::ranges::sort(matches_, {}, &Match::after);
    }

    [[nodiscard]] const std::vector<Match>& matches() const { return matches_; }

  private:
    static constexpr unsigned deepest = 64;
    static constexpr std::size_t least_work = 20'000'000; // steps of Myers' search, some nanoseconds each
    static constexpr std::size_t work_per_line = 20;

    struct Seen {
        std::uint32_t before = 0, after = 0; ///< how often
        Line place = 0;                      ///< in the older list
    };

    void match(Parts parts, unsigned depth_left) {
        while (!parts.is_one_empty() && before_[parts.before] == after_[parts.after])
            matches_.push_back({parts.before++, parts.after++});
        while (!parts.is_one_empty() && before_[parts.before_end - 1] == after_[parts.after_end - 1])
            matches_.push_back({--parts.before_end, --parts.after_end});
        if (parts.is_one_empty()) return;
        const auto anchors = depth_left == 0 ? std::vector<Match>{} : in_order_of_both(single_lines(parts));
        if (anchors.empty()) {
            while (!parts.is_one_empty() && search(parts)) {
            }
            return;
        }
        Parts gap = parts;
        for (const Match& anchor : anchors) {
            matches_.push_back(anchor);
            gap.before_end = anchor.before;
            gap.after_end = anchor.after;
            match(gap, depth_left - 1);
            gap.before = anchor.before + 1;
            gap.after = anchor.after + 1;
        }
        gap.before_end = parts.before_end;
        gap.after_end = parts.after_end;
        match(gap, depth_left - 1);
    }

    /// Lines that each part has once, in the order of the newer one.
    std::vector<Match> single_lines(const Parts& parts) {
        for (Line i = parts.before; i < parts.before_end; ++i) {
            Seen& seen = seen_[before_[i]];
            ++seen.before;
            seen.place = i;
        }
        for (Line i = parts.after; i < parts.after_end; ++i) ++seen_[after_[i]].after;
        std::vector<Match> singles;
        for (Line i = parts.after; i < parts.after_end; ++i)
            if (const Seen& seen = seen_[after_[i]]; seen.before == 1 && seen.after == 1)
                singles.push_back({seen.place, i});
        for (Line i = parts.before; i < parts.before_end; ++i) seen_[before_[i]] = {};
        for (Line i = parts.after; i < parts.after_end; ++i) seen_[after_[i]] = {};
        return singles;
    }

    /// The longest chain of them that goes up in both.
    static std::vector<Match> in_order_of_both(const std::vector<Match>& singles) {
        std::vector<std::uint32_t> ends; // of the chains of each length, the one that ends first
        std::vector<std::uint32_t> previous(singles.size(), none);
        for (std::uint32_t i = 0; i < singles.size(); ++i) {
            const auto place = std::ranges::lower_bound(ends, singles[i].before, {},
                                                        [&](std::uint32_t at) { return singles[at].before; });
            if (place != ends.begin()) previous[i] = *std::prev(place);
            if (place == ends.end()) {
                ends.push_back(i);
            } else {
                *place = i;
            }
        }
        std::vector<Match> chain;
        for (std::uint32_t at = ends.empty() ? none : ends.back(); at != none; at = previous[at])
            chain.push_back(singles[at]);
        std::ranges::reverse(chain);
        return chain;
    }

    /// One round of Myers' search from the beginning of the parts, which it moves to where it came. False:
    /// the work is used up, and what is left counts as different.
    bool search(Parts& parts) {
        constexpr int most = 256; // differences in a round
        const auto width = static_cast<int>(std::min<Line>(parts.before_end - parts.before, none / 2));
        const auto height = static_cast<int>(std::min<Line>(parts.after_end - parts.after, none / 2));
        std::vector<std::vector<int>> trace; // how far each diagonal was after so many differences
        std::vector<int> far(2 * most + 3, 0);
        const auto at = [&](std::vector<int>& list, int diagonal) -> int& {
            return *(list.begin() + diagonal + most + 1);
        };
        int best = 0;
        for (int d = 0;; ++d) {
            trace.emplace_back(far.begin() + (most + 1 - d - 1), far.begin() + (most + 1 + d + 2));
            best = none_yet;
            for (int k = -d; k <= d; k += 2) {
                const bool down = k == -d || (k != d && at(far, k - 1) < at(far, k + 1));
                int x = d == 0 ? 0 : down ? at(far, k + 1) : at(far, k - 1) + 1;
                const int from = x;
                if (x > width || x - k > height || x < k) {
                    at(far, k) = x; // beside the lists
                    continue;
                }
                while (x < width && x - k < height &&
                       before_[parts.before + static_cast<Line>(x)] ==
                           after_[parts.after + static_cast<Line>(x - k)])
                    ++x;
                at(far, k) = x;
                const auto steps = static_cast<std::size_t>(x - from) + 1;
                if (steps > work_left_) return false;
                work_left_ -= steps;
                if (best == none_yet || 2 * x - k > 2 * at(far, best) - best) best = k;
                if (x == width && x - k == height) {
                    best = k;
                    break;
                }
            }
            const bool is_over =
                best == none_yet || d == most || (at(far, best) == width && at(far, best) - best == height);
            if (!is_over) continue;
            if (best == none_yet) return false;
            const int x = at(far, best);
            walk_back(parts, trace, x, best);
            parts.before += static_cast<Line>(x);
            parts.after += static_cast<Line>(x - best);
            return true;
        }
    }

    /// Keeps the lines that are the same on the way that led to a place.
    void walk_back(const Parts& parts, const std::vector<std::vector<int>>& trace, int x, int k) {
        for (int d = static_cast<int>(trace.size()) - 1; d >= 0; --d) {
            const auto before = [&](int diagonal) {
                return *(trace[static_cast<std::size_t>(d)].begin() + diagonal + d + 1);
            };
            const bool down = k == -d || (k != d && before(k - 1) < before(k + 1));
            const int begin = d == 0 ? 0 : down ? before(k + 1) : before(k - 1) + 1;
            for (; x > begin; --x)
                matches_.push_back(
                    {parts.before + static_cast<Line>(x - 1), parts.after + static_cast<Line>(x - 1 - k)});
            if (d == 0) return;
            k = down ? k + 1 : k - 1;
            x = before(k);
        }
    }

    static constexpr int none_yet = std::numeric_limits<int>::min();

    std::span<const Id> before_, after_;
    std::vector<Seen> seen_; ///< by id; all 0 but while single lines are looked for
    std::vector<Match> matches_;
    std::size_t work_left_;
};

} // namespace

FirstLine::FirstLine(std::string_view text) {
    const auto end = text.find('\n');
    const bool ends = end != std::string_view::npos;
    words = without_return(text.substr(0, end), ends);
    size = ends ? end + 1 : text.size();
}

std::vector<LineDifference> differences(std::string_view before, std::string_view after) {
    const Line beginning = take_common_beginning(before, after);
    take_common_end(before, after);
    const auto older = lines_of(before);
    const auto newer = static_cast<Line>(std::ranges::count(after, '\n') +
                                         (!after.empty() && !after.ends_with('\n') ? 1 : 0));
    const Both both = shared_lines(older, after);
    std::vector<LineDifference> found;
    Line next_before = 0;
    Line next_after = 0;
    const auto close = [&](Line before_number, Line after_number) {
        if (after_number > next_after || before_number > next_before)
            found.push_back({beginning + next_before, beginning + before_number, beginning + next_after,
                             beginning + after_number});
        next_before = before_number + 1;
        next_after = after_number + 1;
    };
    const Matching matching(both);
    for (const Match& match : matching.matches())
        close(both.before.numbers[match.before], both.after.numbers[match.after]);
    close(static_cast<Line>(older.size()), newer);
    return found;
}

std::vector<LineRange> changed_lines(std::string_view before, std::string_view after) {
    std::vector<LineRange> ranges;
    for (const LineDifference& one : differences(before, after)) {
        if (one.after_end > one.after)
            ranges.push_back({one.after + 1, one.after_end});
        else
            ranges.push_back({std::max(one.after, 1U), one.after + 1}); // on both sides of what is gone
    }
    return ranges;
}

} // namespace maclint::cli
