//! Pages for a terminal, and what they have in common with those in Markdown.
#pragma once

#include "cli/report/ansi_style.hpp"
#include "cli/report/report.hpp"
#include "rules/rule.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {
struct Dialect;
}

namespace maclint::cli {

/// How a page is laid out for reading.
struct PageStyle {
    Colour colour = Colour::plain;
    std::size_t width = 0; ///< columns; 0: the reader wraps lines
};

/// Writes a page line by line.
class PlainPage {
  public:
    explicit PlainPage(const PageStyle& style)
        : width_(style.width)
        , style_(style.colour) {}

    /// The first line: what the page is about, and what that belongs to.
    void add_title(std::string_view title, std::string_view family);
    /// With an empty line before and behind it.
    void add_heading(std::string_view heading);
    void add(std::string_view text);
    /// Below a heading.
    void add_item(std::string_view text);
    void add_empty_line() { out_ += "\n"; }
    /// As it is, to be copied: not wrapped.
    void add_to_copy(std::string_view text);
    /// `marked`: lines (from 1) that the rule speaks of.
    void add_example(std::string_view heading, const Example& example,
                     const std::vector<std::uint32_t>& marked);
    /// As a sentence, with its key behind.
    void add_source(std::string_view source);

    [[nodiscard]] std::string take() { return std::move(out_); }

  private:
    void add_lines(std::string_view text, std::string_view before);

    std::size_t width_;
    AnsiStyle style_;
    std::string out_;
};

/// "fanuc"; "fanuc, O1002.nc" where the name of the file matters.
[[nodiscard]] std::string origin_of(const Example& example);
/// An example that a page can show: very long ones are cut.
[[nodiscard]] std::string shown_example(const Example& example);
/// A source with what its key means where that decides how far to trust it.
[[nodiscard]] std::string shown_source(std::string_view source);

/// The comment that allows the code, once for every way in which the wanted dialects write comments.
[[nodiscard]] std::string allowances(std::string_view code, const std::function<bool(const Dialect&)>& wanted,
                                     std::string_view quote, std::string_view between);

} // namespace maclint::cli
