//! A copy of the model's tables, with the shop's facts in their place.
#include "cli/config/own_control.hpp"

namespace maclint::cli {

ControlModel OwnControl::with_facts(const ControlModel& base) const {
    ControlModel control = base;
    control.assumed = false;
    control.description = name_ + " (" + base.description + ")";
    control.limits = facts_.limits;
    control.functions = facts_.functions;
    control.lathe = nullptr;
    return control;
}

const ControlModel& OwnControl::model() const {
    return made_
        .get([this] {
            Made made{with_facts(*base_), nullptr};
            if (lathe_ != nullptr) made.lathe = std::make_unique<const ControlModel>(with_facts(*lathe_));
            made.model.lathe = made.lathe.get();
            return made;
        })
        .model;
}

} // namespace maclint::cli
