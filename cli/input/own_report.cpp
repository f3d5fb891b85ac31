//! Reads a text as the writers of reports write it: findings of several lines, tables, and single lines.
#include "cli/input/own_report.hpp"

#include "analyzer/source/encoding.hpp"
#include "cli/input/report_lines.hpp"
#include "cli/report/columns.hpp"
#include "cli/report/report.hpp"

#include <algorithm>
#include <string>

namespace maclint::cli {
namespace {

/// The lines of a text, without line ends and colours. Reports escape what cannot be seen: a text that has it
/// is none.
class Lines {
  public:
    explicit Lines(std::string_view text)
        : rest_(text) {
        next();
    }
    [[nodiscard]] bool at_end() const { return at_end_; }
    [[nodiscard]] bool are_printable() const { return are_printable_; }
    [[nodiscard]] const std::string& line() const { return line_; }
    void next() {
        at_end_ = rest_.empty();
        const std::string_view line = rest_.substr(0, rest_.find_first_of("\r\n"));
        rest_.remove_prefix(line.size());
        if (!rest_.empty()) rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : 1);
        line_ = without_colours(line);
        are_printable_ = are_printable_ && printable(line_) == line_;
    }

  private:
    std::string_view rest_;
    std::string line_;
    bool at_end_ = false;
    bool are_printable_ = true;
};

/// Lines that one text of a report is wrapped to: a line ends where the next word has no room.
class WrappedText {
  public:
    /// The next line, in which `indent` columns stand before the words. Whether there is a width for all
    /// lines up to it.
    bool take(std::string_view line, std::size_t indent) {
        const std::string_view words = line.substr(std::min(indent, line.size()));
        if (words.starts_with(' ') || words.ends_with(' ') || words.find("  ") != std::string_view::npos)
            return false;
        const std::size_t columns = indent + columns_of(words);
        const std::size_t first_word = columns_of(words.substr(0, words.find(' ')));
        if (before_ > 0) most_ = std::min(most_, before_ + first_word);
        if (words.find(' ') != std::string_view::npos) least_ = std::max(least_, columns);
        before_ = columns;
        return least_ <= most_;
    }

  private:
    std::size_t least_ = least_width, most_ = most_width; ///< columns that the report may have
    std::size_t before_ = 0;                              ///< columns of the line before
};

constexpr std::string_view rules_title = "findings by rule:";
constexpr std::string_view files_title = "findings by file:";

bool is_single_line(std::string_view line) {
    return is_concise_finding(line) || is_workflow_command(line) || is_message(line) || is_summary(line) ||
           is_not_shown(line) || is_timing(line);
}

class ReportReader {
  public:
    explicit ReportReader(std::string_view text)
        : lines_(text) {}

    /// Whether the text begins like a report, which few programs do.
    [[nodiscard]] bool begins() const {
        return is_headline(lines_.line()) || lines_.line() == rules_title || is_single_line(lines_.line());
    }

    bool read() {
        while (!lines_.at_end())
            if (!lines_.are_printable() || !read_part()) return false;
        return lines_.are_printable();
    }

  private:
    bool read_part() {
        const std::string& line = lines_.line();
        if (is_headline(line)) return read_finding();
        if (line == rules_title || line == files_title) {
            do lines_.next();
            while (is_count(lines_.line()) && !is_like_tape_mark(lines_.line()));
            return true;
        }
        if (!line.empty() && (!is_single_line(line) || is_like_tape_mark(line))) return false;
        lines_.next();
        return true;
    }

    bool read_finding() {
        constexpr std::size_t indent = 4;
        if (!read_wrapped(lines_.line().find(": ") + 2, indent)) return false;
        if (lines_.at_end()) return true;
        const std::size_t margin = margin_of_place(lines_.line(), "-->");
        if (margin == 0) return false;
        do {
            // No row is longer than a report is wide, but for words in it that are.
            if (holds_tape_mark_as_block(lines_.line()) && columns_of(lines_.line()) > most_width)
                return false;
            lines_.next();
        } while (is_row(lines_.line(), margin) || margin_of_place(lines_.line(), ":::") == margin);
        return read_end(std::string(margin, ' ') + " = ");
    }

    /// The cure and where to read more.
    bool read_end(const std::string& before) {
        const std::string cure = before + "cure: ";
        if (lines_.line().starts_with(cure) && !read_wrapped(cure.size(), cure.size())) return false;
        if (lines_.line().starts_with(before) && is_reference(lines_.line().substr(before.size())))
            lines_.next();
        return lines_.line().empty();
    }

    /// A text with `first` columns before it, and its further lines behind `indent` blanks.
    bool read_wrapped(std::size_t first, std::size_t indent) {
        const std::string blanks(indent, ' ');
        WrappedText text;
        std::size_t before = first;
        do {
            if (is_like_tape_mark(lines_.line()) || !text.take(without_reference(lines_.line()), before))
                return false;
            before = indent;
            lines_.next();
        } while (lines_.line().starts_with(blanks) && margin_of_place(lines_.line(), "-->") == 0);
        return true;
    }

    /// The reference stands at the end of a cure's last line where there is room.
    static std::string_view without_reference(std::string_view line) {
        constexpr std::string_view gap = "   ";
        const std::size_t at = line.rfind(gap);
        if (at == std::string_view::npos || !is_reference(line.substr(at + gap.size()))) return line;
        line = line.substr(0, at);
        return line.substr(0, line.find_last_not_of(' ') + 1);
    }

    Lines lines_;
};

} // namespace

bool is_own_report(std::string_view text) {
    text.remove_prefix(byte_order_mark_length(text));
    const std::string_view first = text.substr(0, text.find_first_of("\r\n"));
    return ReportReader(first).begins() && detect_encoding(text) == Encoding::utf8 &&
           ReportReader(text).read();
}

} // namespace maclint::cli
