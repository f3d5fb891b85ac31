//! Looks at each block with such a word, and at the block after it.
#include "rules/modal/chamfer_or_corner_words_finder.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/queries/words/enclosed_blocks.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/modal/chamfer_or_corner_lengths_finder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace maclint::rules {
namespace {

using Words = std::span<const Word>;

constexpr std::array compensation = {40.0, 41.0, 42.0};

bool is_axis(const Word& word) {
    return word.address.size() == 1 && letters_of_axes.find(word.address) != std::string_view::npos;
}

/// A code of the block, where it is written.
std::optional<double> g_code(const Word& word) {
    const auto* value = std::get_if<Literal>(&word.value);
    return word.address == "G" && value != nullptr ? std::optional(value->value) : std::nullopt;
}

class Corners {
  public:
    Corners(const ProgramAnalysis& analysis, const std::function<void(const ImpossibleCorner&)>& visit)
        : analysis_(analysis)
        , modes_(analysis)
        , visit_(visit)
        , lathe_(analysis.control().machine == Machine::lathe) {}

    void look_at(const BlockView& block, Words words) {
        std::vector<const Word*> corners;
        for (const Word& word : words)
            if (is_corner(word)) corners.push_back(&word);
        const auto unknown = std::ranges::find_if(words, is_unknown);
        if (unknown != words.end()) return tell(*unknown, "unknown_word");
        if (corners.empty()) return look_at_angle(block, words);
        const bool has_comma = corners.front()->address.starts_with(',');
        if (!has_comma && !is_plain_cut(block, words)) return;
        look_at(block, words, corners);
    }

  private:
    [[nodiscard]] bool is_corner(const Word& word) const {
        if (word.address == ",C" || word.address == ",R") return true;
        return lathe_ && word.address.size() == 1 &&
               std::string_view("IJKR").find(word.address) != std::string_view::npos;
    }
    static bool is_unknown(const Word& word) {
        return word.address.size() == 2 && word.address.front() == ',' && word.address != ",C" &&
               word.address != ",R" && word.address != ",A";
    }

    /// A straight cut without a code that may take the words for itself.
    bool is_plain_cut(const BlockView& block, Words words) {
        for (const Word& word : words)
            if (word.address == "G" && g_code(word) != 1) return false;
        return motion_of(block) == 1;
    }

    std::optional<double> motion_of(const BlockView& block) {
        const auto group = analysis_.control().group_with(ModalRole::motion);
        queries::BlockModes modes = modes_(block);
        return group && modes.reached() ? modes.with_words(*group).sure_code() : std::nullopt;
    }

    void look_at(const BlockView& block, Words words, const std::vector<const Word*>& corners) {
        const Word& corner = *corners.front();
        if (corners.size() > 1) return tell(*corners.back(), "several", written(corners));
        const bool two_axes = std::ranges::count_if(words, is_axis) > 1;
        if (!corner.address.starts_with(',') && two_axes) return tell(corner, "taper");
        for (const Word& word : words)
            if (const auto code = g_code(word);
                code && std::ranges::find(compensation, *code) != compensation.end())
                return visit_({corner, "compensation", text(corner), text(word)});
        look_behind(block, words, corner);
    }

    /// A block with an angle and no end point leaves both to the next one.
    void look_at_angle(const BlockView& block, Words words) {
        const auto angle = std::ranges::find(words, ",A", &Word::address);
        if (angle == words.end() || std::ranges::any_of(words, is_axis)) return;
        with_next(block, [&](const BlockView& next, Words behind) {
            const bool goes_on = std::ranges::any_of(
                behind, [](const Word& word) { return is_axis(word) || word.address == ",A"; });
            if (!goes_on && next.effects.count == 0) tell(*angle, "no_end");
        });
    }

    /// Whether two moves along two axes leave no room for the corner between them.
    [[nodiscard]] bool is_too_large(const BlockView& block, Words words, const BlockView& next, Words behind,
                                    const Word& corner) {
        const auto* amount = std::get_if<Literal>(&corner.value);
        if (amount == nullptr) return false;
        const auto first = single_move(analysis_, modes_, block, words);
        const auto second = single_move(analysis_, modes_, next, behind);
        const auto is_shorter = [&](const std::optional<AxisMove>& move) {
            return move && move->length != 0 && move->length < std::abs(amount->value);
        };
        if (first && second && first->axis == second->axis) return false;
        return is_shorter(first) || is_shorter(second);
    }

    /// `visit(block, words)` for the next block with words, if one stands near: a dwell may stand between.
    template<class Visit>
    void with_next(const BlockView& block, const Visit& visit) {
        constexpr Offset near = 400;
        const Program& program = analysis_.program();
        const auto size = static_cast<Offset>(program.text.size());
        bool is_over = false;
        queries::for_each_block_in(program, {block.span.end, std::min(size, block.span.end + near)},
                                   [&](const BlockView& next, Words words) {
                                       if (!std::exchange(is_over, true)) visit(next, words);
                                   });
    }

    void look_behind(const BlockView& block, Words words, const Word& corner) {
        with_next(block, [&](const BlockView& next, Words behind) {
            const bool has_code = std::ranges::any_of(behind, [](const Word& word) {
                const auto code = g_code(word);
                return word.address == "G" && code != 0;
            });
            const bool moves = std::ranges::any_of(
                behind, [](const Word& word) { return is_axis(word) || word.address == ",A"; });
            if (moves && motion_of(next) == 0) return tell(corner, "rapid");
            if (!moves && !has_code && next.effects.count == 0) return tell(corner, "no_move");
            if (moves && motion_of(next) == 1 && is_too_large(block, words, next, behind, corner))
                tell(corner, "short");
        });
    }

    [[nodiscard]] std::string text(const Word& word) const {
        return std::string(analysis_.program().slice(word.span));
    }
    [[nodiscard]] std::string written(const std::vector<const Word*>& words) const {
        std::string list;
        for (const Word* word : words) list += (list.empty() ? "" : ", ") + text(*word);
        return list;
    }
    void tell(const Word& word, std::string_view why) { visit_({word, why, text(word), {}}); }
    void tell(const Word& word, std::string_view why, std::string words) {
        visit_({word, why, std::move(words), {}});
    }

    const ProgramAnalysis& analysis_;
    queries::ModesAt modes_;
    const std::function<void(const ImpossibleCorner&)>& visit_;
    bool lathe_;
};

} // namespace

void for_each_impossible_corner(const ProgramAnalysis& analysis,
                                const std::function<void(const ImpossibleCorner&)>& visit) {
    if (analysis.control().alarms.empty()) return;
    const bool lathe = analysis.control().machine == Machine::lathe;
    const Program& program = analysis.program();
    const syntax::AddressSet bare = addresses_named(program, "I J K R");
    Corners corners(analysis, visit);
    for_each_block_with_words(
        program, [&](const WordSummary& summary) { return lathe && summary.addresses.meets(bare); },
        [&](const BlockView& block, Words words, const WordSummary*) { corners.look_at(block, words); });
}

} // namespace maclint::rules
