//! Content sniffing: counts the bytes that no control and no tape punch writes.
#include "analyzer/source/content.hpp"

#include "analyzer/source/encoding.hpp"

#include <array>
#include <cstddef>

namespace maclint {
namespace {

constexpr std::size_t sample_size = std::size_t{64} * 1024;
/// Text may hold a few strays of a bad transfer; random bytes are over this share (about 1 in 10).
constexpr std::size_t text_bytes_per_stray = 32;

std::string_view without_tape_leader(std::string_view bytes) {
    const auto first = bytes.find_first_not_of('\0');
    if (first == std::string_view::npos) return {};
    return bytes.substr(first, bytes.find_last_not_of('\0') - first + 1);
}

/// What is judged: a long leader or margin is no verdict on what comes after it.
std::string_view sample_of(std::string_view bytes) {
    bytes.remove_prefix(byte_order_mark_length(bytes));
    return without_tape_leader(bytes).substr(0, sample_size);
}

bool is_blank(std::string_view sample) {
    return sample.find_first_not_of(" \t\r\n\v\f\x1A\x7F") == std::string_view::npos;
}

/// Controls that NC files really hold: tab, line ends, vertical tab and form feed, DC1-DC4 (tape reader and
/// punch on and off), SUB (end of file of CP/M and DOS), DEL (rubbed-out tape); BEL, BS and ESC, which the
/// log of a terminal leaves behind.
constexpr bool is_stray(unsigned char value) {
    if (value >= 0x20) return false;
    return !((value >= 0x07 && value <= 0x0D) || (value >= 0x11 && value <= 0x14) || value == 0x1A ||
             value == 0x1B);
}

constexpr std::array<bool, 256> make_strays() {
    std::array<bool, 256> strays{};
    for (std::size_t i = 0; i < strays.size(); ++i) strays[i] = is_stray(static_cast<unsigned char>(i));
    return strays;
}

std::size_t count_strays(std::string_view text) {
    static constexpr std::array<bool, 256> strays = make_strays();
    std::size_t count = 0;
    for (const char c : text) count += strays[static_cast<unsigned char>(c)] ? 1U : 0U;
    return count;
}

} // namespace

Content classify(std::string_view bytes) {
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return Content::utf16;
    const std::string_view sample = sample_of(bytes);
    if (is_blank(sample)) return sample.size() < sample_size ? Content::empty : Content::text;
    if (sample.find('\0') != std::string_view::npos) return Content::binary;
    return count_strays(sample) * text_bytes_per_stray > sample.size() ? Content::binary : Content::text;
}

bool is_empty(std::string_view bytes) {
    const std::string_view sample = sample_of(bytes);
    return sample.size() < sample_size && is_blank(sample);
}

std::string_view without_end_of_file(std::string_view bytes) {
    constexpr std::string_view filling(" \t\r\n\0\x1A", 6);
    const std::size_t tail = bytes.find_last_not_of(filling) + 1; // npos + 1 is 0
    return bytes.substr(0, bytes.find('\x1A', tail));
}

} // namespace maclint
