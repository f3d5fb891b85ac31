//! Plain blocks in a row while they are read: what they leave behind.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/syntax/plain_scanner.hpp"

#include <array>
#include <cstdint>
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
        run_.words.codes.add(block.codes);
        if (!block.number_span.empty()) {
            const auto number = static_cast<std::int32_t>(block.number);
            run_.lowest_number = number < run_.lowest_number ? number : run_.lowest_number;
            run_.highest_number = number > run_.highest_number ? number : run_.highest_number;
        }
        for (const ModalSetting& setting : block.settings()) {
            last_[setting.group] = {setting.value, ++set_};
            touched_ |= std::uint64_t{1} << setting.group;
        }
    }
    [[nodiscard]] bool empty() const { return run_.blocks == 0; }
    /// Runs are kept short enough that who asks for one block of them reads few others again.
    [[nodiscard]] bool is_full() const { return run_.blocks >= most_blocks; }
    /// The run, without its `net`. Its blocks were read by that row of Program::plain_tables.
    [[nodiscard]] PlainRun run(std::uint8_t tables) const {
        PlainRun run = run_;
        run.tables = tables;
        return run;
    }
    /// What it leaves set, one setting a group, in the order of the text.
    [[nodiscard]] std::vector<ModalSetting> net() const;

  private:
    static constexpr std::uint32_t most_blocks = 4096;

    PlainRun run_{};
    struct Last {
        double value;
        std::uint32_t at; ///< so many settings came before or are this one
    };
    std::uint64_t touched_ = 0; ///< bit n: group n is set
    std::uint32_t set_ = 0;
    std::array<Last, 64> last_{};
};

} // namespace maclint
