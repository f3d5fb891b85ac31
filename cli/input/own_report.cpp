//! Reads a text as the writers of reports write it: findings of several lines, tables, and single lines.
#include "cli/input/own_report.hpp"

#include "analyzer/source/encoding.hpp"
#include "cli/input/report_lines.hpp"
#include "cli/report/columns.hpp"
#include "cli/report/report.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
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
constexpr std::string_view no_row = "  none";

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
        return rule_of_headline(lines_.line()) != nullptr || lines_.line() == rules_title ||
               is_single_line(lines_.line());
    }

    bool read() {
        while (!lines_.at_end())
            if (!lines_.are_printable() || !read_part()) return false;
        return lines_.are_printable();
    }

  private:
    bool read_part() {
        const std::string& line = lines_.line();
        if (const Rule* rule = rule_of_headline(line)) return read_finding(*rule);
        if (line == rules_title) return read_statistics();
        if (!line.empty() && (!is_single_line(line) || is_like_blocks(line))) return false;
        lines_.next();
        return true;
    }

    /// Both tables; rows of files could be anything, so they have to follow rows of rules and add up.
    bool read_statistics() {
        std::uint64_t in_rules = 0, in_files = 0;
        lines_.next();
        while (const auto count = count_of_rule(lines_.line())) {
            in_rules += *count;
            lines_.next();
        }
        if (in_rules == 0 && !lines_.at_end() && !take_line(no_row)) return false;
        if (lines_.at_end()) return true;
        if (!take_line(files_title)) return false;
        if (in_rules == 0) return lines_.at_end() || take_line(no_row);
        while (const auto count = count_of_file(lines_.line())) {
            if (is_like_blocks(lines_.line()) || *count > in_rules - in_files) return false;
            in_files += *count;
            lines_.next();
        }
        if (is_count_of_more_files(lines_.line())) lines_.next();
        return true;
    }

    bool take_line(std::string_view wanted) {
        if (lines_.line() != wanted) return false;
        lines_.next();
        return true;
    }

    bool read_finding(const Rule& rule) {
        constexpr std::size_t indent = 4;
        const auto statement = read_wrapped(lines_.line().find(": ") + 2, indent);
        if (!statement || !are_words_of(rule, *statement)) return false;
        const std::size_t margin = margin_of_place(lines_.line(), "-->");
        if (margin == 0 || is_like_blocks(lines_.line())) return false;
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
    std::optional<std::string> read_wrapped(std::size_t first, std::size_t indent) {
        const std::string blanks(indent, ' ');
        WrappedText text;
        std::string words;
        std::size_t before = first;
        do {
            const std::string_view line = without_reference(lines_.line());
            if (is_like_blocks(lines_.line()) || !text.take(line, before)) return std::nullopt;
            words += line.substr(std::min(before, line.size()));
            before = indent;
            lines_.next();
        } while (lines_.line().starts_with(blanks) && margin_of_place(lines_.line(), "-->") == 0);
        return words;
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
