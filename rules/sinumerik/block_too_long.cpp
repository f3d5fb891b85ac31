//! SIN116: blocks with more characters than the control reads.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule block_too_long{
    .code = "SIN116",
    .name = "block-too-long",
    .summary = "A block has more characters than the control reads",
    .why =
        "The control stops with an alarm at the block. No public document confirms the number of characters, "
        "or tells whether remarks count: they are not counted here.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages =
        {{"cure",
          "Block too long: it has more than {1} characters of code, the most that is known to be taken.",
          "Write it as several blocks."}},
    .bad = {{"sinumerik", R"nc(
DEF REAL WAY
WAY=R1+R2+R3+R4+R5+R6+R7+R8+R9+R10+R11+R12+R13+R14+R15+R16+R17+R18+R19+R20+R21+R22+R23+R24+R25+R26+R27+R28+R29+R30+R31+R32+R33+R34+R35+R36+R37+R38+R39+R40+R41+R42+R43+R44+R45+R46+R47+R48+R49+R50+R51+R52+R53+R54+R55+R56+R57+R58+R59+R60+R61+R62+R63+R64+R65+R66+R67+R68+R69+R70+R71+R72+R73+R74+R75+R76+R77+R78+R79+R80+R81+R82+R83+R84+R85+R86+R87+R88+R89+R90+R91+R92+R93+R94+R95+R96+R97+R98+R99+R100+R101+R102+R103+R104+R105+R106+R107+R108+R109+R110+R111+R112+R113+R114+R115+R116+R117+R118+R119+R120+R121+R122+R123+R124+R125+R126+R127+R128+R129+R130
G0 X=WAY
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
DEF REAL WAY
WAY=R1+R2+R3+R4+R5+R6+R7+R8+R9+R10 ; the first ten
WAY=WAY+R11+R12+R13+R14+R15+R16+R17+R18+R19+R20
G0 X=WAY
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12540", "block too long or too complex", false}},
    .sources = {"T: alarm 12540"},
    .check = SyntaxErrorKind::block_too_long,
};

} // namespace maclint::rules
