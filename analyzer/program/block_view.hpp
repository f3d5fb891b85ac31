//! One view of a block, whatever lane it came through, and the only loops over the blocks of a program.
#pragma once

#include "analyzer/program/block_settings.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/syntax/plain_scanner.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace maclint {

/// A block as its readers see it; good as long as its visitor runs.
struct BlockView {
    Span span; ///< without its end of line
    std::optional<std::int64_t> number = {};
    Span number_span = {};
    std::optional<BlockName> name = {};
    Span name_span = {};
    Channels channels = 0;         ///< that it names; 0: those of its section
    std::uint16_t skip_levels = 0; ///< bit n: skip level n (bit 1 for a bare '/'); 0: never skipped
    Slice effects = {};            ///< Program::effects, in execution order
    /// Modal groups that its words set; a block of addresses and literal numbers has no effects that say so,
    /// and then moves.
    BlockSettings settings = {};
    bool moves = false; ///< without an effect of its own
};

/// Blocks in a row which the flow passes as one: a block with effects of its own, or others, as many as there
/// are. `item` says where they are kept.
struct Stretch {
    ItemId item;
    Span span;
};

/// What the program keeps of a block that is not passed with others; good as long as the program.
struct StoredBlock {
    std::uint16_t skip_levels; ///< as in BlockView
    Slice effects;
    std::span<const Word> words;
};

/// The block that the item is; nothing where it is plain blocks in a row, of which no block is kept.
[[nodiscard]] inline std::optional<StoredBlock> stored_block(const Program& program, ItemId item) {
    const auto* block = std::get_if<Block>(&program.items[item]);
    if (block == nullptr) return std::nullopt;
    return StoredBlock{block->skip_levels, block->effects,
                       std::span(program.words).subspan(block->words.first, block->words.count)};
}

namespace blocks {

/// Calls a visitor; one that returns false wants no more.
template<class Visit, class... Things>
bool goes_on(const Visit& visit, const Things&... things) {
    if constexpr (std::is_void_v<std::invoke_result_t<const Visit&, const Things&...>>) {
        visit(things...);
        return true;
    } else {
        return visit(things...);
    }
}

inline BlockView view_of(const Program& program, const Block& block) {
    return {.span = block.span,
            .number = block.sequence_number,
            .number_span = block.sequence_number_span,
            .name = block.name,
            .name_span = block.name_span,
            .channels = block.channels,
            .skip_levels = block.skip_levels,
            .effects = block.effects,
            .settings = BlockSettings(program, program.effects_in(block.effects))};
}

inline BlockView view_of(const syntax::PlainBlock& block) {
    BlockView view{.span = block.span, .settings = BlockSettings(block.settings()), .moves = block.moves};
    if (block.number_span.empty()) return view;
    view.number = block.number;
    view.number_span = block.number_span;
    return view;
}

/// Reads plain blocks again: `scan(text, at, tables, block)` each, then `visit(BlockView)`. False when the
/// visitor wants no more.
template<class Scan, class Visit>
bool scan_again(const Program& program, const PlainRun& run, Span part, const Scan& scan,
                const Visit& visit) {
    const syntax::PlainTables& tables = *program.plain_tables[run.tables];
    const std::string_view text = program.text.substr(0, part.end);
    syntax::PlainBlock block;
    for (Offset at = part.begin; at < part.end; at = block.next) {
        const syntax::Lane lane = scan(text, at, tables, block);
        assert(lane != syntax::Lane::grammar && "the reader ends a run before such a block");
        if (lane == syntax::Lane::grammar) return true;
        if (lane == syntax::Lane::plain && !goes_on(visit, view_of(block))) return false;
    }
    return true;
}

template<class Visit>
bool visit_part(const Program& program, const PlainRun& run, Span part, const Visit& visit) {
    return scan_again(program, run, part, syntax::scan_block, visit);
}

template<class Visit>
bool visit_item(const Program& program, const Item& item, const Visit& visit) {
    if (const auto* run = std::get_if<PlainRun>(&item)) return visit_part(program, *run, run->span, visit);
    return goes_on(visit, view_of(program, std::get<Block>(item)));
}

/// The address of a decoded word: upper case, or as it is written where the tables have no name for it.
inline std::string_view address_of(std::string_view text, const syntax::PlainTables& tables,
                                   const syntax::PlainWord& word) {
    const std::string_view name = tables.names[word.id];
    return name.empty() ? text.substr(word.address.begin, word.address.length()) : name;
}

template<class Wanted>
bool any_number_wanted(const PlainRun& run, const Wanted& wanted) {
    return run.has_numbers() && wanted.between(run.lowest_number, run.highest_number);
}

} // namespace blocks

/// All blocks of the program in text order. A visitor that returns false ends the loop.
template<class Visit>
void for_each_block(const Program& program, const Visit& visit) {
    for (const Item& item : program.items)
        if (!blocks::visit_item(program, item, visit)) return;
}

/// The blocks of a section.
template<class Visit>
void for_each_block(const Program& program, const Section& section, const Visit& visit) {
    for (Id i = section.items.first; i < section.items.first + section.items.count; ++i)
        if (!blocks::visit_item(program, program.items[i], visit)) return;
}

/// The blocks that have effects of their own, of the program or of a section; no other block is read again.
template<class Visit>
void for_each_block_with_effects(const Program& program, Slice items, const Visit& visit) {
    for (Id i = items.first; i < items.first + items.count; ++i) {
        const auto* block = std::get_if<Block>(&program.items[i]);
        if (block != nullptr && block->effects.count != 0) visit(blocks::view_of(program, *block));
    }
}
template<class Visit>
void for_each_block_with_effects(const Program& program, const Visit& visit) {
    for_each_block_with_effects(program, {0, static_cast<Id>(program.items.size())}, visit);
}

/// The blocks of a stretch.
template<class Visit>
void for_each_block(const Program& program, const Stretch& stretch, const Visit& visit) {
    const Item& item = program.items[stretch.item];
    if (const auto* run = std::get_if<PlainRun>(&item))
        blocks::visit_part(program, *run, stretch.span, visit);
    else
        blocks::goes_on(visit, blocks::view_of(program, std::get<Block>(item)));
}

/// The blocks of a section whose numbers are wanted: `wanted(number)`, and `wanted.between(lowest, highest)`
/// whether any number there may be.
template<class Wanted, class Visit>
void for_each_numbered_block(const Program& program, const Section& section, const Wanted& wanted,
                             const Visit& visit) {
    const auto look = [&](const BlockView& block) {
        if (block.number && wanted(*block.number)) visit(block);
    };
    for (Id i = section.items.first; i < section.items.first + section.items.count; ++i) {
        const Item& item = program.items[i];
        const auto* run = std::get_if<PlainRun>(&item);
        if (run == nullptr || blocks::any_number_wanted(*run, wanted))
            blocks::visit_item(program, item, look);
    }
}

/// What a loop over stretches hands out.
struct StretchView {
    Stretch stretch;
    /// Its first block, where that has effects of its own or a number that is wanted.
    const BlockView* first;
    bool plain; ///< no block of it has effects of its own
};

/// The stretches of a section; a block whose number is wanted begins one.
template<class Wanted, class Visit>
void for_each_stretch(const Program& program, const Section& section, const Wanted& wanted,
                      const Visit& visit) {
    for (Id i = section.items.first; i < section.items.first + section.items.count; ++i) {
        const auto* run = std::get_if<PlainRun>(&program.items[i]);
        if (run == nullptr) {
            const BlockView block = blocks::view_of(program, std::get<Block>(program.items[i]));
            visit(StretchView{{i, block.span}, &block, false});
            continue;
        }
        Offset begin = run->span.begin;
        std::optional<BlockView> first;
        if (blocks::any_number_wanted(*run, wanted))
            blocks::visit_part(program, *run, run->span, [&](const BlockView& block) {
                if (!block.number || !wanted(*block.number)) return;
                if (block.span.begin > begin)
                    visit(StretchView{{i, {begin, block.span.begin}}, first ? &*first : nullptr, true});
                begin = block.span.begin;
                first = block;
            });
        visit(StretchView{{i, {begin, run->span.end}}, first ? &*first : nullptr, true});
    }
}

/// Whether any block of a plain stretch moves.
[[nodiscard]] bool moves(const Program& program, const Stretch& stretch);

/// The last settings in a part of plain blocks in a row, one a group, in the order of the text.
[[nodiscard]] std::vector<ModalSetting> last_settings(const Program& program, const PlainRun& run, Span part);

/// What a plain stretch leaves set: `visit(ModalSetting)`, one a group, in the order of the text.
template<class Visit>
void for_each_last_setting(const Program& program, const Stretch& stretch, const Visit& visit) {
    const auto& run = std::get<PlainRun>(program.items[stretch.item]);
    if (stretch.span == run.span)
        std::ranges::for_each(std::span(program.settings).subspan(run.net.first, run.net.count), visit);
    else
        std::ranges::for_each(last_settings(program, run, stretch.span), visit);
}

/// The blocks that set the group by words of their own; plain ones are read only in rows that set it.
template<class Visit>
void for_each_block_that_sets(const Program& program, GroupId group, const Visit& visit) {
    const auto sets = [group](const auto& setting) { return setting.group == group; };
    for (const Item& item : program.items) {
        if (const auto* run = std::get_if<PlainRun>(&item))
            if (std::ranges::none_of(std::span(program.settings).subspan(run->net.first, run->net.count),
                                     sets))
                continue;
        blocks::visit_item(program, item, [&](const BlockView& block) {
            if (std::ranges::any_of(block.settings, sets)) visit(block);
        });
    }
}

/// All effects of the slice, those under conditions included, as `visit(EffectId)` in text order.
template<class Visit>
void for_each_effect_in(const Program& program, Slice slice, const Visit& visit) {
    for (Id i = slice.first; i < slice.first + slice.count; ++i) {
        visit(i);
        if (const auto* guarded = std::get_if<Guarded>(&program.effects[i].what))
            for_each_effect_in(program, guarded->effects, visit);
    }
}

/// The effects of all blocks.
template<class Visit>
void for_each_effect(const Program& program, const Visit& visit) {
    for_each_block_with_effects(
        program, [&](const BlockView& block) { for_each_effect_in(program, block.effects, visit); });
}

// ---- words

/// The addresses that are named, separated by blanks; all of them for "".
[[nodiscard]] syntax::AddressSet addresses_named(const Program& program, std::string_view names);

namespace blocks {

/// The words of plain blocks, read again; keeps its memory.
class WordReader {
  public:
    /// `visit(BlockView, words, summary)` for the blocks of the part that have words and are wanted.
    template<class Wanted, class Visit>
    void visit_words(const Program& program, const PlainRun& run, Span part, const Wanted& wanted,
                     const Visit& visit) {
        const auto scan = [&](std::string_view text, Offset at, const syntax::PlainTables& tables,
                              syntax::PlainBlock& block) {
            words_.clear();
            const syntax::Lane lane = syntax::scan_block(text, at, tables, block);
            summary_ = {block.addresses, block.repeated, block.conflicts, block.codes};
            if (lane != syntax::Lane::plain || !wanted(summary_)) return lane;
            return syntax::scan_words(text, at, tables, block, [&](const syntax::PlainWord& word) {
                words_.push_back({address_of(text, tables, word), Literal{word.value, word.decimal_point},
                                  word.incremental, word.span});
            });
        };
        scan_again(program, run, part, scan, [&](const BlockView& block) {
            if (!words_.empty()) visit(block, std::span<const Word>(words_), &summary_);
        });
    }

  private:
    std::vector<Word> words_;
    WordSummary summary_;
};

} // namespace blocks

/// `visit(BlockView, words, summary)` for the blocks among the items that have words; the summary is nullptr
/// where it is not known. Plain blocks are only looked at in the parts of their run for which
/// `parts_of(run, take)` calls `take(Span)`, and only decoded where `wanted(summary)` wants the block.
template<class PartsOf, class Wanted, class Visit>
void for_each_block_with_words(const Program& program, Slice items, const PartsOf& parts_of,
                               const Wanted& wanted, const Visit& visit) {
    blocks::WordReader reader;
    for (Id i = items.first; i < items.first + items.count; ++i) {
        const Item& item = program.items[i];
        if (const auto* block = std::get_if<Block>(&item)) {
            const auto stored = std::span(program.words).subspan(block->words.first, block->words.count);
            if (!stored.empty()) visit(blocks::view_of(program, *block), stored, nullptr);
            continue;
        }
        const auto& run = std::get<PlainRun>(item);
        parts_of(run, [&](Span part) { reader.visit_words(program, run, part, wanted, visit); });
    }
}
/// The same over a whole program, for who wants a block whose summary would be wanted of a run.
template<class Wanted, class Visit>
void for_each_block_with_words(const Program& program, const Wanted& wanted, const Visit& visit) {
    for_each_block_with_words(
        program, {0, static_cast<Id>(program.items.size())},
        [&](const PlainRun& run, const auto& take) {
            if (wanted(run.words)) take(run.span);
        },
        wanted, visit);
}

/// `visit(BlockView, words)` for the blocks of the stretch that have words.
template<class Visit>
void for_each_block_with_words(const Program& program, const Stretch& stretch, const Visit& visit) {
    const Item& item = program.items[stretch.item];
    if (const auto* block = std::get_if<Block>(&item)) {
        visit(blocks::view_of(program, *block),
              std::span(program.words).subspan(block->words.first, block->words.count));
        return;
    }
    const auto all = [](const WordSummary&) { return true; };
    blocks::WordReader().visit_words(program, std::get<PlainRun>(item), stretch.span, all,
                                     [&](const BlockView& block, std::span<const Word> words,
                                         const WordSummary*) { visit(block, words); });
}

/// Number of blocks, those without words left out.
[[nodiscard]] std::size_t count_blocks(const Program& program);
/// The last block, without its settings; nothing in a program without blocks.
[[nodiscard]] std::optional<BlockView> last_block(const Program& program);

} // namespace maclint
