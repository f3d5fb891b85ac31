//! Programs and sections.
#include "analyzer/dialect/dinplus/collect.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/dinplus/sections.hpp"

#include <algorithm>

namespace maclint::dinplus {
namespace {

using Role = SectionKind::Role;
using Executed = Section::Executed;

constexpr std::string_view without_sections = "program";

bool declares_names(const SectionKind& kind) { return kind.name == "VAR" || kind.name == "CONST"; }

Executed executed(const SectionKind& kind) {
    switch (kind.role) {
    case Role::machining:
    case Role::subprogram: return Executed::when_reached;
    case Role::contour: return Executed::at_load;
    case Role::information: return declares_names(kind) ? Executed::at_load : Executed::never;
    case Role::end: break;
    }
    return Executed::never;
}

std::string_view trim(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

/// Whether the name is that of a subprogram's file: extension .ncs, any case.
bool is_subprogram_file(std::string_view name) { return in_capitals(name).ends_with(".NCS"); }

std::string_view file_name(std::string_view path) {
    const std::size_t slash = path.find_last_of("/\\");
    return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

void add_name(Program& program, std::string_view name) {
    const auto known = [&](std::string_view other) { return in_capitals(other) == in_capitals(name); };
    if (name.empty() || known(program.name) || std::ranges::any_of(program.also_known_as, known)) return;
    program.also_known_as.emplace_back(name);
}

} // namespace

Program& Programs::open(std::string name) {
    Program& program = file_.programs.emplace_back();
    program.name = std::move(name);
    program.text = source_.bytes();
    program.control = &control_;
    before_.emplace_back();
    return program;
}

/// The main part, named after its file.
Program& Programs::main() {
    if (main_ == nothing) {
        main_ = file_.programs.size();
        Program& program = open(stem_of(source_.path()));
        add_name(program, file_name(source_.path()));
        if (is_subprogram_file(source_.path())) program.started = Program::Started::by_call;
    }
    return file_.programs[main_];
}

void Programs::open_main(Span line, Offset mark) {
    leave_section();
    // A second program in the file; before the first there may be remarks.
    if (main_ != nothing && !file_.programs[main_].sections.empty()) main_ = nothing;
    Program& program = main();
    current_ = main_;
    std::string_view name = program.slice({mark + 1, line.end});
    name = trim(name.substr(0, name.find_first_of("\"[")));
    if (name.empty()) return;
    const auto begin = static_cast<Offset>(name.data() - program.text.data());
    program.name_span = {begin, begin + static_cast<Offset>(name.size())};
    add_name(program, stem_of(name));
    add_name(program, name);
    if (is_subprogram_file(name)) program.started = Program::Started::by_call;
}

void Programs::open_section(const SectionWord& word, Span heading) {
    leave_section();
    const SectionKind& kind = kind_of(word);
    if (kind.role == Role::subprogram) {
        open_subprogram(word, heading);
    } else {
        Program& program = main();
        current_ = main_;
        // Names may be declared anywhere; everything else belongs to a program of its own.
        if (!declares_names(kind) && program.started == Program::Started::unknown &&
            in_capitals(source_.path()).ends_with(".NC"))
            program.started = Program::Started::by_hand;
    }
    begin_section(kind, heading);
}

void Programs::open_subprogram(const SectionWord& word, Span heading) {
    std::string_view rest = source_.bytes().substr(heading.begin, heading.length());
    rest = rest.substr(std::min(rest.find_first_of("\"[0123456789"), rest.size()));
    std::string_view name = rest;
    if (rest.starts_with('"'))
        name = rest.substr(1, rest.find('"', 1) - 1);
    else // word processors make other quotation marks of them
        name = rest.substr(0, rest.find_first_not_of("0123456789"));
    name = trim(name.substr(0, name.find('[')));
    main(); // also when the subprograms stand first
    current_ = file_.programs.size();
    Program& program = open(std::string(name));
    program.local = true;
    program.started = Program::Started::by_call;
    if (!name.empty()) {
        const auto begin = static_cast<Offset>(name.data() - program.text.data());
        program.name_span = {begin, begin + static_cast<Offset>(name.size())};
    } else {
        program.name = std::string(word.word);
        program.name_span = heading;
    }
    before_[current_] = inherited(before_[main_]);
}

/// Names of VAR that stand for variables which all programs share are known in local subprograms, too.
Preceding Programs::inherited(const Preceding& main) {
    Preceding result;
    for (const auto& alias : main.aliases)
        if (control().spaces[alias.second.space].scope != Scope::frame) result.aliases.insert(alias);
    return result;
}

void Programs::begin_section(const SectionKind& kind, Span heading) {
    Program& program = file_.programs[current_];
    const auto first = static_cast<Id>(program.items.size());
    program.sections.push_back({kind.name, {first, 0}, executed(kind), heading});
    Preceding& before = before_[current_];
    before.context = kind.role == Role::contour ? Context::contour : Context::machining;
    before.effects = executed(kind) != Executed::never;
    before.declares = declares_names(kind);
}

Part Programs::current() {
    if (current_ == nothing) {
        main();
        current_ = main_;
    }
    Program& program = file_.programs[current_];
    if (program.sections.empty())
        program.sections.push_back({without_sections, {0, 0}, Executed::when_reached, {}});
    return {program, before_[current_]};
}

void Programs::leave_section() {
    if (current_ == nothing) return;
    Program& program = file_.programs[current_];
    before_[current_].waiting_if.reset();
    if (program.sections.empty()) return;
    Section& section = program.sections.back();
    section.items.count = static_cast<Id>(program.items.size()) - section.items.first;
}

void Programs::close() {
    leave_section();
    std::erase_if(file_.programs, [](const Program& program) { return program.sections.empty(); });
    for (Program& program : file_.programs) finish(program);
}

void Programs::finish(Program& program) const {
    if (!program.items.empty())
        program.span = {program.span_of(0).begin,
                        program.span_of(static_cast<ItemId>(program.items.size() - 1)).end};
    else if (!program.sections.empty())
        program.span = program.sections.front().heading;
    if (program.name_span.empty()) program.name_span = {program.span.begin, program.span.begin};
}

} // namespace maclint::dinplus
