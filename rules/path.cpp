//! Puts paths through the flow graph into words.
#include "rules/path.hpp"

#include "analyzer/queries/origins.hpp"
#include "analyzer/queries/path_steps.hpp"
#include "analyzer/source/encoding.hpp"

#include <array>
#include <charconv>
#include <cstddef>

namespace maclint {
namespace {

constexpr std::size_t most_steps = 12;
constexpr std::size_t longest_quote = 40;

/// What a step along the edge means to a reader; empty for the next block.
std::string words_for(const ProgramAnalysis& analysis, const flow::Edge& edge) {
    const Program& program = analysis.program();
    switch (edge.kind) {
    case flow::EdgeKind::next: return {};
    case flow::EdgeKind::branch:
        return "the condition '" + quoted(program, program.expressions[*edge.condition].span) +
               (edge.holds ? "' is true here" : "' is not true here");
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
    for (const flow::EdgeId step : queries::telling_steps(analysis, path, most_steps))
        related.push_back({analysis.source(), queries::span_of_step(analysis, step),
                           words_for(analysis, analysis.graph().edges[step])});
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

std::string quoted(const Program& program, Span span) {
    const std::string_view bytes = program.slice(span);
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
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    return {digits.data(), error == std::errc{} ? end : digits.data()};
}

std::string line_number(const ProgramFile& file, Offset offset) {
    return std::to_string(file.source->position(offset).line);
}

} // namespace maclint
