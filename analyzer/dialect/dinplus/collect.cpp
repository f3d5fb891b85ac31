//! Programs and sections.
#include "analyzer/dialect/dinplus/collect.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/dinplus/channels.hpp"
#include "analyzer/dialect/dinplus/plain.hpp"
#include "analyzer/dialect/dinplus/remarks.hpp"
#include "analyzer/dialect/dinplus/sections.hpp"
#include "analyzer/dialect/dinplus/value_tables.hpp"

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

const Variable* OpenProgram::alias_of(std::string_view name) const {
    if (const auto own = aliases.find(name); own != aliases.end()) return &own->second;
    if (inherited == nullptr) return nullptr;
    const auto shared = inherited->find(name);
    return shared == inherited->end() ? nullptr : &shared->second;
}

OpenProgram& Programs::open(std::string name) {
    OpenProgram& program = open_.emplace_back(
        OpenProgram{.builder = ProgramBuilder(std::move(name), source_.bytes(), control_)});
    program.builder.set_plain_tables(
        {&plain_tables(plain_sections::commands), &plain_tables(plain_sections::descriptions)});
    return program;
}

/// The main part, named after its file.
OpenProgram& Programs::main() {
    if (main_ == nothing) {
        main_ = open_.size();
        ProgramBuilder& program = open(stem_of(source_.path())).builder;
        add_name(program, file_name_of(source_.path()));
        if (is_subprogram_file(source_.path())) program.set_started(Program::Started::by_call);
    }
    return open_[main_];
}

void Programs::open_main(Span line, Offset mark) {
    leave_section();
    // A second program in the file; before the first there may be remarks.
    if (main_ != nothing && open_[main_].builder.has_sections()) main_ = nothing;
    ProgramBuilder& program = main().builder;
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
    check_language(word, heading);
    if (kind.role == Role::subprogram) {
        open_subprogram(word, heading);
    } else {
        ProgramBuilder& program = main().builder;
        current_ = main_;
        // Names may be declared anywhere; everything else belongs to a program of its own.
        if (!declares_names(kind) && program.program().started == Program::Started::unknown &&
            in_capitals(source_.path()).ends_with(".NC"))
            program.set_started(Program::Started::by_hand);
        open_[main_].knows_all_names = program.program().started == Program::Started::by_hand;
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
    const auto names = inherited(main()); // also when the subprograms stand first
    const bool knows_all = open_[main_].knows_all_names && !open_[main_].declares_something_unreadable;
    current_ = open_.size();
    OpenProgram& opened = open(std::string(name.empty() ? word.word : name));
    opened.inherited = names;
    opened.of_main = of_main_;
    opened.knows_all_names = knows_all;
    check_length(name);
    opened.builder.set_local();
    opened.builder.set_started(Program::Started::by_call);
    opened.builder.set_name_span(name.empty() ? heading : span_in(source_.bytes(), name));
}

/// The words of a program are of one language; CONST and VAR are the same in all [dinplus.md 2.2].
void Programs::check_language(const SectionWord& word, Span heading) {
    using Use = SectionWord::Use;
    if (word.use == Use::translated || word.kind == "VAR" || word.kind == "CONST") return;
    const Use use = word.use == Use::german ? Use::german : Use::english;
    if (!language_) language_ = use;
    if (*language_ == use) return;
    const auto same = std::ranges::find_if(section_words(), [&](const SectionWord& other) {
        return other.kind == word.kind && other.use == *language_;
    });
    const auto length = static_cast<Offset>(word.word.size());
    const Span span{heading.begin, heading.begin + std::min(length, heading.length())};
    file_.syntax_errors.push_back({SyntaxErrorKind::section_of_other_language, span,
                                   std::string(source_.bytes(span)),
                                   same == section_words().end() ? "" : std::string(same->word)});
}

/// The name of a local subprogram has at most 40 characters [l.2945].
void Programs::check_length(std::string_view name) {
    if (name.size() <= limits::local_name) return;
    file_.syntax_errors.push_back({SyntaxErrorKind::long_program_name, span_in(source_.bytes(), name),
                                   std::string(name), std::to_string(limits::local_name)});
}

/// Names of VAR that stand for variables which all programs share are known in local subprograms, too.
std::shared_ptr<const VariablesByName> Programs::inherited(const OpenProgram& main) {
    // Names are only ever added.
    if (inherited_ != nullptr && inherited_from_ == main_ && inherited_of_ == main.aliases.size())
        return inherited_;
    auto names = std::make_shared<VariablesByName>();
    for (const auto& alias : main.aliases)
        if (control().spaces[alias.second.space].scope != Scope::frame) names->insert(alias);
    inherited_ = std::move(names);
    of_main_ = std::make_shared<const VariablesByName>(main.aliases);
    inherited_from_ = main_;
    inherited_of_ = main.aliases.size();
    return inherited_;
}

void Programs::begin_section(const SectionKind& kind, Span heading) {
    OpenProgram& program = open_[current_];
    program.builder.begin_section(kind.name, executed(kind), heading);
    program.context = kind.role == Role::contour ? Context::contour : Context::machining;
    program.effects = executed(kind) != Executed::never;
    program.declares = declares_names(kind);
}

OpenProgram& Programs::current() {
    if (current_ == nothing) {
        main();
        current_ = main_;
    }
    ProgramBuilder& program = open_[current_].builder;
    if (!program.has_sections()) program.begin_section(without_sections, Executed::when_reached, {});
    return open_[current_];
}

const OpenProgram* Programs::current_if_any() const {
    return current_ == nothing ? nullptr : &open_[current_];
}

void Programs::leave_section() {
    if (current_ == nothing) return;
    OpenProgram& program = open_[current_];
    program.waiting_if.reset();
    for (const Span group : program.groups)
        file_.syntax_errors.push_back(
            {SyntaxErrorKind::group_unbalanced, group, std::string(source_.bytes(group)), "BLOCKEND"});
    program.groups.clear();
}

void Programs::close() {
    leave_section();
    check_remarks(source_, file_.syntax_errors);
    for (OpenProgram& program : open_) {
        if (!program.builder.has_sections()) continue;
        check_slides(program.builder.program(), file_.syntax_errors);
        assign_channels(program.builder);
        file_.programs.push_back(program.builder.take());
    }
}

} // namespace maclint::dinplus
