//! Pairs loops and choices with a stack, the way a control does when it meets DO and END.
#include "analyzer/flow/structure.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace maclint::flow {
namespace {

/// What pairs an opening with its close: an END closes WHILE and DO alike, every other construct has a close
/// of its own; numbers must agree.
using Key = std::pair<Construct, std::optional<std::int64_t>>;

Key key_of(Construct construct, std::optional<std::int64_t> number) {
    return {is_loop(construct) ? Construct::while_loop : construct, number};
}

/// A close that belongs to nothing, and the innermost loop or choice open there.
struct Stray {
    EffectId close;
    std::optional<StructureId> within;
};

class Pairing {
  public:
    explicit Pairing(const Program& program)
        : program_(program) {}

    Structures run() {
        for_each_effect(program_, [this](EffectId id) { take(id); });
        judge_numbers();
        judge_units();
        judge_unpaired();
        for (Paired& paired : result_.all) {
            paired.crossed |= paired.close && crossing_closes_.contains(*paired.close);
            if (paired.parent) {
                const Paired& outer = result_.all[*paired.parent];
                paired.closed_around =
                    is_loop(outer.construct) && outer.close ? paired.parent : outer.closed_around;
            }
        }
        std::ranges::stable_sort(result_.faults, {}, &StructureFault::effect);
        index_effects();
        return std::move(result_);
    }

  private:
    void take(EffectId id) {
        const auto& what = program_.effects[id].what;
        if (const auto* unreadable = std::get_if<UnreadableBlock>(&what))
            result_.balance_in_doubt |= unreadable->may_open_or_close;
        const auto* structure = std::get_if<Structure>(&what);
        if (structure == nullptr) return;
        switch (structure->part) {
        case Structure::Part::open: open(id, *structure); break;
        case Structure::Part::begin:
        case Structure::Part::middle:
        case Structure::Part::leave: divide(id, *structure); break;
        case Structure::Part::close: close(id, *structure); break;
        }
    }

    // ---- pairing ----

    void open(EffectId id, const Structure& structure) {
        Paired paired{structure.construct, id, {}, {}, false, {}, {}, structure.number, structure.condition};
        if (!open_.empty()) paired.parent = open_.back();
        open_at_[key_of(structure.construct, structure.number)].push_back(open_.size());
        open_.push_back(static_cast<StructureId>(result_.all.size()));
        result_.all.push_back(std::move(paired));
    }

    void divide(EffectId id, const Structure& structure) {
        const auto position = find_open(structure);
        if (!position) return fault(Imbalance::never_opened, id, {});
        result_.all[open_[*position]].parts.push_back(id);
    }

    void close(EffectId id, const Structure& structure) {
        const auto position = find_open(structure);
        if (position) return close_open(id, *position);
        if (close_crossed(id, structure)) return;
        strays_.push_back({id, open_.empty() ? std::nullopt : std::optional(open_.back())});
    }

    /// Closes what is open there; what opened inside it and is still open may be crossed.
    void close_open(EffectId id, std::size_t position) {
        result_.all[open_[position]].close = id;
        while (open_.size() > position) {
            const StructureId top = open_.back();
            const Key key = key_of(result_.all[top].construct, result_.all[top].number);
            open_.pop_back();
            open_at_[key].pop_back();
            if (open_.size() > position) crossed_[key].emplace_back(top, id);
        }
    }

    /// A close for a structure that an outer close has already run over: now the crossing is certain.
    bool close_crossed(EffectId id, const Structure& structure) {
        const auto found = crossed_.find(key_of(structure.construct, structure.number));
        if (found == crossed_.end() || found->second.empty()) return false;
        const auto [inner, outer_close] = found->second.back();
        found->second.pop_back();
        result_.all[inner].close = id;
        fault(Imbalance::crossed, outer_close, result_.all[inner].open);
        result_.all[inner].crossed = true;
        crossing_closes_.insert(outer_close);
        return true;
    }

    /// The innermost open structure that the close belongs to; a loop whose number the text lacks takes any.
    [[nodiscard]] std::optional<std::size_t> find_open(const Structure& close) const {
        for (const auto& number : {close.number, std::optional<std::int64_t>{}}) {
            const auto found = open_at_.find(key_of(close.construct, number));
            if (found != open_at_.end() && !found->second.empty()) return found->second.back();
            if (!is_loop(close.construct)) break;
        }
        return std::nullopt;
    }

    // ---- judging ----

    /// One cause, one fault: a loop that is never closed explains that the loops behind it seem nested too
    /// deep or seem to use its number again.
    void judge_numbers() {
        std::vector<std::vector<StructureId>> closed_around(result_.all.size());
        for (StructureId id = 0; id < result_.all.size(); ++id) {
            const Paired& paired = result_.all[id];
            auto& around = closed_around[id];
            if (paired.parent && judges_loops()) {
                around = closed_around[*paired.parent];
                const Paired& outer = result_.all[*paired.parent];
                const bool counts = is_loop(outer.construct) && outer.close;
                if (counts && around.size() < most_levels()) around.push_back(*paired.parent);
            }
            if (is_loop(paired.construct) && judges_loops()) judge_number(paired, around);
        }
    }

    /// Units stand one behind the other.
    void judge_units() {
        std::vector<std::optional<StructureId>> unit_around(result_.all.size());
        for (StructureId id = 0; id < result_.all.size(); ++id) {
            const Paired& paired = result_.all[id];
            auto& around = unit_around[id];
            if (paired.parent) {
                const Paired& outer = result_.all[*paired.parent];
                const bool is_unit = outer.construct == Construct::unit && outer.close;
                around = is_unit ? paired.parent : unit_around[*paired.parent];
            }
            if (around && paired.construct == Construct::unit && paired.close)
                fault(Imbalance::nested_too_deep, paired.open, result_.all[*around].open);
        }
    }

    void judge_number(const Paired& paired, const std::vector<StructureId>& around) {
        if (paired.close && around.size() >= most_levels())
            return fault(Imbalance::nested_too_deep, paired.open, {});
        if (!has_numbers() || !paired.number) return;
        const auto same = std::ranges::find_if(
            around, [&](StructureId id) { return result_.all[id].number == paired.number; });
        if (paired.close && same != around.end())
            fault(Imbalance::number_reused, paired.open, result_.all[*same].open);
        else if (is_out_of_range(paired))
            fault(Imbalance::number_out_of_range, paired.open, {});
    }

    /// What is never closed and what closes nothing are one fault when they can be meant for each other: the
    /// number of one of them is wrong.
    void judge_unpaired() {
        std::vector<StructureId> waiting; // loops never closed that open before the stray
        StructureId next = 0;
        for (const Stray& stray : strays_) {
            for (; next < result_.all.size() && is_before(result_.all[next].open, stray.close); ++next)
                if (!result_.all[next].close && is_loop(result_.all[next].construct)) waiting.push_back(next);
            const auto& close = std::get<Structure>(program_.effects[stray.close].what);
            if (!is_loop(close.construct) || waiting.empty()) {
                fault(Imbalance::never_opened, stray.close, {});
                continue;
            }
            judge_pair(waiting.back(), stray);
            waiting.pop_back();
        }
        for (StructureId id = 0; id < result_.all.size(); ++id)
            if (!result_.all[id].close && !told_.contains(id)) judge_unclosed(id, {});
    }

    void judge_pair(StructureId unclosed, const Stray& stray) {
        told_.insert(unclosed);
        // DO1 DO1 END2 END1: the inner loop took the number of the outer one, and its END1.
        if (has_numbers() && stray.within && *stray.within != unclosed) {
            const Paired& inner = result_.all[*stray.within];
            if (inner.close && inner.number == result_.all[unclosed].number)
                return fault(Imbalance::number_reused, inner.open, result_.all[unclosed].open);
        }
        judge_unclosed(unclosed, stray.close);
    }

    void judge_unclosed(StructureId id, std::optional<EffectId> meant) {
        const Paired& paired = result_.all[id];
        // A loop that lost its DO has no number; a number out of range is told already.
        const bool told =
            is_loop(paired.construct) && has_numbers() && (!paired.number || is_out_of_range(paired));
        if (!told) fault(Imbalance::never_closed, paired.open, meant);
    }

    [[nodiscard]] bool has_numbers() const { return program_.control->limits.last_loop_number != 0; }
    [[nodiscard]] std::size_t most_levels() const {
        return static_cast<std::size_t>(program_.control->limits.loop_levels);
    }
    /// Nothing can be wrong with how loops stand in each other where neither levels nor numbers are limited.
    [[nodiscard]] bool judges_loops() const { return most_levels() != 0; }

    [[nodiscard]] bool is_out_of_range(const Paired& paired) const {
        const Limits& limits = program_.control->limits;
        return has_numbers() && paired.number &&
               (*paired.number < limits.first_loop_number || *paired.number > limits.last_loop_number);
    }

    [[nodiscard]] bool is_before(EffectId a, EffectId b) const {
        return program_.effects[a].span.begin < program_.effects[b].span.begin;
    }

    void index_effects() {
        auto& index = result_.by_effect;
        for (StructureId id = 0; id < result_.all.size(); ++id) {
            const Paired& paired = result_.all[id];
            index.emplace_back(paired.open, id);
            for (const EffectId part : paired.parts) index.emplace_back(part, id);
            if (paired.close) index.emplace_back(*paired.close, id);
        }
        std::ranges::sort(index);
    }

    void fault(Imbalance what, EffectId effect, std::optional<EffectId> other) {
        result_.faults.push_back({what, effect, other});
    }

    const Program& program_;
    Structures result_;
    std::vector<StructureId> open_;
    std::map<Key, std::vector<std::size_t>> open_at_; ///< positions in open_
    /// Run over by the close of an outer structure, own close not met yet, and that close.
    std::map<Key, std::vector<std::pair<StructureId, EffectId>>> crossed_;
    std::set<EffectId> crossing_closes_; ///< of outer structures whose crossing is certain
    std::vector<Stray> strays_;
    std::set<StructureId> told_; ///< never closed, and reported with a stray close
};

} // namespace

bool Structures::holds(const Program& program, StructureId loop, Offset place) const {
    const Paired& paired = all[loop];
    if (!paired.close) return false;
    return place >= program.effects[paired.open].span.end && place < program.effects[*paired.close].span.end;
}

std::optional<StructureId> Structures::with(EffectId effect) const {
    const auto found =
        std::ranges::lower_bound(by_effect, effect, {}, &std::pair<EffectId, StructureId>::first);
    return found != by_effect.end() && found->first == effect ? std::optional(found->second) : std::nullopt;
}

std::optional<StructureId> Structures::loop_around(const Program& program, Offset place) const {
    // Structures are sorted by where they open, so the last one opened before the place, or one around it,
    // holds the place.
    const auto after = std::ranges::upper_bound(
        all, place, {}, [&](const Paired& p) { return program.effects[p.open].span.end; });
    if (after == all.begin()) return std::nullopt;
    std::optional<StructureId> id = static_cast<StructureId>(after - all.begin() - 1);
    while (id && !(is_loop(all[*id].construct) && holds(program, *id, place))) id = all[*id].closed_around;
    return id;
}

std::optional<StructureId> Structures::entered(const Program& program, Offset from, Offset to) const {
    std::optional<StructureId> entered;
    for (auto id = loop_around(program, to); id; id = all[*id].closed_around)
        if (holds(program, *id, to) && !holds(program, *id, from)) entered = id;
    return entered;
}

Structures pair_structures(const Program& program) { return Pairing(program).run(); }

} // namespace maclint::flow
