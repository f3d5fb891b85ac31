//! Runs the marks and meetings of all channels until nothing moves.
#include "analyzer/queries/channels/sync_order.hpp"

#include "analyzer/program/channels.hpp"
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/program/word_lookup.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint::queries {
namespace {

/// The codes of a control, and the words beside them [SEED-003:20105-20200].
constexpr double sets_mark = 162, waits_for_mark = 62, meets = 97;
constexpr std::string_view mark_word = "H", channels_word = "Q", coordinate_word = "O";

/// One thing that a channel does.
struct Step {
    enum class Kind : std::uint8_t { set, wait, meet } kind;
    double mark;       ///< of a meeting without one: -1
    Channels channels; ///< of a wait the one that sets the mark; of a meeting all that take part
    Span block;
    bool is_told = false; ///< the word names the channels of a meeting: these need no block of their own
};

/// The channels whose digits a number has: 13 is 1 and 3. None of a number that is no list of digits.
Channels channels_of_digits(double number) {
    constexpr double beyond = 1e9;
    Channels channels = 0;
    if (!(number >= 0 && number < beyond)) return channels;
    for (auto rest = static_cast<unsigned>(number); rest != 0; rest /= 10)
        channels = static_cast<Channels>(channels | (1U << (rest % 10)));
    return channels;
}

/// Each of them is held against the others.
constexpr std::size_t most_steps = 1000;

class Course {
  public:
    explicit Course(const ProgramAnalysis& analysis)
        : program_(analysis.program())
        , regions_(analysis.regions()) {}

    /// Whether all of it could be read.
    bool read() {
        for (const Section& section : program_.sections) {
            if (section.executed != Section::Executed::when_reached) continue;
            for_each_block_of(program_, section, [&](const BlockView& block, std::span<const Word> words) {
                const Channels own = block.channels != 0 ? block.channels : section.channels;
                read(own != 0 ? own : program_.channels, block.span, words);
            });
        }
        for (const Effect& effect : program_.effects)
            is_readable_ &= !std::holds_alternative<Jump>(effect.what) &&
                            !std::holds_alternative<Call>(effect.what) &&
                            !std::holds_alternative<UnreadableBlock>(effect.what);
        is_readable_ &= regions_.faults.empty() && !regions_.balance_unknown &&
                        std::ranges::none_of(
                            regions_.all, [&](const flow::Region& region) { return has_steps_in(region); });
        return is_readable_;
    }

    std::optional<EndlessWait> run() {
        bool moves = true;
        while (moves) {
            moves = false;
            for (auto& [channel, steps] : steps_)
                while (at_[channel] < steps.size() && can_pass(channel, steps[at_[channel]])) {
                    pass(channel, steps[at_[channel]]);
                    moves = true;
                }
        }
        for (const auto& [channel, steps] : steps_)
            if (at_[channel] < steps.size()) return stuck(channel, steps[at_[channel]]);
        return std::nullopt;
    }

  private:
    /// Whether a loop or a choice decides how often a channel waits.
    [[nodiscard]] bool has_steps_in(const flow::Region& region) const {
        if (!region.close) return true;
        const Span open = program_.effects[region.open].span, close = program_.effects[*region.close].span;
        return std::ranges::any_of(steps_, [&](const auto& one) {
            return std::ranges::any_of(one.second, [&](const Step& step) {
                return open.begin < step.block.begin && step.block.begin < close.end;
            });
        });
    }

    void read(Channels running, Span block, std::span<const Word> words) {
        for (const Word& code : words) {
            const auto* number = std::get_if<Literal>(&code.value);
            if (number == nullptr) continue;
            const bool is_mark =
                code.address == "G" && (number->value == sets_mark || number->value == waits_for_mark);
            const bool is_meeting = code.address == "M" && number->value == meets;
            if (!is_mark && !is_meeting) continue;
            const Word *mark = find_word(words, mark_word), *others = find_word(words, channels_word);
            const auto value = [&](const Word* word, double missing) {
                const auto* literal = word == nullptr ? nullptr : std::get_if<Literal>(&word->value);
                is_readable_ &= word == nullptr || literal != nullptr;
                return literal == nullptr ? missing : literal->value;
            };
            Step step{is_meeting                        ? Step::Kind::meet
                      : number->value == waits_for_mark ? Step::Kind::wait
                                                        : Step::Kind::set,
                      value(mark, -1), channels_of_digits(value(others, 0)), block};
            // Without Q all slides meet that the block names, or all of the program where it names one.
            if (is_meeting && step.channels == 0)
                step.channels = (running & (running - 1U)) != 0 ? running : program_.channels;
            else if (is_meeting)
                step.is_told = true;
            // A mark of nobody is told elsewhere, and a coordinate ends a wait, too: it may be over at once.
            if (step.kind == Step::Kind::wait &&
                (step.channels == 0 || mark == nullptr || find_word(words, coordinate_word) != nullptr))
                continue;
            for_each_channel(running, [&](std::uint8_t channel) { steps_[channel].push_back(step); });
            is_readable_ &= ++steps_in_all_ <= most_steps;
        }
    }

    [[nodiscard]] bool can_pass(unsigned channel, const Step& step) const {
        if (step.kind == Step::Kind::set) return true;
        bool all_there = true;
        for_each_channel(step.channels, [&](std::uint8_t other) {
            if (other != channel)
                all_there =
                    all_there && (step.kind == Step::Kind::wait
                                      ? marks_.contains({other, step.mark})
                                      : is_at(other, channel, step) || (step.is_told && !will_meet(other)));
        });
        return all_there;
    }
    [[nodiscard]] bool runs(unsigned channel, Span block) const {
        const auto steps = steps_.find(channel);
        return steps != steps_.end() && std::ranges::any_of(steps->second, [&](const Step& one) {
                   return one.block.begin == block.begin;
               });
    }
    /// What the channel has not done yet.
    [[nodiscard]] std::span<const Step> left(unsigned channel) const {
        const auto steps = steps_.find(channel);
        if (steps == steps_.end()) return {};
        const auto done = at_.find(channel);
        return std::span(steps->second).subspan(done == at_.end() ? 0 : done->second);
    }
    [[nodiscard]] bool will_meet(unsigned channel) const {
        return std::ranges::any_of(left(channel),
                                   [](const Step& one) { return one.kind == Step::Kind::meet; });
    }
    /// Whether the channel has come to the meeting: blocks that both run are one only where they are the
    /// same.
    [[nodiscard]] bool is_at(unsigned channel, unsigned asking, const Step& step) const {
        const auto steps = left(channel);
        if (steps.empty()) return false;
        const Step& now = steps.front();
        const bool shares_block = runs(channel, step.block) || runs(asking, now.block);
        return now.kind == Step::Kind::meet && now.mark == step.mark &&
               (!shares_block || now.block.begin == step.block.begin);
    }
    /// Those who meet go on together.
    void pass(unsigned channel, const Step& step) {
        if (step.kind == Step::Kind::set) marks_.insert({channel, step.mark});
        if (step.kind == Step::Kind::meet)
            for_each_channel(step.channels, [&](std::uint8_t other) {
                if (other != channel && is_at(other, channel, step)) ++at_[other];
            });
        ++at_[channel];
    }

    [[nodiscard]] std::optional<EndlessWait> stuck(unsigned channel, const Step& step) {
        std::optional<EndlessWait> found;
        for_each_channel(step.channels, [&](std::uint8_t other) {
            const bool is_there = step.kind == Step::Kind::meet && is_at(other, channel, step);
            if (other == channel || found || is_there) return;
            const auto steps = steps_.find(other);
            const bool is_over = steps == steps_.end() || at_[other] >= steps->second.size();
            if (is_over && step.kind == Step::Kind::wait) return; // told elsewhere
            found = EndlessWait{step.block, is_over ? Span{} : steps->second[at_[other]].block, channel,
                                other, is_over};
        });
        return found;
    }

    const Program& program_;
    const flow::Regions& regions_;
    bool is_readable_ = true;
    std::size_t steps_in_all_ = 0;
    std::map<unsigned, std::vector<Step>> steps_; ///< by channel
    std::map<unsigned, std::size_t> at_;          ///< the next step of each
    std::set<std::pair<unsigned, double>> marks_; ///< channel and mark
};

} // namespace

std::optional<EndlessWait> find_endless_wait(const ProgramAnalysis& analysis) {
    if (!analysis.program().has_several_channels()) return std::nullopt;
    Course course(analysis);
    if (!course.read()) return std::nullopt;
    return course.run();
}

} // namespace maclint::queries
