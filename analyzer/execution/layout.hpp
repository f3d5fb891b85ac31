//! The blocks of a program one after the other, as the control reads them.
#pragma once

#include "analyzer/flow/regions.hpp"
#include "analyzer/program/block_view.hpp"

#include <optional>
#include <vector>

namespace maclint::execution {

/// A block that is executed; its settings are kept here.
struct Step {
    BlockView block;
    std::vector<ModalSetting> settings;
};

/// Where something stands in the program: a step, and the effect in it that comes next.
struct Position {
    std::size_t step;
    std::optional<EffectId> effect; ///< nothing: the step has not begun
};

class Layout {
  public:
    explicit Layout(const Program& program, const flow::Regions& regions);

    [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
    /// The step of the label at which a search that begins in the step `from` stops.
    [[nodiscard]] std::optional<std::size_t> find(const Label& label, std::size_t from,
                                                  LabelSearch search) const;
    /// The step whose block holds the effect, which is one that can be executed.
    [[nodiscard]] std::size_t step_of(EffectId effect) const;
    /// What comes when the effect is done and does not jump.
    [[nodiscard]] Position after(EffectId effect) const;

    /// The region that the effect opens, divides, leaves or closes; nothing where it does none of these,
    /// or where the region has no end.
    [[nodiscard]] const flow::Region* region_of(EffectId effect) const;

  private:
    struct Within {
        std::size_t step;
        EffectId end;                  ///< one after the last of its slice
        std::optional<EffectId> guard; ///< around it
    };
    void index(Slice effects, std::size_t step, std::optional<EffectId> guard);

    const Program& program_;
    const flow::Regions& regions_;
    std::vector<Step> steps_;
    std::vector<std::optional<Within>> within_; ///< of every effect
};

} // namespace maclint::execution
