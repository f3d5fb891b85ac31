//! MAC533: a profile that its cycle cannot turn from where the tool stands.
#include "rules/machine/profile_check.hpp"

namespace maclint::rules {

extern const Rule profile_cannot_be_turned{
    .code = "MAC533",
    .name = "profile-cannot-be-turned",
    .summary = "A roughing cycle begins inside the stock, has its allowance on the wrong side, or a profile "
               "that goes back",
    .why = "The cycle takes its first pass from where the tool stands, at rapid traverse: inside the stock "
           "it runs into the work. A profile that goes back is cut through in one pass, or stops the "
           "control.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"inside",
                  "Start inside the stock: {0} begins at {1}{2}, and its profile goes from {1}{3} to {1}{4}.",
                  "Begin outside the stock, or correct the profile."},
                 {"back",
                  "Profile that goes back: '{0}' turns around on the way of the profile of {1}, which begins "
                  "along one axis and so takes no pockets.",
                  "Correct the point, or write both axes into the first block where the control takes "
                  "pockets."},
                 {"side",
                  "Allowance on the wrong side: {0} begins at X{1}, {2} its profile, and U{3} leaves it "
                  "{4}.",
                  "Change the sign of U, or the start."}},
    .bad = {{"fanuc", R"nc(
O9533(TURN)
G21 G40 G97 G99
T0101
G0 X42. Z2.
G71 U2. R0.5
G71 P10 Q20 U0.4 W0.1 F0.25
N10 G0 X20.
G1 Z-10.
X46.
Z-30.
N20 X52.
M30
)nc"},
            {"fanuc", R"nc(
O9533(TURN A NECK)
G21 G40 G97 G99
T0101
G0 X54. Z2.
G71 U2. R0.5
G71 P10 Q20 U0.4 W0.1 F0.25
N10 G0 X20.
G1 Z-10.
X46.
X40. Z-20.
Z-30.
X50.
N20 G0 X54.
M30
)nc"},
            {"fanuc", R"nc(
O9533(BORE)
G21 G40 G97 G99
T0101
G0 X17. Z2.
G71 U2. R0.5
G71 P10 Q20 U0.4 W0.1 F0.25
N10 G0 X30.
G1 Z-10.
X22.
Z-30.
N20 X18.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9533(TURN A NECK, FROM A BLOCK WITH BOTH AXES; RETREAT BY U)
G21 G40 G97 G99
T0101
G0 X46. Z2.
G71 U2. R0.5
G71 P10 Q20 U0.4 W0.1 F0.25
N10 G0 X20. Z2.
G1 Z-10.
X46.
X40. Z-20.
Z-30.
N20 U7.
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check_profile},
};

} // namespace maclint::rules
