//! Reads the remarks beside jumps.
#include "rules/flow/remark_names_other_block_finder.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/program/block_view.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace maclint::rules {
namespace {

/// What a remark says, and where.
struct Remark {
    Span span;
    bool is_alone; ///< in its line
    std::int64_t named;
};

/// Where a number begins that is that of a block: behind `GOTO`, `GO TO N`, `TO N`; nothing where there is
/// none.
std::optional<std::size_t> number_behind_to(std::string_view text, std::size_t from) {
    constexpr std::array<std::string_view, 6> openings = {"GO TO N",      "GOTO N",    "GOTO",
                                                          "GO TO BLOCK ", "JUMP TO N", "JUMPS TO N"};
    std::optional<std::size_t> found;
    for (const std::string_view opening : openings) {
        const std::size_t at = text.find(opening, from);
        if (at == std::string_view::npos) continue;
        std::size_t number = at + opening.size();
        while (number < text.size() && text[number] == ' ') ++number;
        if (number < text.size() && is_digit(text[number])) found = std::min(number, found.value_or(number));
    }
    return found;
}

/// The only block that a remark sends to.
std::optional<std::int64_t> block_named(std::string_view remark) {
    const std::string text = in_capitals(remark);
    std::optional<std::int64_t> named;
    for (auto at = number_behind_to(text, 0); at; at = number_behind_to(text, *at)) {
        std::int64_t number = 0;
        std::from_chars(text.data() + *at, text.data() + text.size(), number);
        if (named && *named != number) return std::nullopt;
        named = number;
    }
    // Code that is switched off is no word about the code that is not: `(IF[#1EQ1]GOTO5)`.
    return text.find_first_of("[#=") == std::string::npos ? named : std::nullopt;
}

/// The remark in a line, where it names a block.
std::optional<Remark> remark_in(const Program& program, Span line) {
    const std::string_view text = program.slice(line);
    const std::size_t open = text.find('(');
    if (open == std::string_view::npos) return std::nullopt;
    const std::size_t close = text.find(')', open);
    if (close == std::string_view::npos) return std::nullopt;
    const auto named = block_named(text.substr(open, close - open));
    if (!named) return std::nullopt;
    const bool is_alone = text.substr(0, open).find_first_not_of(" \t") == std::string_view::npos;
    return Remark{{static_cast<Offset>(line.begin + open), static_cast<Offset>(line.begin + close + 1)},
                  is_alone,
                  *named};
}

std::vector<Span> lines_of(const ProgramAnalysis& analysis) {
    std::vector<Span> lines;
    const Source& source = *analysis.source();
    const Span program = analysis.program().span;
    const std::uint32_t last = source.position(program.end).line;
    for (std::uint32_t line = source.position(program.begin).line; line <= last; ++line)
        lines.push_back(source.line_span(line));
    return lines;
}

/// Jumps to a number, by the line in which they stand.
using Jumps = std::multimap<std::size_t, const flow::ResolvedJump*>;

Jumps jumps_by_line(const ProgramAnalysis& analysis, const std::vector<Span>& lines) {
    Jumps jumps;
    for (const flow::ResolvedJump& jump : analysis.graph().jumps) {
        if (!jump.label || !std::holds_alternative<std::int64_t>(*jump.label)) continue;
        const Offset at = analysis.program().effects[jump.jump].span.begin;
        const auto line = std::ranges::upper_bound(lines, at, {}, &Span::begin);
        if (line != lines.begin()) jumps.emplace(line - lines.begin() - 1, &jump);
    }
    return jumps;
}

bool has_block(const Program& program, std::int64_t number) {
    bool found = false;
    for_each_block(program, [&](const BlockView& block) {
        found |= block.number == number;
        return !found;
    });
    return found;
}

bool is_remark(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t");
    return first != std::string_view::npos && line[first] == '(';
}

class Finder {
  public:
    explicit Finder(const ProgramAnalysis& analysis)
        : program_(analysis.program())
        , lines_(lines_of(analysis))
        , jumps_(jumps_by_line(analysis, lines_)) {}

    [[nodiscard]] std::vector<OtherBlockNamed> run() const {
        std::vector<OtherBlockNamed> found;
        for (std::size_t line = 0; line < lines_.size(); ++line) {
            const auto remark = remark_in(program_, lines_[line]);
            if (!remark) continue;
            const auto beside = remark->is_alone ? jumps_around(line) : jumps_in(line);
            const auto goes_there = [&](const flow::ResolvedJump* jump) {
                return target(*jump) == remark->named;
            };
            if (beside.empty() || std::ranges::any_of(beside, goes_there)) continue;
            if (!has_block(program_, remark->named)) continue;
            found.push_back({beside.front()->jump, target(*beside.front()), remark->named, remark->span});
        }
        return found;
    }

  private:
    using Beside = std::vector<const flow::ResolvedJump*>;

    static std::int64_t target(const flow::ResolvedJump& jump) { return std::get<std::int64_t>(*jump.label); }

    [[nodiscard]] Beside jumps_in(std::size_t line) const {
        Beside found;
        const auto [first, last] = jumps_.equal_range(line);
        for (auto one = first; one != last; ++one) found.push_back(one->second);
        return found;
    }

    /// Of the lines with jumps next to the remarks around the line: a few jumps in a row may have theirs
    /// behind them, one each. The nearest before comes first. None that another of these remarks names.
    [[nodiscard]] Beside jumps_around(std::size_t line) const {
        Beside found;
        std::vector<std::int64_t> named;
        for (const int step : {-1, 1}) {
            bool in_remarks = true;
            for (int i = 1; i <= most_lines; ++i) {
                const std::size_t at = line + static_cast<std::size_t>(step * i); // wraps below the first
                if (at >= lines_.size()) break;
                const Beside here = jumps_in(at);
                in_remarks = in_remarks && here.empty() && is_remark(program_.slice(lines_[at]));
                if (here.empty() && !in_remarks) break;
                const auto other = in_remarks ? remark_in(program_, lines_[at]) : std::nullopt;
                if (other) named.push_back(other->named);
                found.insert(found.end(), here.begin(), here.end());
            }
        }
        std::erase_if(found, [&](const flow::ResolvedJump* jump) {
            return std::ranges::find(named, target(*jump)) != named.end();
        });
        return found;
    }

    static constexpr int most_lines = 8; ///< before a remark, and behind it
    const Program& program_;
    std::vector<Span> lines_;
    Jumps jumps_;
};

/// A number behind a T, with where it stands in a line.
struct NumberedTool {
    std::int64_t number;
    std::size_t begin, end;
};

std::optional<NumberedTool> tool_at(std::string_view text, std::size_t at) {
    std::size_t end = at + 1;
    while (end < text.size() && is_digit(text[end])) ++end;
    constexpr std::size_t most_digits = 4;
    if (at >= text.size() || to_capital(text[at]) != 'T' || end == at + 1 || end > at + 1 + most_digits ||
        (end < text.size() && (is_letter(text[end]) || text[end] == '.')))
        return std::nullopt;
    std::int64_t number = 0;
    std::from_chars(text.data() + at + 1, text.data() + end, number);
    return number == 0 ? std::nullopt : std::optional(NumberedTool{number, at, end});
}

/// The only T of the block, where it calls nothing and holds no variable.
std::optional<NumberedTool> tool_called_in(std::string_view block) {
    if (block.find_first_of("#[Pp") != std::string_view::npos) return std::nullopt;
    const std::size_t at = block.find_first_of("Tt");
    if (at == std::string_view::npos || block.find_first_of("Tt", at + 1) != std::string_view::npos)
        return std::nullopt;
    return tool_at(block, at);
}

/// The tool with which the remark begins that opens there.
std::optional<NumberedTool> tool_of_remark(std::string_view line, std::size_t open) {
    const std::size_t first = line.find_first_not_of(' ', open + 1);
    return first == std::string_view::npos ? std::nullopt : tool_at(line, first);
}

bool is_same_tool(std::int64_t called, std::int64_t named) {
    constexpr std::int64_t edges = 100; // of a lathe's T1205
    return named == called || named == called / edges || named == called % edges || called == named / edges;
}

class ToolFinder {
  public:
    explicit ToolFinder(const ProgramAnalysis& analysis)
        : program_(analysis.program())
        , source_(*analysis.source()) {}

    [[nodiscard]] std::vector<OtherToolNamed> run() {
        const Span all = program_.span;
        const std::string_view text = program_.slice(all);
        std::uint32_t read_to = 0; // lines up to it have been looked at
        for (std::size_t at = text.find('('); at != std::string_view::npos; at = text.find('(', at + 1)) {
            const std::uint32_t line = source_.position(all.begin + static_cast<Offset>(at)).line;
            if (line <= read_to) continue;
            read_to = line;
            look_at(line);
        }
        return std::move(found_);
    }

  private:
    [[nodiscard]] std::string_view text_of(std::uint32_t line) const {
        return program_.slice(source_.line_span(line));
    }

    void look_at(std::uint32_t line) {
        const std::string_view text = text_of(line);
        const auto named = tool_of_remark(text, text.find('('));
        if (!named) return;
        if (!is_remark(text)) return hold(line, text.substr(0, text.find('(')), line, *named);
        const bool is_last = line == source_.position(program_.span.end).line;
        if (is_last || is_in_list(line)) return;
        const std::string_view next = text_of(line + 1);
        if (next.find('(') == std::string_view::npos) hold(line + 1, next, line, *named);
    }

    /// Whether the line before is such a remark, too.
    [[nodiscard]] bool is_in_list(std::uint32_t line) const {
        if (line <= source_.position(program_.span.begin).line) return false;
        const std::string_view before = text_of(line - 1);
        return is_remark(before) && tool_of_remark(before, before.find('('));
    }

    void hold(std::uint32_t line, std::string_view block, std::uint32_t remark, const NumberedTool& named) {
        const auto called = tool_called_in(block);
        if (!called || is_same_tool(called->number, named.number)) return;
        const Offset begin = source_.line_span(line).begin;
        found_.push_back(
            {{begin + static_cast<Offset>(called->begin), begin + static_cast<Offset>(called->end)},
             called->number,
             named.number,
             remark_of(remark)});
    }

    [[nodiscard]] Span remark_of(std::uint32_t line) const {
        const std::string_view text = text_of(line);
        const std::size_t open = text.find('(');
        const std::size_t close = std::min(text.find(')', open), text.size() - 1);
        const Offset begin = source_.line_span(line).begin;
        return {begin + static_cast<Offset>(open), begin + static_cast<Offset>(close + 1)};
    }

    const Program& program_;
    const Source& source_;
    std::vector<OtherToolNamed> found_;
};

bool has_remarks(const ProgramAnalysis& analysis) {
    return analysis.program().slice(analysis.program().span).find('(') != std::string_view::npos;
}

} // namespace

std::vector<OtherBlockNamed> find_other_blocks_named(const ProgramAnalysis& analysis) {
    if (analysis.graph().jumps.empty() || !has_remarks(analysis)) return {};
    return Finder(analysis).run();
}

std::vector<OtherToolNamed> find_other_tools_named(const ProgramAnalysis& analysis) {
    return ToolFinder(analysis).run();
}

} // namespace maclint::rules
