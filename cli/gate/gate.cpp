//! First what is known, of all findings: a baseline must not lose what one run does not show. What a maker's
//! programs hold is left out last.
#include "cli/gate/gate.hpp"

#include "cli/gate/vendor_code.hpp"
#include "cli/text/shown.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <iterator>
#include <unordered_set>
#include <utility>

namespace maclint::cli {
namespace {

std::vector<InputFile> inputs_of(const Snapshot& snapshot) {
    std::vector<InputFile> inputs;
    for (const SnapshotFile& file : snapshot.files) inputs.push_back(file.input);
    return inputs;
}

/// Its own place, the others of the same cause, those that explain it, and the way there, till one is enough.
template<class IsEnough>
bool any_place(const Finding& finding, const IsEnough& is_enough) {
    const auto look_at = [&](const RelatedLocation& place) { return is_enough(*place.source, place.span); };
    return is_enough(*finding.source, finding.span) || std::ranges::any_of(finding.path, look_at) ||
           std::ranges::any_of(finding.further_places(), look_at);
}

std::unordered_set<const Source*> sources_shown(const Result& result) {
    std::unordered_set<const Source*> sources;
    for (const FilteredFinding& filtered : result.findings)
        any_place(filtered.finding, [&](const Source& source, Span) {
            sources.insert(&source);
            return false;
        });
    return sources;
}

std::vector<Notice> compare(ChangedLines& changed, const Result& result) {
    std::vector<const Source*> checked;
    for (const auto& source : result.sources) checked.push_back(source.get());
    return changed.compare(sources_shown(result), checked);
}

/// What the command itself raises hangs on more than the line that it is shown at: that a file is no program,
/// or one for another control, on any line, and whether a comment allows something on what other lines hold.
bool hangs_on_whole_file(const Finding& finding) {
    return std::holds_alternative<RaisedByCommand>(finding.rule->check);
}

bool shows_change(const Finding& finding, const ChangedLines& changed) {
    if (hangs_on_whole_file(finding) && changed.touch_any_line(*finding.source)) return true;
    return any_place(finding, [&](const Source& source, Span span) { return changed.touch(source, span); });
}

/// Nothing when none that counts is left out.
std::optional<Notice> leave_unchanged_out(Result& result, const ChangedLines& changed,
                                          const std::string& since) {
    std::size_t count = 0;
    std::erase_if(result.findings, [&](const FilteredFinding& filtered) {
        if (shows_change(filtered.finding, changed)) return false;
        if (!filtered.suppressed) ++count;
        return true;
    });
    if (count == 0) return std::nullopt;
    return Notice{NoticeKind::left_out, "",
                  counted(count, "finding") + " not shown: " + (count == 1 ? "it shows" : "they show") +
                      " no line changed since '" + shown(since) + "'."};
}

} // namespace

std::variant<Gate, Notice> Gate::open(const CheckRequest& request, const Snapshot& snapshot,
                                      BaselineStore& store) {
    Gate gate;
    auto known = KnownFindings::read(
        {request.overrides.baseline, request.write_baseline, request.prune_baseline, request.fail_on_gone},
        snapshot, store);
    if (auto* notice = std::get_if<Notice>(&known)) return std::move(*notice);
    gate.known_ = std::get<KnownFindings>(std::move(known));
    if (request.since.empty()) return gate;
    auto changed = ChangedLines::since(request.since, inputs_of(snapshot));
    if (auto* notice = std::get_if<Notice>(&changed)) return std::move(*notice);
    gate.changed_ = std::get<ChangedLines>(std::move(changed));
    gate.since_ = request.since;
    return gate;
}

std::vector<Notice> Gate::judge(const Snapshot& snapshot, Result& result) {
    std::vector<Notice> notices = known_.mark(snapshot, result);
    if (changed_) {
        std::ranges::move(compare(*changed_, result), std::back_inserter(notices));
        if (auto notice = leave_unchanged_out(result, *changed_, since_))
            notices.push_back(*std::move(notice));
    }
    if (auto notice = withhold_vendor_code(result)) notices.push_back(*std::move(notice));
    return notices;
}

} // namespace maclint::cli
