//! What leads to a block for the first time is kept, and varied.
#include "tests/execution/start_search.hpp"

#include "analyzer/program/tables.hpp"
#include "tests/support/analysed.hpp"

#include <algorithm>
#include <array>

namespace maclint::test {
namespace {

using semantics::Content;

constexpr execution::Bounds of_a_run{.steps = 4000, .depth = 6};
constexpr std::size_t most_runs = 4000, most_blocks = 400'000; // of a search
/// Where a run went wrong stands near its end.
constexpr std::size_t tail = 16;
/// Sizes that programs for parts reckon with, beside the numbers in their texts.
constexpr std::array sizes{0.1, 0.5, 3.0, 8.0, 12.0, 20.0, 37.5, 60.0, 250.0, 930.0, 4000.0};
constexpr std::size_t most_leading = 40, most_varied = 12, most_any = 60;

} // namespace

StartSearch::StartSearch(const ProgramAnalysis& analysis)
    : main_(analysis.is_main())
    , numbers_(numbers_of(analysis.program())) {
    find_tellable(analysis);
    find_compared(analysis.program());
    search(analysis);
}

/// Arguments, or all locals where the caller's may be seen; variables that programs share, values of the
/// machine.
void StartSearch::find_tellable(const ProgramAnalysis& analysis) {
    const Program& program = analysis.program();
    const ControlModel& control = analysis.control();
    for (const Expression& expression : program.expressions) {
        Tellable what{false, {}, 0, true, {}};
        if (const auto* load = std::get_if<Load>(&expression.node)) {
            const VariableSpace& space = control.spaces[load->variable.space];
            what.local = space.scope == Scope::frame;
            what.variable = load->variable;
            what.question = question_of(program, load->variable);
            const bool formal = std::ranges::find(control.formals, load->variable) != control.formals.end();
            if (what.local && (main_ || (!formal && analysis.is_macro()))) continue;
            what.may_be_vacant = space.scope != Scope::machine;
        } else if (const auto* owned = std::get_if<LoadMachine>(&expression.node)) {
            const VariableRange* range = control.families[owned->family].find(owned->number);
            what.question = question_of(*owned);
            what.may_be_vacant = range != nullptr && range->may_be_vacant;
        } else {
            continue;
        }
        const std::uint32_t line = line_of(analysis, expression.span.begin);
        const auto known = std::ranges::find_if(tellable_, [&](const Tellable& other) {
            return other.local == what.local && other.variable == what.variable &&
                   other.question == what.question;
        });
        if (known != tellable_.end()) {
            read_on_[static_cast<std::size_t>(known - tellable_.begin())].push_back(line);
            continue;
        }
        tellable_.push_back(what);
        read_on_.push_back({line});
    }
}

Tellable* StartSearch::tellable(const Program& program, ExpressionId id) {
    const auto& node = program.expressions[id].node;
    const auto* load = std::get_if<Load>(&node);
    const auto* owned = std::get_if<LoadMachine>(&node);
    for (Tellable& what : tellable_) {
        if (load != nullptr && what.variable == load->variable) return &what;
        if (owned != nullptr && !what.local && what.question == question_of(*owned)) return &what;
    }
    return nullptr;
}

void StartSearch::find_compared(const Program& program) {
    for (const Expression& expression : program.expressions) {
        const auto* apply = std::get_if<Apply>(&expression.node);
        if (apply == nullptr || !semantics::is_comparison(apply->operation)) continue;
        const auto operands = program.operands_of(*apply);
        for (std::size_t i = 0; i < operands.size() && operands.size() == 2; ++i) {
            const auto* literal = std::get_if<Literal>(&program.expressions[operands[1 - i]].node);
            Tellable* what = literal == nullptr ? nullptr : tellable(program, operands[i]);
            if (what == nullptr) continue;
            for (const double number : {literal->value, literal->value + 1, literal->value - 1})
                what->compared.push_back(number);
        }
    }
}

Content StartSearch::content_for(const Tellable& what) {
    if (what.may_be_vacant && below(5) == 0) return {};
    if (!what.compared.empty() && below(3) != 0) return what.compared[below(what.compared.size())];
    if (below(3) == 0) return sizes[below(sizes.size())];
    return numbers_[below(numbers_.size())];
}

ToldStart StartSearch::any(std::uint64_t seed) {
    ToldStart start{seed, {}};
    const bool full = below(3) == 0;
    for (const Tellable& what : tellable_) {
        Content content = content_for(what);
        if (full && !content) content = 5.0;
        start.told.push_back(content);
    }
    return start;
}

/// What was read near the end of the run mostly decided how it ended.
ToldStart StartSearch::varied(const Found& found, std::uint64_t seed) {
    ToldStart next = found.start;
    if (below(8) == 0) next.seed = seed;
    if (next.told.empty()) return next;
    std::vector<std::size_t> read_last;
    for (std::size_t what = 0; what < tellable_.size(); ++what)
        if (std::ranges::any_of(read_on_[what],
                                [&](std::uint32_t line) { return found.last.contains(line); }))
            read_last.push_back(what);
    for (std::size_t times = 1 + below(2); times != 0; --times) {
        const std::size_t at =
            read_last.empty() || below(4) == 0 ? below(next.told.size()) : read_last[below(read_last.size())];
        next.told[at] = content_for(tellable_[at]);
    }
    return next;
}

void StartSearch::search(const ProgramAnalysis& analysis) {
    const ChangedLines none{std::string(analysis.source()->path()), {}, {}};
    std::set<std::pair<std::uint32_t, std::uint32_t>> known;
    std::size_t blocks = 0;
    // What is told decides where a run leads: without it one run is like another.
    const std::size_t runs = std::min(most_runs, 60 + 150 * tellable_.size());
    for (std::size_t i = 0; i < runs && blocks < most_blocks; ++i) {
        const bool vary = !found_.empty() && i > 20 && below(5) != 0;
        // What was found last leads on mostly.
        const std::size_t kept = found_.size();
        const std::size_t at = kept == 0       ? 0
                               : below(2) == 0 ? below(kept)
                                               : kept - 1 - below(std::min<std::size_t>(kept, 5));
        ToldStart start = vary ? varied(found_[at], i) : any(i);
        const RecordedRun done = run(analysis, start, none, false);
        meets_unreadable_ |= done.how == execution::Leaving::unreadable;
        blocks += done.blocks.size() + 20;
        bool fresh = false;
        for (std::size_t k = 1; k < done.blocks.size(); ++k)
            fresh |= known.emplace(done.blocks[k - 1], done.blocks[k]).second;
        if (fresh)
            found_.push_back({start,
                              {done.blocks.begin(), done.blocks.end()},
                              {done.blocks.end() - std::min<std::ptrdiff_t>(std::ssize(done.blocks), tail),
                               done.blocks.end()}});
        else if (any_.size() < (tellable_.empty() ? most_any / 4 : most_any) && !vary)
            any_.push_back(std::move(start));
    }
}

std::set<std::uint32_t> StartSearch::lines() const {
    std::set<std::uint32_t> lines;
    for (const Found& found : found_) lines.insert(found.lines.begin(), found.lines.end());
    return lines;
}

std::vector<ToldStart> StartSearch::starts_for(const ChangedLines& changes) const {
    std::vector<const Found*> leading;
    for (const Found& found : found_)
        if (std::ranges::any_of(changes.lines,
                                [&](std::uint32_t line) { return found.lines.contains(line); }))
            leading.push_back(&found);
    std::ranges::stable_sort(leading, [](const Found* one, const Found* other) {
        return one->lines.size() > other->lines.size();
    });
    leading.resize(std::min(leading.size(), most_leading));
    std::vector<ToldStart> starts;
    for (const Found* found : leading) starts.push_back(found->start);
    const auto is_read_there = [&](std::size_t what) {
        return std::ranges::any_of(read_on_[what], [&](std::uint32_t line) { return changes.holds(line); });
    };
    for (const bool there : {true, false})
        for (std::size_t i = 0; i < std::min(leading.size(), there ? most_varied : most_varied / 2); ++i)
            for (std::size_t what = 0; what < tellable_.size(); ++what) {
                if (is_read_there(what) != there) continue;
                std::vector<Content> contents{0.0};
                if (tellable_[what].may_be_vacant) contents.insert(contents.begin(), Content{});
                if (there)
                    for (const double number : tellable_[what].compared) contents.emplace_back(number);
                for (const Content content : contents) {
                    starts.push_back(leading[i]->start);
                    starts.back().told[what] = content;
                }
            }
    starts.insert(starts.end(), any_.begin(), any_.end());
    return starts;
}

RecordedRun StartSearch::run(const ProgramAnalysis& analysis, const ToldStart& start,
                             const ChangedLines& changes, bool moved) const {
    ToldWorld world(start.seed, numbers_);
    execution::Start begin{analysis.index(), {}};
    for (std::size_t i = 0; i < tellable_.size(); ++i) {
        const Tellable& what = tellable_[i];
        if (!what.local)
            world.tell(what.question, start.told[i]);
        else if (start.told[i])
            begin.variables.emplace_back(what.variable, start.told[i]);
    }
    const execution::Environment environment = world.environment(analysis.control(), main_);
    Recorder recorder(changes, moved);
    execution::Stepper stepper(
        analysis.workspace(), environment,
        [&](execution::Stepper& at, const execution::Event& event) { recorder.observe(at, event); },
        of_a_run);
    const execution::Leaving how = stepper.run(begin);
    return recorder.finish(how);
}

} // namespace maclint::test
