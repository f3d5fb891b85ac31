//! `maclint explain WORD`: the page of a rule or a row, of a code, a variable or an alarm, or all that a word
//! may mean.
#include "cli/commands/commands.hpp"
#include "cli/commands/explanation.hpp"
#include "cli/report/json_head.hpp"
#include "cli/report/row_page.hpp"
#include "cli/report/rule_json.hpp"
#include "cli/report/rule_page.hpp"
#include "cli/terminal.hpp"
#include "cli/text/shown.hpp"
#include "rules/listed.hpp"

#include <vector>

#include <nlohmann/json.hpp>

namespace maclint::cli {
namespace {

using Json = nlohmann::ordered_json;

/// The rules, or the rows, that a word may mean.
std::string list_of(const std::vector<NamedRule>& named, std::size_t width) {
    std::vector<const Rule*> rules;
    std::vector<const RuleRow*> rows;
    for (const auto& [rule, row] : named) {
        if (row == nullptr)
            rules.push_back(rule);
        else
            rows.push_back(row);
    }
    std::vector<std::string> counts;
    if (!rules.empty()) counts.push_back(counted(rules.size(), "rule"));
    if (!rows.empty()) counts.push_back(counted(rows.size(), "row"));
    const std::string heading = rules.empty() || rows.empty() ? "" : "\nrows\n";
    return plain_list(rules, ListedRows::left_out, width) + heading + list_of_rows(rows, width) + "\n" +
           rules::listed(counts, " and ");
}

std::string text_of(const ExplainRequest& request, const Explanation& explanation, std::size_t width) {
    if (explanation.pages.empty())
        return list_of(explanation.meant, width) + " may be meant by '" + shown(request.rule) + "'.\n";
    std::string text; // with an empty line between pages
    for (const ExplainedPage& page : explanation.pages) text += (text.empty() ? "" : "\n") + page.text;
    // The number of an alarm may be that of a rule, too; a word may be a part of rules' names.
    const bool is_alarm = explanation.pages.front().kind == "alarm";
    if (!explanation.meant.empty())
        text += (is_alarm ? "\nRules with that number:\n" : "\nRules with that name:\n") +
                list_of(explanation.meant, width) + ".\n";
    return text;
}

Json meant_as_json(const NamedRule& named) {
    if (named.row != nullptr) return {{"row", named.row->name()}};
    return {{"code", named.rule->code}, {"name", named.rule->name}, {"summary", named.rule->summary}};
}

std::string json_of(const ExplainRequest& request, const Explanation& explanation) {
    Json pages = Json::array(), meant = Json::array();
    for (const ExplainedPage& page : explanation.pages) {
        Json one = {{"kind", page.kind}, {"text", page.text}};
        if (page.named.row != nullptr) one["row"] = page.named.row->name();
        if (page.named.rule != nullptr) one["rule"] = rule_as_json(*page.named.rule);
        pages.push_back(std::move(one));
    }
    for (const NamedRule& named : explanation.meant) meant.push_back(meant_as_json(named));
    Json out = json_head();
    out["word"] = request.rule;
    out["pages"] = std::move(pages);
    out["meant"] = std::move(meant);
    return json_text(out);
}

} // namespace

int run_explain(const ExplainRequest& request) {
    const bool as_json = request.format == ListFormat::json;
    const PageStyle style =
        as_json ? PageStyle{} : PageStyle{colour_for_output(request.colour), output_width()};
    const Explanation explanation = explanation_of(request, style);
    if (!explanation.pages.empty() || !explanation.meant.empty())
        return print_text(as_json ? json_of(request, explanation)
                                  : text_of(request, explanation, style.width));
    print_error(
        "there is no rule" +
        std::string(request.control == nullptr ? "" : ", and no such code or alarm of that control,") + " '" +
        shown(request.rule) + "'." + advice_for(request.rule));
    return exit_error;
}

} // namespace maclint::cli
