//! Counts what only mills and only lathes have, in the first part of a text.
#include "analyzer/dialect/fanuc/machine_type.hpp"

#include "analyzer/dialect/fanuc/lexer.hpp"
#include "analyzer/dialect/numbers.hpp"

#include <cstddef>

namespace maclint::fanuc {
namespace {

constexpr std::size_t looked_at = 64 * 1024;

/// The words of one block that tell.
struct BlockWords {
    bool g50 = false, cycle = false, s = false;
    bool p = false, q = false; ///< whole numbers, as those of blocks are
    bool z_or_r = false;       ///< where G73 of a mill drills to
    bool pecking = false;      ///< G74, G75
    bool threading = false;    ///< G76
    bool p_of_six = false;     ///< P020060: passes, chamfer and angle of a thread
    bool z = false, r = false;
    bool others = false; ///< but G, N and R

    bool g92 = false, g32 = false, g33 = false;
    bool g90 = false, move = false;
    bool turning_a = false; ///< G90, G94: a turning cycle of A where axes stand beside it
    bool turning_b = false; ///< G77 to G79
    bool turning_c = false; ///< G20, G21, G24: as G90 of A
    bool feed_a = false;    ///< G98, G99
    bool feed_bc = false;   ///< G94, G95
    bool unit_c = false;    ///< G70, G71
    bool hole = false;      ///< G80 to G89
    bool own_u = false;     ///< G04, G10, G71 to G76: U and W mean something of their own
    bool x_or_z = false, u_or_w = false, f = false;
};

struct Signs {
    bool mill = false;          ///< Y, G17, G19, G43, G49, M6
    bool distance = false;      ///< G91, which system A has not
    bool absolute_move = false; ///< G90 beside G00 to G03: no turning cycle of A
    bool turning = false;       ///< G50 S, G96, G70-G73 P Q, G74 R, G76 P020060
    bool surface_speed = false;
    bool incremental = false;             ///< U or W with X or Z elsewhere
    bool turret = false;                  ///< T0101
    bool a = false, b = false, c = false; ///< marks of the G code systems, fanuc-lathe-answers.md section 1

    void take(const BlockWords& block) {
        turning |= (block.g50 && block.s) || (block.cycle && block.p && block.q && !block.z_or_r) ||
                   (block.threading && block.p_of_six && !block.z) ||
                   (block.pecking && block.r && !block.others);
        const bool axes = block.x_or_z || block.u_or_w;
        const bool profile = block.p && block.q;
        absolute_move |= block.g90 && block.move;
        a |= (block.g50 && block.s) || (block.feed_a && !block.hole) || (block.u_or_w && !block.own_u) ||
             (axes && block.f && (block.g92 || block.turning_a)) || (axes && block.g32);
        b |= (block.g92 && block.s && !axes) || (block.feed_bc && !axes) ||
             (block.turning_b && axes && !profile) || (block.g33 && axes);
        c |= (block.unit_c && !axes && !block.p && !block.r) || (block.turning_c && axes && block.f);
    }

    /// A bare G90 tells nothing: it stands in the first line of lathes of all systems.
    [[nodiscard]] char system() const {
        if (a) return 'A';
        if (c) return 'C';
        return b ? 'B' : 'A';
    }
};

void take_code(double code, BlockWords& block, Signs& signs) {
    const auto is = [&](double first, double last) { return code >= first && code <= last; };
    signs.mill |= code == 17 || code == 19 || code == 43 || code == 49;
    signs.distance |= code == 91;
    signs.surface_speed |= code == 96;
    block.g50 |= code == 50;
    block.cycle |= is(70, 73);
    block.pecking |= is(74, 75);
    block.threading |= code == 76;
    block.g92 |= code == 92;
    block.g32 |= code == 32;
    block.g33 |= code == 33;
    block.g90 |= code == 90;
    block.move |= is(0, 3);
    block.turning_a |= code == 90 || code == 94;
    block.turning_b |= is(77, 79);
    block.turning_c |= is(20, 21) || code == 24;
    block.feed_a |= is(98, 99);
    block.feed_bc |= is(94, 95);
    block.unit_c |= is(70, 71);
    block.hole |= is(80, 89);
    block.own_u |= code == 4 || code == 10 || is(71, 76);
}

void take_word(char letter, std::string_view digits, BlockWords& block, Signs& signs) {
    const auto is_whole = [&] { return digits.find('.') == std::string_view::npos; };
    block.others |= letter != 'G' && letter != 'N' && letter != 'R';
    block.z |= letter == 'Z';
    block.r |= letter == 'R';
    block.x_or_z |= letter == 'X' || letter == 'Z';
    switch (letter) {
    case 'Y': signs.mill = true; break;
    case 'G': take_code(read_number(digits).value, block, signs); break;
    case 'M': signs.mill |= read_number(digits).value == 6; break;
    case 'S': block.s = true; break;
    case 'F': block.f = true; break;
    case 'P':
        block.p = is_whole();
        block.p_of_six = is_whole() && digits.size() == 6;
        break;
    case 'Q': block.q = is_whole(); break;
    case 'Z':
    case 'R': block.z_or_r = true; break;
    case 'U':
    case 'W':
        signs.incremental = true;
        block.u_or_w = true;
        break;
    case 'T': signs.turret |= digits.size() == 4; break;
    default: break;
    }
}

/// `Y#25`, `Z[#1+2]`: of what is computed the address tells.
void take_computed_word(char letter, BlockWords& block, Signs& signs) {
    signs.mill |= letter == 'Y';
    block.z_or_r |= letter == 'Z' || letter == 'R';
    block.z |= letter == 'Z';
    block.r |= letter == 'R';
    block.f |= letter == 'F';
    block.s |= letter == 'S';
    block.x_or_z |= letter == 'X' || letter == 'Z';
    block.u_or_w |= letter == 'U' || letter == 'W';
    block.others |= letter != 'R';
}

Signs signs_in(std::string_view text) {
    text = text.substr(0, looked_at);
    Signs signs;
    BlockWords block;
    for (Offset at = 0; at < text.size() && !signs.mill;) {
        const char c = text[at];
        if (c == '(') {
            at = after_comment(text, at);
            continue;
        }
        ++at;
        if (ends_block(c)) {
            signs.take(block);
            block = {};
            continue;
        }
        const char letter = to_capital(c);
        if (letter < 'A' || letter > 'Z') continue;
        const Offset value = at;
        while (at < text.size() &&
               (is_digit(text[at]) || text[at] == '.' || text[at] == '-' || is_blank(text[at])))
            ++at;
        std::string_view digits = text.substr(value, at - value);
        while (!digits.empty() && is_blank(digits.front())) digits.remove_prefix(1);
        while (!digits.empty() && is_blank(digits.back())) digits.remove_suffix(1);
        const bool address = value < 2 || !is_letter(text[value - 2]); // not the end of a name or a function
        if (!digits.empty())
            take_word(letter, digits, block, signs);
        else if (address && at < text.size() && (text[at] == '#' || text[at] == '['))
            take_computed_word(letter, block, signs);
    }
    signs.take(block);
    return signs;
}

} // namespace

MachineOfText machine_of(std::string_view text, Machine machine) {
    const Signs signs = signs_in(text);
    const char system = signs.system();
    const bool has_distance_code = signs.distance || signs.absolute_move;
    if (machine == Machine::lathe) return {system, {true, has_distance_code}};
    if (signs.mill) return {no_lathe, {true, has_distance_code}};
    // What turns in A alone does not tell in the others, and a mill has G94 and G92 S, too.
    const bool turns = system == 'A'
                           ? signs.turning || signs.surface_speed || (signs.turret && signs.incremental)
                           : signs.turret || signs.surface_speed;
    if (!turns || (system == 'A' && signs.distance)) return {no_lathe, {false, has_distance_code}};
    return {system, {true, has_distance_code}};
}

} // namespace maclint::fanuc
