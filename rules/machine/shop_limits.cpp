//! MAC587: numbers beyond what the shop allows on its machine.
#include "rules/machine/shop_limits_check.hpp"
#include "rules/machine_check.hpp"

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule shop_limits{
    .code = "MAC587",
    .name = "limit-exceeded",
    .summary =
        "A speed, a feed, a tool or a position beyond the limits that the configuration gives the machine",
    .why =
        "The machine turns or feeds no faster than it can, stops at the end of its travel, or takes the tool "
        "from a place that it does not have. Only the shop knows its limits: without them nothing is told.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"above", "Above the limit: {0} of '{1}' is {2}, and the configuration allows {3} at most.",
                  "Correct the number, or the limit '{4}' of the control."},
                 {"below",
                  "Below the limit: {0} of '{1}' is {2}, and the configuration demands {3} at least.",
                  "Correct the number, or the limit '{4}' of the control."}},
    .bad = {Example("fanuc", R"nc(
O9586(PLATE)
G90 G17 G21 G54
T1 M6
S15000 M3
G0 X0 Y0
G43 H1 Z50.
G1 Z-5. F200.
X620.
G0 Z50.
M30
)nc")
                .on_control_with(R"("limits": {"speed": 12000, "X": [-10, 600]})")},
    .good = {Example("fanuc", R"nc(
O9586(PLATE)
G90 G17 G21 G54
T1 M6
S12000 M3
G0 X0 Y0
G43 H1 Z50.
G1 Z-5. F200.
X600.
G0 Z50.
M30
)nc")
                 .on_control_with(R"("limits": {"speed": 12000, "X": [-10, 600]})"),
             {"fanuc", R"nc(
O9586(NOBODY HAS NAMED A LIMIT)
G90 G17 G21 G54
T1 M6
S40000 M3
G43 H1 Z50.
G1 Z-5. F200.
G0 Z50.
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

void check(const MachineStep& at, Reporter& reporter) {
    if (at.analysis.control().demands == nullptr) return;
    look_for_broken_limits(at, at.analysis.control().demands->limits, reporter);
}

} // namespace
} // namespace maclint::rules
