//! What exemptions hold back.
#pragma once

#include "rules/rule.hpp"

#include <functional>
#include <vector>

namespace maclint {

/// Those of the rule that are off.
[[nodiscard]] ExemptionBits off_in(const ExemptionChoice& choice, const Rule& rule);
/// What checks ask for these.
[[nodiscard]] std::vector<const Exemption*> exemptions_of(const Rule& rule, ExemptionBits chosen);

/// What a rule finds without some of its exemptions.
using FindWithout = std::function<std::vector<Finding>(ExemptionBits off)>;

/// What the rule finds only without exemptions besides those that are `off` anyway, with those that hold it
/// back: each of them by itself or, where none does, all together.
[[nodiscard]] std::vector<Finding> withheld_findings(const Rule& rule, ExemptionBits off,
                                                     const FindWithout& find);

} // namespace maclint
