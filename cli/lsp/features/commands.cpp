//! A row for each command.
#include "cli/lsp/features/commands.hpp"

#include "cli/lsp/features/block_numbers.hpp"
#include "cli/lsp/features/explain_rule.hpp"

#include <algorithm>
#include <array>

namespace maclint::cli::lsp {
namespace {

struct CommandRow {
    std::string_view name;
    Handler handle; ///< of its arguments
};

constexpr std::array<CommandRow, 2> command_rows{{
    {"maclint.explain", explain_rule},
    {"maclint.renumber", renumber},
}};

} // namespace

std::vector<std::string> command_names_of_server() {
    std::vector<std::string> names;
    for (const CommandRow& row : command_rows) names.emplace_back(row.name);
    return names;
}

Json execute_command(Session& session, const Json& params) {
    const std::string& name = string_in(params, "command");
    const auto* const row = std::ranges::find(command_rows, name, &CommandRow::name);
    if (row == command_rows.end())
        throw ResponseError{ErrorCode::invalid_params, "There is no command '" + name + "'."};
    const Json* arguments = find(params, {"arguments"});
    if (arguments == nullptr || !arguments->is_array())
        throw ResponseError{ErrorCode::invalid_params, "'" + name + "' needs a list of arguments."};
    return row->handle(session, *arguments);
}

} // namespace maclint::cli::lsp
