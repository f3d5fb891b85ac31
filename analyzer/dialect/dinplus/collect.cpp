//! Programs and sections.
#include "analyzer/dialect/dinplus/collect.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/dinplus/plain.hpp"
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

/// The control knows no case in names.
void add_name(ProgramBuilder& builder, std::string_view name) {
    const Program& program = builder.program();
    const auto known = [&](std::string_view other) { return in_capitals(other) == in_capitals(name); };
    if (name.empty() || known(program.name) || std::ranges::any_of(program.also_known_as, known)) return;
    builder.add_name(name);
}

/// Where a name stands in the text of its program.
Span span_in(std::string_view text, std::string_view name) {
    const auto begin = static_cast<Offset>(name.data() - text.data());
    return {begin, begin + static_cast<Offset>(name.size())};
}

} // namespace

Part& Programs::open(std::string name) {
    Part& part = parts_.emplace_back(Part{ProgramBuilder(std::move(name), source_.bytes(), control_), {}});
    part.program.set_plain_tables(
        {&plain_tables(plain_sections::commands), &plain_tables(plain_sections::descriptions)});
    return part;
}

/// The main part, named after its file.
Part& Programs::main() {
    if (main_ == nothing) {
        main_ = parts_.size();
        ProgramBuilder& program = open(stem_of(source_.path())).program;
        add_name(program, file_name(source_.path()));
        if (is_subprogram_file(source_.path())) program.set_started(Program::Started::by_call);
    }
    return parts_[main_];
}

void Programs::open_main(Span line, Offset mark) {
    leave_section();
    // A second program in the file; before the first there may be remarks.
    if (main_ != nothing && parts_[main_].program.has_sections()) main_ = nothing;
    ProgramBuilder& program = main().program;
    current_ = main_;
    const std::string_view text = source_.bytes();
    std::string_view name = text.substr(mark + 1, line.end - mark - 1);
    name = trim(name.substr(0, name.find_first_of("\"[")));
    if (name.empty()) return;
    program.set_name_span(span_in(text, name));
    add_name(program, stem_of(name));
    add_name(program, name);
    if (is_subprogram_file(name)) program.set_started(Program::Started::by_call);
}

void Programs::open_section(const SectionWord& word, Span heading) {
    leave_section();
    const SectionKind& kind = kind_of(word);
    if (kind.role == Role::subprogram) {
        open_subprogram(word, heading);
    } else {
        ProgramBuilder& program = main().program;
        current_ = main_;
        // Names may be declared anywhere; everything else belongs to a program of its own.
        if (!declares_names(kind) && program.program().started == Program::Started::unknown &&
            in_capitals(source_.path()).ends_with(".NC"))
            program.set_started(Program::Started::by_hand);
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
    Preceding before = inherited(main().before); // also when the subprograms stand first
    current_ = parts_.size();
    Part& part = open(std::string(name.empty() ? word.word : name));
    part.before = std::move(before);
    part.program.set_local();
    part.program.set_started(Program::Started::by_call);
    part.program.set_name_span(name.empty() ? heading : span_in(source_.bytes(), name));
}

/// Names of VAR that stand for variables which all programs share are known in local subprograms, too.
Preceding Programs::inherited(const Preceding& main) {
    Preceding result;
    for (const auto& alias : main.aliases)
        if (control().spaces[alias.second.space].scope != Scope::frame) result.aliases.insert(alias);
    return result;
}

void Programs::begin_section(const SectionKind& kind, Span heading) {
    auto& [program, before] = parts_[current_];
    program.begin_section(kind.name, executed(kind), heading);
    before.context = kind.role == Role::contour ? Context::contour : Context::machining;
    before.effects = executed(kind) != Executed::never;
    before.declares = declares_names(kind);
}

Part& Programs::current() {
    if (current_ == nothing) {
        main();
        current_ = main_;
    }
    ProgramBuilder& program = parts_[current_].program;
    if (!program.has_sections()) program.begin_section(without_sections, Executed::when_reached, {});
    return parts_[current_];
}

const Preceding& Programs::preceding() const {
    static const Preceding nothing_yet;
    return current_ == nothing ? nothing_yet : parts_[current_].before;
}

void Programs::leave_section() {
    if (current_ != nothing) parts_[current_].before.waiting_if.reset();
}

void Programs::close() {
    for (Part& part : parts_)
        if (part.program.has_sections()) file_.programs.push_back(part.program.take());
}

} // namespace maclint::dinplus
