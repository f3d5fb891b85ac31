//! Writes a block that keeps every row of its code, and the same with one of them broken.
#include "rules/words/row_examples.hpp"

#include "rules/path.hpp"
#include "rules/words/example_frames.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint {
namespace {

/// Writes blocks with the code of a row.
class BlockWriter {
  public:
    explicit BlockWriter(const RowForCode& row)
        : code_(row)
        , frame_(*std::ranges::find(example_frames, row.table->language, &ExampleFrame::language)) {
        for (const RuleRow& rule_row : all_rule_rows())
            for (const RowForCode& other : rule_row.rows)
                if (other.letter == row.letter && other.code == row.code &&
                    other.table->language == row.table->language)
                    rows_.push_back(other.row);
    }

    [[nodiscard]] std::string program(bool kept) const {
        const WordRow& row = *code_.row;
        std::string text(frame_.head);
        if (!row.sections.empty() || !code_.table->sections.empty()) text = heading() + "\n";
        if (row.says == RowStatement::refused && !kept)
            text += std::string(first(row.under)) + std::string(frame_.straight) + "\n";
        text += code_of(code_);
        for (const auto& [address, value] : words(kept)) text.append(" ").append(address).append(value);
        text += "\n";
        if (const WordRow* order = find(RowStatement::precedes))
            text += kept || order != &row
                        ? std::string(first(order->others)) + std::string(frame_.straight) + "\n"
                        : std::string(frame_.arc);
        return text + std::string(frame_.tail);
    }

  private:
    using Words = std::vector<std::pair<std::string, std::string>>;

    static std::string_view first(std::string_view list) { return words_of(list).front(); }
    static bool stands(const Words& words, std::string_view list) {
        return std::ranges::any_of(words, [&](const auto& word) { return has_word(list, word.first); });
    }
    [[nodiscard]] const WordRow* find(RowStatement says) const {
        const auto found = std::ranges::find(rows_, says, &WordRow::says);
        return found == rows_.end() ? nullptr : *found;
    }

    [[nodiscard]] std::string heading() const {
        const WordRow& row = *code_.row;
        std::string name(first(row.sections.empty() ? code_.table->sections : row.sections));
        std::ranges::replace(name, '_', ' ');
        return name;
    }

    /// A value that every row allows.
    [[nodiscard]] std::string value_of(std::string_view address) const {
        for (const WordRow* row : rows_)
            if (row->says == RowStatement::values && has_word(row->words, address))
                return allowed_value(*row);
        return has_word(frame_.with_point, address) ? "10." : "1";
    }
    static std::string allowed_value(const WordRow& row) {
        if (!row.values.empty()) return std::string(first(row.values));
        if (!std::isfinite(row.most)) return number_word(row.above_least ? row.least + 1 : row.least);
        return number_word(std::isfinite(row.least) ? (row.least + row.most) / 2 : row.most - 1);
    }
    static std::string refused_value(const WordRow& row) {
        if (!row.values.empty()) return "99";
        return number_word(std::isfinite(row.most) ? row.most + 1 : row.least - 1);
    }

    /// The words of the row, then those that other rows want beside them.
    [[nodiscard]] Words words(bool kept) const {
        const WordRow& row = *code_.row;
        Words all;
        const auto add = [&](std::string_view address) { all.emplace_back(address, value_of(address)); };
        switch (row.says) {
        case RowStatement::needs:
        case RowStatement::takes_not:
            if (kept == (row.says == RowStatement::needs)) add(first(row.words));
            break;
        case RowStatement::excludes:
            add(first(row.words));
            if (!kept) add(first(row.others));
            break;
        case RowStatement::only_with: add(first(row.words)); break;
        case RowStatement::values:
            all.emplace_back(first(row.words), kept ? allowed_value(row) : refused_value(row));
            break;
        case RowStatement::whole:
            all.emplace_back(first(row.words), value_of(first(row.words)) + (kept ? "" : "."));
            break;
        case RowStatement::alone:
            if (!kept) all.emplace_back("S", "500");
            break;
        case RowStatement::precedes:
        case RowStatement::refused: break;
        }
        for (const WordRow* other : rows_) {
            const bool is_row = other == &row && !kept;
            if (other->says == RowStatement::needs && !is_row && !stands(all, other->words))
                add(first(other->words));
            if (other->says == RowStatement::only_with && !is_row && stands(all, other->words) &&
                !stands(all, other->others))
                add(first(other->others));
        }
        return all;
    }

    const RowForCode& code_;
    const ExampleFrame& frame_;
    std::vector<const WordRow*> rows_; ///< of the code
};

} // namespace

RowExamples examples_of(const RowForCode& row) {
    const BlockWriter writer(row);
    const auto controls = words_of(row.row->controls);
    return {std::string(row.table->language), controls.empty() ? "" : std::string(controls.front()),
            writer.program(false), writer.program(true)};
}

} // namespace maclint
