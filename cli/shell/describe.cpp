//! Reads the declarations back from CLI11.
#include "cli/shell/describe.hpp"

#include <CLI/CLI.hpp>

namespace maclint::cli {
namespace {

/// Values are named for what they are: a FILE is completed as a path, RULES and EXEMPTIONS as lists.
ValueKind kind_of(const OptionText& option) {
    if (option.value.empty()) return ValueKind::none;
    if (option.value == "RULES" || option.value == "EXEMPTIONS") return ValueKind::lists;
    if (!option.words.empty()) return ValueKind::words;
    if (option.value == "FILE" || option.value == "DIR" || option.value == "PATH" || option.value == "FOLDER")
        return ValueKind::path;
    return ValueKind::free;
}

OptionText describe(const CLI::Option& option, const KnownWords& known) {
    OptionText text;
    for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
    for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
    text.value = text.names.empty() ? option.get_name(true) : option.get_type_name();
    text.text = option.get_description();
    text.words = known(text.names.empty() ? text.value : text.names.front());
    text.repeatable = option.get_items_expected_max() > 1;
    text.kind = kind_of(text);
    return text;
}

} // namespace

CommandText describe(const CLI::App& app, std::string text, const KnownWords& known) {
    CommandText command{app.get_name(), std::move(text), {}};
    for (const CLI::Option* option : app.get_options()) command.options.push_back(describe(*option, known));
    return command;
}

} // namespace maclint::cli
