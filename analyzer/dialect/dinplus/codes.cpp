//! What G and M codes do beyond setting a modal group.
#include "analyzer/dialect/dinplus/tables.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::dinplus {
namespace {

constexpr std::uint16_t cycle = moves | block_words;

// clang-format off
constexpr CodeFact facts[] = {
    {'G',   0,   3, moves | sets_group,                "l.12254, l.12341, l.12370"},
    {'G',   4,   4, synchronises,                      "l.18038: F is the dwell, no feed"},
    {'G',  12,  13, moves | sets_group,                "l.12421"},
    {'G',  14,  14, moves | approaches,                "l.12287"},
    {'G',  15,  15, moves,                             "l.23226: positions a rotary axis"},
    {'G',  16,  16, sets_group | off_by_word,          "l.23206", "Q", 0},
    {'G',  17,  19, sets_group,                        "l.23169-23181"},
    {'G',  30,  30, sets_group | off_by_word,          "l.20957, l.21019", "Q", 0},
    {'G',  31,  31, cycle,                             "l.14637"},
    {'G',  32,  33, moves,                             "l.14808, l.14904"},
    {'G',  35,  36, moves,                             "l.14975, l.15582"},
    {'G',  38,  38, cycle,                             "l.15100"},
    {'G',  40,  42, sets_group,                        "l.12673, l.12692"},
    {'G',  51,  51, sets_group,                        "l.12750"},
    {'G',  53,  56, sets_group,                        "l.12777, l.12793"},
    {'G',  59,  59, sets_group,                        "l.12822"},
    {'G',  67,  67, block_words,                       "l.18029"},
    {'G',  71,  75, cycle,                             "l.15623-15907"},
    {'G',  81,  83, moves,                             "l.20407-20495"},
    {'G',  85,  88, moves,                             "l.15226, l.20551-20630"},
    {'G',  93,  95, sets_group | feed_word,            "l.12532-12575"},
    {'G',  96,  97, sets_group | speed_word,           "l.12596, l.12628"},
    {'G', 100, 103, moves,                             "l.16365-16463"},
    {'G', 110, 113, moves,                             "l.16535-16628"},
    {'G', 193, 193, sets_group | feed_word,            "l.12532"},
    {'G', 195, 195, sets_group | feed_word,            "l.12575"},
    {'G', 196, 197, sets_group | speed_word,           "l.12596, l.12628"},
    {'G', 293, 293, sets_group | feed_word,            "l.12532"},
    {'G', 295, 295, sets_group | feed_word,            "l.12575"},
    {'G', 296, 297, sets_group | speed_word,           "l.12596, l.12628"},
    {'G', 350, 352, moves,                             "l.15022, l.20656, l.20684"},
    {'G', 393, 393, sets_group | feed_word,            "l.12532"},
    {'G', 395, 395, sets_group | feed_word,            "l.12575"},
    {'G', 396, 397, sets_group | speed_word,           "l.12596, l.12628"},
    {'G', 701, 701, moves,                             "l.12272"},
    {'G', 740, 748, moves,                             "l.13641, l.15977-16177, l.21574"},
    {'G', 764, 788, moves,                             "l.21170-22250"},
    {'G', 791, 794, moves,                             "l.16746-16911"},
    {'G', 797, 797, cycle,                             "l.16993"},
    {'G', 798, 798, moves,                             "l.17087"},
    {'G', 799, 804, cycle,                             "l.16244, l.17901, l.23814, l.23873"},
    {'G', 806, 806, cycle,                             "l.23902"},
    {'G', 808, 809, moves,                             "l.14331, l.23931"},
    {'G', 810, 810, cycle,                             "l.13155"},
    {'G', 820, 820, cycle,                             "l.13272"},
    {'G', 830, 830, cycle,                             "l.13386"},
    {'G', 835, 835, cycle,                             "l.13471"},
    {'G', 840, 848, cycle,                             "l.17130-17728, l.23432-23543"},
    {'G', 851, 859, moves,                             "l.15191-15516"},
    {'G', 860, 860, cycle,                             "l.13558"},
    {'G', 869, 870, cycle,                             "l.13708, l.13799"},
    {'G', 890, 891, cycle,                             "l.13835, l.14158"},
    {'G', 895, 895, cycle,                             "l.13975"},
    {'G', 909, 909, synchronises,                      "l.18135"},
    {'G', 910, 914, moves | synchronises,              "l.22275-22344"},
    {'G', 916, 917, moves | synchronises,              "l.20276, l.20326"},
    {'G', 920, 921, sets_group,                        "l.18155, l.18161"},
    {'G', 923, 923, moves,                             "l.14958"},
    {'G', 980, 981, sets_group,                        "l.18391, l.18395"},
    {'M',   0,   1, pauses | synchronises,             "l.20013-20014"},
    {'M',  30,  30, ends | synchronises,               "l.20016"},
    {'M',  99,  99, restarts | synchronises,           "l.20021-20025"},
};
// clang-format on

} // namespace

const CodeFact* find_code(char letter, double code) {
    if (code != std::floor(code)) return nullptr;
    const auto* row = std::ranges::find_if(facts, [&](const CodeFact& fact) {
        return fact.letter == letter && fact.first <= code && code <= fact.last;
    });
    return row == std::end(facts) ? nullptr : row;
}

} // namespace maclint::dinplus
