//! Writes a block that keeps every row of its code, and the same with one of them broken.
#include "rules/words/row_examples.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "rules/words/code_pages.hpp"
#include "rules/words/example_after.hpp"
#include "rules/words/example_block.hpp"
#include "rules/words/example_frames.hpp"
#include "rules/words/example_preludes.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <string_view>

namespace maclint {
namespace {

/// Writes programs round blocks with the code of a row.
class ProgramWriter {
  public:
    explicit ProgramWriter(const RowForCode& row)
        : of_code_(row)
        , row_(*row.row)
        , control_(example_control(row))
        , frame_(frame_of(control_))
        , section_(section_of(row))
        , block_(block_with(code_of(row))) {}

    [[nodiscard]] const ControlModel& control() const { return control_; }

    [[nodiscard]] std::string program(bool kept) const {
        if (of_code_.is_of_address()) return start() + of_address(kept) + "\n" + end(section_);
        const bool names_switch = !row_.while_on.empty() || !row_.while_off.empty();
        const bool stands_apart = names_switch || !row_.after.empty() || !row_.unless_after.empty();
        if (row_.says == RowStatement::refused && row_.under.empty() && !stands_apart)
            return in_section(kept);
        SwitchedAround around = switched_around(of_code_, block_, {control_, frame_, section_}, kept);
        std::string text = contour_named(kept) + start() + around.before;
        if (!row_.under.empty() && (row_.says != RowStatement::refused || !kept))
            text += switched_under(row_, {control_, frame_, section_}, around.after);
        if (!row_.after.empty() && (row_.says != RowStatement::refused || !kept))
            text += block_with(first_of(row_.after)).text() + "\n";
        text += kept ? block_.text_that_keeps(row_) : block_.text(&row_);
        if (row_.says == RowStatement::apart && !kept) text += " " + std::string(first_of(row_.others));
        text += "\n" + blocks_after(of_code_, block_, {control_, frame_, section_}, kept);
        return text + around.after + end(section_);
    }

  private:
    [[nodiscard]] static std::string_view section_of(const RowForCode& row) {
        const std::string_view list = row.row->sections.empty() ? row.table->sections : row.row->sections;
        return list.empty() ? list : first_of(list);
    }
    [[nodiscard]] ExampleBlock block_with(std::string_view code) const { return {control_, code, section_}; }
    [[nodiscard]] std::string of_address(bool kept) const {
        const std::string address(row_.words);
        if (row_.says == RowStatement::whole) return address + (kept ? "8" : "8.");
        if (row_.says == RowStatement::values)
            return address + (kept ? allowed_value(row_) : refused_value(row_));
        return address + std::string(static_cast<std::size_t>(row_.most) + (kept ? 0 : 1), '1');
    }
    [[nodiscard]] static std::string heading(std::string_view section) {
        std::string name(section);
        std::ranges::replace(name, '_', ' ');
        return name + "\n";
    }
    /// What must be on counts in whole programs alone.
    [[nodiscard]] std::string start() const {
        const std::string head = row_.while_off.empty() ? "" : heading(frame_.first_section);
        return section_.empty() ? std::string(frame_.head) : head + heading(section_);
    }

    [[nodiscard]] std::string end(std::string_view section) const {
        const bool has_main = section.empty() || section == frame_.main_section;
        return (has_main ? "" : heading(frame_.main_section)) + std::string(frame_.tail);
    }

    /// The contour whose block the words number.
    [[nodiscard]] std::string contour_named(bool kept) const {
        if (row_.says != RowStatement::names_none) return {};
        const std::string_view code = first_of(kept ? row_.first_block : row_.others);
        for (const CodePage* page : pages_of_code(of_code_.table->language, code)) {
            const std::string_view section = first_of(page->sections());
            if (section == frame_.main_section) continue;
            const ExampleBlock block(control_, code, section);
            const WordRow* order = block.order();
            SwitchedAround around;
            Preludes preludes({control_, frame_, section});
            preludes.begin_contour(block, nullptr, around);
            return heading(section) + around.before + "N10 " + block.text() + "\n" +
                   (order == nullptr
                        ? ""
                        : ExampleBlock(control_, first_of(order->others), section).text() + "\n");
        }
        return {};
    }

    /// The code where it has no place, or in one of its own sections.
    [[nodiscard]] std::string in_section(bool kept) const {
        if (!kept) return start() + code_of(of_code_) + "\n" + end(section_);
        const auto pages = pages_of_code(of_code_.table->language, code_of(of_code_));
        const std::string_view section = first_of(pages.front()->sections());
        const ExampleBlock block(control_, code_of(of_code_), section);
        const WordRow* order = block.order();
        SwitchedAround around;
        Preludes preludes({control_, frame_, section});
        preludes.leave_reset(block, nullptr, around);
        preludes.begin_contour(block, nullptr, around);
        around.after = preludes.switched_off(block, nullptr, block.text());
        std::string text = heading(section) + around.before + block.text() + "\n";
        if (order != nullptr) text += ExampleBlock(control_, first_of(order->others), section).text() + "\n";
        text += around.after;
        return text + end(section);
    }

    const RowForCode& of_code_;
    const WordRow& row_;
    const ControlModel& control_;
    const ExampleFrame& frame_;
    std::string_view section_;
    ExampleBlock block_;
};

} // namespace

RowExamples examples_of(const RowForCode& row) {
    const ProgramWriter writer(row);
    const bool is_usual = find_dialect(row.table->language)->default_control == writer.control().name;
    return {std::string(row.table->language), is_usual ? "" : writer.control().name, writer.program(false),
            writer.program(true)};
}

} // namespace maclint
