//! Decoding by tables, and what gives an encoding away.
#include "analyzer/source/double_byte.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace maclint {
namespace {

constexpr char32_t replacement = 0xFFFD;
constexpr unsigned char first_lead = 0x81, first_trail = 0x40;

constexpr unsigned char to_byte(char c) { return static_cast<unsigned char>(c); }
constexpr bool is_between(unsigned char c, unsigned char first, unsigned char last) {
    return first <= c && c <= last;
}

constexpr bool is_shift_jis_lead(unsigned char c) {
    return is_between(c, 0x81, 0x9F) || is_between(c, 0xE0, 0xFC);
}
constexpr bool is_gbk_lead(unsigned char c) { return is_between(c, 0x81, 0xFE); }

char32_t from_row(std::u16string_view row, char trail) {
    const std::size_t at = to_byte(trail) - first_trail;
    return to_byte(trail) < first_trail || at >= row.size() ? replacement : row[at];
}

char32_t shift_jis_pair(unsigned char lead, char trail) {
    constexpr std::size_t gap = 0xE0 - 0xA0; // between the two ranges of first bytes
    const std::size_t row = lead - first_lead - (lead >= 0xE0 ? gap : 0U);
    return from_row(shift_jis_rows.at(row), trail);
}

char32_t single_byte(unsigned char c, Encoding encoding) {
    if (c < 0x80) return c;
    constexpr char32_t first_half_width = 0xFF61, euro = 0x20AC;
    if (encoding == Encoding::shift_jis && is_between(c, 0xA1, 0xDF)) return first_half_width + (c - 0xA1U);
    return encoding == Encoding::gbk && c == 0x80 ? euro : replacement;
}

/// The commonest characters of programs and lists of a workshop, and of Chinese.
constexpr std::u16string_view common_chinese =
    u"的一是不在有和中上下左右前后大小高低内外长宽深直径角度圆孔面槽刀具号工件加程序换钻铣车镗铰攻丝螺纹"
    u"粗精心点零原位置坐标系主轴转速进给冷却液开关启停止退回安全余量参数测补偿次第完成毛坯端弧循环子调用"
    u"始结束数据检查报警打倒平台夹自动手机床头尾旋测量长补清单序";

/// What one encoding makes of a text.
struct Sighting {
    bool fits = true;
    std::size_t pairs = 0;   ///< characters of two bytes
    std::size_t telling = 0; ///< of them, those that hardly any other encoding has
};

/// Signs between Japanese words, and the long vowel. As CP850 their first byte is a small u with two dots.
bool is_japanese_sign(unsigned char trail) {
    constexpr std::string_view trails = "\x40\x41\x42\x45\x5B\x5C\x5D\x60\x7C\x7E\x80";
    return trail >= 0x80 || trails.find(static_cast<char>(trail)) != std::string_view::npos;
}

/// Kana, signs, and words of several kanji.
bool tells_japanese(std::string_view pair, bool after_pair) {
    const unsigned char lead = to_byte(pair[0]);
    const unsigned char trail = to_byte(pair[1]);
    if (lead == 0x81) return is_japanese_sign(trail);
    if (lead == 0x82 || lead == 0x83) return trail >= 0x80 || after_pair;
    return after_pair && is_between(lead, 0x88, 0x9F);
}

template<class Tells>
Sighting look(std::string_view bytes, Encoding encoding, const Tells& tells) {
    Sighting sighting;
    bool after_pair = false;
    while (!bytes.empty() && sighting.fits) {
        const Character next = double_byte_character(bytes, encoding);
        if (next.value == replacement) sighting.fits = false;
        const bool is_pair = next.length == 2;
        if (is_pair) {
            ++sighting.pairs;
            sighting.telling += tells(bytes.substr(0, 2), next.value, after_pair) ? 1U : 0U;
        }
        after_pair = is_pair;
        bytes.remove_prefix(next.length);
    }
    return sighting;
}

} // namespace

Character double_byte_character(std::string_view bytes, Encoding encoding) {
    const unsigned char lead = to_byte(bytes.front());
    const bool is_lead = encoding == Encoding::shift_jis ? is_shift_jis_lead(lead) : is_gbk_lead(lead);
    if (!is_lead) return {single_byte(lead, encoding), 1};
    const char32_t pair = bytes.size() < 2 ? replacement
                          : encoding == Encoding::shift_jis
                              ? shift_jis_pair(lead, bytes[1])
                              : from_row(gbk_rows.at(lead - first_lead), bytes[1]);
    return pair == replacement ? Character{replacement, 1} : Character{pair, 2};
}

std::optional<Encoding> detect_double_byte(std::string_view bytes) {
    constexpr std::size_t enough_chinese = 2, one_of = 4;
    const Sighting chinese = look(bytes, Encoding::gbk, [](std::string_view, char32_t character, bool) {
        return common_chinese.find(static_cast<char16_t>(character)) != std::u16string_view::npos;
    });
    if (chinese.fits && chinese.telling >= enough_chinese && chinese.telling * one_of >= chinese.pairs)
        return Encoding::gbk;
    const Sighting japanese =
        look(bytes, Encoding::shift_jis, [](std::string_view pair, char32_t, bool after_pair) {
            return tells_japanese(pair, after_pair);
        });
    if (japanese.fits && japanese.telling > 0) return Encoding::shift_jis;
    return std::nullopt;
}

} // namespace maclint
