//! Gathers the marks that are set and those that are waited for.
#include "analyzer/queries/channels/sync_marks.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/program/word_lookup.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <string_view>

namespace maclint::queries {
namespace {

/// The codes of a control, and the words beside them [SEED-003:20105-20147].
constexpr double sets_mark = 162, waits_for_mark = 62;
constexpr std::string_view mark_word = "H", channel_word = "Q";

struct SetMark {
    double mark;
    Channels channels; ///< that run its block; 0: any
};

/// The kinds under which the scanner notes the two codes.
syntax::CodeSet kinds_of_marks(const Program& program) {
    syntax::CodeSet kinds;
    for (const syntax::PlainTables* tables : program.plain_tables) {
        if (tables == nullptr) continue;
        for (const double code : {sets_mark, waits_for_mark})
            kinds.add(tables->codes.front().rows.at(static_cast<std::size_t>(code)).kind);
    }
    return kinds;
}

/// What the words of the blocks tell.
class Marks {
  public:
    void look_at(const Program& program) {
        if (!program.control->has(Capability::sections)) return;
        const syntax::CodeSet wanted = kinds_of_marks(program);
        for (const Section& section : program.sections) {
            if (section.executed != Section::Executed::when_reached) continue;
            for_each_block_with_words(
                program, section.items,
                [&](const PlainRun& run, const auto& take) {
                    if (run.words.codes.meets(wanted)) take(run.span);
                },
                [&](const WordSummary& summary) { return summary.codes.meets(wanted); },
                [&](const BlockView& block, std::span<const Word> words, const WordSummary* /*summary*/) {
                    look_at(block.channels != 0 ? block.channels : section.channels, block.span, words);
                });
        }
    }

    [[nodiscard]] std::vector<MarkWait> missed() const {
        std::vector<MarkWait> found;
        if (calculated_) return found;
        std::ranges::copy_if(waits_, std::back_inserter(found),
                             [this](const MarkWait& wait) { return !is_set(wait); });
        return found;
    }

  private:
    void look_at(Channels channels, Span block, std::span<const Word> words) {
        for (const Word& code : words) {
            const auto* number = std::get_if<Literal>(&code.value);
            if (number == nullptr || code.address != "G") continue;
            if (number->value != sets_mark && number->value != waits_for_mark) continue;
            const Word* word = find_word(words, mark_word);
            if (word == nullptr) continue; // a row of the table of words says so
            const auto* mark = std::get_if<Literal>(&word->value);
            if (mark == nullptr) {
                calculated_ = true;
            } else if (number->value == sets_mark) {
                set_.push_back({mark->value, channels});
            } else {
                const Word* channel = find_word(words, channel_word);
                const auto* of = channel == nullptr ? nullptr : std::get_if<Literal>(&channel->value);
                const bool known = of != nullptr && of->value >= 0 && of->value < 16;
                waits_.push_back({mark->value,
                                  known ? std::optional(static_cast<unsigned>(of->value)) : std::nullopt,
                                  block});
            }
        }
    }

    [[nodiscard]] bool is_set(const MarkWait& wait) const {
        return std::ranges::any_of(set_, [&](const SetMark& set) {
            const bool may_run =
                set.channels == 0 || !wait.channel || ((set.channels >> *wait.channel) & 1U) != 0;
            return set.mark == wait.mark && may_run;
        });
    }

    std::vector<SetMark> set_;
    std::vector<MarkWait> waits_;
    bool calculated_ = false;
};

} // namespace

std::vector<MarkWait> waits_for_nothing(const ProgramFile& file) {
    Marks marks;
    for (const Program& program : file.programs) marks.look_at(program);
    return marks.missed();
}

} // namespace maclint::queries
