//! Program numbers and names to programs, by distance between folders.
#include "analyzer/workspace/resolve.hpp"

#include "analyzer/flow/graph.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace maclint {
namespace {

/// Names are compared without case: controls store capitals, file systems do not.
std::string folded(std::string_view name) {
    std::string result(name);
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return result;
}

std::string_view folder_of(std::string_view path) {
    const auto slash = path.find_last_of('/');
    return slash == std::string_view::npos ? std::string_view{} : path.substr(0, slash);
}

/// Calls `visit(folder, steps up to it)` for the folder and all around it.
template<class Visit>
void for_each_folder_around(std::string_view folder, const Visit& visit) {
    for (std::size_t steps = 0;; ++steps) {
        visit(folder, steps);
        if (folder.empty()) return;
        folder = folder_of(folder);
    }
}

/// What is started by hand is called only where nothing else as near has the name.
constexpr std::size_t step = 2;
std::size_t handicap(const Program& program) { return program.started == Program::Started::by_hand ? 1 : 0; }

} // namespace

void CallResolver::Nearest::consider(ProgramIndex program, std::size_t steps_to_it) {
    ++all;
    if (steps_to_it > steps) return;
    if (steps_to_it < steps) programs = std::make_shared<Candidates>();
    steps = steps_to_it;
    programs->programs.push_back(program);
}

CallResolver::CallResolver(const std::deque<ProgramAnalysis>& programs) {
    for (const ProgramAnalysis& analysis : programs) {
        const Program& program = analysis.program();
        const std::string_view language = analysis.control().language;
        if (program.number) add(by_number_[{language, *program.number}], analysis);
        std::vector<std::string> names{folded(program.name)};
        for (const std::string& name : program.also_known_as) names.push_back(folded(name));
        std::ranges::sort(names);
        names.erase(std::ranges::unique(names).begin(), names.end());
        for (std::string& name : names) add(by_name_[{language, std::move(name)}], analysis);
    }
}

void CallResolver::add(ProgramsByName& programs_by_name, const ProgramAnalysis& analysis) {
    const Program& program = analysis.program();
    const std::size_t by_hand = handicap(program);
    // Every file may have local programs of the same names: only calls in the file look at them.
    if (program.local) return programs_by_name.local[&analysis.file()].consider(analysis.index(), by_hand);
    programs_by_name.in_file[&analysis.file()].consider(analysis.index(), by_hand);
    for_each_folder_around(
        folder_of(analysis.file().source->path()), [&](std::string_view folder, std::size_t down) {
            programs_by_name.below[folder].consider(analysis.index(), step * down + by_hand);
        });
}

bool CallResolver::is_computed(const Program& program, const Call& call) {
    const auto* expression = std::get_if<ExpressionId>(&call.program);
    return expression != nullptr && !flow::constant_number(program, *expression);
}

const CallResolver::ProgramsByName* CallResolver::programs_named(const ProgramAnalysis& caller,
                                                                 const Call& call) const {
    const auto look_up = [&](const auto& index, const auto& name) -> const ProgramsByName* {
        const auto found = index.find({caller.control().language, name});
        return found == index.end() ? nullptr : &found->second;
    };
    if (const auto* text = std::get_if<Text>(&call.program))
        return look_up(by_name_, folded(caller.program().slice(text->characters)));
    const auto* expression = std::get_if<ExpressionId>(&call.program);
    if (expression == nullptr) return nullptr;
    const auto number = flow::constant_number(caller.program(), *expression);
    return number ? look_up(by_number_, *number) : nullptr;
}

CallSite CallResolver::resolve(const ProgramAnalysis& caller, EffectId effect) const {
    const auto& call = std::get<Call>(caller.program().effects[effect].what);
    CallSite site{effect, {}, false, false, 0, {}, {}};
    const ProgramsByName* programs_by_name = programs_named(caller, call);
    if (programs_by_name == nullptr) return site;
    std::size_t nearest = static_cast<std::size_t>(-1);
    const auto look_at = [&](const Nearest& there, std::size_t steps_there) {
        const std::size_t steps = steps_there + there.steps;
        if (steps > nearest) return;
        if (steps < nearest) site.equally_near.clear();
        site.equally_near.push_back(there.programs);
        nearest = steps;
    };
    const auto look_into = [&](const auto& files) {
        if (const auto found = files.find(&caller.file()); found != files.end()) look_at(found->second, 0);
    };
    // First the file itself, then folder by folder outwards. A name that the call looks for in other files
    // may still be that of a local program.
    const bool only_other_files = caller.control().calls[call.kind].lookup == LookupScope::other_files;
    look_into(programs_by_name->in_file);
    if (!only_other_files) look_into(programs_by_name->local);
    if (site.equally_near.empty())
        for_each_folder_around(folder_of(caller.file().source->path()),
                               [&](std::string_view folder, std::size_t up) {
                                   if (const auto found = programs_by_name->below.find(folder);
                                       found != programs_by_name->below.end())
                                       look_at(found->second, step * (1 + up));
                               });
    if (site.equally_near.empty()) look_into(programs_by_name->local);

    // Seen from the outermost folder, all that are not local are there.
    if (const auto all = programs_by_name->below.find(std::string_view{});
        all != programs_by_name->below.end())
        site.candidates += all->second.all;
    if (const auto local = programs_by_name->local.find(&caller.file());
        local != programs_by_name->local.end())
        site.candidates += local->second.all;
    if (site.equally_near.size() == 1 && site.equally_near.front()->programs.size() == 1) {
        site.target = site.equally_near.front()->programs.front();
        site.equally_near.clear();
    }
    return site;
}

} // namespace maclint
