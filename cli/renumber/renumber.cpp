//! Counts from the top; what names a block gets the number that this has got.
#include "cli/renumber/renumber.hpp"

#include "cli/text/shown.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace maclint::cli {
namespace {

/// Numbers of older controls have four digits, those of newer ones five; larger ones are refused in programs
/// that have none.
constexpr std::int64_t usual_most = 9999, most = 99999;

/// As wide as before where zeros stood in front.
std::string written_as(const Source& source, const WrittenNumber& before, std::int64_t number) {
    std::string digits = std::to_string(number);
    if (source.bytes()[before.digits.begin] == '0' && digits.size() < before.digits.length())
        digits.insert(0, before.digits.length() - digits.size(), '0');
    return digits;
}

std::optional<UnsafeNumber> too_large(const std::shared_ptr<const Source>& source, const NumberSpace& space,
                                      Numbering numbering) {
    if (space.blocks.empty()) return std::nullopt;
    const auto greatest = std::ranges::max_element(space.blocks, {}, &WrittenNumber::number)->number;
    const std::int64_t last =
        numbering.start + static_cast<std::int64_t>(space.blocks.size() - 1) * numbering.step;
    const std::int64_t limit = greatest > usual_most ? most : usual_most;
    if (last <= limit) return std::nullopt;
    return UnsafeNumber{source, space.blocks.back().digits,
                        "the last block would be N" + std::to_string(last) + ", and " +
                            std::to_string(limit) +
                            " is the greatest number that its control surely takes. Give a smaller --step or "
                            "--start."};
}

/// A word that finds no block today would find one.
std::optional<UnsafeNumber> comes_to_life(const std::shared_ptr<const Source>& source,
                                          const NumberSpace& space, Numbering numbering) {
    for (const WrittenNumber& word : space.without_block) {
        const std::int64_t from_start = word.number - numbering.start;
        const auto count = static_cast<std::int64_t>(space.blocks.size());
        if (from_start < 0 || from_start % numbering.step != 0 || from_start / numbering.step >= count)
            continue;
        return UnsafeNumber{
            source, word.digits,
            "'" + std::to_string(word.number) +
                "' names a block that is not there, and one would get that number. Correct it first."};
    }
    return std::nullopt;
}

} // namespace

std::variant<std::vector<Edit>, UnsafeNumber>
renumbering_of(const std::shared_ptr<const Source>& source, const NumberSpaces& spaces, Numbering numbering) {
    std::vector<Edit> edits;
    for (const NumberSpace& space : spaces) {
        for (auto unsafe : {too_large(source, space, numbering), comes_to_life(source, space, numbering)})
            if (unsafe) return *std::move(unsafe);
        const auto number_of = [&](std::size_t block) {
            return numbering.start + static_cast<std::int64_t>(block) * numbering.step;
        };
        const auto add = [&](const WrittenNumber& before, std::size_t block) {
            edits.push_back({source, before.digits, written_as(*source, before, number_of(block))});
        };
        for (std::size_t i = 0; i < space.blocks.size(); ++i) add(space.blocks[i], i);
        for (const BlockUse& use : space.uses) add(use.written, use.block);
    }
    std::erase_if(edits, [&](const Edit& edit) { return source->bytes(edit.span) == edit.text; });
    std::ranges::sort(edits, {}, [](const Edit& edit) { return edit.span.begin; });
    return edits;
}

std::string reason_of(const UnsafeNumber& unsafe, std::string_view path) {
    const std::string& holder = unsafe.source->path();
    const std::uint32_t line = unsafe.source->position(unsafe.at.begin).line;
    return (holder == path ? "" : shown(holder) + " ") + "line " + std::to_string(line) + ": " + unsafe.why;
}

bool name_the_same_blocks(const NumberSpaces& before, const NumberSpaces& after) {
    return std::ranges::equal(before, after, [](const NumberSpace& a, const NumberSpace& b) {
        return a.blocks.size() == b.blocks.size() && a.without_block.size() == b.without_block.size() &&
               std::ranges::equal(a.uses, b.uses, {}, &BlockUse::block, &BlockUse::block);
    });
}

} // namespace maclint::cli
