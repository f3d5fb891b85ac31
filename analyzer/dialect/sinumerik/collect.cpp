//! Programs and their names.
#include "analyzer/dialect/sinumerik/collect.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/near_names.hpp"
#include "analyzer/dialect/sinumerik/keywords.hpp"
#include "analyzer/dialect/sinumerik/lexer.hpp"
#include "analyzer/dialect/sinumerik/parts.hpp"
#include "analyzer/dialect/sinumerik/plain.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace maclint::sinumerik {
namespace {

/// What a program is by the ending of its name.
struct Ending {
    std::string_view ending;
    Program::Started started;
    Section::Executed executed;
};
constexpr Ending endings[] = {
    {"MPF", Program::Started::by_hand, Section::Executed::when_reached},
    {"SPF", Program::Started::by_call, Section::Executed::when_reached},
    {"CPF", Program::Started::by_call, Section::Executed::when_reached},
    {"DEF", Program::Started::unknown, Section::Executed::never}, // definitions of variables and macros
};

const Ending* ending_of(std::string_view capitals) {
    const auto* row = std::ranges::find(endings, capitals, &Ending::ending);
    return row == std::end(endings) ? nullptr : row;
}

/// "SHAFT" of "SHAFT.MPF", "_N_SHAFT_MPF", "SHAFT_MPF", and its ending.
std::pair<std::string, const Ending*> parts_of(std::string_view written) {
    constexpr std::size_t length_of_ending = 4; // with the character before it
    std::string name = in_capitals(written);
    if (name.starts_with("_N_")) name.erase(0, 3);
    const Ending* ending = nullptr;
    if (name.size() > length_of_ending) {
        const char before = name[name.size() - length_of_ending];
        if (before == '_' || before == '.')
            ending = ending_of(std::string_view(name).substr(name.size() - length_of_ending + 1));
    }
    if (ending != nullptr) name.resize(name.size() - length_of_ending);
    return {std::move(name), ending};
}

/// The first label of a part whose last one stands before it alone; nullptr: the part can be found.
const NamedPlace* part_turned_round(const OpenProgram& program, const Repetition& repetition) {
    if (repetition.names_numbers || repetition.last.empty()) return nullptr;
    const auto first = std::ranges::find(program.labels, repetition.first, &NamedPlace::name);
    const auto behind = std::ranges::subrange(first, program.labels.end());
    const auto is_last = [&](const NamedPlace& label) { return label.name == repetition.last; };
    if (first == program.labels.end() || std::ranges::any_of(behind, is_last)) return nullptr;
    return std::ranges::any_of(program.labels, is_last) ? &*first : nullptr;
}

} // namespace

/// A call may write `SUB`, `_N_SUB`, `SUB_SPF` or `_N_SUB_SPF` [NCP23 p.490].
void Programs::open(std::string written) {
    auto [name, ending] = parts_of(written);
    OpenProgram& program = open_.emplace_back(OpenProgram{
        .builder = ProgramBuilder(name.empty() ? std::move(written) : name, source_.bytes(), control_)});
    program.builder.set_plain_tables({&plain_tables(), nullptr});
    program.builder.add_name("_N_" + name);
    if (ending != nullptr) {
        const std::string whole = name + '_' + std::string(ending->ending);
        program.builder.add_name(whole);
        program.builder.add_name("_N_" + whole);
        program.builder.set_started(ending->started);
        program.has_file_name = true;
        program.is_for_all = ending->executed == Section::Executed::never;
    }
    program.builder.begin_section("program",
                                  ending == nullptr ? Section::Executed::when_reached : ending->executed, {});
}

void Programs::open_behind(Span line, Offset mark) {
    std::string_view name = source_.bytes().substr(mark + 1, line.end - mark - 1);
    const auto end = std::ranges::find_if_not(name, [](char c) { return begins_name(c) || is_digit(c); });
    name = name.substr(0, static_cast<std::size_t>(end - name.begin()));
    // A bare `%` is the mark of a tape.
    open(std::string(name.empty() ? file_name_of(source_.path()) : name));
    if (!name.empty()) {
        const auto begin = static_cast<Offset>(name.data() - source_.bytes().data());
        open_.back().builder.set_name_span({begin, begin + static_cast<Offset>(name.size())});
    }
}

OpenProgram& Programs::current() {
    if (open_.empty()) open(std::string(file_name_of(source_.path())));
    return open_.back();
}

/// A part that REPEAT names and that is not there; a GOTO whose label stands before it and behind it: it
/// takes the one behind [NCI].
void Programs::check_labels(const OpenProgram& program) {
    const auto error = [&](SyntaxErrorKind kind, const NamedPlace& place, std::string cure) {
        file_.syntax_errors.push_back(
            {kind, place.span, std::string(source_.bytes(place.span)), std::move(cure)});
    };
    for (const NamedPlace& label : program.labels) // a name stands for one thing alone [NCP19 p.45]
        if (program.variables.contains(label.name) || program.arrays.contains(label.name))
            error(SyntaxErrorKind::taken_name, label, "a variable");
    for (const Span action : program.left_at_return) error(SyntaxErrorKind::action_left, {{}, action}, "");
    for (const NamedPlace& part : program.repeated)
        if (std::ranges::find(program.labels, part.name, &NamedPlace::name) == program.labels.end())
            error(SyntaxErrorKind::mark_missing, part, "");
    for (const Repetition& repetition : program.repetitions)
        if (const NamedPlace* first = part_turned_round(program, repetition))
            error(SyntaxErrorKind::mark_missing, {{}, repetition.here}, first->name);
    for (const NamedPlace& jump : program.both_ways) {
        const NamedPlace* ahead = nullptr;
        bool behind = false;
        for (const NamedPlace& label : program.labels) {
            if (label.name != jump.name) continue;
            behind |= label.span.begin < jump.span.begin;
            if (ahead == nullptr && label.span.begin > jump.span.begin) ahead = &label;
        }
        if (behind && ahead != nullptr)
            error(SyntaxErrorKind::ambiguous_jump, jump,
                  std::to_string(source_.position(ahead->span.begin).line));
    }
}

/// Of a name that stands once it is a slip where it is a letter off a variable of the program, or off a word
/// that stands for a value.
void Programs::collect_names(OpenProgram& program) {
    std::vector<UnknownName> names;
    for (const auto& [name, uses] : program.unknown) {
        if (program.variables.contains(name) || program.arrays.contains(name) ||
            program.unread.contains(name))
            continue;
        UnknownName unknown{name, uses.first, {}, true};
        const bool is_once = uses.count == 1;
        const auto look_at = [&](const std::string& known) {
            const bool first = unknown.meant.empty() || known < unknown.meant;
            if (is_once && first && is_one_letter_off(name, known)) unknown.meant = known;
        };
        for (const auto& [known, variable] : program.variables) look_at(known);
        for (const auto& [known, array] : program.arrays) look_at(known);
        if (unknown.meant.empty() && is_once && uses.is_read) {
            unknown.meant = value_meant_by(name);
            unknown.of_the_program = unknown.meant.empty();
        }
        if (uses.is_read || !unknown.meant.empty()) names.push_back(std::move(unknown));
    }
    std::ranges::sort(names, {}, [](const UnknownName& name) { return name.span.begin; });
    for (UnknownName& name : names) program.builder.add_unknown_name(std::move(name));
}

void Programs::close() {
    for (OpenProgram& program : open_) {
        check_labels(program);
        follow_parts(program);
        collect_names(program);
        file_.programs.push_back(program.builder.take());
    }
}

} // namespace maclint::sinumerik
