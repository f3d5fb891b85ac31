//! A copy of the model's tables, with the shop's facts in their place.
#include "cli/config/own_control.hpp"

namespace maclint::cli {

ControlModel OwnControl::with_facts(const ControlModel& base) const {
    ControlModel control = base;
    control.assumed = false;
    control.description = name_ + " (" + base.description + ")";
    control.limits = facts_.limits;
    control.functions = facts_.functions;
    if (facts_.block_if) control.has_block_if = *facts_.block_if;
    facts_.machine.apply_to(control);
    control.returns_within.clear();
    control.limits_at_most.reset();
    control.lathes.clear();
    return control;
}

const ControlModel& OwnControl::model() const {
    return made_
        .get([this] {
            Made made{with_facts(*base_), {}};
            for (const ControlModel* lathe : lathes_)
                made.model.lathes.push_back(
                    made.lathes.emplace_back(std::make_unique<const ControlModel>(with_facts(*lathe))).get());
            return made;
        })
        .model;
}

} // namespace maclint::cli
