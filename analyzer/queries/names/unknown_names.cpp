//! Asks the workspace, the files of definitions and the configuration.
#include "analyzer/queries/names/unknown_names.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/dialect.hpp"
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

} // namespace

bool is_misspelt(const ProgramAnalysis& analysis, const UnknownName& name) {
    return !name.meant.empty() && !analysis.names_elsewhere().contain(name.name) &&
           analysis.workspace().count_named(name.name) == 0;
}

bool is_undefined(const ProgramAnalysis& analysis, const UnknownName& name) {
    const NamesElsewhere& elsewhere = analysis.names_elsewhere();
    return name.meant.empty() && elsewhere.are_all && !elsewhere.contain(name.name);
}

bool is_g_code(const UnknownName& name) {
    return name.name.size() > 1 && name.name.front() == 'G' &&
           std::ranges::all_of(std::string_view(name.name).substr(1), is_digit);
}

bool is_misspelt_at(const ProgramAnalysis& analysis, Span span) {
    return std::ranges::any_of(analysis.program().unknown_names, [&](const UnknownName& name) {
        return name.span.begin == span.begin && is_misspelt(analysis, name);
    });
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
