//! First all names and calls, then one group of connected files after the other.
#include "cli/engine/engine.hpp"

#include "analyzer/dialect/maker_rights.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "analyzer/workspace/analyse_until.hpp"
#include "analyzer/workspace/parallel.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "analyzer/workspace/workspace.hpp"
#include "cli/engine/bounds.hpp"
#include "cli/engine/connections.hpp"
#include "cli/engine/other_control.hpp"
#include "cli/engine/read.hpp"
#include "cli/engine/row_choice.hpp"
#include "rules/finding_order.hpp"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>

namespace maclint::cli {
namespace {

/// A text as long as this is mostly rows of plain blocks, whose programs are small: reading it once is worth
/// more than letting it go in between. Bytes.
constexpr std::size_t long_text = 256UL * 1024;
/// So many bytes of shorter texts are read once, too: with their programs they take ten times as much.
constexpr std::size_t short_texts = 16UL * 1024 * 1024;

/// The work on one snapshot.
class Run {
  public:
    Run(const Snapshot& snapshot, const EngineOptions& options, Progress& progress, ProgramStore& store,
        OutlineStore& outlines, std::shared_ptr<const Connections> connections, const std::stop_token& stop)
        : snapshot_(snapshot)
        , options_(options)
        , progress_(progress)
        , store_(store)
        , outlines_(outlines)
        , connections_(std::move(connections))
        , stop_(stop)
        , rows_(snapshot)
        , seen_(snapshot.files.size())
        , stamps_(snapshot.files.size())
        , controls_(snapshot.files.size()) {}

    Result run() {
        progress_.begin("reading", seen_.size());
        for_each(seen_.size(), options_.jobs, [&](std::size_t i) {
            try {
                look_at(i);
            } catch (const std::bad_alloc&) {
                give_up(i, "it does not fit into memory. Split the program or leave the file out.");
            }
            progress_.step();
        });
        if (stop_.stop_requested()) return Result{.cancelled = true};
        check_groups(groups_asked_for());
        if (stop_.stop_requested()) return Result{.cancelled = true};
        put_in_order(result_.findings, &FilteredFinding::finding);
        for (auto notice : {bounds_.searches(), bounds_.jumps()})
            if (notice) result_.notices.push_back(*std::move(notice));
        result_.timing = watches_.times();
        return std::move(result_);
    }

    /// At files of which nothing was known.
    [[nodiscard]] std::size_t looks() const { return looks_; }
    [[nodiscard]] const std::shared_ptr<const Connections>& connections() const { return connections_; }

  private:
    template<class Work>
    void for_each(std::size_t count, unsigned jobs, const Work& work) const {
        for_each_parallel(count, jobs, [&](std::size_t i) {
            if (!stop_.stop_requested()) work(i);
        });
    }

    /// Finds out what the file is, and which programs it names and calls.
    void look_at(std::size_t place) {
        const Stopwatches::Running running(watches_.reading);
        const SnapshotFile& file = snapshot_.files[place];
        if (options_.kept_bytes == 0 || file.input.asked || file.text) return look_anew_at(place);
        const auto stamp = stamps_[place] = platform::settled_stamp_of(platform::path_of(file.input.path));
        if (auto kept = outlines_.find(file, stamp)) {
            seen_[place] = *std::move(kept);
            return;
        }
        look_anew_at(place);
        outlines_.keep(file, stamp, seen_[place]);
    }

    void look_anew_at(std::size_t place) {
        const SnapshotFile& file = snapshot_.files[place];
        SeenFile& seen = seen_[place];
        ++looks_;
        auto opened = open_file(file);
        if (auto* notice = std::get_if<Notice>(&opened)) {
            seen.read.notice = std::move(*notice);
            return;
        }
        auto source = std::make_shared<const Source>(std::get<Source>(std::move(opened)));
        ++watches_.files;
        watches_.bytes += source->size();
        const bool at_once =
            source->size() >= long_text || (file.input.asked && (at_once_ += source->size()) <= short_texts);
        seen.read =
            read_source(file, std::move(source), at_once ? Extent::whole : Extent::names_and_calls, store_);
        if (seen.read.file == nullptr || seen.read.not_nc) return;
        seen.outline = outline_of(*seen.read.file);
        if (!at_once) seen.read.file = nullptr;
        if (!file.input.asked) seen.read.source = nullptr; // few of these will be asked for again
    }

    /// Nothing is said of the file but why: what could be read of others is still reported.
    void give_up(std::size_t place, std::string_view why) {
        const std::string& path = snapshot_.files[place].input.path;
        seen_[place] = {};
        seen_[place].read.notice =
            Notice{NoticeKind::unreadable, path, "cannot be analysed: " + std::string(why)};
    }

    /// Those with a file that was asked for, the longest first, so that no thread is left with it at the end.
    std::vector<Group> groups_asked_for() {
        std::vector<FileOutline> outlines;
        outlines.reserve(seen_.size());
        for (SeenFile& seen : seen_) outlines.push_back(std::move(seen.outline));
        if (connections_ == nullptr || !connections_->hold_for(snapshot_, outlines))
            connections_ = std::make_shared<const Connections>(snapshot_, std::move(outlines));
        std::vector<Group> groups;
        std::ranges::copy_if(connections_->groups(), std::back_inserter(groups), [&](const Group& group) {
            return std::ranges::any_of(
                group, [&](std::size_t i) { return snapshot_.files[i].input.asked && is_linted(i); });
        });
        return groups;
    }

    [[nodiscard]] bool is_linted(std::size_t place) const { return seen_[place].read.dialect != nullptr; }

    void check_groups(const std::vector<Group>& groups) {
        std::size_t files = 0;
        for (const Group& group : groups) files += group.size();
        progress_.begin("checking", files);
        // A group that is most of the work has all threads; the others share them.
        const std::size_t share = files / (2UL * options_.jobs) + 1;
        const auto large = static_cast<std::size_t>(
            std::ranges::count_if(groups, [&](const Group& group) { return group.size() > share; }));
        std::vector<Checked> checked(groups.size());
        const auto check_one = [&](std::size_t i, unsigned jobs) {
            try {
                checked[i] = check(groups[i], jobs);
            } catch (const std::bad_alloc&) {
                for (const std::size_t place : groups[i])
                    if (is_linted(place))
                        give_up(place,
                                "there is not enough memory to analyse it with the programs that calls "
                                "connect it with. Leave large ones out.");
            }
            for (std::size_t done = 0; done < groups[i].size(); ++done) progress_.step();
        };
        for_each(large, 1, [&](std::size_t i) { check_one(i, options_.jobs); });
        for_each(groups.size() - large, options_.jobs, [&](std::size_t i) { check_one(large + i, 1); });
        for (Checked& part : checked) {
            std::ranges::move(part.findings, std::back_inserter(result_.findings));
            std::ranges::move(part.vendor, std::back_inserter(result_.vendor));
        }
        for (std::size_t i = 0; i < seen_.size(); ++i) {
            if (!snapshot_.files[i].input.asked) continue;
            ReadFile& read = seen_[i].read;
            if (read.notice) result_.notices.push_back(*std::move(read.notice));
            if (read.dialect == nullptr) continue;
            result_.read_as.push_back({std::string(read.dialect->name), std::move(controls_[i])});
            result_.sources.push_back(std::move(read.source));
        }
    }

    struct Checked {
        std::vector<FilteredFinding> findings;
        std::vector<VendorProgram> vendor;
    };

    /// What the rules find in the group's files that were asked for, judged by each file's own settings.
    Checked check(const Group& group, unsigned jobs) {
        std::vector<std::shared_ptr<const ProgramFile>> held;
        std::vector<WorkspaceFile> members;
        std::vector<FileRules> rules;
        std::vector<Finding> findings;
        for (const std::size_t i : group) {
            if (stop_.stop_requested()) return {};
            const SnapshotFile& file = snapshot_.files[i];
            const auto programs = held.emplace_back(programs_of(i));
            if (programs == nullptr) continue;
            controls_[i] = programs->control->name;
            if (file.input.asked) rules.push_back({programs.get(), file.settings.rules.get()});
            if (file.input.asked && file.settings.dialect == nullptr) // whoever names it wants to see all
                std::ranges::move(other_control(*programs, *seen_[i].read.dialect),
                                  std::back_inserter(findings));
            if (file.input.asked)
                std::ranges::move(connections_->same_numbers().findings_in(i, *programs),
                                  std::back_inserter(findings));
            if (seen_[i].read.not_nc)
                std::ranges::move(not_nc(*programs, *seen_[i].read.not_nc), std::back_inserter(findings));
            else
                members.push_back({programs, file.input.asked, file.settings.complete,
                                   connections_->computed_calls().may_mean(file, programs->control->language),
                                   connections_->own_macros().lie_by(file, programs->control->language),
                                   connections_->definitions().names_for(file, programs->control->language)});
        }
        const Selection selection = selection_of(rules);
        std::ranges::move(find_in(std::move(members), selection, jobs), std::back_inserter(findings));
        Checked checked{withhold_misread(apply_suppressions(std::move(findings), rules)), {}};
        checked.vendor = vendor_programs(group, held, checked.findings);
        return checked;
    }

    /// Those of files in which something was found that may be left out.
    [[nodiscard]] std::vector<VendorProgram>
    vendor_programs(const Group& group, const std::vector<std::shared_ptr<const ProgramFile>>& held,
                    const std::vector<FilteredFinding>& findings) const {
        std::unordered_set<const Source*> sources;
        for (const FilteredFinding& filtered : findings)
            if (filtered.finding.severity != Severity::error) sources.insert(filtered.finding.source.get());
        std::vector<VendorProgram> vendor;
        for (std::size_t i = 0; i < group.size(); ++i)
            if (held[i] != nullptr && sources.contains(held[i]->source.get()))
                add_vendor_programs(*held[i], snapshot_.files[group[i]].settings.vendor, vendor);
        return vendor;
    }

    static void add_vendor_programs(const ProgramFile& file, VendorCode code,
                                    std::vector<VendorProgram>& vendor) {
        const Source* source = file.source.get();
        if (code == VendorCode::whole_file)
            for (const Program& program : file.programs) vendor.push_back({source, program.span});
        if (code == VendorCode::by_remarks)
            for (const ProgramWithRights& program : programs_with_rights(file))
                vendor.push_back({source, program.program});
    }

    std::unique_ptr<Workspace> analyse(std::vector<WorkspaceFile> members, WorkspaceOptions options) {
        const Stopwatches::Running running(watches_.analysis);
        auto workspace = analyse_until(stop_, std::move(members), options);
        if (workspace != nullptr) watches_.programs += workspace->programs().size();
        return workspace;
    }

    /// The workspace goes before anybody judges what was found: both may be large. Nothing is found, or not
    /// all, where somebody has asked to stop.
    std::vector<Finding> find_in(std::vector<WorkspaceFile> members, const Selection& selection,
                                 unsigned jobs) {
        const auto workspace = analyse(std::move(members), {.jobs = jobs, .facts = facts_for(selection)});
        return workspace == nullptr ? std::vector<Finding>() : find(*workspace, selection, jobs);
    }

    std::vector<Finding> find(const Workspace& workspace, const Selection& selection, unsigned jobs) {
        const Stopwatches::Running running(watches_.rules);
        std::vector<BoundMet> met;
        auto findings = run_rules(workspace, selection, jobs, met, stop_);
        bounds_.add(met);
        for (const ProgramAnalysis& program : workspace.programs()) {
            const SearchCounts counts = program.search_memory().counts();
            watches_.searches += counts.searches;
            watches_.searches_given_up += counts.gave_up;
        }
        return findings;
    }

    /// The file's programs, whole; nullptr when it is not linted, or has gone in the meantime.
    std::shared_ptr<const ProgramFile> programs_of(std::size_t place) {
        const Stopwatches::Running running(watches_.reading);
        ReadFile& read = seen_[place].read;
        const ControlModel* lathe =
            read.dialect == nullptr ? nullptr : read.control->lathe_of(connections_->lathe_of_callers(place));
        if (read.dialect == nullptr || (read.file != nullptr && lathe == nullptr))
            return std::exchange(read.file, nullptr);
        read.file = nullptr;
        const SnapshotFile& file = snapshot_.files[place];
        const ProgramStore::Reading reading{read.dialect, lathe == nullptr ? read.control : lathe,
                                            file.settings.configuration};
        std::shared_ptr<const Source> source = read.source;
        if (source == nullptr) {
            if (auto kept = store_.find(file.input.path, stamps_[place], reading)) return kept;
            auto opened = open_file(file);
            if (std::holds_alternative<Notice>(opened)) return nullptr;
            source = std::make_shared<const Source>(std::get<Source>(std::move(opened)));
        }
        auto programs = store_.read(source, reading, stamps_[place]);
        if (read.source != nullptr) read.source = programs->source; // that of the findings
        return programs;
    }

    static std::vector<Finding> not_nc(const ProgramFile& file, const std::string& what_it_is) {
        Reporter reporter(*find_rule("MAC003"));
        reporter.report({file, {0, 0}}, {0, 0}, "not-nc", {what_it_is});
        return reporter.take();
    }

    /// What any file wants, or needs to have its suppressions judged; each file drops what it did not want.
    Selection selection_of(const std::vector<FileRules>& files) const {
        const Rule& unused_suppression = *find_rule("MAC001");
        std::vector<bool> wanted(all_rules().size());
        std::vector<const RuleStates*> seen;
        Selection selection{.rules = {}, .rows = rows_.wanted(), .exemptions = options_.exemptions};
        for (const FileRules& file : files) {
            const RuleStates& states = *file.rules;
            if (states.is_on(unused_suppression))
                for (const NamedRule& named : rules_in_suppressions(*file.file)) {
                    wanted[RuleStates::index_of(*named.rule)] = true;
                    if (!rows_.wants(named)) selection.rows = rows_.all();
                }
            if (std::ranges::find(seen, &states) != seen.end()) continue;
            seen.push_back(&states);
            for (std::size_t i = 0; i < wanted.size(); ++i)
                if (states.rules_on()[i]) wanted[i] = true;
        }
        for (std::size_t i = 0; i < wanted.size(); ++i)
            if (wanted[i]) selection.rules.push_back(all_rules()[i]);
        return selection;
    }

    const Snapshot& snapshot_;
    const EngineOptions& options_;
    Progress& progress_;
    ProgramStore& store_;
    OutlineStore& outlines_;
    std::shared_ptr<const Connections> connections_; ///< of the last snapshot, then of this
    const std::stop_token& stop_;
    RowChoice rows_;
    std::vector<SeenFile> seen_;                             ///< by place in the snapshot
    std::vector<std::optional<platform::FileStamp>> stamps_; ///< as above: of files that need not be opened
    std::vector<std::string> controls_;                      ///< that files were checked for, as above
    std::atomic<std::size_t> looks_ = 0;                     ///< at files of which nothing was known
    std::atomic<std::size_t> at_once_ = 0;                   ///< bytes of texts that were asked for
    Stopwatches watches_;
    Bounds bounds_;
    Result result_;
};

} // namespace

Result Engine::analyse(const Snapshot& snapshot, const std::stop_token& stop) {
    Run run(snapshot, options_, progress_, store_, outlines_, std::move(connections_), stop);
    Result result = run.run();
    looks_ += run.looks();
    if (options_.kept_bytes > 0) connections_ = run.connections();
    if (result.cancelled) return result; // what was not asked for yet may be in the next snapshot
    store_.drop_unused();
    outlines_.drop_unused();
    return result;
}

} // namespace maclint::cli
