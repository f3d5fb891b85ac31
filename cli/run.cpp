//! Hands each request to its command and turns what is thrown into one error.
#include "cli/run.hpp"

#include "analyzer/program/overloaded.hpp"
#include "cli/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/out_of_memory.hpp"
#include "cli/terminal.hpp"

#include <cstdio>
#include <exception>
#include <new>

namespace maclint::cli {
namespace {

int do_request(const Request& request) {
    return std::visit(overloaded{[](const CheckRequest& check) { return run_check(check); },
                                 [](const RulesRequest& rules) { return run_rules_command(rules); },
                                 [](const ExplainRequest& explain) { return run_explain(explain); },
                                 [](const ControlsRequest& controls) { return run_controls(controls); },
                                 [](const InitRequest& init) { return run_init(init); },
                                 [](const RenumberRequest& renumber) { return run_renumber(renumber); },
                                 [](const LspRequest& lsp) { return run_lsp(lsp); },
                                 [](const PrintRequest& print) { return print_text(print.text); },
                                 [](const UsageError& error) {
                                     print_error(error.message);
                                     return exit_error;
                                 }},
                      request);
}

} // namespace

int run(const std::vector<std::string>& arguments) noexcept {
    try {
        return do_request(read_command_line(arguments));
    } catch (const std::bad_alloc&) {
        end_out_of_memory();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "maclint: error: something went wrong inside maclint (%s). Please report it.\n",
                     error.what());
    } catch (...) {
        std::fputs("maclint: error: something went wrong inside maclint. Please report it.\n", stderr);
    }
    return exit_error;
}

} // namespace maclint::cli
