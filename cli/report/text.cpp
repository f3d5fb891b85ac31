//! Findings for people: what is wrong, where, how the control gets there and what it does then, the cure.
#include "cli/config/rule_words.hpp"
#include "cli/report/ansi_style.hpp"
#include "cli/report/columns.hpp"
#include "cli/report/report.hpp"
#include "cli/report/rows.hpp"
#include "cli/report/snippet.hpp"
#include "cli/report/statistics.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace maclint::cli {
namespace {

constexpr std::size_t least_code = 24;   ///< columns for code beside a long remark
constexpr std::size_t least_remark = 24; ///< columns for a remark
constexpr std::size_t gap = 3;           ///< between both

/// The texts of one row, laid out.
struct LaidOut {
    CodeLine code;
    std::string remark;
};

class TextWriter {
  public:
    explicit TextWriter(const TextStyle& style)
        : wanted_(style)
        , style_(style.colour) {}

    void add(const Finding& finding) {
        if (is_one_of_many(finding)) return;
        const Rows rows = rows_of(finding, wanted_.path, Remarks::beside_code);
        left_out_ += rows.left_out;
        margin_ = widest_number(rows.rows) + 1;
        add_headline("", finding);
        add_place("-->", *finding.source, finding.span);
        add_rows(rows.rows, finding.source.get());
        add_end(finding);
        out_ += "\n";
    }

    /// Places of findings that say what others before them say in full.
    void add_kinds() {
        for (const Kind& kind : kinds_) {
            if (kind.places.empty()) continue;
            const std::string head = std::string(name_of(kind.severity)) + "[" + kind.code + "]";
            out_ += style_.severity(kind.severity, head) +
                    style_.bold(": The same in " + counted(kind.places.size(), "more place") +
                                "; --path full shows all.") +
                    "\n";
            for (const std::string& place : kind.places) out_ += "  " + place + "\n";
            out_ += "\n";
        }
    }

    /// A finding that does not count: where it is, and why nobody is told of it.
    void add_withheld(const FilteredFinding& filtered) {
        const Finding& finding = filtered.finding;
        const Rows rows = rows_of(finding, PathDetail::none, Remarks::beside_code);
        margin_ = widest_number(rows.rows) + 1;
        add_headline("withheld ", finding);
        add_place("-->", *finding.source, finding.span);
        add_rows(rows.rows, finding.source.get());
        for (const NamedExemption& exemption : withheld_by(finding))
            add_labelled("by " + exemption.name() + ": ", std::string(exemption.record().why));
        out_ += "\n";
    }

    [[nodiscard]] std::size_t left_out() const { return left_out_; }
    [[nodiscard]] std::string take() { return std::move(out_); }

  private:
    /// Findings of one rule that say the same but for numbers.
    struct Kind {
        std::string code; ///< with the key of a row
        Severity severity;
        std::size_t count = 0;
        std::vector<std::string> places = {};
    };

    /// A habit is told in full three times; of what the control stops at, every place is.
    bool is_one_of_many(const Finding& finding) {
        constexpr std::size_t most_in_full = 3;
        if (finding.severity == Severity::error || wanted_.path == PathDetail::full) return false;
        const std::string code = code_with_key(finding);
        std::string words = finding.statement();
        std::erase_if(words, [](char c) { return c >= '0' && c <= '9'; });
        const auto [known, is_new] =
            kind_of_.try_emplace(code + std::string(name_of(finding.severity)) + words, kinds_.size());
        Kind& kind = is_new ? kinds_.emplace_back(Kind{code, finding.severity}) : kinds_[known->second];
        if (++kind.count <= most_in_full) return false;
        const auto add_place_of = [&](const Source& source, Span span) {
            const Position at = source.position(span.begin);
            kind.places.push_back(shown(source.path()) + ":" + std::to_string(at.line) + ":" +
                                  std::to_string(at.column));
        };
        add_place_of(*finding.source, finding.span);
        for (const RelatedLocation& repeat : finding.repeats) add_place_of(*repeat.source, repeat.span);
        return true;
    }

    static std::size_t widest_number(const std::vector<Row>& rows) {
        std::uint32_t widest = 1;
        for (const Row& row : rows) widest = std::max(widest, row.line);
        return std::to_string(widest).size();
    }

    void add_headline(std::string_view before, const Finding& finding) {
        const std::string head =
            std::string(before) + std::string(name_of(finding.severity)) + "[" + code_with_key(finding) + "]";
        const std::size_t used = std::min(head.size() + 2, wanted_.width); // a key of a row may be long
        const auto lines =
            wrapped(printable(finding.statement()), wanted_.width - used, wanted_.width - indent);
        out_ += style_.severity(finding.severity, head) + style_.bold(": " + lines.front()) + "\n";
        for (auto line = lines.begin() + 1; line != lines.end(); ++line)
            out_ += std::string(indent, ' ') + style_.bold(*line) + "\n";
    }

    void add_place(std::string_view arrow, const Source& source, Span span) {
        const Position at = source.position(span.begin);
        out_ += std::string(margin_, ' ') + style_.frame(arrow) + " " + shown(source.path()) + ":" +
                std::to_string(at.line) + ":" + std::to_string(at.column) + "\n";
    }

    void add_rows(const std::vector<Row>& rows, const Source* source) {
        const std::size_t room = wanted_.width - margin_ - frame_width;
        std::vector<LaidOut> texts;
        std::size_t widest_remark = 0;
        for (const Row& row : rows) {
            texts.push_back({code_line(*row.source, row.span, room), printable(row.remark)});
            if (!row.own) widest_remark = std::max(widest_remark, columns_of(texts.back().remark));
        }
        std::size_t column = least_code / 2; // at which remarks begin
        const std::size_t most = room - std::min(room - least_code, std::max(widest_remark, least_remark));
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::size_t end = columns_of(texts[i].code.text) + gap;
            // The finding's own row is not cut: a long one has its remark to itself.
            if (!rows[i].own || end <= most) column = std::max(column, std::min(end, most));
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (rows[i].source != source) add_place(":::", *rows[i].source, rows[i].span);
            source = rows[i].source;
            if (rows[i].own)
                add_own(rows[i], texts[i], column, room);
            else
                add_other(rows[i], texts[i], column, room);
        }
    }

    /// A row on the way; its code is cut so that the remark has room.
    void add_other(const Row& row, const LaidOut& text, std::size_t column, std::size_t room) {
        const bool fits = columns_of(text.code.text) + gap <= column;
        const std::string code = fits ? text.code.text : code_line(*row.source, row.span, column - gap).text;
        const auto lines = wrapped(text.remark, room - column, room - column);
        add_line(std::to_string(row.line), code, column, lines.front());
        for (auto line = lines.begin() + 1; line != lines.end(); ++line) add_line("", "", column, *line);
    }

    /// The finding's own row: all of its code, marked, and the remark where there is room for it.
    void add_own(const Row& row, const LaidOut& text, std::size_t column, std::size_t room) {
        const std::size_t code = columns_of(text.code.text);
        const std::size_t begin = std::max(column, code + gap);
        const bool beside = begin + columns_of(text.remark) <= room;
        add_line(std::to_string(row.line), text.code.text, begin, beside ? text.remark : "");
        const std::size_t blanks = text.code.marks.find('^');
        out_ += std::string(margin_, ' ') + " " + style_.frame("|") + " " + std::string(blanks, ' ') +
                style_.severity(Severity::error, text.code.marks.substr(blanks));
        const bool below = !beside && text.code.marks.size() + 1 + columns_of(text.remark) <= room;
        out_ += (below ? " " + style_.note(text.remark) : "") + "\n";
        // What has no room mostly repeats the headline.
        if (beside || below || wanted_.path != PathDetail::full) return;
        for (const std::string& line : wrapped(text.remark, room, room)) add_line("", "", 0, line);
    }

    void add_line(const std::string& number, const std::string& code, std::size_t column,
                  const std::string& remark) {
        out_ += std::string(margin_ - number.size(), ' ') + style_.frame(number) + " " + style_.frame("|");
        if (!code.empty()) out_ += " " + code;
        if (!remark.empty())
            out_ +=
                std::string(column - columns_of(code) + (code.empty() ? 1 : 0), ' ') + style_.note(remark);
        out_ += "\n";
    }

    /// A sentence below the rows.
    void add_labelled(const std::string& label, const std::string& sentence) {
        const std::size_t room = wanted_.width - margin_ - frame_width;
        const auto lines = wrapped(sentence, room - std::min(label.size(), room), room - indent);
        out_ +=
            std::string(margin_, ' ') + " " + style_.frame("=") + " " + style_.note(label) + lines.front();
        for (auto line = lines.begin() + 1; line != lines.end(); ++line)
            out_ += "\n" + std::string(margin_ + frame_width + indent, ' ') + *line;
        out_ += "\n";
    }

    /// The cure, and where to read more: beside it where there is room, on a line of its own for the first
    /// finding of the rule or row.
    void add_end(const Finding& finding) {
        const std::string code = code_with_key(finding);
        const std::string more = "more: maclint explain " + code;
        const bool is_first = explained_.insert(code).second;
        const std::string label = "cure: ";
        const std::string before = std::string(margin_, ' ') + " " + style_.frame("=") + " ";
        const std::size_t room = wanted_.width - margin_ - frame_width;
        const std::string cure = printable(finding.cure());
        if (cure.empty()) {
            if (is_first) out_ += before + more + "\n";
            return;
        }
        const auto lines = wrapped(cure, room - label.size(), room - label.size());
        out_ += before + style_.note(label) + lines.front();
        for (auto line = lines.begin() + 1; line != lines.end(); ++line)
            out_ += "\n" + std::string(margin_ + frame_width + label.size(), ' ') + *line;
        const std::size_t used = label.size() + columns_of(lines.back()) + gap;
        if (used + more.size() <= room)
            out_ += std::string(room - used - more.size() + gap, ' ') + more;
        else if (is_first)
            out_ += "\n" + before + more;
        out_ += "\n";
    }

    static constexpr std::size_t indent = 4;      ///< of a headline's further lines
    static constexpr std::size_t frame_width = 3; ///< of " | "

    TextStyle wanted_;
    AnsiStyle style_;
    std::size_t margin_ = 0;                    ///< columns before the frame
    std::size_t left_out_ = 0;                  ///< rows of paths
    std::unordered_set<std::string> explained_; ///< codes, with keys of rows
    std::vector<Kind> kinds_;
    std::unordered_map<std::string, std::size_t> kind_of_; ///< by code, severity and words without figures
    std::string out_;
};

} // namespace

std::string write_text(const Report& report, const TextStyle& style) {
    TextWriter writer(style);
    for (const FilteredFinding& filtered : report.findings)
        if (!filtered.suppressed) writer.add(filtered.finding);
    writer.add_kinds();
    for (const FilteredFinding& filtered : report.findings)
        if (is_withheld(filtered)) writer.add_withheld(filtered);
    const std::size_t left_out = writer.left_out();
    std::string out = writer.take();
    if (report.statistics) out += statistics_text(report);
    if (style.summary == Summary::left_out) return out;
    out += summary_line(report) + "\n" + fix_line(report) + known_lines(report);
    if (left_out > 0) out += counted(left_out, "step") + " of paths not shown; --path full shows them\n";
    return out;
}

} // namespace maclint::cli
