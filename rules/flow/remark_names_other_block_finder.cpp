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

} // namespace

std::vector<OtherBlockNamed> find_other_blocks_named(const ProgramAnalysis& analysis) {
    const bool has_remarks =
        analysis.program().slice(analysis.program().span).find('(') != std::string_view::npos;
    if (analysis.graph().jumps.empty() || !has_remarks) return {};
    return Finder(analysis).run();
}

} // namespace maclint::rules
