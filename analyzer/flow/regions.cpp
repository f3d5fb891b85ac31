//! Pairs loops and choices with a stack, the way a control does when it meets DO and END.
#include "analyzer/flow/regions.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace maclint::flow {
namespace {

/// What pairs an opening with its close: where loops have numbers an END closes WHILE and DO alike, every
/// other construct has a close of its own; numbers must agree.
using Key = std::pair<RegionKind, std::optional<std::int64_t>>;

/// A close that belongs to nothing, and the innermost loop or choice open there.
struct Stray {
    EffectId close;
    std::optional<RegionId> within;
};

class Pairing {
  public:
    explicit Pairing(const Program& program)
        : program_(program) {}

    Regions run() {
        for_each_effect(program_, [this](EffectId id) { take(id); });
        check_numbers();
        check_units();
        check_unpaired();
        for (Region& region : result_.all) {
            region.crossed |= region.close && crossing_closes_.contains(*region.close);
            if (region.parent) {
                const Region& outer = result_.all[*region.parent];
                region.closed_around =
                    is_loop(outer.region_kind) && outer.close ? region.parent : outer.closed_around;
            }
        }
        std::ranges::stable_sort(result_.faults, {}, &RegionFault::effect);
        index_effects();
        return std::move(result_);
    }

  private:
    void take(EffectId id) {
        const auto& what = program_.effects[id].what;
        if (const auto* unreadable = std::get_if<UnreadableBlock>(&what))
            result_.balance_unknown |= unreadable->may_open_or_close;
        const auto* mark = std::get_if<RegionMark>(&what);
        if (mark == nullptr) return;
        switch (mark->part) {
        case RegionMark::Part::open: open(id, *mark); break;
        case RegionMark::Part::begin:
        case RegionMark::Part::middle:
        case RegionMark::Part::leave: divide(id, *mark); break;
        case RegionMark::Part::close: close(id, *mark); break;
        }
    }

    // ---- pairing ----

    [[nodiscard]] Key key_of(RegionKind region_kind, std::optional<std::int64_t> number) const {
        const bool alike = has_numbers() && is_loop(region_kind);
        return {alike ? RegionKind::while_loop : region_kind, number};
    }

    void open(EffectId id, const RegionMark& mark) {
        Region region{mark.region_kind, id, {}, {}, false, {}, {}, mark.number, mark.condition};
        if (!open_.empty()) region.parent = open_.back();
        open_at_[key_of(mark.region_kind, mark.number)].push_back(open_.size());
        open_.push_back(static_cast<RegionId>(result_.all.size()));
        result_.all.push_back(std::move(region));
    }

    void divide(EffectId id, const RegionMark& mark) {
        const auto position = find_open(mark);
        if (!position) return fault(Imbalance::never_opened, id, {});
        result_.all[open_[*position]].parts.push_back(id);
    }

    void close(EffectId id, const RegionMark& mark) {
        const auto position = find_open(mark);
        if (position) return close_open(id, *position);
        if (close_crossed(id, mark)) return;
        strays_.push_back({id, open_.empty() ? std::nullopt : std::optional(open_.back())});
    }

    /// Closes what is open there; what opened inside it and is still open may be crossed.
    void close_open(EffectId id, std::size_t position) {
        result_.all[open_[position]].close = id;
        while (open_.size() > position) {
            const RegionId top = open_.back();
            const Key key = key_of(result_.all[top].region_kind, result_.all[top].number);
            open_.pop_back();
            open_at_[key].pop_back();
            if (open_.size() > position) crossed_[key].emplace_back(top, id);
        }
    }

    /// A close for a region that an outer close has already run over: now the crossing is certain.
    bool close_crossed(EffectId id, const RegionMark& mark) {
        const auto found = crossed_.find(key_of(mark.region_kind, mark.number));
        if (found == crossed_.end() || found->second.empty()) return false;
        const auto [inner, outer_close] = found->second.back();
        found->second.pop_back();
        result_.all[inner].close = id;
        fault(Imbalance::crossed, outer_close, result_.all[inner].open);
        result_.all[inner].crossed = true;
        crossing_closes_.insert(outer_close);
        return true;
    }

    /// The innermost open region that the close belongs to; a loop whose number the text lacks takes any.
    [[nodiscard]] std::optional<std::size_t> find_open(const RegionMark& close) const {
        for (const auto& number : {close.number, std::optional<std::int64_t>{}}) {
            const auto found = open_at_.find(key_of(close.region_kind, number));
            if (found != open_at_.end() && !found->second.empty()) return found->second.back();
            if (!is_loop(close.region_kind)) break;
        }
        return std::nullopt;
    }

    // ---- judging ----

    /// One cause, one fault: a loop that is never closed explains that the loops after it seem nested too
    /// deep or seem to use its number again.
    void check_numbers() {
        std::vector<std::vector<RegionId>> closed_around(result_.all.size());
        for (RegionId id = 0; id < result_.all.size(); ++id) {
            const Region& region = result_.all[id];
            auto& around = closed_around[id];
            if (region.parent && judges_loops()) {
                around = closed_around[*region.parent];
                const Region& outer = result_.all[*region.parent];
                const bool counts = is_loop(outer.region_kind) && outer.close;
                if (counts && around.size() < most_levels()) around.push_back(*region.parent);
            }
            if (is_loop(region.region_kind) && judges_loops()) check_number(region, around);
        }
    }

    /// Units stand one after the other.
    void check_units() {
        std::vector<std::optional<RegionId>> unit_around; // of each region
        for (const Region& region : result_.all) {
            auto& around = unit_around.emplace_back();
            if (region.parent) {
                const Region& outer = result_.all[*region.parent];
                const bool is_unit = outer.region_kind == RegionKind::unit && outer.close;
                around = is_unit ? region.parent : unit_around[*region.parent];
            }
            if (around && region.region_kind == RegionKind::unit && region.close)
                fault(Imbalance::nested_too_deep, region.open, result_.all[*around].open);
        }
    }

    void check_number(const Region& region, const std::vector<RegionId>& around) {
        if (region.close && around.size() >= most_levels())
            return fault(Imbalance::nested_too_deep, region.open, {});
        if (!has_numbers() || !region.number) return;
        const auto same = std::ranges::find_if(
            around, [&](RegionId id) { return result_.all[id].number == region.number; });
        if (region.close && same != around.end())
            fault(Imbalance::number_reused, region.open, result_.all[*same].open);
        else if (is_out_of_range(region))
            fault(Imbalance::number_out_of_range, region.open, {});
    }

    /// What is never closed and what closes nothing are one fault when they can be meant for each other: the
    /// number of one of them is wrong.
    void check_unpaired() {
        std::vector<RegionId> waiting; // loops never closed that open before the stray
        RegionId next = 0;
        for (const Stray& stray : strays_) {
            for (; next < result_.all.size() && is_before(result_.all[next].open, stray.close); ++next)
                if (!result_.all[next].close && is_loop(result_.all[next].region_kind))
                    waiting.push_back(next);
            const auto& close = std::get<RegionMark>(program_.effects[stray.close].what);
            if (!is_loop(close.region_kind) || waiting.empty()) {
                fault(Imbalance::never_opened, stray.close, {});
                continue;
            }
            check_pair(waiting.back(), stray);
            waiting.pop_back();
        }
        for (RegionId id = 0; id < result_.all.size(); ++id)
            if (!result_.all[id].close && !reported_.contains(id)) check_unclosed(id, {});
    }

    void check_pair(RegionId unclosed, const Stray& stray) {
        reported_.insert(unclosed);
        // DO1 DO1 END2 END1: the inner loop took the number of the outer one, and its END1.
        if (has_numbers() && stray.within && *stray.within != unclosed) {
            const Region& inner = result_.all[*stray.within];
            if (inner.close && inner.number == result_.all[unclosed].number)
                return fault(Imbalance::number_reused, inner.open, result_.all[unclosed].open);
        }
        check_unclosed(unclosed, stray.close);
    }

    void check_unclosed(RegionId id, std::optional<EffectId> meant) {
        const Region& region = result_.all[id];
        // A loop that lost its DO has no number; a number out of range is reported already.
        const bool reported =
            is_loop(region.region_kind) && has_numbers() && (!region.number || is_out_of_range(region));
        if (!reported) fault(Imbalance::never_closed, region.open, meant);
    }

    [[nodiscard]] bool has_numbers() const { return program_.control->limits.last_loop_number != 0; }
    [[nodiscard]] std::size_t most_levels() const {
        return static_cast<std::size_t>(program_.control->limits.loop_levels);
    }
    /// Nothing can be wrong with how loops stand in each other where neither levels nor numbers are limited.
    [[nodiscard]] bool judges_loops() const { return most_levels() != 0; }

    [[nodiscard]] bool is_out_of_range(const Region& region) const {
        const Limits& limits = program_.control->limits;
        return has_numbers() && region.number &&
               (*region.number < limits.first_loop_number || *region.number > limits.last_loop_number);
    }

    [[nodiscard]] bool is_before(EffectId a, EffectId b) const {
        return program_.effects[a].span.begin < program_.effects[b].span.begin;
    }

    void index_effects() {
        auto& index = result_.by_effect;
        for (RegionId id = 0; id < result_.all.size(); ++id) {
            const Region& region = result_.all[id];
            index.emplace_back(region.open, id);
            for (const EffectId part : region.parts) index.emplace_back(part, id);
            if (region.close) index.emplace_back(*region.close, id);
        }
        std::ranges::sort(index);
    }

    void fault(Imbalance what, EffectId effect, std::optional<EffectId> other) {
        result_.faults.push_back({what, effect, other});
    }

    const Program& program_;
    Regions result_;
    std::vector<RegionId> open_;
    std::map<Key, std::vector<std::size_t>> open_at_; ///< positions in open_
    /// Run over by the close of an outer region, own close not met yet, and that close.
    std::map<Key, std::vector<std::pair<RegionId, EffectId>>> crossed_;
    std::set<EffectId> crossing_closes_; ///< of outer regions whose crossing is certain
    std::vector<Stray> strays_;
    std::set<RegionId> reported_; ///< never closed, and reported with a stray close
};

} // namespace

bool Regions::holds(const Program& program, RegionId loop, Offset offset) const {
    const Region& region = all[loop];
    if (!region.close) return false;
    return offset >= program.effects[region.open].span.end &&
           offset < program.effects[*region.close].span.end;
}

std::optional<RegionId> Regions::with(EffectId effect) const {
    const auto found = std::ranges::lower_bound(by_effect, effect, {}, &std::pair<EffectId, RegionId>::first);
    return found != by_effect.end() && found->first == effect ? std::optional(found->second) : std::nullopt;
}

std::optional<RegionId> Regions::loop_around(const Program& program, Offset offset) const {
    // Regions are sorted by where they open, so the last one opened before the place, or one around it,
    // holds the place.
    const auto after = std::ranges::upper_bound(
        all, offset, {}, [&](const Region& p) { return program.effects[p.open].span.end; });
    if (after == all.begin()) return std::nullopt;
    std::optional<RegionId> id = static_cast<RegionId>(after - all.begin() - 1);
    while (id && !(is_loop(all[*id].region_kind) && holds(program, *id, offset)))
        id = Budget::allows() ? all[*id].closed_around : std::nullopt;
    return id;
}

std::optional<RegionId> Regions::entered(const Program& program, Offset from, Offset to) const {
    std::optional<RegionId> entered;
    for (auto id = loop_around(program, to); id && Budget::allows(); id = all[*id].closed_around)
        if (holds(program, *id, to) && !holds(program, *id, from)) entered = id;
    return entered;
}

Regions pair_regions(const Program& program) { return Pairing(program).run(); }

} // namespace maclint::flow
