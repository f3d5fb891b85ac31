//! Pairs loops and choices with a stack, the way a control does when it meets DO and END.
#include "analyzer/flow/structure.hpp"

#include <algorithm>
#include <iterator>

namespace maclint::flow {
namespace {

bool is_loop(Construct construct) {
    return construct == Construct::while_loop || construct == Construct::endless_loop;
}

class Pairing {
  public:
    explicit Pairing(const Program& program)
        : program_(program) {}

    Structures run() {
        for_each_effect(program_, [this](EffectId id) { take(id); });
        for (const StructureId id : open_) never_closed(id);
        for (const StructureId id : crossed_) never_closed(id);
        std::ranges::sort(result_.faults, {}, &StructureFault::effect);
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
        case Structure::Part::middle:
        case Structure::Part::leave: divide(id, *structure); break;
        case Structure::Part::close: close(id, *structure); break;
        }
    }

    void open(EffectId id, const Structure& structure) {
        Paired paired{structure.construct, id, {}, {}, {}, 0, structure.number, structure.condition};
        if (!open_.empty()) {
            paired.parent = open_.back();
            paired.loop_level = result_.all[open_.back()].loop_level;
        }
        if (is_loop(structure.construct)) {
            ++paired.loop_level;
            check_number(id, paired);
        }
        open_.push_back(static_cast<StructureId>(result_.all.size()));
        result_.all.push_back(std::move(paired));
    }

    /// One cause, one fault: a level too many explains a number out of range or in use.
    void check_number(EffectId id, const Paired& paired) {
        const Limits& limits = program_.control->limits;
        if (paired.loop_level > limits.loop_levels) return fault(Imbalance::nested_too_deep, id, {});
        if (!paired.number || limits.last_loop_number == 0) return;
        const auto same = std::ranges::find_if(
            open_, [&](StructureId s) { return result_.all[s].number == paired.number; });
        if (same != open_.end()) return fault(Imbalance::number_reused, id, result_.all[*same].open);
        if (*paired.number < limits.first_loop_number || *paired.number > limits.last_loop_number)
            fault(Imbalance::number_out_of_range, id, {});
    }

    void divide(EffectId id, const Structure& structure) {
        const auto position = find_open(structure);
        if (!position) return fault(Imbalance::never_opened, id, {});
        result_.all[open_[*position]].parts.push_back(id);
    }

    void close(EffectId id, const Structure& structure) {
        if (close_crossed(id, structure)) return;
        const auto position = find_open(structure);
        if (!position) return fault(Imbalance::never_opened, id, {});
        const auto at = open_.begin() + static_cast<std::ptrdiff_t>(*position);
        result_.all[*at].close = id;
        crossed_.insert(crossed_.end(), at + 1, open_.end());
        for (auto inner = at + 1; inner != open_.end(); ++inner) crossing_close_.push_back(id);
        open_.erase(at, open_.end());
    }

    /// A close for a structure that an outer close has already run over: now the crossing is certain.
    bool close_crossed(EffectId id, const Structure& structure) {
        if (find_open(structure)) return false;
        const auto inner =
            std::ranges::find_if(crossed_, [&](StructureId s) { return matches(s, structure); });
        if (inner == crossed_.end()) return false;
        const auto close = crossing_close_.begin() + (inner - crossed_.begin());
        result_.all[*inner].close = id;
        fault(Imbalance::crossed, *close, result_.all[*inner].open);
        crossing_close_.erase(close);
        crossed_.erase(inner);
        return true;
    }

    [[nodiscard]] bool matches(StructureId open, const Structure& close) const {
        const Paired& paired = result_.all[open];
        // An END closes WHILE and DO alike; every other construct has a close of its own.
        const bool both_loops = is_loop(paired.construct) && is_loop(close.construct);
        return (both_loops || paired.construct == close.construct) && paired.number == close.number;
    }

    /// The innermost open structure that the close belongs to; a loop whose number the text lacks takes any.
    [[nodiscard]] std::optional<std::size_t> find_open(const Structure& close) const {
        for (std::size_t i = open_.size(); i-- > 0;)
            if (matches(open_[i], close)) return i;
        for (std::size_t i = open_.size(); i-- > 0;) {
            const Paired& paired = result_.all[open_[i]];
            if (is_loop(paired.construct) && is_loop(close.construct) && !paired.number) return i;
        }
        return std::nullopt;
    }

    void never_closed(StructureId id) {
        // A loop without a number has lost its DO: that is the fault to report, not the missing END.
        const Paired& paired = result_.all[id];
        const bool numbered = program_.control->limits.last_loop_number != 0;
        if (!numbered || paired.number || !is_loop(paired.construct))
            fault(Imbalance::never_closed, paired.open, {});
    }

    void fault(Imbalance what, EffectId effect, std::optional<EffectId> other) {
        result_.faults.push_back({what, effect, other});
    }

    const Program& program_;
    Structures result_;
    std::vector<StructureId> open_;
    std::vector<StructureId> crossed_; ///< run over by the close of an outer structure, own close not met yet
    std::vector<EffectId> crossing_close_; ///< for each of crossed_: that close
};

} // namespace

bool Structures::holds(const Program& program, StructureId loop, Offset place) const {
    const Paired& paired = all[loop];
    if (!paired.close) return false;
    return place >= program.effects[paired.open].span.end && place < program.effects[*paired.close].span.end;
}

std::optional<StructureId> Structures::loop_around(const Program& program, Offset place) const {
    // Structures are sorted by where they open, so the last one opened before the place, or one around it,
    // holds the place.
    const auto after = std::ranges::upper_bound(
        all, place, {}, [&](const Paired& p) { return program.effects[p.open].span.end; });
    if (after == all.begin()) return std::nullopt;
    std::optional<StructureId> id = static_cast<StructureId>(after - all.begin() - 1);
    while (id && !(is_loop(all[*id].construct) && holds(program, *id, place))) id = all[*id].parent;
    return id;
}

Structures pair_structures(const Program& program) { return Pairing(program).run(); }

} // namespace maclint::flow
