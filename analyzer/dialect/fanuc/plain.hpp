//! The plain lane: reads a block of nothing but address letters and literal numbers straight from its bytes.
#pragma once

#include "analyzer/dialect/fanuc/codes.hpp"
#include "analyzer/program/builder.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/source/span.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace maclint::fanuc {

enum class Lane : std::uint8_t {
    blank,   ///< no words: blanks and comments only
    plain,   ///< everything is known
    grammar, ///< the block must be parsed
};

/// A block as the scanner leaves it. For Lane::grammar only the lane is told.
struct ScannedBlock {
    static constexpr std::size_t most_settings = 24; ///< a block with more goes to the grammar
    Span span;          ///< from the first to behind the last character that is no blank
    Offset next;        ///< behind its end of block
    Span sequence_span; ///< empty without a sequence number
    std::int64_t sequence_number;
    bool moves;
    std::uint8_t settings_count;
    std::array<ModalSetting, most_settings> settings;
};

/// Scans the block that begins at `begin` in `text`.
[[nodiscard]] Lane scan_block(std::string_view text, Offset begin, const CodeTable& codes,
                              ScannedBlock& block);

/// What plain blocks in a row leave behind.
class RunTotals {
  public:
    void add(const ScannedBlock& block);
    [[nodiscard]] bool empty() const { return blocks_ == 0; }
    /// Appends the run to a program and starts the next one.
    void close(ProgramBuilder& program);

  private:
    Span span_;
    std::uint32_t blocks_ = 0;
    bool moves_ = false;
    bool has_sequence_numbers_ = false;
    std::uint64_t touched_ = 0; ///< bit n: group n is set
    std::array<double, 64> last_{};
};

/// The RunDecoder of this dialect.
void decode_run(const Program& program, Span part, const std::function<bool(const PlainBlock&)>& visit);

} // namespace maclint::fanuc
