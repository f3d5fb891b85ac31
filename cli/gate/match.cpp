//! Counts places: first under the name of their own file, then under the names of files that are gone.
#include "cli/gate/match.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace maclint::cli {
namespace {

/// Whether the rule, or the row, held for a file when findings were looked for. One that no longer exists
/// finds nothing.
bool was_looked_for(const KnownPlace& place, const RuleStates& rules) {
    if (const Rule* rule = find_rule(place.rule)) return rules.is_on(*rule);
    const RuleRow* row = find_rule_row(place.rule);
    return row == nullptr || rules.of(*row).on;
}

std::string_view last_name(std::string_view path) { return path.substr(path.rfind('/') + 1); }

using Counts = std::map<KnownPlace, std::size_t>; ///< of one file; its name is left empty

std::size_t size_of(const Counts& counts) {
    std::size_t size = 0;
    for (const auto& [place, count] : counts) size += count;
    return size;
}

std::size_t shared_by(const Counts& a, const Counts& b) {
    std::size_t shared = 0;
    for (const auto& [place, count] : a)
        if (const auto other = b.find(place); other != b.end()) shared += std::min(count, other->second);
    return shared;
}

KnownPlace nameless(KnownPlace place) {
    place.file.clear();
    return place;
}

/// Pairs files that are gone with new ones.
class PairedFiles {
  public:
    PairedFiles(std::map<std::string, Counts> gone, std::map<std::string, Counts> fresh)
        : gone_(std::move(gone))
        , fresh_(std::move(fresh)) {}

    /// A file that was only moved to another folder keeps its last name.
    std::vector<Renamed> find() {
        pair_by([](const std::string& file, const Counts&) {
            return std::vector<std::string>{std::string(last_name(file))};
        });
        pair_equal();
        pair_by([](const std::string&, const Counts& places) {
            std::vector<std::string> keys;
            for (const auto& [place, count] : places) keys.push_back(place.rule + " " + place.fingerprint);
            return keys;
        });
        std::ranges::sort(pairs_, {}, &Renamed::to);
        return std::move(pairs_);
    }

  private:
    struct Candidate {
        std::size_t shared;
        const std::string* from;
        const std::string* to;
    };

    /// What more files have in common says of none which it is; and time stays with the number of files.
    static constexpr std::size_t most_holders = 32;

    /// Looks at pairs that share a key, best ones first.
    template<class KeysOf>
    void pair_by(const KeysOf& keys_of) {
        std::map<std::string, std::vector<const std::string*>> holders;
        for (const auto& [from, places] : gone_)
            for (const std::string& key : keys_of(from, places)) holders[key].push_back(&from);
        std::vector<Candidate> candidates;
        for (const auto& [to, places] : fresh_) {
            std::set<const std::string*> seen;
            for (const std::string& key : keys_of(to, places)) {
                const auto found = holders.find(key);
                if (found == holders.end() || found->second.size() > most_holders) continue;
                for (const std::string* from : found->second)
                    if (seen.insert(from).second) consider(candidates, *from, to);
            }
        }
        std::ranges::sort(candidates, [](const Candidate& a, const Candidate& b) {
            return std::tie(b.shared, *a.from, *a.to) < std::tie(a.shared, *b.from, *b.to);
        });
        std::vector<Renamed> pairs;
        std::set<std::string_view> taken_from;
        std::set<std::string_view> taken_to;
        for (const auto& [shared, from, to] : candidates) {
            if (taken_from.contains(*from) || !taken_to.insert(*to).second) continue;
            taken_from.insert(*from);
            pairs.push_back({*from, *to});
        }
        take(std::move(pairs));
    }

    /// Files that hold the very same may be paired in any way: in the order of their names.
    void pair_equal() {
        std::map<Counts, std::vector<const std::string*>> from_by_places;
        for (auto file = gone_.rbegin(); file != gone_.rend(); ++file)
            from_by_places[file->second].push_back(&file->first);
        std::vector<Renamed> pairs;
        for (const auto& [to, places] : fresh_) {
            const auto found = from_by_places.find(places);
            if (found == from_by_places.end() || found->second.empty()) continue;
            pairs.push_back({*found->second.back(), to});
            found->second.pop_back();
        }
        take(std::move(pairs));
    }

    void take(std::vector<Renamed> pairs) {
        for (Renamed& pair : pairs) {
            gone_.erase(pair.from);
            fresh_.erase(pair.to);
            pairs_.push_back(std::move(pair));
        }
    }

    void consider(std::vector<Candidate>& candidates, const std::string& from, const std::string& to) const {
        const Counts& known = gone_.at(from);
        const std::size_t shared = shared_by(known, fresh_.at(to));
        if (2 * shared >= size_of(known)) candidates.push_back({shared, &from, &to});
    }

    std::map<std::string, Counts> gone_, fresh_;
    std::vector<Renamed> pairs_;
};

class BaselineMatching {
  public:
    BaselineMatching(const Baseline& baseline, const std::vector<FoundPlaces>& findings,
                     const LookedAt& looked_at, const std::function<bool(const std::string&)>& exists)
        : findings_(findings)
        , looked_at_(looked_at) {
        for (const auto& [place, count, block] : baseline) {
            left_[place] += count;
            const bool is_new_name = files_.insert(place.file).second;
            if (is_new_name && !looked_at.contains(place.file) && !exists(place.file))
                gone_.insert(place.file);
        }
        matched_.known.resize(findings.size());
    }

    Matched match(const Baseline& baseline) {
        for (std::size_t i = 0; i < findings_.size(); ++i)
            if (!is_in_unknown_file(i)) take(i, nullptr);
        matched_.renamed = renames();
        std::map<std::string, const std::string*> old_names;
        std::map<std::string, std::string> new_names;
        for (const Renamed& renamed : matched_.renamed) {
            old_names[renamed.to] = &renamed.from;
            new_names[renamed.from] = renamed.to;
        }
        for (std::size_t i = 0; i < findings_.size(); ++i)
            if (is_in_unknown_file(i))
                if (const auto old = old_names.find(findings_[i].front().file); old != old_names.end())
                    take(i, old->second);
        for (const BaselineEntry& entry : baseline) keep(entry, new_names);
        return std::move(matched_);
    }

  private:
    [[nodiscard]] bool is_in_unknown_file(std::size_t finding) const {
        return !files_.contains(findings_[finding].front().file);
    }

    /// Also what makes the finding a new one uses up what is known of it.
    void take(std::size_t finding, const std::string* old_name) {
        bool all = true;
        for (KnownPlace place : findings_[finding]) {
            if (old_name != nullptr) place.file = *old_name;
            const auto left = left_.find(place);
            if (left != left_.end() && left->second > 0)
                --left->second;
            else
                all = false;
        }
        matched_.known[finding] = all;
    }

    [[nodiscard]] std::vector<Renamed> renames() const {
        if (gone_.empty()) return {};
        std::map<std::string, Counts> gone;
        std::map<std::string, Counts> fresh;
        for (const auto& [place, count] : left_)
            if (gone_.contains(place.file)) gone[place.file][nameless(place)] += count;
        for (std::size_t i = 0; i < findings_.size(); ++i)
            if (is_in_unknown_file(i))
                for (const KnownPlace& place : findings_[i]) ++fresh[place.file][nameless(place)];
        return PairedFiles(std::move(gone), std::move(fresh)).find();
    }

    /// Adds to the rest what is not gone of an entry, and counts the others.
    void keep(const BaselineEntry& entry, const std::map<std::string, std::string>& new_names) {
        BaselineEntry kept = entry;
        const auto renamed = new_names.find(entry.place.file);
        if (renamed != new_names.end()) kept.place.file = renamed->second;
        const auto seen = looked_at_.find(kept.place.file);
        const bool looked_for = seen != looked_at_.end() && was_looked_for(entry.place, *seen->second);
        const bool is_gone = gone_.contains(kept.place.file);
        if (looked_for || is_gone) {
            std::size_t& left = left_.at(entry.place);
            const std::size_t missing = std::min(left, kept.count);
            left -= missing;
            kept.count -= missing;
            if (looked_for) matched_.gone += missing;
        }
        if (kept.count > 0) matched_.rest.push_back(std::move(kept));
    }

    const std::vector<FoundPlaces>& findings_;
    const LookedAt& looked_at_;
    Counts left_;
    std::set<std::string> files_; ///< that the baseline knows
    std::set<std::string> gone_;  ///< of these
    Matched matched_;
};

} // namespace

Matched match(const Baseline& baseline, const std::vector<FoundPlaces>& findings, const LookedAt& looked_at,
              const std::function<bool(const std::string& name)>& exists) {
    return BaselineMatching(baseline, findings, looked_at, exists).match(baseline);
}

Baseline out_of_sight(const Baseline& baseline, const LookedAt& looked_at,
                      const std::function<bool(const std::string& name)>& exists) {
    Baseline others;
    std::ranges::copy_if(baseline, std::back_inserter(others), [&](const BaselineEntry& entry) {
        const auto seen = looked_at.find(entry.place.file);
        return seen != looked_at.end() ? !was_looked_for(entry.place, *seen->second)
                                       : exists(entry.place.file);
    });
    return others;
}

} // namespace maclint::cli
