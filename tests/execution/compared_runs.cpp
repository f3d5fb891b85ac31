//! Each variable that a program may find vacant is so alone, is the only one that is not, and takes each
//! number.
#include "tests/execution/compared_runs.hpp"

#include "tests/execution/start_search.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace maclint::test {
namespace {

using execution::Leaving;

/// After the first difference: whether there is one at the end, too.
constexpr std::size_t after_difference = 60;

/// Where the deeds part; what was cut off says nothing of what comes then.
std::optional<std::uint32_t> first_difference(const RecordedRun& one, const RecordedRun& other) {
    const auto [at, at_other] = std::ranges::mismatch(one.deeds, other.deeds);
    const bool ends = at == one.deeds.end(), other_ends = at_other == other.deeds.end();
    if (!ends && !other_ends) return at_other->line;
    if ((ends && one.how == Leaving::cut_off) || (other_ends && other.how == Leaving::cut_off)) {
        // One goes on for ever without a deed where the other one has ended.
        const bool both = one.how == Leaving::cut_off && other.how == Leaving::cut_off;
        return both ? std::nullopt : std::optional<std::uint32_t>{0};
    }
    if (ends && other_ends && one.how == other.how) return std::nullopt;
    return ends ? (other_ends ? 0 : at_other->line) : at->line;
}

bool goes_on(const RecordedRun& run) { return run.how == Leaving::returns || run.how == Leaving::runs_off; }

/// What one start shows.
void add(Comparison& comparison, const RecordedRun& before, const RecordedRun& after) {
    ++comparison.runs;
    const bool ends = before.how != Leaving::cut_off || after.how != Leaving::cut_off;
    comparison.touching += ends && (before.touches_change || after.touches_change) ? 1U : 0U;
    comparison.blocks |= before.blocks != after.blocks;
    if (goes_on(before) && goes_on(after)) {
        comparison.codes_at_end |= before.codes_at_end != after.codes_at_end;
        comparison.variables_at_end |= before.variables_at_end != after.variables_at_end;
    }
    const auto difference = first_difference(before, after);
    if (!difference || comparison.values) return;
    comparison.values = true;
    comparison.line = *difference;
}

/// The programs of the first file that hold a changed line: those of both texts, in their order.
std::vector<std::size_t> programs_changed(const Workspace& workspace, const ChangedLines& changes) {
    std::vector<std::size_t> found;
    std::size_t index = 0;
    for (const ProgramAnalysis& analysis : workspace.programs()) {
        if (analysis.source()->path() != changes.path) continue;
        const Span span = analysis.program().span;
        const std::uint32_t first = line_of(analysis, span.begin);
        const std::uint32_t last = line_of(analysis, span.end == span.begin ? span.end : span.end - 1);
        if (std::ranges::any_of(changes.lines,
                                [&](std::uint32_t line) { return first <= line && line <= last; }))
            found.push_back(index);
        ++index;
    }
    return found;
}

const ProgramAnalysis* program_at(const Workspace& workspace, const std::string& path, std::size_t index) {
    for (const ProgramAnalysis& analysis : workspace.programs())
        if (analysis.source()->path() == path && index-- == 0) return &analysis;
    return nullptr;
}

/// The lines of blocks that some path leads to.
std::set<std::uint32_t> reachable_lines(const ProgramAnalysis& analysis) {
    std::set<std::uint32_t> lines;
    const flow::Graph& graph = analysis.graph();
    for (flow::NodeId node = 0; node < graph.nodes.size(); ++node) {
        const Span part = graph.nodes[node].part;
        if (part.empty() || !analysis.path_from_start(node)) continue;
        const std::uint32_t last = line_of(analysis, part.end - 1);
        for (std::uint32_t line = line_of(analysis, part.begin); line <= last; ++line) lines.insert(line);
    }
    return lines;
}

} // namespace

/// The searches in programs of the first file, by their place in it.
struct RunsOf::Kept {
    std::map<std::size_t, StartSearch> searches;
};

RunsOf::RunsOf(std::vector<NamedText> files)
    : files_(std::move(files))
    , workspace_(analyse_files(files_, {.complete = false, .jobs = 1}))
    , kept_(std::make_unique<Kept>()) {}

RunsOf::~RunsOf() = default;

Comparison RunsOf::compare(const std::string& text, const std::vector<NamedText>& added,
                           const ChangedLines& changes) {
    std::vector<NamedText> files = files_;
    files.front().second = text;
    files.insert(files.end(), added.begin(), added.end());
    const auto changed = analyse_files(files, {.complete = false, .jobs = 1});
    Comparison comparison;
    comparison.reachable = false;
    for (const std::size_t index : programs_changed(*workspace_, changes)) {
        const ProgramAnalysis* analysis = program_at(*workspace_, changes.path, index);
        const ProgramAnalysis* other = program_at(*changed, changes.path, index);
        if (analysis == nullptr || other == nullptr) continue;
        const StartSearch& search = kept_->searches.try_emplace(index, *analysis).first->second;
        const std::set<std::uint32_t> reachable = reachable_lines(*analysis), led_to = search.lines();
        comparison.reachable |=
            std::ranges::any_of(changes.lines, [&](std::uint32_t line) { return reachable.contains(line); });
        comparison.unreadable |= search.meets_unreadable();
        comparison.lines += reachable.size();
        comparison.led_to += static_cast<std::size_t>(
            std::ranges::count_if(led_to, [&](std::uint32_t line) { return reachable.contains(line); }));
        const std::vector<ToldStart> starts = search.starts_for(changes);
        std::size_t left = starts.size();
        for (const ToldStart& start : starts) {
            if (left-- == 0 || (comparison.values && comparison.codes_at_end)) break;
            const bool same_so_far = comparison.same();
            add(comparison, search.run(*analysis, start, changes, false),
                search.run(*other, start, changes, true));
            if (same_so_far && !comparison.same()) left = std::min(left, after_difference);
        }
    }
    return comparison;
}

} // namespace maclint::test
