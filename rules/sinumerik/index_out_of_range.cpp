//! SIN207: an index beyond its array.
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/queries/names/array_indices.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule index_out_of_range{
    .code = "SIN207",
    .name = "index-out-of-range",
    .summary = "An index is lower than 0, or not lower than the size of its array",
    .why = "Places of an array count from 0, so the last one is one less than its size: the control stops "
           "with an"
           " alarm at any other.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .facts = dataflow::facts<dataflow::Read>(),
    .messages = {{"always", "Index beyond the array: in '{0}' it is {1}, and the places go from 0 to {2}.",
                  "Correct the index, or the size of the array."},
                 {"reaches", "Index beyond the array: in '{0}' it goes to {1}, and the places from 0 to {2}.",
                  "Correct the bounds, or the size of the array."}},
    .bad = {{"sinumerik", R"nc(
DEF REAL PLACE[4]
PLACE[4]=50
M30
)nc"},
            {"sinumerik", R"nc(
DEF REAL PLACE[4]=SET(0,15,40,80)
DEF INT HOLE
FOR HOLE=1 TO 4
G0 X=PLACE[HOLE]
ENDFOR
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
DEF REAL PLACE[4]=SET(0,15,40,80)
DEF INT HOLE
FOR HOLE=1 TO 4
G0 X=PLACE[HOLE-1]
ENDFOR
M30
)nc"}},
    .alarms = {{"SINUMERIK", "17020", "illegal array index 1", false},
               {"SINUMERIK", "17030", "illegal array index 2", false}},
    .sources = {"MD: arrays begin at 0", "FUND06 p.63"},
    .check = &check,
};

namespace {

struct Range {
    double low, high;
};
using Ranges = std::unordered_map<ExpressionId, Range>;

Ranges ranges_read(const ProgramAnalysis& analysis) {
    Ranges ranges;
    for (const dataflow::Read& read : analysis.facts().all<dataflow::Read>()) {
        const auto [known, is_new] = ranges.emplace(read.expression, Range{read.value.low, read.value.high});
        if (is_new) continue;
        known->second.low = std::min(known->second.low, read.value.low);
        known->second.high = std::max(known->second.high, read.value.high);
    }
    return ranges;
}

std::optional<Range> range_of(const Program& program, const Ranges& ranges, ExpressionId id) {
    const auto& node = program.expressions[id].node;
    if (const auto* literal = std::get_if<Literal>(&node)) return Range{literal->value, literal->value};
    if (std::holds_alternative<Load>(node)) {
        const auto known = ranges.find(id);
        return known == ranges.end() ? std::nullopt : std::optional(known->second);
    }
    const auto* sum = std::get_if<Apply>(&node);
    if (sum == nullptr || (sum->operation != Operation::add && sum->operation != Operation::subtract))
        return {};
    const auto operands = program.operands_of(*sum);
    const auto left = range_of(program, ranges, operands.front());
    const auto right = range_of(program, ranges, operands.back());
    if (!left || !right) return {};
    if (sum->operation == Operation::add) return Range{left->low + right->low, left->high + right->high};
    return Range{left->low - right->high, left->high - right->low};
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const std::vector<ArrayIndex> indices = queries::known_indices(analysis);
    if (indices.empty()) return;
    const Ranges ranges = ranges_read(analysis);
    for (const ArrayIndex& index : indices) {
        const auto range = range_of(program, ranges, index.index);
        if (!range || !std::isfinite(range->low) || !std::isfinite(range->high)) continue;
        const double last = index.size - 1;
        const bool always = range->high < 0 || range->low > last;
        if (!always && range->low >= 0 && range->high <= last) continue;
        const double wrong = range->high > last ? range->high : range->low;
        Finding& finding = reporter.report(
            {analysis, index.array}, program.expressions[index.index].span, always ? "always" : "reaches",
            {quoted(program, index.array), number_word(wrong), number_word(last)});
        if (!always) finding.severity = Severity::warning;
        if (!index.declared.empty())
            finding.related.push_back({analysis.source(), index.declared, "the array is defined here"});
    }
}

} // namespace
} // namespace maclint::rules
