//! Writes data, enclosed blocks and the next code.
#include "rules/words/example_after.hpp"

#include "rules/words/code_pages.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/word_list.hpp"

namespace maclint {
namespace {

class Writer {
  public:
    Writer(const RowForCode& row, const ExampleBlock& block, const ExamplePlace& place)
        : of_code_(row)
        , row_(*row.row)
        , block_(block)
        , place_(place) {}

    std::string text(bool kept) const { return next_block(kept) + enclosed_blocks(kept) + data_blocks(kept); }

  private:
    ExampleBlock block_with(std::string_view code) const { return {place_.control, code, place_.section}; }

    /// Those up to the code that ends them, one of them with a foreign word where that row is broken.
    std::string data_blocks(bool kept) const {
        const WordRow* row = block_.begun_data(&row_);
        if (row == nullptr) return {};
        return std::string(first_of(row->words)) + "1" + (kept || row != &row_ ? "" : " G1") + "\n" +
               std::string(first_of(row->others)) + "\n";
    }

    /// Those that the block numbers; the last one is missing where that row is broken.
    std::string enclosed_blocks(bool kept) const {
        const WordRow* row = block_.enclosed();
        if (row == nullptr) return {};
        const std::string code(row->first_block.empty() ? "G1" : first_of(row->first_block));
        std::string blocks = "N10 " + code + std::string(place_.frame.straight) + "\n";
        if (kept || row != &row_) blocks += "N20 G1" + std::string(place_.frame.straight) + "\n";
        return blocks;
    }

    /// What the row on the block after wants, or something else; nothing where no row says anything of it.
    std::string next_block(bool kept) const {
        const bool is_order = row_.says == RowStatement::precedes;
        const WordRow* order = is_order ? &row_ : block_.order(&row_);
        if (order == nullptr) return {};
        if (is_order && row_.others.empty())
            return (kept ? other_code_than(row_.words) : block_with(first_of(row_.words)).text()) + "\n";
        if (kept || !is_order) return block_with(first_of(order->others)).text() + "\n";
        return other_code_than(order->others) + "\n";
    }

    /// A block of the section with a code that is none of these, and wants nothing of the block after.
    std::string other_code_than(std::string_view codes) const {
        for (const CodePage& page : all_code_pages()) {
            const std::string_view code = first_of(page.head->row.code);
            if (!page.is_of(place_.control) || !has_word(page.sections(), place_.section) ||
                code.front() != of_code_.letter || has_word(codes, code) || code == code_of(of_code_))
                continue;
            const ExampleBlock block = block_with(code);
            if (block.order() == nullptr) return block.text();
        }
        return std::string(place_.frame.arc);
    }

    const RowForCode& of_code_;
    const WordRow& row_;
    const ExampleBlock& block_;
    const ExamplePlace& place_;
};

} // namespace

std::string blocks_after(const RowForCode& row, const ExampleBlock& block, const ExamplePlace& place,
                         bool kept) {
    return Writer(row, block, place).text(kept);
}

} // namespace maclint
