//! Alarms of NCT controls.
#include "rules/alarms/tables.hpp"

namespace maclint::alarms {

std::span<const ControlAlarm> nct() {
    // clang-format off
    static constexpr ControlAlarm rows[] = {
    // number, titles by list (16i/18i/21i, 30i/0i-D, NCT), machine
    //  what brings it, what it is about, whether text shows it, what stands behind it, source
    {"3054", {"", "", "G31 INCORRECT STATE"}, both,
     "G31 under cutter compensation, a feed a revolution, scaling, mirror image, rotation or polar coordinates", program, sometimes, partly, "NCT-159; T"},
    {"3064", {"", "", "BAD MACRO STATEMENT"}, both,
     "bracket depth above five (and other syntax errors)", program, always, document, "NCT-188"},
    {"3070", {"", "", "NOT EXISTING BLOCK NO. P"}, both,
     "GOTO target block not found", program, always, document, "NCT-188"},
    {"3091", {"", "", "ERRONEOUS OPERATION WITH #"}, both,
     "operand of NOT/OR/XOR/AND does not fit 32 bits (and similar)", program, sometimes, document, "NCT-185"},
    {"4000+n", {"", "", "the text of the program"}, both,
     "the program itself: #3000=n shows 4000+n, cleared by RESET", program, sometimes, document, "SEED-002:545-626"},
    {"5000+n", {"", "", "the text of the program"}, both,
     "the program itself: #3006=n shows 5000+n and waits for START", program, sometimes, document, "SEED-002:627-639"},
    };
    // clang-format on
    return rows;
}

} // namespace maclint::alarms
