//! Findings for people: message, place, the lines concerned, and how the control gets there.
#include "cli/report/ansi_style.hpp"
#include "cli/report/report.hpp"
#include "cli/report/snippet.hpp"
#include "cli/suggest.hpp"

#include <algorithm>

namespace maclint::cli {
namespace {

constexpr std::size_t longest_path = 12; ///< steps; of more the first and the last are shown

class TextWriter {
  public:
    explicit TextWriter(Colour colour)
        : style_(colour) {}

    void add(const Finding& finding) {
        const std::string head =
            std::string(name_of(finding.severity)) + "[" + std::string(finding.rule->code) + "]";
        out_ +=
            style_.severity(finding.severity, head) + style_.bold(": " + printable(finding.message())) + "\n";
        add_frame(*finding.source, finding.span);
        for (const RelatedLocation& related : finding.related) add_related(related, printable(related.text));
        add_path(finding.path);
        out_ += "\n";
    }

    [[nodiscard]] std::string take() { return std::move(out_); }

  private:
    void add_path(const std::vector<RelatedLocation>& path) {
        for (std::size_t i = 0; i < path.size(); ++i) {
            const bool skipped =
                path.size() > longest_path && i >= longest_path / 2 && i < path.size() - longest_path / 2;
            if (skipped) {
                const std::size_t count = path.size() - longest_path;
                out_ += style_.note("note") + ": " + counted(count, "step") + " left out\n";
                i += count - 1;
                continue;
            }
            const std::string step =
                "step " + std::to_string(i + 1) + " of " + std::to_string(path.size()) + ": ";
            add_related(path[i], step + printable(path[i].text));
        }
    }

    void add_related(const RelatedLocation& related, const std::string& text) {
        out_ += style_.note("note") + ": " + text + "\n";
        add_frame(*related.source, related.span);
    }

    void add_frame(const Source& source, Span span) {
        const auto lines = frame_of(source, span);
        const Position at = source.position(span.begin);
        std::uint32_t widest = 1;
        for (const FrameLine& line : lines) widest = std::max(widest, line.number);
        const std::string margin(std::to_string(widest).size() + 1, ' ');
        out_ += margin + style_.frame("-->") + " " + shown(source.path()) + ":" + std::to_string(at.line) +
                ":" + std::to_string(at.column) + "\n";
        out_ += margin + " " + style_.frame("|") + "\n";
        for (const FrameLine& line : lines) add_line(line, margin);
    }

    void add_line(const FrameLine& line, const std::string& margin) {
        if (line.number == 0) {
            out_ += margin + " " + style_.frame("|") + " " + line.text + "\n";
            return;
        }
        const std::string number = std::to_string(line.number);
        out_ += margin.substr(number.size()) + style_.frame(number) + " " + style_.frame("|");
        out_ += (line.text.empty() ? "" : " " + line.text) + "\n";
        if (line.marks.empty()) return;
        const std::size_t blanks = line.marks.find('^');
        out_ += margin + " " + style_.frame("|") + " " + line.marks.substr(0, blanks) +
                style_.severity(Severity::error, line.marks.substr(blanks)) + "\n";
    }

    AnsiStyle style_;
    std::string out_;
};

} // namespace

std::string write_text(const Report& report, const TextStyle& style) {
    TextWriter writer(style.colour);
    for (const FilteredFinding& filtered : report.findings)
        if (!filtered.suppressed) writer.add(filtered.finding);
    std::string out = writer.take();
    if (style.summary == Summary::at_the_end) out += summary_line(report) + "\n";
    return out;
}

} // namespace maclint::cli
