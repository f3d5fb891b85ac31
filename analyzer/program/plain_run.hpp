//! Plain blocks in a row while they are read: what they leave behind.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/syntax/plain_scanner.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace maclint {

/// Adds up plain blocks; a new object is the next run.
class PlainRunTotals {
  public:
    void add(const syntax::PlainBlock& block) {
        run_.span = run_.blocks == 0 ? block.span : Span{run_.span.begin, block.span.end};
        ++run_.blocks;
        run_.moves |= block.moves;
        run_.words.addresses.add(block.addresses);
        run_.words.repeated.add(block.repeated);
        run_.words.conflicts |= block.conflicts;
        if (!block.codes.empty()) add_codes(block);
        if (!block.number_span.empty()) {
            const auto number = static_cast<std::int32_t>(block.number);
            run_.lowest_number = number < run_.lowest_number ? number : run_.lowest_number;
            run_.highest_number = number > run_.highest_number ? number : run_.highest_number;
        }
        for (const ModalSetting& setting : block.settings()) {
            last_[setting.group] = {setting.value, ++set_};
            touched_.add(setting.group);
        }
    }
    [[nodiscard]] bool empty() const { return run_.blocks == 0; }
    /// Runs are kept short enough that who asks for one block of them reads few others again.
    [[nodiscard]] bool is_full() const { return run_.blocks >= most_blocks; }
    /// The run, without its `net` and its `beside_codes`. Its blocks were read by that row of
    /// Program::plain_tables.
    [[nodiscard]] PlainRun run(std::uint8_t tables) const {
        PlainRun run = run_;
        run.tables = tables;
        return run;
    }
    /// What it leaves set, one setting a group, in the order of the text.
    [[nodiscard]] std::vector<ModalSetting> net() const;
    /// What stands beside its codes; empty where there are too many kinds of them.
    [[nodiscard]] std::span<const CodeWords> beside_codes() const {
        return std::span(beside_).first(kinds_ > beside_.size() ? 0 : kinds_);
    }

  private:
    static constexpr std::uint32_t most_blocks = 4096;
    static constexpr std::size_t most_kinds = 16; ///< of codes: more have no use for a summary

    void add_codes(const syntax::PlainBlock& block) {
        run_.words.codes.add(block.codes);
        block.codes.for_each([&](syntax::CodeSet::Kind kind) {
            for (std::size_t i = 0; i < std::min(kinds_, most_kinds); ++i)
                if (beside_[i].kind == kind) {
                    beside_[i].any.add(block.addresses);
                    beside_[i].all = beside_[i].all.common(block.addresses);
                    return;
                }
            if (kinds_ < most_kinds) beside_[kinds_] = {kind, block.addresses, block.addresses};
            if (kinds_ <= most_kinds) ++kinds_;
        });
    }

    PlainRun run_{};
    struct Last {
        double value;
        std::uint32_t at; ///< so many settings came before or are this one
    };
    syntax::GroupSet touched_;
    std::uint32_t set_ = 0;
    std::array<Last, syntax::most_groups> last_{};
    std::size_t kinds_ = 0; ///< of codes
    std::array<CodeWords, most_kinds> beside_{};
};

} // namespace maclint
