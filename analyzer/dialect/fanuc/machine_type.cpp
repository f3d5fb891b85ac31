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
};

struct Signs {
    bool mill = false;        ///< Y, G17, G19, G43, G49, G91, M6
    bool turning = false;     ///< G50 S, G96, G70-G73 P Q, G74 R, G76 P020060
    bool incremental = false; ///< U or W with X or Z elsewhere
    bool turret = false;      ///< T0101

    void take(const BlockWords& block) {
        turning |= (block.g50 && block.s) || (block.cycle && block.p && block.q && !block.z_or_r) ||
                   (block.threading && block.p_of_six && !block.z) ||
                   (block.pecking && block.r && !block.others);
    }
};

void take_word(char letter, std::string_view digits, BlockWords& block, Signs& signs) {
    const auto is_whole = [&] { return digits.find('.') == std::string_view::npos; };
    block.others |= letter != 'G' && letter != 'N' && letter != 'R';
    block.z |= letter == 'Z';
    block.r |= letter == 'R';
    switch (letter) {
    case 'Y': signs.mill = true; break;
    case 'G': {
        const double value = read_number(digits).value;
        signs.mill |= value == 17 || value == 19 || value == 43 || value == 91 || value == 49;
        signs.turning |= value == 96;
        block.g50 |= value == 50;
        block.cycle |= value >= 70 && value <= 73;
        block.pecking |= value == 74 || value == 75;
        block.threading |= value == 76;
        break;
    }
    case 'M': signs.mill |= read_number(digits).value == 6; break;
    case 'S': block.s = true; break;
    case 'P':
        block.p = is_whole();
        block.p_of_six = is_whole() && digits.size() == 6;
        break;
    case 'Q': block.q = is_whole(); break;
    case 'Z':
    case 'R': block.z_or_r = true; break;
    case 'U':
    case 'W': signs.incremental = true; break;
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
    block.others |= letter != 'R';
}

} // namespace

bool is_written_for_lathe(std::string_view text) {
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
    return !signs.mill && (signs.turning || (signs.turret && signs.incremental));
}

} // namespace maclint::fanuc
