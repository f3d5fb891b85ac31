//! Files are told apart by their names below the folder of a baseline, wherever maclint was started.
#include "cli/gate/known_findings.hpp"

#include "analyzer/source/encoding.hpp"
#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/config/rule_words.hpp"
#include "cli/gate/match.hpp"
#include "cli/gate/write_alone.hpp"
#include "cli/report/fingerprint.hpp"
#include "cli/terminal.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <unordered_map>
#include <utility>

namespace maclint::cli {
namespace {

/// What a baseline is for: files that were linted, and what was found in them.
struct Share {
    std::string folder;
    LookedAt looked_at = {};
    std::vector<FilteredFinding*> findings = {}; ///< those that no comment allows
    std::vector<FoundPlaces> places = {};        ///< of these

    [[nodiscard]] bool exists(const std::string& name) const {
        return platform::kind_of(platform::path_of(path_of_name(name, folder))) !=
               platform::FileKind::missing;
    }
    [[nodiscard]] auto existing() const {
        return [this](const std::string& name) { return exists(name); };
    }
};

template<class Visit>
void for_each_place(const Finding& finding, const Visit& visit) {
    visit(finding.span);
    for (const RelatedLocation& repeat : finding.repeats) visit(repeat.span);
}

/// Of all linted files for which `takes` holds.
template<class Takes>
Share share_of(const std::string& path, const Snapshot& snapshot, Result& result, Fingerprints& prints,
               const Takes& takes) {
    Share share{.folder = folder_of_baseline(path)};
    std::set<std::string_view> linted;
    for (const auto& source : result.sources) linted.insert(source->path());
    std::unordered_map<std::string_view, std::string> names;
    for (const SnapshotFile& file : snapshot.files) {
        if (!linted.contains(file.input.path) || !takes(file)) continue;
        const std::string& name = names[file.input.path] = name_in_baseline(file.input.path, share.folder);
        share.looked_at[name] = file.settings.rules.get();
    }
    for (FilteredFinding& filtered : result.findings) {
        const Finding& finding = filtered.finding;
        const auto name = names.find(finding.source->path());
        if (filtered.suppressed || name == names.end()) continue;
        FoundPlaces& places = share.places.emplace_back();
        for_each_place(finding, [&](Span place) {
            places.push_back({name->second, code_with_key(finding), prints.of_place(finding, place)});
        });
        share.findings.push_back(&filtered);
    }
    return share;
}

std::string entries_of(std::size_t count) {
    return std::to_string(count) + (count == 1 ? " entry" : " entries");
}

std::string cut(const std::string& text) {
    constexpr std::size_t longest = 60;
    return text.size() <= longest ? text : text.substr(0, character_begin(text, longest, Encoding::utf8));
}

Baseline baseline_of(const Share& share, Fingerprints& prints) {
    std::map<KnownPlace, BaselineEntry> entries;
    for (std::size_t i = 0; i < share.findings.size(); ++i) {
        const Finding& finding = share.findings[i]->finding;
        auto place = share.places[i].begin();
        for_each_place(finding, [&](Span span) {
            const auto [entry, is_new] =
                entries.try_emplace(*place, BaselineEntry{.place = *place, .block = {}});
            if (is_new)
                entry->second.block = cut(prints.line_of(finding, span));
            else
                ++entry->second.count;
            ++place;
        });
    }
    Baseline baseline;
    for (auto& [place, entry] : entries) baseline.push_back(std::move(entry));
    return baseline;
}

void mark_known(FilteredFinding& filtered, const std::string& path) {
    filtered.suppressed = Suppression{.baseline = path};
}

Notice note(const std::string& path, const std::string& message) {
    return {NoticeKind::baseline, path, message};
}

/// A first one by name, the others by their number: a folder that has moved is many files.
std::string renamed_text(const std::vector<Renamed>& renamed, bool pruned) {
    const std::string others =
        renamed.size() == 1 ? "" : " and so on, " + counted(renamed.size(), "file") + " in all";
    return "'" + shown(renamed.front().from) + "' is gone and '" + shown(renamed.front().to) +
           "' has its findings" + others + ": taken for renamed." +
           (pruned ? "" : " --prune-baseline writes the new name.");
}

std::string gone_text(std::size_t count) {
    return entries_of(count) + (count == 1 ? " is" : " are") +
           " gone from the files checked. --prune-baseline takes " + (count == 1 ? "it" : "them") + " out.";
}

std::size_t places_in(const Baseline& baseline) {
    std::size_t count = 0;
    for (const BaselineEntry& entry : baseline) count += entry.count;
    return count;
}

/// Whatever stands there for people.
bool says_the_same(const Baseline& a, const Baseline& b) {
    return std::ranges::equal(a, b, [](const BaselineEntry& one, const BaselineEntry& other) {
        return one.place == other.place && one.count == other.count;
    });
}

Notice nothing_to_prune(const std::string& path) {
    return note(path, "nothing is to be pruned: nothing that was looked at is gone.");
}

Notice prune(const std::string& path, NamedBy named_by, const Share& share) {
    const auto read = read_baseline(path, named_by); // others may have written it since the run began
    if (const auto* refused = std::get_if<Notice>(&read)) return *refused;
    const auto& baseline = std::get<Baseline>(read);
    const Matched matched = match(baseline, share.places, share.looked_at, share.existing());
    if (says_the_same(baseline, matched.rest)) return nothing_to_prune(path);
    if (auto failure = write_to(path, baseline_text(matched.rest))) return *std::move(failure);
    const std::size_t removed = places_in(baseline) - places_in(matched.rest);
    return note(path, entries_of(removed) + " removed, " + std::to_string(places_in(matched.rest)) + " left" +
                          (matched.renamed.empty()
                               ? "."
                               : ", " + counted(matched.renamed.size(), "file") + " under a new name."));
}

/// A file that is there is only written over when it is a baseline.
std::variant<Baseline, Notice> read_before(const std::string& path) {
    const auto at = platform::path_of(path);
    if (platform::kind_of(at) != platform::FileKind::regular || platform::size_of(at) == 0) return Baseline{};
    auto read = read_baseline(path, NamedBy::command_line);
    if (auto* notice = std::get_if<Notice>(&read)) {
        if (!holds_baseline(path))
            notice->message = "--write-baseline does not write over this file, which is no baseline of "
                              "maclint. Name another file, or remove this one.";
        return std::move(*notice);
    }
    return read;
}

Notice write(const std::string& path, const Share& share, Fingerprints& prints) {
    const auto before = read_before(path); // others may have written it since the run began
    if (const auto* refused = std::get_if<Notice>(&before)) return *refused;
    Baseline baseline = baseline_of(share, prints);
    const Baseline others = out_of_sight(std::get<Baseline>(before), share.looked_at, share.existing());
    baseline.insert(baseline.end(), others.begin(), others.end());
    if (auto failure = write_to(path, baseline_text(std::move(baseline)))) return *std::move(failure);
    for (FilteredFinding* filtered : share.findings) mark_known(*filtered, path);
    return note(path,
                counted(share.findings.size(), "finding") + (share.findings.size() == 1 ? " is" : " are") +
                    " known from now on." +
                    (others.empty() ? ""
                                    : " " + entries_of(places_in(others)) + " of other files or rules " +
                                          (places_in(others) == 1 ? "is" : "are") + " kept."));
}

} // namespace

std::variant<KnownFindings, Notice> KnownFindings::read(BaselineWishes wishes, const Snapshot& snapshot,
                                                        BaselineStore& store) {
    KnownFindings known;
    known.wishes_ = std::move(wishes);
    std::set<std::string> paths;
    if (!known.wishes_.read.empty()) paths.insert(known.wishes_.read);
    for (const SnapshotFile& file : snapshot.files)
        if (file.input.asked && !file.settings.baseline.empty()) paths.insert(file.settings.baseline);
    for (const std::string& path : paths) {
        auto baseline = store.read(path, known.wishes_.named_by());
        if (auto* notice = std::get_if<Notice>(&baseline)) return std::move(*notice);
        known.baselines_[path] = std::get<std::shared_ptr<const Baseline>>(std::move(baseline));
    }
    if ((known.wishes_.prune || known.wishes_.fail_on_gone) && paths.empty())
        return Notice{NoticeKind::configuration, "",
                      std::string(known.wishes_.prune ? "--prune-baseline finds no baseline to prune"
                                                      : "--fail-on-gone finds no baseline") +
                          ". Name it with --baseline FILE, or as "
                          "'baseline' in the configuration."};
    if (!known.wishes_.write.empty()) {
        auto before = read_before(known.wishes_.write);
        if (auto* notice = std::get_if<Notice>(&before)) return std::move(*notice);
    }
    return known;
}

std::vector<Notice> KnownFindings::mark(const Snapshot& snapshot, Result& result) {
    std::vector<Notice> notices;
    has_stale_entries_ = false;
    Fingerprints prints;
    for (const auto& [path, kept] : baselines_) {
        const Baseline& baseline = *kept;
        const Share share =
            share_of(path, snapshot, result, prints,
                     [&path = path](const SnapshotFile& file) { return file.settings.baseline == path; });
        const Matched matched = match(baseline, share.places, share.looked_at, share.existing());
        for (std::size_t i = 0; i < share.findings.size(); ++i)
            if (matched.known[i]) mark_known(*share.findings[i], path);
        if (!matched.renamed.empty())
            notices.push_back(note(path, renamed_text(matched.renamed, wishes_.prune)));
        if (wishes_.prune && says_the_same(baseline, matched.rest))
            notices.push_back(nothing_to_prune(path)); // no lock: the folder may be one to read only
        else if (wishes_.prune)
            notices.push_back(
                write_alone(path, [&, &path = path] { return prune(path, wishes_.named_by(), share); }));
        else if (matched.gone > 0) {
            notices.push_back(note(path, gone_text(matched.gone)));
            has_stale_entries_ = true;
        }
    }
    if (!wishes_.write.empty()) {
        const Share share =
            share_of(wishes_.write, snapshot, result, prints, [](const SnapshotFile&) { return true; });
        notices.push_back(write_alone(wishes_.write, [&] { return write(wishes_.write, share, prints); }));
    }
    return notices;
}

} // namespace maclint::cli
