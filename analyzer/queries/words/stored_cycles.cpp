//! Follows the text behind each block that begins a cycle.
#include "analyzer/queries/words/stored_cycles.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/queries/words/enclosed_blocks.hpp"

#include <algorithm>
#include <string_view>
#include <variant>

namespace maclint::queries {
namespace {

using Words = std::span<const Word>;

bool is_one_of(const Word& word, std::string_view letters) {
    return word.address.size() == 1 && letters.find(word.address) != std::string_view::npos &&
           word.has_value();
}

const Word* find(Words words, std::string_view letters) {
    const auto found =
        std::ranges::find_if(words, [&](const Word& word) { return is_one_of(word, letters); });
    return found == words.end() ? nullptr : &*found;
}

std::optional<double> last_code(const BlockView& block, GroupId group) {
    std::optional<double> code;
    for (const BlockSetting& setting : block.settings)
        if (setting.group == group) code = setting.value;
    return code;
}

bool sets(const BlockView& block, GroupId group) {
    return std::ranges::any_of(block.settings,
                               [&](const BlockSetting& setting) { return setting.group == group; });
}

/// K counts repeats, but where it is a shift of the tool.
const Word* no_repeats(Words words, double code) {
    constexpr double fine_boring = 76, back_boring = 87;
    const auto found = std::ranges::find_if(words, [&](const Word& word) {
        const auto* value = std::get_if<Literal>(&word.value);
        const bool repeats =
            word.address == "L" || (word.address == "K" && code != fine_boring && code != back_boring);
        return repeats && value != nullptr && value->value == 0;
    });
    return found == words.end() ? nullptr : &*found;
}

class Cycles {
  public:
    Cycles(const ProgramAnalysis& analysis, GroupId cycle)
        : analysis_(analysis)
        , program_(analysis.program())
        , cycle_(cycle)
        , motion_(*analysis.control().group_with(ModalRole::motion))
        , distance_(analysis.control().group_with(ModalRole::distance))
        , modes_at_(analysis) {}

    std::vector<StoredCycle> take() {
        for_each_block_that_sets(program_, cycle_, [&](const BlockView& block) {
            const auto code = last_code(block, cycle_);
            if (code && code != analysis_.control().groups[cycle_].cancel) begin(block, *code);
        });
        return std::move(found_);
    }

  private:
    void begin(const BlockView& block, double code) {
        StoredCycle cycle;
        for_each_block_in(program_, block.span, [&](const BlockView&, Words words) {
            if (const Word* word = no_repeats(words, code)) cycle.no_repeats = word->span;
            for (const Word& word : words)
                if (const auto* value = std::get_if<Literal>(&word.value);
                    word.address == "G" && value != nullptr && value->value == code)
                    cycle.code = word.span;
            const Word* level = find(words, "ZR");
            const auto mode = distance_ ? modes_at_(block).with_words(*distance_).sure_code() : std::nullopt;
            if (level != nullptr && mode == incremental) cycle.incremental_level = level->span;
        });
        if (cycle.code.empty() || (!cycle.no_repeats && !cycle.incremental_level)) return;
        follow(block, cycle);
        found_.push_back(cycle);
    }

    void follow(const BlockView& block, StoredCycle& cycle) {
        constexpr Offset near = 2000;
        const auto size = static_cast<Offset>(program_.text.size());
        Span part{block.span.end, std::min(size, block.span.end + near)};
        if (const auto statement = first_statement_in(program_, part)) part.end = statement->begin;
        bool is_over = false;
        for_each_block_in(program_, part, [&](const BlockView& next, Words words) {
            if (!is_over) is_over = look_at(next, words, cycle);
        });
    }

    /// Whether it is over there, or nobody knows.
    bool look_at(const BlockView& block, Words words, StoredCycle& cycle) {
        const auto does_more = [](const Effect& effect) {
            return !std::holds_alternative<SetModal>(effect.what) &&
                   !std::holds_alternative<Motion>(effect.what);
        };
        const auto effects = program_.effects_in(block.effects);
        // G70 of a Haas makes the holes of a pattern.
        const auto is_other_code = [&](const Word& word) {
            const auto* value = std::get_if<Literal>(&word.value);
            return word.address == "G" &&
                   (value == nullptr || !analysis_.control().group_of('G', value->value));
        };
        const bool ends_job = std::ranges::any_of(effects, [](const Effect& effect) {
            const auto* stop = std::get_if<Stop>(&effect.what);
            return stop != nullptr && stop->kind == Stop::Kind::end;
        });
        if (sets(block, cycle_) || sets(block, motion_) || ends_job) {
            cycle.end = block.span;
            return true;
        }
        if (std::ranges::any_of(effects, does_more) || std::ranges::any_of(words, is_other_code)) return true;
        if (distance_ && sets(block, *distance_) && last_code(block, *distance_) == absolute)
            for (const Word& word : words)
                if (word.address == "G" && !cycle.absolute) cycle.absolute = word.span;
        const Word* level = find(words, "ZR");
        if (level != nullptr) cycle.incremental_level.reset();
        const Word* position = find(words, letters_of_axes);
        if (position == nullptr) return false;
        cycle.is_carried_out = true;
        if (cycle.absolute && cycle.incremental_level && !cycle.position) cycle.position = position->span;
        return false;
    }

    static constexpr double absolute = 90, incremental = 91;
    const ProgramAnalysis& analysis_;
    const Program& program_;
    GroupId cycle_, motion_;
    std::optional<GroupId> distance_;
    ModesAt modes_at_;
    std::vector<StoredCycle> found_;
};

} // namespace

std::vector<StoredCycle> stored_cycles(const ProgramAnalysis& analysis) {
    const auto cycle = analysis.control().group_with(ModalRole::cycle);
    if (!cycle || !analysis.control().group_with(ModalRole::motion)) return {};
    return Cycles(analysis, *cycle).take();
}

} // namespace maclint::queries
