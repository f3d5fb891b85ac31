//! Finds the parts by their labels, and writes what runs once more.
#include "analyzer/dialect/sinumerik/parts.hpp"

#include "analyzer/dialect/sinumerik/part_work.hpp"
#include "analyzer/dialect/sinumerik/tables.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace maclint::sinumerik {
namespace {

/// A program repeats a few parts of some blocks; others are not followed.
constexpr std::size_t most_repetitions = 1'000;
constexpr std::size_t most_repeated_text = 4'000'000; // bytes, of all parts

constexpr std::string_view end_label = "ENDLABEL"; ///< where a part ends whose end REPEAT does not name

/// A part, and what is known of where it ends.
struct Found {
    Part part;
    bool is_certain; ///< it ends there; else not behind it
};

class Repetitions {
  public:
    explicit Repetitions(OpenProgram& program)
        : open_(program)
        , builder_(program.builder) {}

    void write(const Repetition& repetition) {
        const auto found =
            repetition.names_numbers || ++written_ > most_repetitions ? std::nullopt : find(repetition);
        builder_.begin_block();
        if (!found || found->part.first > found->part.last || contains(found->part, repetition.block) ||
            is_too_long(found->part))
            run_anything(repetition);
        else if (found->is_certain && ends_in_front_of(repetition.block, found->part.last))
            jump_back(repetition);
        else
            run_once_more(repetition, *found);
        builder_.replace_effects(repetition.block);
    }

    /// A part that nothing but REPEAT leads to goes on behind whichever REPEAT it was.
    void end_parts() {
        std::ranges::sort(ends_);
        ends_.erase(std::ranges::unique(ends_).begin(), ends_.end());
        for (const ItemId end : ends_) {
            const auto* block = std::get_if<Block>(&program().items[end]);
            if (block == nullptr) continue;
            const auto own = program().effects_in(block->effects);
            const std::vector<Effect> effects(own.begin(), own.end());
            const Span here = block->span;
            builder_.begin_block();
            for (const Effect& effect : effects) builder_.add_effect(effect);
            forget_modes(here);
            builder_.add_unreadable({{}, {}, false, true}, here);
            builder_.replace_effects(end);
        }
    }

  private:
    [[nodiscard]] const Program& program() const { return builder_.program(); }
    [[nodiscard]] static bool contains(Part part, ItemId item) {
        return part.first <= item && item <= part.last;
    }

    /// With the parts before.
    [[nodiscard]] bool is_too_long(Part part) {
        text_ += program().span_of(part.last).end - program().span_of(part.first).begin;
        return text_ > most_repeated_text;
    }

    // ---- where it is

    /// Of a label that stands several times the nearest in front of REPEAT counts, else the first behind it.
    [[nodiscard]] const NamedPlace* start_of(const Repetition& repetition) const {
        const NamedPlace* start = nullptr;
        for (const NamedPlace& label : open_.labels) {
            if (label.name != repetition.first) continue;
            if (label.span.begin < repetition.here.begin)
                start = &label;
            else if (start == nullptr)
                return &label;
        }
        return start;
    }

    [[nodiscard]] const NamedPlace* first_behind(std::string_view name, Offset place) const {
        const auto found = std::ranges::find_if(open_.labels, [&](const NamedPlace& label) {
            return label.name == name && label.span.begin >= place;
        });
        return found == open_.labels.end() ? nullptr : &*found;
    }

    [[nodiscard]] std::optional<Found> find(const Repetition& repetition) const {
        const NamedPlace* start = start_of(repetition);
        const auto first = start == nullptr ? std::nullopt : item_of(*start);
        if (!first) return std::nullopt;
        if (repetition.is_one_block) return Found{{*first, *first}, true};
        const bool is_behind = start->span.begin > repetition.here.begin;
        const std::string_view end = repetition.last.empty() ? end_label : std::string_view(repetition.last);
        const NamedPlace* last = first_behind(end, start->span.begin);
        const bool is_between = last != nullptr && last->span.begin < repetition.here.begin;
        // Whether ENDLABEL counts between the two the sources do not say [language.md 5].
        if (repetition.last.empty() && !is_behind) return Found{{*first, repetition.block - 1}, !is_between};
        const auto item = last == nullptr ? std::nullopt : item_of(*last);
        if (!item) return std::nullopt;
        return Found{{*first, *item}, true};
    }

    [[nodiscard]] std::optional<ItemId> item_of(const NamedPlace& label) const {
        const auto& items = program().items;
        const auto after = std::ranges::partition_point(items, [&](const Item& item) {
            return std::visit([](const auto& blocks) { return blocks.span.begin; }, item) <= label.span.begin;
        });
        if (after == items.begin()) return std::nullopt;
        return static_cast<ItemId>(after - items.begin() - 1);
    }

    /// Remarks may stand between.
    [[nodiscard]] bool ends_in_front_of(ItemId block, ItemId last) const {
        for (ItemId item = last + 1; item < block; ++item) {
            const auto* between = std::get_if<Block>(&program().items[item]);
            if (between == nullptr || between->effects.count != 0 || between->name) return false;
        }
        return last < block;
    }

    /// Whether the control runs into the block from the one before it.
    [[nodiscard]] bool is_run_into(ItemId item) const {
        if (item == 0) return true;
        const auto* before = std::get_if<Block>(&program().items[item - 1]);
        if (before == nullptr || before->effects.count == 0 || before->skip_levels != 0) return true;
        const auto& last = program().effects_in(before->effects).back().what;
        if (const auto* stop = std::get_if<Stop>(&last)) return stop->kind == Stop::Kind::pause;
        if (const auto* jump = std::get_if<Jump>(&last)) return jump->missing != MissingLabel::alarm;
        return !std::holds_alternative<Return>(last);
    }

    // ---- what runs

    [[nodiscard]] ExpressionId nobody_knows(Span here) {
        return builder_.add({LoadMachine{families::system, 0}, here});
    }

    void set(GroupId group, std::optional<double> value, Span here) {
        builder_.add_effect(
            {SetModal{group, value ? builder_.literal(*value, here) : nobody_knows(here)}, here});
    }

    void forget_modes(Span here) {
        builder_.add_effect({SetModal{std::nullopt, nobody_knows(here)}, here});
        for (const GroupId group : frame_groups()) set(group, std::nullopt, here);
    }

    /// The part is not found, or it repeats itself.
    void run_anything(const Repetition& repetition) {
        forget_modes(repetition.here);
        NamedInBlock may;
        may.labels = repetition.labels;
        for (const auto& [name, variable] : open_.variables) may.variables.push_back(variable);
        std::ranges::sort(may.variables, {}, [](Variable v) { return std::pair(v.space, v.number); });
        may.may_call_or_return = true;
        builder_.add_unreadable(may, repetition.here);
    }

    void guarded_jump(ExpressionId condition, std::size_t first_effect, const Repetition& repetition,
                      LabelSearch search) {
        const Span here = repetition.here;
        const ExpressionId target = builder_.add({builder_.block_name(repetition.first), here});
        builder_.add_effect({Jump{target, search, MissingLabel::alarm}, here});
        builder_.guard(condition, first_effect, here);
    }

    /// The part ends where REPEAT stands: it is a loop that counts its passes, where the text says how many.
    void jump_back(const Repetition& repetition) {
        const Span here = repetition.here;
        const auto passes = passes_of(repetition);
        if (!passes) return guarded_jump(nobody_knows(here), 0, repetition, LabelSearch::backward);
        // No name of a program holds a blank.
        const std::string name = "REPEAT " + std::to_string(repetition.block);
        const Variable done{spaces::local, builder_.number_of_name(spaces::local, name)};
        const auto load = [&] { return builder_.add({Load{done}, here}); };
        const std::array one_more{load(), builder_.literal(1, here)};
        const std::array compared{load(), builder_.literal(*passes, here)};
        const ExpressionId condition = builder_.apply(Operation::less, compared, here);
        builder_.add_effect({Assign{done, builder_.apply(Operation::add, one_more, here)}, here});
        guarded_jump(condition, 0, repetition, LabelSearch::backward);
        const std::array again{done};
        builder_.add_exchange({}, again, here); // whoever comes by again counts anew
    }

    /// Absent means once; nothing where it is calculated.
    [[nodiscard]] std::optional<double> passes_of(const Repetition& repetition) const {
        if (!repetition.passes) return 1;
        return builder_.literal_value(*repetition.passes);
    }

    /// The part stands elsewhere, and is judged there. Behind REPEAT its last words are in force.
    void run_once_more(const Repetition& repetition, const Found& found) {
        const Part part = found.part;
        const Span here = repetition.here;
        const Offset begin = program().span_of(part.first).begin, end = program().span_of(part.last).end;
        PartWork work = work_of(program(), part, [&](const Label& label) {
            const auto* named = std::get_if<BlockName>(&label);
            return named != nullptr && std::ranges::all_of(open_.labels, [&](const NamedPlace& place) {
                       return builder_.block_name(place.name) != *named ||
                              (begin <= place.span.begin && place.span.begin < end);
                   });
        });
        // Of blocks behind that repeat parts themselves nothing is written so far.
        if (std::ranges::any_of(open_.repetitions, [&](const Repetition& other) {
                return other.block > repetition.block && contains(part, other.block);
            }))
            work.may_do_anything = true;
        if (!is_run_into(part.first)) {
            guarded_jump(nobody_knows(here), 0, repetition, LabelSearch::forward_then_backward);
            ends_.push_back(part.last);
        }
        if (work.may_do_anything) forget_modes(here);
        const auto passes = passes_of(repetition);
        const bool is_known = found.is_certain && work.in_a_row && passes && *passes >= 1;
        if (!work.may_do_anything)
            for (const auto& [group, value] : work.groups) set(group, is_known ? value : std::nullopt, here);
        if (work.moves) builder_.add_effect({Motion{}, here});
        if (work.stops_look_ahead) builder_.add_effect({Synchronise{}, here});
        store(work, here);
        if (work.handles_machine || work.may_do_anything)
            builder_.add_unreadable({{}, {}, false, work.may_do_anything}, here);
    }

    /// What a part stores it may have stored before, and read.
    void store(const PartWork& work, Span here) {
        std::vector<ExpressionId> read;
        for (const auto* variables : {&work.read, &work.written})
            for (const Variable variable : *variables) read.push_back(builder_.add({Load{variable}, here}));
        if (!read.empty()) builder_.add_exchange(read, work.written, here);
    }

    OpenProgram& open_;
    ProgramBuilder& builder_;
    std::size_t written_ = 0, text_ = 0; ///< repetitions, and the text of their parts, so far
    std::vector<ItemId> ends_;           ///< of parts that nothing but REPEAT leads to
};

} // namespace

void follow_parts(OpenProgram& program) {
    Repetitions repetitions(program);
    for (const Repetition& repetition : program.repetitions) repetitions.write(repetition);
    repetitions.end_parts();
}

} // namespace maclint::sinumerik
