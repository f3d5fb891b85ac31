//! Deeds are told from what the program says and what its values are, not from where the model keeps it.
#include "tests/execution/recorded_run.hpp"

#include "analyzer/program/overloaded.hpp"
#include "analyzer/program/tables.hpp"
#include "tests/support/analysed.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdlib>

namespace maclint::test {
namespace {

using execution::Leaving;

enum Kind : std::uint64_t { word = 1, codes, machine_store, call, other_effect };

/// What such a word does is told by what is in force at moves and at the end: a modal code, or a return.
bool is_told_later(const ControlModel& control, std::string_view address, double value) {
    constexpr double return_code = 99;
    return address.size() == 1 &&
           ((address == "M" && value == return_code) || control.group_of(address.front(), value).has_value());
}

/// The text without comments, blanks and '/', in capitals.
std::string words_of(std::string_view text) {
    std::string words;
    int depth = 0;
    for (const char character : text) {
        depth += character == '(' ? 1 : 0;
        const bool counts =
            std::isspace(static_cast<unsigned char>(character)) == 0 && character != ';' && character != '/';
        if (depth == 0 && counts)
            words += static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
        depth -= character == ')' && depth > 0 ? 1 : 0;
    }
    return words;
}

} // namespace

std::uint64_t mixed(std::initializer_list<std::uint64_t> parts) {
    std::uint64_t sum = 0x9e3779b97f4a7c15U;
    for (std::uint64_t part : parts) { // splitmix64
        part += sum + 0x9e3779b97f4a7c15U;
        part = (part ^ (part >> 30U)) * 0xbf58476d1ce4e5b9U;
        part = (part ^ (part >> 27U)) * 0x94d049bb133111ebU;
        sum = part ^ (part >> 31U);
    }
    return sum;
}

std::uint64_t mixed(std::string_view text) {
    std::uint64_t sum = text.size();
    for (const char character : text) sum = mixed({sum, static_cast<unsigned char>(character)});
    return sum;
}

/// Numbers that differ by rounding alone are the same.
std::uint64_t mixed(semantics::Content content) {
    if (!content) return 1;
    constexpr double finest = 1e6;
    const double rounded = std::abs(*content) < 1e9 ? std::round(*content * finest) + 0.0 : *content;
    return mixed({2, std::bit_cast<std::uint64_t>(rounded)});
}

std::uint32_t ChangedLines::before(std::uint32_t line) const {
    std::uint32_t passed = 0;
    for (const auto& [at, lines] : added) {
        const std::uint32_t unmoved = line - passed;
        if (unmoved > at) passed += std::min(lines, unmoved - at);
    }
    return line - passed;
}

bool ChangedLines::holds(std::uint32_t line) const { return std::ranges::find(lines, line) != lines.end(); }

void Recorder::observe(execution::Stepper& stepper, const execution::Event& event) {
    if (moves_next_) {
        moves_next_ = false;
        record_codes(stepper);
    }
    std::visit([&](const auto& what) { on(stepper, what); }, event);
}

RecordedRun Recorder::finish(Leaving how) {
    run_.how = how;
    return std::move(run_);
}

void Recorder::record(std::initializer_list<std::uint64_t> parts) {
    run_.deeds.push_back({mixed({place_, mixed(parts)}), line_});
}

const Recorder::Names& Recorder::names_of(const ProgramAnalysis& analysis) {
    const auto [found, fresh] = names_.try_emplace(&analysis);
    if (!fresh) return found->second;
    const Program& program = analysis.program();
    Names& names = found->second;
    for (const Word& one : program.words)
        if (const auto* value = std::get_if<ExpressionId>(&one.value)) names.addresses[*value] = one.address;
    for (const Argument& argument : program.arguments) names.addresses[argument.value] = argument.address;
    for (const Item& item : program.items)
        if (const auto* block = std::get_if<Block>(&item)) names.blocks[block->span.begin] = block;
    return names;
}

void Recorder::on(execution::Stepper& stepper, const execution::BlockBegins& event) {
    const ProgramAnalysis& analysis = stepper.program();
    line_ = line_of(analysis, event.span.begin);
    const bool here = analysis.source()->path() == changes_.path;
    if (here && moved_) line_ = changes_.before(line_);
    const bool changed = here && changes_.holds(line_);
    place_ = changed ? 0 : mixed({mixed(analysis.source()->path()), line_});
    run_.touches_change |= changed;
    if (here && !changed) run_.blocks.push_back(line_);
    const auto& blocks = names_of(analysis).blocks;
    if (const auto found = blocks.find(event.span.begin); found != blocks.end())
        record_words(analysis.program(), *found->second);
    if (!event.has_effects) record_plain(analysis, event.span);
}

/// Its words but the sequence number and those that set a modal group.
void Recorder::record_plain(const ProgramAnalysis& analysis, Span span) {
    const std::string text = words_of(analysis.program().slice(span));
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t begin = at++;
        while (at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) == 0) ++at;
        const std::string_view one = std::string_view(text).substr(begin, at - begin);
        const double value = std::strtod(text.c_str() + begin + 1, nullptr);
        if (one.front() == 'N' || is_told_later(analysis.control(), one.substr(0, 1), value)) continue;
        record({Kind::word, mixed(one.substr(0, 1)), mixed(semantics::Content{value})});
        moves_next_ = true;
    }
}

/// Those with numbers; what others say is told when it is known.
void Recorder::record_words(const Program& program, const Block& block) {
    for (const Word& one : std::span(program.words).subspan(block.words.first, block.words.count)) {
        const auto* literal = std::get_if<Literal>(&one.value);
        if (literal != nullptr && !is_told_later(*program.control, one.address, literal->value))
            record({Kind::word, mixed(one.address), mixed(semantics::Content{literal->value})});
    }
}

void Recorder::record_codes(execution::Stepper& stepper) {
    std::uint64_t sum = 0;
    for (std::size_t group = 0; group < stepper.program().control().groups.size(); ++group)
        sum = mixed({sum, mixed(semantics::Content{stepper.code(static_cast<GroupId>(group))})});
    record({Kind::codes, sum});
}

void Recorder::on(execution::Stepper& stepper, const execution::EffectBegins& event) {
    const auto& what = stepper.program().program().effects[event.effect].what;
    if (std::holds_alternative<Motion>(what)) return record_codes(stepper);
    if (const auto* stop = std::get_if<Stop>(&what))
        return record({Kind::other_effect, what.index(), static_cast<std::uint64_t>(stop->kind)});
    if (std::holds_alternative<ToolChange>(what) || std::holds_alternative<Exchange>(what))
        record({Kind::other_effect, what.index()});
}

/// A word with a vacant variable is as good as none.
void Recorder::on(execution::Stepper& stepper, const execution::ValueTaken& event) {
    const Program& program = stepper.program().program();
    if (!stepper.effect()) return;
    const auto& what = program.effects[*stepper.effect()].what;
    if (const auto* assign = std::get_if<Assign>(&what)) return record_store(program, *assign, event);
    if (!event.content || std::holds_alternative<SetModal>(what)) return;
    const auto& addresses = names_of(stepper.program()).addresses;
    const auto address = addresses.find(event.expression);
    record({Kind::word, address == addresses.end() ? 0 : mixed(address->second), mixed(event.content)});
}

/// What the machine owns is changed; of a store through an index the value is known before the index.
void Recorder::record_store(const Program& program, const Assign& assign,
                            const execution::ValueTaken& event) {
    if (const auto* store = std::get_if<StoreMachine>(&assign.target))
        record({Kind::machine_store, static_cast<std::uint64_t>(store->number), mixed(event.content)});
    const auto* store = std::get_if<StoreAt>(&assign.target);
    if (store == nullptr || event.expression != store->index) {
        stored_ = event.content;
        return;
    }
    const auto number = semantics::variable_number(event.content.value_or(0));
    const VariableRange* range = number ? program.control->families[store->family].find(*number) : nullptr;
    if (range != nullptr && range->meaning != Meaning::variable)
        record({Kind::machine_store, static_cast<std::uint64_t>(*number), mixed(stored_)});
}

void Recorder::on(execution::Stepper& stepper, const execution::Stored& event) {
    const VariableSpace& space = stepper.program().control().spaces[event.variable.space];
    if (space.scope != Scope::frame) shared_[{event.variable.space, event.variable.number}] = event.content;
}

void Recorder::on(execution::Stepper& stepper, const execution::CallBegins& event) {
    const auto& programs = stepper.program().workspace().programs();
    record({Kind::call, event.target ? mixed(programs[*event.target].program().name) : 0});
    record_codes(stepper);
}

void Recorder::on(execution::Stepper& stepper, const execution::ProgramLeft& event) {
    if (stepper.depth() != 0 && event.how != Leaving::cut_off && event.how != Leaving::fault) return;
    for (std::size_t group = 0; group < stepper.program().control().groups.size(); ++group)
        run_.codes_at_end.push_back(stepper.code(static_cast<GroupId>(group)));
    for (const auto& [variable, content] : shared_)
        run_.variables_at_end = mixed({run_.variables_at_end, variable.first,
                                       static_cast<std::uint64_t>(variable.second), mixed(content)});
}

} // namespace maclint::test
