//! Program numbers and names to programs, by distance between folders.
#include "analyzer/workspace/resolve.hpp"

#include "analyzer/flow/graph.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

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

std::size_t depth_of(std::string_view folder) {
    if (folder.empty()) return 0;
    return 1 + static_cast<std::size_t>(std::ranges::count(folder, '/'));
}

/// Steps up and down from one folder to another.
std::size_t distance(std::string_view a, std::string_view b) {
    const auto starts_within = [](std::string_view inner, std::string_view outer) {
        return outer.empty() || inner == outer || (inner.starts_with(outer) && inner[outer.size()] == '/');
    };
    std::string_view common = a;
    while (!starts_within(b, common)) common = folder_of(common);
    return depth_of(a) + depth_of(b) - 2 * depth_of(common);
}

/// How far the control looks for the program; nothing when it does not find it there at all.
std::optional<std::size_t> steps_to(const ProgramAnalysis& target, const ProgramAnalysis& caller,
                                    const Call& call) {
    const Program& program = target.program();
    if (program.control->language != caller.control().language) return std::nullopt;
    const std::string_view here = caller.file().source->path();
    const std::string_view there = target.file().source->path();
    if (program.local && here != there) return std::nullopt;
    // A name that the call looks for elsewhere may still be that of a local program.
    constexpr std::size_t last_of_all = static_cast<std::size_t>(-2);
    const Reach reach = caller.control().calls[call.kind].reach;
    if (reach == Reach::other_files && program.local) return last_of_all;
    // What is started by hand is called only where nothing else has the name.
    const std::size_t by_hand = program.started == Program::Started::by_hand ? 1 : 0;
    const std::size_t folders = here == there ? 0 : 1 + distance(folder_of(here), folder_of(there));
    return 2 * folders + by_hand;
}

} // namespace

CallResolver::CallResolver(const std::deque<ProgramAnalysis>& programs)
    : programs_(programs) {
    for (const ProgramAnalysis& analysis : programs) {
        const Program& program = analysis.program();
        if (program.number) by_number_[*program.number].push_back(analysis.index());
        // Every file may have local programs of the same names: only calls in the file look at them.
        Names& names = program.local ? local_[&analysis.file()] : by_name_;
        names[folded(program.name)].push_back(analysis.index());
        for (const std::string& name : program.also_known_as) {
            auto& known = names[folded(name)];
            if (known.empty() || known.back() != analysis.index()) known.push_back(analysis.index());
        }
    }
}

std::vector<ProgramIndex> CallResolver::candidates(const ProgramAnalysis& caller, const Call& call) const {
    if (const auto* text = std::get_if<Text>(&call.program)) {
        const std::string name = folded(caller.program().slice(text->characters));
        std::vector<ProgramIndex> all;
        const auto add = [&](const Names& names) {
            if (const auto found = names.find(name); found != names.end())
                all.insert(all.end(), found->second.begin(), found->second.end());
        };
        add(by_name_);
        if (const auto local = local_.find(&caller.file()); local != local_.end()) add(local->second);
        return all;
    }
    const auto* expression = std::get_if<ExpressionId>(&call.program);
    if (expression == nullptr) return {};
    const auto number = flow::constant_target(caller.program(), *expression);
    if (!number) return {};
    const auto found = by_number_.find(*number);
    return found == by_number_.end() ? std::vector<ProgramIndex>{} : found->second;
}

CallSite CallResolver::resolve(const ProgramAnalysis& caller, EffectId effect) const {
    const auto& call = std::get<Call>(caller.program().effects[effect].what);
    CallSite site{effect, {}, false, false, 0, {}};
    std::size_t nearest = static_cast<std::size_t>(-1);
    for (const ProgramIndex index : candidates(caller, call)) {
        const std::optional<std::size_t> steps = steps_to(programs_[index], caller, call);
        if (!steps) continue;
        ++site.candidates;
        if (*steps > nearest) continue;
        if (*steps < nearest) site.equally_near.clear();
        site.equally_near.push_back(index);
        nearest = *steps;
    }
    if (site.equally_near.size() == 1) {
        site.target = site.equally_near.front();
        site.equally_near.clear();
    }
    return site;
}

} // namespace maclint
