//! Asks the workspace, the files of definitions and the configuration.
#include "analyzer/queries/names/unknown_names.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/dialect.hpp"
#include "analyzer/dialect/near_names.hpp"
#include "analyzer/program/language_words.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <string>

namespace maclint::queries {
namespace {

std::string_view without_number(std::string_view name) {
    while (!name.empty() && is_digit(name.back())) name.remove_suffix(1);
    return name;
}

/// Whether the program has the name in one place alone.
bool stands_once(const Program& program, std::string_view capitals) {
    const std::string text = in_capitals(program.slice(program.span));
    const auto is_of_name = [&](std::size_t at) {
        return at < text.size() && (is_letter(text[at]) || is_digit(text[at]) || text[at] == '_');
    };
    std::size_t count = 0;
    for (std::size_t at = text.find(capitals); at != std::string::npos; at = text.find(capitals, at + 1))
        count += (at == 0 || !is_of_name(at - 1)) && !is_of_name(at + capitals.size()) ? 1U : 0U;
    return count == 1;
}

} // namespace

std::string meant_by(const ProgramAnalysis& analysis, const UnknownName& name) {
    const NamesElsewhere& elsewhere = analysis.names_elsewhere();
    // Where all programs are there, that one is missing is more than that its name is near another.
    const auto& externals = analysis.program().externals;
    if (analysis.complete() &&
        std::ranges::find(externals, name.meant, &ExternalDeclaration::name) != externals.end())
        return {};
    if (elsewhere.contain(name.name) || analysis.workspace().count_named(name.name) != 0) return {};
    if (!name.meant.empty() || !elsewhere.are_all || elsewhere.defined == nullptr) return name.meant;
    std::string meant; // the first by the alphabet
    for (const std::string& known : *elsewhere.defined)
        if ((meant.empty() || known < meant) && is_one_letter_off(name.name, known)) meant = known;
    return meant.empty() || stands_once(analysis.program(), name.name) ? meant : "";
}

bool is_undefined(const ProgramAnalysis& analysis, const UnknownName& name) {
    const NamesElsewhere& elsewhere = analysis.names_elsewhere();
    return name.meant.empty() && elsewhere.are_all && !elsewhere.contain(name.name) &&
           meant_by(analysis, name).empty();
}

bool is_g_code(const UnknownName& name) {
    return name.name.size() > 1 && name.name.front() == 'G' &&
           std::ranges::all_of(std::string_view(name.name).substr(1), is_digit);
}

bool is_misspelt_at(const ProgramAnalysis& analysis, Span span) {
    return std::ranges::any_of(analysis.program().unknown_names, [&](const UnknownName& name) {
        return name.span.begin == span.begin && !meant_by(analysis, name).empty();
    });
}

bool is_of_another_control(const ControlModel& control, std::string_view code) {
    const Dialect* dialect = find_dialect(control.language);
    return dialect != nullptr && dialect->words != nullptr &&
           std::ranges::binary_search(dialect->words().foreign_codes, code);
}

bool is_brought_by_control(const ControlModel& control, std::string_view name) {
    const Dialect* dialect = find_dialect(control.language);
    if (dialect == nullptr || dialect->words == nullptr) return false;
    const std::string capitals = in_capitals(name);
    return std::ranges::any_of(dialect->words().words, [&](const LanguageWord& word) {
        return word.use == WordUse::cycle && without_number(word.word) == without_number(capitals);
    });
}

} // namespace maclint::queries
