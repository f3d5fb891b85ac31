//! Rules have a page in Markdown; what else there is, codes and alarms, is shown as text.
#include "cli/lsp/features/explain_rule.hpp"

#include "cli/commands/explanation.hpp"
#include "cli/report/rule_page.hpp"

namespace maclint::cli::lsp {
namespace {

std::string as_block(const std::string& text) { return "```text\n" + text + "```\n"; }

} // namespace

Json explain_rule(Session& /*session*/, const Json& arguments) {
    if (arguments.empty() || !arguments.front().is_string())
        throw ResponseError{ErrorCode::invalid_params, "'maclint.explain' needs a code, such as \"MAC303\"."};
    const auto& word = arguments.front().get_ref<const std::string&>();
    const auto named = rules_named(word);
    if (named.size() == 1 && named.front().row == nullptr) {
        const Rule& rule = *named.front().rule;
        Json page = {{"markdown", markdown_page(rule)}};
        if (const std::string url = page_url(rule); !url.empty()) page["url"] = url;
        return page;
    }
    std::string text;
    for (const ExplainedPage& page : explanation_of({.rule = word}, {}).pages) text += as_block(page.text);
    if (text.empty())
        throw ResponseError{ErrorCode::invalid_params, "There is nothing to say of '" + word + "'."};
    return {{"markdown", text}};
}

} // namespace maclint::cli::lsp
