//! A rolling hash over UTF-16 code units, and FNV-1a.
#include "cli/report/fingerprint.hpp"

#include "cli/config/rule_words.hpp"
#include "rules/rule.hpp"

#include <array>
#include <utility>

namespace maclint::cli {
namespace {

// Names and numbers are those of the upload action: block of 100, multiplier 37, 65535 for the end of the
// file.
constexpr std::size_t block_size = 100;
constexpr std::uint64_t multiplier = 37;
constexpr std::uint64_t end_of_file = 65535;

constexpr std::uint64_t first_multiplier() {
    std::uint64_t product = 1;
    for (std::size_t i = 0; i < block_size; ++i) product *= multiplier;
    return product;
}

std::string hexadecimal(std::uint64_t value) {
    std::string digits;
    do {
        digits.insert(digits.begin(), "0123456789abcdef"[value & 0xFU]);
        value >>= 4U;
    } while (value != 0);
    return digits;
}

class LineHasher {
  public:
    explicit LineHasher(const std::set<std::uint32_t>& wanted)
        : wanted_(wanted) {}

    void take(std::uint64_t unit) {
        if (unit == ' ' || unit == '\t' || (after_cr_ && unit == '\n')) {
            after_cr_ = false;
            return;
        }
        after_cr_ = unit == '\r';
        if (after_cr_) unit = '\n';
        emit();
        if (line_begins_) lines_.at(index_) = ++line_;
        line_begins_ = unit == '\n';
        roll(unit);
    }

    std::map<std::uint32_t, std::string> finish() {
        take(end_of_file);
        for (std::size_t i = 0; i < block_size; ++i) {
            emit();
            roll(0);
        }
        return std::move(hashes_);
    }

  private:
    /// The window is full again: what it holds begins with a line.
    void emit() {
        const std::uint32_t line = std::exchange(lines_.at(index_), 0);
        if (line == 0) return;
        const std::size_t count = ++counts_[hash_];
        if (wanted_.contains(line)) hashes_[line] = hexadecimal(hash_) + ":" + std::to_string(count);
    }

    void roll(std::uint64_t unit) {
        const std::uint64_t leaving = std::exchange(window_.at(index_), unit);
        hash_ = multiplier * hash_ + unit - first_multiplier() * leaving;
        index_ = (index_ + 1) % block_size;
    }

    const std::set<std::uint32_t>& wanted_;
    std::array<std::uint64_t, block_size> window_{};
    std::array<std::uint32_t, block_size> lines_{}; ///< line that begins at a place of the window; 0: none
    std::size_t index_ = 0;
    std::uint64_t hash_ = 0;
    std::uint32_t line_ = 0;
    bool line_begins_ = true;
    bool after_cr_ = false;
    std::unordered_map<std::uint64_t, std::size_t> counts_;
    std::map<std::uint32_t, std::string> hashes_;
};

/// Calls `visit` with every UTF-16 code unit of valid UTF-8.
template<class Visit>
void for_each_unit(std::string_view utf8, const Visit& visit) {
    while (!utf8.empty()) {
        const auto [character, length] = first_character(utf8);
        if (character >= 0x10000) {
            visit(0xD800 + ((character - 0x10000) >> 10U));
            visit(0xDC00 + ((character - 0x10000) & 0x3FFU));
        } else {
            visit(character);
        }
        utf8.remove_prefix(length);
    }
}

std::uint64_t fnv1a(std::string_view text) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    return hash;
}

} // namespace

std::map<std::uint32_t, std::string> line_hashes(const Source& source,
                                                 const std::set<std::uint32_t>& wanted) {
    LineHasher hasher(wanted);
    // The action reads every file as UTF-8, whatever it is.
    for_each_unit(to_utf8(source.bytes(), Encoding::utf8), [&](std::uint64_t unit) { hasher.take(unit); });
    return hasher.finish();
}

std::string Fingerprints::of_place(const Finding& finding, Span place) {
    const auto [line, part] = numberless_.of(*finding.source, place);
    std::string key = code_with_key(finding);
    for (const std::string_view word : {finding.message_id, std::string_view(line), std::string_view(part)})
        key.append("\n").append(word);
    return hexadecimal(fnv1a(key));
}

std::string Fingerprints::line_of(const Finding& finding, Span place) {
    return numberless_.of(*finding.source, place).line;
}

std::string Fingerprints::of(const Finding& finding) {
    const std::string print = of_place(finding, finding.span);
    return print + ":" + std::to_string(++seen_[finding.source->path() + "\n" + print]);
}

std::string hash_of(std::string_view text) { return hexadecimal(fnv1a(text)); }

} // namespace maclint::cli
