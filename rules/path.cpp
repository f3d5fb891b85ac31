//! Puts paths through the flow graph into words.
#include "rules/path.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/paths/path_steps.hpp"
#include "analyzer/queries/values/origins.hpp"
#include "analyzer/source/encoding.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace maclint {
namespace {

constexpr std::size_t most_steps = 12;
constexpr std::size_t longest_quote = 40;
constexpr std::size_t most_looked_at = 1024; ///< bytes of a quote

/// What a step along the edge means to a reader; empty for the next block.
std::string words_for(const ProgramAnalysis& analysis, const flow::Edge& edge) {
    switch (edge.kind) {
    case flow::EdgeKind::next: return {};
    case flow::EdgeKind::branch: return std::string(queries::outcome_of(analysis, edge));
    case flow::EdgeKind::jump:
    case flow::EdgeKind::computed:
        return "jumps to line " + line_number(analysis.file(), analysis.graph().nodes[edge.to].part.begin);
    case flow::EdgeKind::back: return "the loop starts again";
    case flow::EdgeKind::pass: return "the other channels go on";
    case flow::EdgeKind::skip: return "the block is skipped when its switch is on";
    case flow::EdgeKind::resume:
        return "the called program returns to line " +
               line_number(analysis.file(), analysis.graph().nodes[edge.to].part.begin);
    }
    return {};
}

} // namespace

std::vector<RelatedLocation> steps_along(const ProgramAnalysis& analysis,
                                         std::span<const flow::EdgeId> path) {
    std::vector<RelatedLocation> related;
    std::optional<flow::NodeId> decided; // where the condition of the last step leads
    for (const flow::EdgeId step : queries::telling_steps(analysis, path, most_steps)) {
        const flow::Edge& edge = analysis.graph().edges[step];
        std::string words = words_for(analysis, edge);
        if (!related.empty() && edge.kind == flow::EdgeKind::jump && edge.from == decided)
            related.back().text += ": " + words;
        else
            related.push_back({analysis.source(), queries::span_of_step(analysis, step), std::move(words)});
        decided = edge.kind == flow::EdgeKind::branch ? std::optional(edge.to) : std::nullopt;
    }
    return related;
}

std::vector<RelatedLocation> path_between(const ProgramAnalysis& analysis, flow::NodeId from,
                                          flow::NodeId to) {
    const auto path = queries::shortest_path(analysis, from, to);
    return path ? steps_along(analysis, *path) : std::vector<RelatedLocation>{};
}

RelatedLocation related_at(const ProgramAnalysis& analysis, dataflow::OriginId origin, std::string text) {
    return {analysis.source(), queries::span_of_origin(analysis, origin), std::move(text)};
}

RelatedLocation related_at_effect(const ProgramAnalysis& analysis, EffectId effect, std::string text) {
    return {analysis.source(), analysis.program().effects[effect].span, std::move(text)};
}

Cause cause_at(const ProgramAnalysis& analysis, dataflow::OriginId origin) {
    if (const auto effect = queries::effect_of_origin(analysis, origin)) return {analysis, *effect};
    return {analysis, queries::span_of_origin(analysis, origin)};
}

std::string with_letter(const ProgramAnalysis& analysis, Variable variable) {
    std::string name = analysis.program().spell(variable);
    const ControlModel& control = analysis.control();
    const auto formal = std::ranges::find(control.formals, variable);
    if (control.formal_letters.empty() || formal == control.formals.end() || !analysis.is_macro())
        return name;
    const char letter = control.formal_letters[static_cast<std::size_t>(formal - control.formals.begin())];
    return name + " (" + letter + ")";
}

std::string quoted(const Program& program, Span span) { return quoted(program.slice(span)); }

std::string quoted(std::string_view bytes) {
    // A block can be as long as a file: what is not shown is not looked at.
    if (bytes.size() > most_looked_at)
        bytes = bytes.substr(0, character_begin(bytes, most_looked_at, Encoding::utf8));
    const std::string text = to_utf8(bytes, detect_encoding(bytes));
    std::string folded;
    std::size_t characters = 0;
    for (const char c : text) {
        const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\0';
        if (blank && (folded.empty() || folded.back() == ' ')) continue;
        // A byte that does not continue a UTF-8 character begins one.
        const bool begins_character = (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
        if (begins_character && characters++ == longest_quote) return folded + "…";
        folded += blank ? ' ' : c;
    }
    while (!folded.empty() && folded.back() == ' ') folded.pop_back();
    return folded;
}

std::string number_word(double number) {
    std::array<char, 32> digits{};
    char* const last = digits.data() + digits.size();
    auto written = std::to_chars(digits.data(), last, number, std::chars_format::fixed); // 200000, no 2e+05
    if (written.ec != std::errc{}) written = std::to_chars(digits.data(), last, number);
    return {digits.data(), written.ec == std::errc{} ? written.ptr : digits.data()};
}

std::string length_word(double length) {
    constexpr double steps = 10'000; // in a millimetre
    return number_word(std::round(length * steps) / steps);
}

std::string line_number(const ProgramFile& file, Offset offset) {
    return std::to_string(file.source->position(offset).line);
}

std::string place_in(const ProgramAnalysis& analysis, Span span) {
    const std::string& name = analysis.program().name;
    const std::string& path = analysis.source()->path();
    const std::string file = analysis.workspace().count_named(name) > 1
                                 ? " (" + path.substr(path.find_last_of('/') + 1) + ")"
                                 : "";
    return name + " line " + line_number(analysis.file(), span.begin) + file;
}

} // namespace maclint
