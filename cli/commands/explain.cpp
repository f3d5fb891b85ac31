//! `maclint explain RULE`.
#include "cli/commands/commands.hpp"
#include "cli/config/selection.hpp"
#include "cli/report/rule_page.hpp"
#include "cli/suggest.hpp"
#include "cli/terminal.hpp"

namespace maclint::cli {

int run_explain(const ExplainRequest& request) {
    if (const Rule* rule = find_rule(request.rule)) return print_text(plain_page(*rule));
    print_error("there is no rule '" + shown(request.rule) + "'." +
                did_you_mean(request.rule, rule_words(), "See 'maclint rules' for the list."));
    return exit_error;
}

} // namespace maclint::cli
