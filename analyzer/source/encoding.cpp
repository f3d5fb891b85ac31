//! Character encodings: a strict UTF-8 decoder, the Windows-1252 table and the escapes of `printable`.
#include "analyzer/source/encoding.hpp"

#include "analyzer/source/double_byte.hpp"
#include "analyzer/source/encode.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace maclint {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr char32_t replacement = 0xFFFD;

constexpr unsigned char to_byte(char c) { return static_cast<unsigned char>(c); }
constexpr bool is_ascii(char c) { return to_byte(c) < 0x80; }
constexpr bool is_continuation(char c) { return (to_byte(c) & 0xC0) == 0x80; }

/// Number of ASCII bytes that `bytes` begins with, eight at a time: nearly all NC text is ASCII.
std::size_t ascii_prefix(std::string_view bytes) {
    std::size_t length = 0;
    for (; length + 8 <= bytes.size(); length += 8) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, bytes.data() + length, 8);
        if ((eight & 0x8080808080808080U) != 0) break;
    }
    while (length < bytes.size() && is_ascii(bytes[length])) ++length;
    return length;
}

/// What a lead byte announces: the length of the sequence and the limits of the second byte, which is where
/// overlong forms, surrogates and values above U+10FFFF show (Unicode 15, table 3-7).
struct Lead {
    std::size_t length;
    unsigned char second_min, second_max;
};

constexpr Lead classify_lead(unsigned char lead) {
    if (lead < 0x80) return {1, 0, 0};
    if (lead < 0xC2) return {0, 0, 0};
    if (lead < 0xE0) return {2, 0x80, 0xBF};
    if (lead == 0xE0) return {3, 0xA0, 0xBF};
    if (lead == 0xED) return {3, 0x80, 0x9F};
    if (lead < 0xF0) return {3, 0x80, 0xBF};
    if (lead == 0xF0) return {4, 0x90, 0xBF};
    if (lead < 0xF4) return {4, 0x80, 0xBF};
    if (lead == 0xF4) return {4, 0x80, 0x8F};
    return {0, 0, 0};
}

/// Length of the well-formed sequence that `bytes` begins with, 0 when there is none.
std::size_t sequence_length(std::string_view bytes) {
    const Lead lead = classify_lead(to_byte(bytes.front()));
    if (lead.length <= 1) return lead.length;
    if (bytes.size() < lead.length) return 0;
    if (to_byte(bytes[1]) < lead.second_min || to_byte(bytes[1]) > lead.second_max) return 0;
    const auto tail = bytes.substr(2, lead.length - 2);
    return std::all_of(tail.begin(), tail.end(), is_continuation) ? lead.length : 0;
}

/// The character of a well-formed sequence.
char32_t decode(std::string_view sequence) {
    if (sequence.size() == 1) return to_byte(sequence.front());
    char32_t character = to_byte(sequence.front()) & (0xFFU >> (sequence.size() + 1));
    for (const char c : sequence.substr(1)) character = (character << 6U) | (to_byte(c) & 0x3FU);
    return character;
}

void append_utf8(std::string& out, char32_t character) {
    const auto put = [&out](char32_t value) { out.push_back(static_cast<char>(value)); };
    if (character < 0x80) {
        put(character);
    } else if (character < 0x800) {
        put(0xC0U | (character >> 6U));
        put(0x80U | (character & 0x3FU));
    } else {
        put(0xE0U | (character >> 12U));
        put(0x80U | ((character >> 6U) & 0x3FU));
        put(0x80U | (character & 0x3FU));
    }
}

/// Bytes 0x80 to 0x9F; the five that Windows leaves open are the C1 controls (WHATWG Encoding, index
/// windows-1252).
constexpr std::array<char16_t, 32> windows_1252_high = {
    0x20AC, 0x0081, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0x008D, 0x017D, 0x008F, 0x0090, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x009D, 0x017E, 0x0178,
};

char32_t decode_windows_1252(char c) {
    const unsigned char value = to_byte(c);
    return value >= 0x80 && value < 0xA0 ? windows_1252_high.at(value - 0x80U) : value;
}

struct Range {
    char32_t first, last;
};

/// Characters that steer a terminal, reorder the text around them, cannot be seen or are none (Unicode 15,
/// section 23.7).
constexpr std::array escaped_ranges = {
    Range{0x0000, 0x0008},   // C0 controls; the tab stays
    Range{0x000A, 0x001F},   // C0 controls
    Range{0x007F, 0x009F},   // DEL and the C1 controls
    Range{0x061C, 0x061C},   // Arabic letter mark (bidirectional)
    Range{0x200B, 0x200F},   // zero width, left-to-right and right-to-left marks
    Range{0x2028, 0x202E},   // line and paragraph separators, bidirectional embeddings and overrides
    Range{0x2060, 0x206F},   // invisible operators, bidirectional isolates
    Range{0xFDD0, 0xFDEF},   // noncharacters
    Range{0xFEFF, 0xFEFF},   // byte order mark
    Range{0xFFF9, 0xFFFB},   // interlinear annotation
    Range{0xE0000, 0xE007F}, // tags
};

/// The last two of each plane are noncharacters, too.
bool ends_plane(char32_t character) { return (character & 0xFFFEU) == 0xFFFEU; }

bool needs_escape(char32_t character) {
    return ends_plane(character) ||
           std::any_of(escaped_ranges.begin(), escaped_ranges.end(),
                       [=](Range range) { return range.first <= character && character <= range.last; });
}

/// Whether every character is ASCII that can be seen, as in nearly all texts.
bool is_plain(std::string_view bytes) {
    return std::ranges::all_of(bytes, [](char c) { return c >= ' ' && c < '\x7F'; });
}

void append_hexadecimal(std::string& out, char32_t value, std::size_t least_digits) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string reversed;
    for (; value != 0 || reversed.size() < least_digits; value >>= 4U)
        reversed.push_back(digits[value & 0xFU]);
    out.append(reversed.rbegin(), reversed.rend());
}

void append_escape(std::string& out, char32_t character) {
    switch (character) {
    case U'\n': out += "\\n"; return;
    case U'\r': out += "\\r"; return;
    default: break;
    }
    if (character < 0x100) {
        out += "\\x";
        append_hexadecimal(out, character, 2);
        return;
    }
    out += "\\u{";
    append_hexadecimal(out, character, 4);
    out += '}';
}

/// Calls `visit(sequence, character)` for every character; a byte that belongs to none comes alone as U+FFFD.
template<class Visitor>
void for_each_character(std::string_view bytes, const Visitor& visit) {
    while (!bytes.empty()) {
        const std::size_t length = sequence_length(bytes);
        const auto sequence = bytes.substr(0, std::max<std::size_t>(length, 1));
        visit(sequence, length == 0 ? replacement : decode(sequence));
        bytes.remove_prefix(sequence.size());
    }
}

} // namespace

std::string_view name_of(Encoding encoding) {
    constexpr std::array<std::string_view, 4> names = {"utf-8", "windows-1252", "shift-jis", "gbk"};
    return names.at(static_cast<std::size_t>(encoding));
}

std::string_view registered_name_of(Encoding encoding) {
    constexpr std::array<std::string_view, 4> names = {"UTF-8", "windows-1252", "Shift_JIS", "GBK"};
    return names.at(static_cast<std::size_t>(encoding));
}

Encoding detect_encoding(std::string_view bytes) {
    while (true) {
        bytes.remove_prefix(ascii_prefix(bytes));
        if (bytes.empty()) return Encoding::utf8;
        const std::size_t length = sequence_length(bytes);
        if (length == 0) return Encoding::windows_1252;
        bytes.remove_prefix(length);
    }
}

std::size_t byte_order_mark_length(std::string_view bytes) {
    return bytes.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
}

std::string to_utf8(std::string_view bytes, Encoding encoding) {
    if (ascii_prefix(bytes) == bytes.size()) return std::string(bytes);
    std::string out;
    out.reserve(bytes.size() + bytes.size() / 4);
    if (encoding == Encoding::windows_1252) {
        for (const char c : bytes) append_utf8(out, decode_windows_1252(c));
        return out;
    }
    if (encoding == Encoding::shift_jis || encoding == Encoding::gbk) {
        while (!bytes.empty()) {
            const std::size_t plain = ascii_prefix(bytes);
            out += bytes.substr(0, plain);
            bytes.remove_prefix(plain);
            if (bytes.empty()) break;
            const Character next = double_byte_character(bytes, encoding);
            append_utf8(out, next.value);
            bytes.remove_prefix(next.length);
        }
        return out;
    }
    for_each_character(bytes, [&out](std::string_view sequence, char32_t character) {
        if (character == replacement) {
            append_utf8(out, replacement);
        } else {
            out += sequence;
        }
    });
    return out;
}

Character first_character(std::string_view utf8) {
    const std::size_t length = classify_lead(to_byte(utf8.front())).length;
    return {decode(utf8.substr(0, length)), length};
}

std::size_t utf16_length(std::string_view bytes, Encoding encoding) {
    if (encoding == Encoding::windows_1252) return bytes.size();
    const std::size_t plain = ascii_prefix(bytes);
    std::size_t units = plain;
    for_each_character(bytes.substr(plain), [&units](std::string_view, char32_t character) {
        units += character < 0x10000 ? 1U : 2U;
    });
    return units;
}

std::size_t character_begin(std::string_view bytes, std::size_t offset, Encoding encoding) {
    if (encoding == Encoding::windows_1252 || offset >= bytes.size()) return offset;
    constexpr std::size_t most_continuations = 3;
    std::size_t begin = offset;
    while (begin > 0 && offset - begin < most_continuations && is_continuation(bytes[begin])) --begin;
    // A byte that belongs to no character stands for one of its own.
    return begin + sequence_length(bytes.substr(begin)) > offset ? begin : offset;
}

std::string printable(std::string_view utf8) {
    if (is_plain(utf8)) return std::string(utf8);
    std::string out;
    out.reserve(utf8.size());
    for_each_character(utf8, [&out](std::string_view sequence, char32_t character) {
        if (needs_escape(character)) {
            append_escape(out, character);
        } else if (character == replacement) {
            append_utf8(out, replacement);
        } else {
            out += sequence;
        }
    });
    return out;
}

std::string printable_json(std::string_view json) {
    constexpr char32_t first_of_two = 0x10000, high = 0xD800, low = 0xDC00, half = 0x400;
    if (std::ranges::all_of(json, [](char c) { return c > '\0' && c < '\x7F'; })) return std::string(json);
    std::string out;
    out.reserve(json.size());
    const auto append = [&](char32_t unit) {
        out += "\\u";
        append_hexadecimal(out, unit, 4);
    };
    for_each_character(json, [&](std::string_view sequence, char32_t character) {
        // Line feeds between the values are layout; in strings they are escaped already.
        if (character < U' ' || !needs_escape(character)) {
            out += sequence;
        } else if (character < first_of_two) {
            append(character);
        } else {
            append(high + (character - first_of_two) / half);
            append(low + (character - first_of_two) % half);
        }
    });
    return out;
}

std::size_t utf8_length(char32_t character) {
    if (character < 0x80) return 1;
    if (character < 0x800) return 2;
    return character < 0x10000 ? 3 : 4;
}

std::optional<std::string> encode(std::string_view utf8, Encoding encoding) {
    if (encoding == Encoding::utf8) return std::string(utf8);
    std::string bytes;
    while (!utf8.empty()) {
        const Character next = first_character(utf8);
        const auto* high = std::ranges::find(windows_1252_high, next.value);
        const bool is_of_windows = encoding == Encoding::windows_1252;
        if (next.value < 0x80 || (is_of_windows && next.value >= 0xA0 && next.value <= 0xFF))
            bytes += static_cast<char>(next.value);
        else if (is_of_windows && high != windows_1252_high.end())
            bytes += static_cast<char>(0x80 + (high - windows_1252_high.begin()));
        else
            return std::nullopt;
        utf8.remove_prefix(next.length);
    }
    return bytes;
}

} // namespace maclint
