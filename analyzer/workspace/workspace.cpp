//! Builds the workspace: calls resolved, programs analysed from callees to callers, depths from callers to
//! callees.
#include "analyzer/workspace/workspace.hpp"

#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/dataflow/solver/callers_labels.hpp"
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/flow/components.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/analyse_until.hpp"
#include "analyzer/workspace/bind.hpp"
#include "analyzer/workspace/callers_locals.hpp"
#include "analyzer/workspace/handed_down.hpp"
#include "analyzer/workspace/parallel.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "analyzer/workspace/resolve.hpp"
#include "analyzer/workspace/written_as_macro.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <unordered_map>

namespace maclint {
namespace {

/// What the workspace itself asks for: whether a program reads arguments, and what changes in loops.
constexpr dataflow::FactSet own_facts =
    dataflow::facts<dataflow::Read, dataflow::Store, dataflow::Clobber, dataflow::CallMade>();

} // namespace

class WorkspaceBuilder {
  public:
    WorkspaceBuilder(Workspace& workspace, std::deque<ProgramAnalysis>& programs,
                     const WorkspaceOptions& options, const std::stop_token& stop)
        : workspace_(workspace)
        , programs_(programs)
        , stop_(stop)
        , jobs_(options.jobs)
        , facts_(options.facts | own_facts) {}

    static std::unique_ptr<Workspace> build(std::vector<WorkspaceFile> files, const WorkspaceOptions& options,
                                            const std::stop_token& stop) {
        std::unique_ptr<Workspace> workspace(new Workspace);
        workspace->files_ = std::move(files);
        if (!WorkspaceBuilder(*workspace, *workspace->programs_, options, stop).run()) return nullptr;
        return workspace;
    }

  private:
    /// False where somebody has asked to stop.
    bool run() {
        for (const WorkspaceFile& file : workspace_.files())
            for (const Program& program : file.file->programs)
                programs_.emplace_back(workspace_, static_cast<ProgramIndex>(programs_.size()), file,
                                       program);
        resolve_calls();
        find_ambiguous_names();
        components_ = flow::find_components(adjacency_);
        find_needed();
        find_labels_in_cycles();
        handed_down_.emplace(programs_, components_);
        callers_locals_.emplace(programs_, components_, &runs_on_its_own,
                                [this](const ProgramAnalysis& analysis) {
                                    return !analysis.undecided_.empty() ||
                                           (may_be_computed(analysis) && !runs_on_its_own(analysis));
                                });
        for (const auto& layer : flow::layers_of(adjacency_, components_)) analyse_layer(layer);
        if (stop_.stop_requested()) return false;
        mark_cycles();
        measure_depth();
        return true;
    }

    void resolve_calls() {
        const auto files = workspace_.files();
        std::vector<FileOutline> outlines(files.size());
        for_each_parallel(files.size(), jobs_,
                          [&](std::size_t i) { outlines[i] = outline_of(*files[i].file); });
        const CallResolver resolver(outlines);
        ProgramIndex index = 0;
        for (std::size_t file = 0; file < outlines.size(); ++file)
            for (const ProgramOutline& program : outlines[file].programs)
                resolve_calls(resolver, file, program, programs_[index++]);
        attribute_computed_calls();
        for (UndecidedCalls* calls : undecided_) {
            calls->passed = passed_by(calls->callers, nullptr);
            calls->locals_shared = some_share_locals(calls->callers);
        }
    }

    void resolve_calls(const CallResolver& resolver, std::size_t file, const ProgramOutline& outline,
                       ProgramAnalysis& analysis) {
        std::vector<std::pair<EffectId, const CallOutline*>> calls;
        for_each_effect(analysis.program(), [&](EffectId id) {
            if (std::holds_alternative<Call>(analysis.program().effects[id].what))
                calls.emplace_back(id, &outline.calls[calls.size()]);
        });
        std::ranges::sort(calls);
        for (const auto& [effect, call] : calls) {
            const auto* name = std::get_if<std::string>(&call->program);
            // A word of a file of definitions is read before a program of its name is looked for.
            const bool is_word = name != nullptr && analysis.names_elsewhere().word(*name) != nullptr;
            const Namesakes meant = is_word ? Namesakes{} : resolver.resolve(file, outline, *call);
            const auto target = meant.only();
            analysis.calls_.push_back({effect, target, false, false, meant.all, {}});
            const Caller caller{analysis.index(), effect};
            if (call->is_computed()) {
                computing_.insert(&analysis.file());
                computed_.push_back(caller);
            }
            if (target)
                bind(analysis, caller, analysis.calls_.back());
            else
                for (const auto& namesakes : meant.nearest) add_undecided(namesakes, caller);
        }
        adjacency_.end_list();
    }

    /// A call whose number only the running program knows may mean what nobody else calls: programs of its
    /// file, where there are none those of all files.
    void attribute_computed_calls() {
        if (computed_.empty()) return;
        std::map<const ProgramFile*, NamesakeList> uncalled; ///< by file; nullptr: of all files
        for (const ProgramAnalysis& analysis : programs_) {
            if (!analysis.program().number || analysis.program().local || !analysis.callers_.empty() ||
                !analysis.undecided_.empty() || runs_on_its_own(analysis))
                continue;
            uncalled[&analysis.file()].push_back(analysis.index());
            uncalled[nullptr].push_back(analysis.index());
        }
        using Lists = std::map<std::optional<std::int64_t>, std::shared_ptr<const NamesakeList>>;
        std::map<const ProgramFile*, Lists> lists;
        for (const Caller& caller : computed_) {
            const ProgramAnalysis& calling = programs_[caller.program];
            const ProgramFile* from = uncalled.contains(&calling.file()) ? &calling.file() : nullptr;
            Lists& known = lists[from];
            auto base = base_of(calling.program(), call_of(caller));
            if (known.size() >= most_bases) base.reset();
            auto& list = known[base];
            if (list == nullptr)
                list = std::make_shared<const NamesakeList>(that_lie_above(uncalled[from], base));
            add_undecided(list, caller);
        }
    }

    static constexpr std::size_t most_bases = 16; ///< that differ, of one file's calls
    [[nodiscard]] NamesakeList that_lie_above(const NamesakeList& programs,
                                              std::optional<std::int64_t> base) const {
        NamesakeList found;
        const auto room = base ? room_above(*base) : std::nullopt;
        for (const ProgramIndex index : programs) {
            const std::int64_t number = *programs_[index].program().number;
            if (!base || (number >= *base && (!room || number < *base + *room))) found.push_back(index);
        }
        return found;
    }

    /// What is added stands in place of the zeros that the number ends with: 100 programs from 7100 on.
    /// Nothing for a number that ends with none, which leaves no place.
    static std::optional<std::int64_t> room_above(std::int64_t base) {
        constexpr std::int64_t ten = 10;
        std::int64_t room = 1;
        while (base != 0 && base % (room * ten) == 0) room *= ten;
        return room == 1 ? std::nullopt : std::optional(room);
    }

    /// 7100 of `M98 P[7100+#501]`.
    static std::optional<std::int64_t> base_of(const Program& program, const Call& call) {
        const auto* expression = std::get_if<ExpressionId>(&call.program);
        const auto* sum =
            expression == nullptr ? nullptr : std::get_if<Apply>(&program.expressions[*expression].node);
        if (sum == nullptr || sum->operation != Operation::add) return std::nullopt;
        for (const ExpressionId operand : program.operands_of(*sum))
            if (const auto base = flow::constant_number(program, operand)) return base;
        return std::nullopt;
    }

    void bind(const ProgramAnalysis& calling, Caller caller, CallSite& site) {
        ProgramAnalysis& called = programs_[*site.target];
        site.references = references_of(calling.program(), call_of(caller), called.program());
        adjacency_.add(called.index());
        called.callers_.push_back(caller);
    }

    void add_undecided(const std::shared_ptr<const NamesakeList>& namesakes, Caller caller) {
        auto& calls = undecided_by_list_[namesakes];
        if (calls == nullptr) {
            calls = std::make_shared<UndecidedCalls>();
            undecided_.push_back(calls.get());
            for (const ProgramIndex possible : *namesakes) programs_[possible].undecided_.push_back(calls);
        }
        calls->callers.push_back(caller);
    }

    /// What some of the callers pass to the program, sorted; without a program what letters pass to any.
    [[nodiscard]] std::vector<Variable> passed_by(const std::vector<Caller>& callers,
                                                  const Program* callee) const {
        std::vector<Variable> passed;
        for (const Caller& caller : callers)
            for (const Argument& argument : programs_[caller.program].program().arguments_of(call_of(caller)))
                if (const auto formal = bound_to(argument, callee)) passed.push_back(*formal);
        sort(passed);
        return passed;
    }

    /// Variables that a call hands over for parameters that the callee declares as references.
    static std::vector<dataflow::PassedReference> references_of(const Program& caller, const Call& call,
                                                                const Program& callee) {
        std::vector<dataflow::PassedReference> references;
        if (callee.formals.empty()) return references;
        for (const Argument& argument : caller.arguments_of(call)) {
            const auto formal = bound_to(argument, &callee);
            const auto& given = caller.expressions[argument.value].node;
            const bool is_variable =
                std::holds_alternative<Load>(given) || std::holds_alternative<LoadAt>(given);
            if (!formal || !is_variable) continue;
            const auto declared = std::ranges::find(callee.formals, *formal, &Formal::variable);
            if (declared != callee.formals.end() && declared->passing == Passing::by_reference)
                references.push_back({*formal, argument.value});
        }
        return references;
    }

    /// Names that share their number with another one, in whatever program they stand.
    void find_ambiguous_names() {
        std::vector<SharedNames::Numbered> names;
        for (const ProgramAnalysis& analysis : programs_) {
            const auto own = analysis.program().shared_names.all();
            names.insert(names.end(), own.begin(), own.end());
        }
        std::ranges::sort(names);
        names.erase(std::ranges::unique(names).begin(), names.end());
        auto& ambiguous = workspace_.ambiguous_names_;
        for (std::size_t i = 1; i < names.size(); ++i)
            if (names[i].first == names[i - 1].first) ambiguous.push_back(names[i].first);
        ambiguous.erase(std::ranges::unique(ambiguous).begin(), ambiguous.end());
    }

    static void sort(std::vector<Variable>& variables) {
        std::ranges::sort(variables, {},
                          [](Variable variable) { return std::pair(variable.space, variable.number); });
        variables.erase(std::ranges::unique(variables).begin(), variables.end());
        variables.shrink_to_fit();
    }

    [[nodiscard]] bool some_share_locals(const std::vector<Caller>& callers) const {
        return std::ranges::any_of(callers, [this](const Caller& caller) {
            return programs_[caller.program].control().calls[call_of(caller).kind].frame == Frame::shared;
        });
    }

    [[nodiscard]] const Call& call_of(Caller caller) const {
        return std::get<Call>(programs_[caller.program].program().effects[caller.effect].what);
    }

    /// What is asked for, whatever calls it, and what those call: of the others only the text is asked for.
    void find_needed() {
        needed_.resize(programs_.size());
        for (const ProgramAnalysis& analysis : programs_) needed_[analysis.index()] = analysis.asked();
        std::set<const UndecidedCalls*> seen;
        spread_need([&](const ProgramAnalysis& analysis, const auto& add) {
            for (const Caller& caller : analysis.callers_) add(caller.program);
            for (const auto& calls : analysis.undecided_)
                if (seen.insert(calls.get()).second)
                    for (const Caller& caller : calls->callers) add(caller.program);
        });
        spread_need([](const ProgramAnalysis& analysis, const auto& add) {
            for (const CallSite& site : analysis.calls_)
                if (site.target) add(*site.target);
        });
    }

    /// Whom `next(program, add)` adds for a needed program is needed, too.
    template<class Next>
    void spread_need(const Next& next) {
        std::vector<ProgramIndex> pending;
        for (const ProgramAnalysis& analysis : programs_)
            if (needed_[analysis.index()]) pending.push_back(analysis.index());
        while (!pending.empty()) {
            const ProgramAnalysis& analysis = programs_[pending.back()];
            pending.pop_back();
            next(analysis, [&](ProgramIndex other) {
                if (!needed_[other]) pending.push_back(other);
                needed_[other] = true;
            });
        }
    }

    void analyse_layer(const std::vector<std::uint32_t>& layer) {
        std::vector<ProgramIndex> members;
        for (const std::uint32_t component : layer)
            for (const ProgramIndex member : components_.members[component])
                if (needed_[member]) members.push_back(member);
        for_each_parallel(members.size(), jobs_, [&](std::size_t i) {
            if (!stop_.stop_requested()) analyse(programs_[members[i]]);
        });
    }

    [[nodiscard]] bool is_in_cycle(ProgramIndex program) const {
        return components_.members[components_.of[program]].size() > 1 ||
               std::ranges::count(adjacency_[program], program) != 0;
    }

    /// Calls within a cycle have no summary to go by.
    void find_labels_in_cycles() {
        for (ProgramIndex index = 0; index < programs_.size(); ++index)
            if (is_in_cycle(index))
                named_in_cycles_.emplace(index,
                                         dataflow::labels_named_for_callers(programs_[index].program()));
    }

    void analyse(ProgramAnalysis& analysis) {
        const Program& program = analysis.program();
        const std::uint32_t own = components_.of[analysis.index()];
        analysis.recursive_ = is_in_cycle(analysis.index());
        for (CallSite& site : analysis.calls_)
            site.in_cycle = site.target && components_.of[*site.target] == own;
        const dataflow::Callees callees = [&analysis, &programs = programs_](EffectId call) {
            static const dataflow::Summary unknown{};
            const CallSite* site = analysis.call_at(call);
            if (const GivenWord* word = analysis.word_at(call))
                return dataflow::Callee{unknown, {}, nullptr, word};
            // Within a cycle no summary is there yet: its calls count as unknown, whatever the order of work.
            if (site == nullptr || !site->target || site->in_cycle) return dataflow::Callee{unknown, {}};
            const ProgramAnalysis& called = programs[*site->target];
            return dataflow::Callee{called.summary(), site->references, &called.data()};
        };
        analysis.regions_ = flow::pair_regions(program);
        analysis.graph_ = flow::build_graph(program, analysis.regions_, [&](EffectId call) {
            const dataflow::Summary& summary = callees(call).summary;
            const CallSite* site = analysis.call_at(call);
            if (site == nullptr || !site->target) return flow::ReturnTargets{summary.returns};
            if (site->in_cycle) return flow::ReturnTargets{true, named_in_cycles_.at(*site->target)};
            const dataflow::AlarmEnd& end = summary.alarm_end;
            return flow::ReturnTargets{summary.returns || (end.always && !end.is_for_stopping()),
                                       summary.resume_labels, alarm_call_of(summary)};
        });
        const bool main = runs_on_its_own(analysis);
        analysis.locals_are_callers_ =
            some_share_locals(analysis.callers_) ||
            std::ranges::any_of(analysis.undecided_, &UndecidedCalls::locals_shared);
        analysis.data_.emplace(program, analysis.graph_, entry_of(analysis, main), callees, facts_);
        if (const auto cycles = dataflow::find_cycles(analysis.graph_, *analysis.data_)) {
            analysis.loops_ =
                dataflow::find_loops(program, analysis.regions_, analysis.graph_, *analysis.data_, *cycles);
            analysis.inescapable_cycles_ = dataflow::find_inescapable_cycles(
                program, analysis.regions_, analysis.graph_, *analysis.data_, *cycles);
        }
        analysis.is_macro_ = !main && takes_arguments(analysis);
    }

    static flow::AlarmCall alarm_call_of(const dataflow::Summary& summary) {
        if (summary.alarm_end.always && summary.resume_labels == nullptr) return flow::AlarmCall::always;
        return summary.decides_end.empty() ? flow::AlarmCall::none : flow::AlarmCall::perhaps;
    }

    static bool runs_on_its_own(const ProgramAnalysis& analysis) {
        if (!analysis.callers_.empty()) return false;
        const Program::Started started = analysis.program().started;
        // Where programs have sections, one that does not show how it is started is a fragment.
        if (started != Program::Started::unknown || !analysis.control().sections.empty())
            return started == Program::Started::by_hand;
        bool returns = false;
        for_each_effect(analysis.program(), [&](EffectId id) {
            returns |= std::holds_alternative<Return>(analysis.program().effects[id].what);
        });
        return !returns && !find_macro_argument(analysis.program());
    }

    dataflow::EntryKnowledge entry_of(const ProgramAnalysis& analysis, bool main) const {
        dataflow::EntryKnowledge entry{
            main ? dataflow::Entry::main : dataflow::Entry::called_unknown, {}, {}};
        auto& passed = entry.passed_somewhere;
        passed = passed_by(analysis.callers_, &analysis.program());
        entry.ambiguous_names = workspace_.ambiguous_names_;
        entry.locals_are_callers = analysis.locals_are_callers_;
        if (entry.locals_are_callers) entry.set_by_callers = callers_locals_->set_before(analysis);
        for (const auto& calls : analysis.undecided_) {
            passed.insert(passed.end(), calls->passed.begin(), calls->passed.end());
            if (analysis.program().formals.empty()) continue;
            const auto by_position = passed_by(calls->callers, &analysis.program());
            passed.insert(passed.end(), by_position.begin(), by_position.end());
        }
        sort(passed);
        if (!analysis.callers_.empty() && analysis.undecided_.empty() && !may_be_computed(analysis)) {
            if (analysis.complete())
                entry.arguments = what_all_pass(analysis);
            else if (analysis.program().local)
                entry.arguments = what_callers_in_the_file_pass(analysis);
        }
        entry.handed_down = handed_down_->to(analysis);
        return entry;
    }

    /// Whether a call whose program only the running program knows may mean it: one of its own file, if only
    /// that can call it.
    [[nodiscard]] bool may_be_computed(const ProgramAnalysis& analysis) const {
        return analysis.program().local ? computing_.contains(&analysis.file())
                                        : analysis.file_->may_be_computed;
    }

    /// All callers of a local program are there. What they leave out may still be asked for in it: such
    /// blocks count as reached.
    std::optional<std::vector<std::pair<Variable, dataflow::Vacancy>>>
    what_callers_in_the_file_pass(const ProgramAnalysis& analysis) const {
        auto arguments = what_all_pass(analysis);
        if (!arguments) return arguments;
        const auto add = [&](Variable formal) {
            if (std::ranges::find(*arguments, formal, &std::pair<Variable, dataflow::Vacancy>::first) ==
                arguments->end())
                arguments->emplace_back(formal, dataflow::Vacancy::maybe);
        };
        std::ranges::for_each(analysis.control().formals, add);
        for (const Formal& formal : analysis.program().formals) add(formal.variable);
        return arguments;
    }

    /// Arguments that all callers pass and those that some leave out. A call that shares its locals passes
    /// it is unknown what.
    std::optional<std::vector<std::pair<Variable, dataflow::Vacancy>>>
    what_all_pass(const ProgramAnalysis& analysis) const {
        std::vector<std::pair<Variable, std::size_t>> counts;
        for (const Caller& caller : analysis.callers_) {
            const Program& program = programs_[caller.program].program();
            const Call& call = call_of(caller);
            if (program.control->calls[call.kind].frame == Frame::shared) return std::nullopt;
            for (const Variable formal : formals_set_by(program, call, analysis.program())) {
                const auto known =
                    std::ranges::find(counts, formal, &std::pair<Variable, std::size_t>::first);
                if (known == counts.end())
                    counts.emplace_back(formal, 1);
                else
                    ++known->second;
            }
        }
        std::vector<std::pair<Variable, dataflow::Vacancy>> result;
        for (const auto& [variable, count] : counts) {
            // Passed by all: a variable that is passed on may still be vacant itself.
            result.emplace_back(variable, count < analysis.callers_.size() ? dataflow::Vacancy::maybe
                                                                           : dataflow::Vacancy::unknown);
        }
        return result;
    }

    /// In the order of the arguments; a letter that is given twice is passed once.
    static std::vector<Variable> formals_set_by(const Program& caller, const Call& call,
                                                const Program& callee) {
        std::vector<Variable> formals;
        for (const Argument& argument : caller.arguments_of(call)) {
            const auto formal = bound_to(argument, &callee);
            if (formal && std::ranges::find(formals, *formal) == formals.end()) formals.push_back(*formal);
        }
        return formals;
    }

    bool takes_arguments(const ProgramAnalysis& analysis) const {
        for (const Caller& caller : analysis.callers_) {
            if (programs_[caller.program].control().calls[call_of(caller).kind].frame == Frame::fresh)
                return true;
        }
        if (!analysis.callers_.empty()) return false;
        return std::ranges::any_of(analysis.facts().all<dataflow::Read>(), [&](const dataflow::Read& read) {
            const auto symbol = analysis.data().table().symbols[read.value.symbol];
            return symbol.kind() == dataflow::Symbol::Kind::entry &&
                   analysis.program().is_formal(read.variable);
        });
    }

    /// Depth-first from the programs that nobody calls: a call of a program still being followed closes a
    /// cycle.
    void mark_cycles() {
        enum class Mark : std::uint8_t { fresh, open, done };
        std::vector<Mark> marks(programs_.size(), Mark::fresh);
        struct Frame {
            ProgramIndex program;
            std::size_t next;
        };
        const auto follow = [&](ProgramIndex root) {
            if (marks[root] != Mark::fresh) return;
            marks[root] = Mark::open;
            std::vector<Frame> frames{{root, 0}};
            while (!frames.empty()) {
                const ProgramIndex at = frames.back().program;
                auto& calls = programs_[at].calls_;
                if (frames.back().next == calls.size()) {
                    marks[at] = Mark::done;
                    frames.pop_back();
                    continue;
                }
                CallSite& site = calls[frames.back().next++];
                if (!site.target) continue;
                if (marks[*site.target] == Mark::open) site.closes_cycle = true;
                if (marks[*site.target] != Mark::fresh) continue;
                marks[*site.target] = Mark::open;
                frames.push_back({*site.target, 0});
            }
        };
        for (const ProgramAnalysis& program : programs_)
            if (program.callers_.empty()) follow(program.index());
        for (const ProgramAnalysis& program : programs_) follow(program.index());
    }

    /// Longest paths from programs that nothing calls, callers before callees; calls within a cycle do not
    /// count.
    void measure_depth() {
        for (std::size_t component = components_.members.size(); component-- > 0;)
            for (const ProgramIndex index : components_.members[component]) deepen_callees(programs_[index]);
    }

    void deepen_callees(const ProgramAnalysis& caller) {
        for (const CallSite& site : caller.calls_) {
            if (!site.target || components_.of[*site.target] == components_.of[caller.index()]) continue;
            ProgramAnalysis& callee = programs_[*site.target];
            const auto& call = std::get<Call>(caller.program().effects[site.effect].what);
            const bool macro = caller.control().calls[call.kind].counts_against == NestingLimit::macro;
            const int macros = caller.depth_.macro + (macro ? 1 : 0);
            const int subprograms = caller.depth_.subprogram + (macro ? 0 : 1);
            if (macros > callee.depth_.macro) {
                callee.depth_.macro = macros;
                callee.deepest_macro_caller_ = Caller{caller.index(), site.effect};
            }
            if (subprograms > callee.depth_.subprogram) {
                callee.depth_.subprogram = subprograms;
                callee.deepest_subprogram_caller_ = Caller{caller.index(), site.effect};
            }
        }
    }

    Workspace& workspace_;
    std::deque<ProgramAnalysis>& programs_;
    const std::stop_token& stop_;
    unsigned jobs_;
    dataflow::FactSet facts_;
    flow::Adjacency adjacency_;
    flow::Components components_;
    std::unordered_map<ProgramIndex, std::shared_ptr<const flow::LabelList>>
        named_in_cycles_; ///< see find_labels_in_cycles
    std::optional<HandedDown> handed_down_;
    std::optional<CallersLocals> callers_locals_;
    std::vector<bool> needed_;               ///< by program: its flow and data flow are asked for
    std::set<const ProgramFile*> computing_; ///< files with a call that may mean any program
    std::vector<Caller> computed_;           ///< these calls
    std::map<std::shared_ptr<const NamesakeList>, std::shared_ptr<UndecidedCalls>> undecided_by_list_;
    std::vector<UndecidedCalls*> undecided_; ///< all of them, in the order of the first call
};

const CallSite* ProgramAnalysis::call_at(EffectId effect) const {
    const auto found = std::ranges::lower_bound(calls_, effect, {}, &CallSite::effect);
    return found != calls_.end() && found->effect == effect ? &*found : nullptr;
}

CallPath ProgramAnalysis::path_to(ProgramIndex program) const {
    return workspace_->call_paths_->between(index_, program);
}

std::vector<Caller> ProgramAnalysis::chain_to(NestingLimit nesting) const {
    std::vector<Caller> chain;
    const ProgramAnalysis* at = this;
    while (true) {
        const auto& caller =
            nesting == NestingLimit::macro ? at->deepest_macro_caller_ : at->deepest_subprogram_caller_;
        if (!caller) break;
        chain.push_back(*caller);
        at = &workspace_->programs()[caller->program];
    }
    std::ranges::reverse(chain);
    return chain;
}

Workspace::Workspace()
    : programs_(std::make_unique<std::deque<ProgramAnalysis>>())
    , call_paths_(std::make_unique<CallPaths>(*programs_)) {}
Workspace::~Workspace() = default;

const std::deque<ProgramAnalysis>& Workspace::programs() const { return *programs_; }

std::size_t Workspace::count_named(std::string_view name) const {
    const auto& counts = named_.get([this] {
        std::unordered_map<std::string_view, std::size_t> all;
        for (const ProgramAnalysis& analysis : *programs_) ++all[analysis.program().name];
        return all;
    });
    const auto known = counts.find(name);
    return known == counts.end() ? 0 : known->second;
}

std::unique_ptr<Workspace> Workspace::analyse(std::vector<WorkspaceFile> files,
                                              const WorkspaceOptions& options) {
    return analyse_until({}, std::move(files), options);
}

std::unique_ptr<Workspace> analyse_until(const std::stop_token& stop, std::vector<WorkspaceFile> files,
                                         const WorkspaceOptions& options) {
    return WorkspaceBuilder::build(std::move(files), options, stop);
}

} // namespace maclint
