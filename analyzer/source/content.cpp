//! Content sniffing: counts the bytes that no control and no tape punch writes.
#include "analyzer/source/content.hpp"

#include "analyzer/source/encoding.hpp"

#include <algorithm>

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
bool is_stray(char c) {
    const auto value = static_cast<unsigned char>(c);
    if (value >= 0x20) return false;
    return !((value >= 0x07 && value <= 0x0D) || (value >= 0x11 && value <= 0x14) || value == 0x1A ||
             value == 0x1B);
}

} // namespace

Content classify(std::string_view bytes) {
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return Content::utf16;
    const std::string_view sample = sample_of(bytes);
    if (is_blank(sample)) return sample.size() < sample_size ? Content::empty : Content::text;
    if (sample.find('\0') != std::string_view::npos) return Content::binary;
    const auto strays = static_cast<std::size_t>(std::count_if(sample.begin(), sample.end(), is_stray));
    return strays * text_bytes_per_stray > sample.size() ? Content::binary : Content::text;
}

bool is_empty(std::string_view bytes) {
    const std::string_view sample = sample_of(bytes);
    return sample.size() < sample_size && is_blank(sample);
}

} // namespace maclint
