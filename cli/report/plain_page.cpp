//! Lines are wrapped but for what is to be copied.
#include "cli/report/plain_page.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/source/encoding.hpp"
#include "cli/report/columns.hpp"
#include "cli/report/sources.hpp"

#include <algorithm>

namespace maclint::cli {
namespace {

constexpr std::string_view indent = "    ";

std::string printable_lines(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const auto line = text.substr(0, text.find('\n'));
        out += printable(to_utf8(line, detect_encoding(line))) + "\n";
        text.remove_prefix(line.size() == text.size() ? line.size() : line.size() + 1);
    }
    return out;
}

} // namespace

void PlainPage::add_title(std::string_view title, std::string_view family) {
    out_ += style_.bold(title) + " (" + std::string(family) + ")\n\n";
}

void PlainPage::add_heading(std::string_view heading) { out_ += "\n" + style_.note(heading) + "\n\n"; }

void PlainPage::add(std::string_view text) { add_lines(text, ""); }

void PlainPage::add_item(std::string_view text) { add_lines(text, indent); }

void PlainPage::add_to_copy(std::string_view text) { out_.append(indent).append(text).append("\n"); }

void PlainPage::add_lines(std::string_view text, std::string_view before) {
    if (width_ == 0) {
        out_ += std::string(before) + std::string(text) + "\n";
        return;
    }
    const std::size_t room = width_ - before.size();
    for (const std::string& line : wrapped(text, room, room)) out_ += std::string(before) + line + "\n";
}

void PlainPage::add_example(std::string_view heading, const Example& example,
                            const std::vector<std::uint32_t>& marked) {
    add_heading(std::string(heading) + " (" + origin_of(example) + "):");
    const std::string text = shown_example(example);
    std::uint32_t number = 1;
    for (std::string_view rest = text; !rest.empty(); ++number) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(rest.size(), line.size() + 1));
        if (std::ranges::find(marked, number) != marked.end())
            out_ += "  " + style_.severity(Severity::error, "> " + std::string(line)) + "\n";
        else
            out_ += (line.empty() ? "" : std::string(indent) + std::string(line)) + "\n";
    }
}

void PlainPage::add_source(std::string_view source) { add_item(source_sentence(source)); }

std::string origin_of(const Example& example) {
    std::string origin(example.dialect);
    if (example.file != Example::usual_file) origin.append(", ").append(example.file);
    if (!example.control.empty()) origin.append(", control with ").append(example.control);
    return origin;
}

std::string shown_example(const Example& example) {
    constexpr std::size_t longest = 2000;
    constexpr std::size_t start = 120;
    const bool cut = example.text.size() > longest;
    std::string out = printable_lines(cut ? example.text.substr(0, start) : example.text);
    if (cut) out += "… (" + std::to_string(example.text.size()) + " bytes)\n";
    return out;
}

std::string shown_source(std::string_view source) {
    const bool is_experience = source == "T" || source.starts_with("T:");
    return is_experience ? source_sentence(source) : std::string(source);
}

std::string allowances(std::string_view code, const std::function<bool(const Dialect&)>& wanted,
                       std::string_view quote, std::string_view between) {
    std::string all;
    for (const Dialect& dialect : dialects()) {
        if (!wanted(dialect)) continue;
        const std::string comment = std::string(dialect.comment_open) + "MACLINT ALLOW " + std::string(code) +
                                    " - REASON" + std::string(dialect.comment_close);
        if (all.find(comment) != std::string::npos) continue;
        all.append(all.empty() ? "" : between).append(quote).append(comment).append(quote);
        if (!dialect.comment_open.starts_with('(')) all.append(" (").append(dialect.name).append(")");
    }
    return all;
}

} // namespace maclint::cli
