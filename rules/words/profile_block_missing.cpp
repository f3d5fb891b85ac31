//! MAC338: a cycle names blocks that are not there, or not such as it can work with.

#include "rules/words/profile.hpp"

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule profile_block_missing{
    .code = "MAC338",
    .name = "profile-block-missing",
    .summary = "A cycle names blocks that are missing, stand twice, or hold what it cannot take",
    .why = "A roughing cycle reads its profile between two sequence numbers. Where a number is mistyped, or "
           "stands twice after a part was copied, the control stops with the tool at the work, or turns "
           "another profile.",
    .severity = Severity::error,
    .precision = Precision::high,
    .also = "MAC460",
    .messages = {{"missing", "Missing block: '{0}' of {1} names N{2}, and this program has none.",
                  "Correct the number, or give the block its N."},
                 {"twice",
                  "Block named twice: '{0}' of {1} names N{2}, which stands {3} times in this program.",
                  "Give each block a number of its own."},
                 {"order", "Profile that ends before it begins: N{2} of '{0}' stands before N{3}.",
                  "Exchange the two numbers."},
                 {"behind_end",
                  "Block behind the program's end: '{0}' of {1} names N{2}, which stands behind the {3} of "
                  "line {4}.",
                  "Move the block to where the cycle reads it."},
                 {"first", "Profile of {1} that begins without {3}: its first block, N{2}, has none.",
                  "Write one of them into that block."},
                 {"inside", "Word '{0}' between N{2} and N{3}, where {1} reads its profile: {4}.",
                  "Move it out of the profile."}},
    .bad = {{"fanuc", R"nc(
O9338(TURN)
G21 G40 G99
T0101
G50 S2000
G96 S180 M3
G0 X52. Z2.
G71 U2. R0.5
G71 P10 Q30 U0.4 W0.1 F0.25
N10 G0 X20.
G1 Z-10.
N20 X52.
M30
)nc"},
            {"fanuc", R"nc(
O9338(TURN)
G21 G40 G99
T0101
G50 S2000
G96 S180 M3
G0 X52. Z2.
G71 U2. R0.5
G71 P10 Q20 U0.4 W0.1 F0.25
G0 X150. Z120.
M30
N10 G0 X20.
G1 Z-10.
N20 X52.
)nc"}},
    .good = {{"fanuc", R"nc(
O9338(TURN)
G21 G40 G99
T0101
G50 S2000
G96 S180 M3
G0 X52. Z2.
G71 U2. R0.5
G71 P10 Q20 U0.4 W0.1 F0.25
N10 G0 X20.
G1 Z-10.
N20 X52.
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "063", "SEQUENCE NUMBER NOT FOUND", true, "missing"},
               {"FANUC 30i/0i-D", "063", "THE BLOCK OF A SPECIFIED SEQUENCE NUMBER IS NOT FOUND", true,
                "missing"},
               {"FANUC 16i/18i/21i", "065", "ILLEGAL COMMAND IN G71-G73", true, "first"},
               {"FANUC 30i/0i-D", "065", "G00/G01 IS NOT IN THE FIRST BLOCK OF SHAPE PROGRAM", true, "first"},
               {"FANUC 16i/18i/21i", "066", "IMPROPER G-CODE IN G71-G73", true, "inside"},
               {"FANUC 30i/0i-D", "325", "UNAVAILABLE COMMAND IS IN SHAPE PROGRAM", true, "inside"}},
    .sources = {"GH-ALM", "BLOG-MRC: no number twice", "T"},
    .check = RowCheck{.says = RowStatement::encloses, .check = &check},
};

namespace {

void check(const RowOfBlock& block, Reporter& reporter) { look_at_profile(block, reporter); }

} // namespace
} // namespace maclint::rules
