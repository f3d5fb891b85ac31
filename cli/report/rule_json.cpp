//! Written from the records of the rules. Keys are added, never changed, within a version.
#include "cli/report/rule_json.hpp"

#include "cli/config/selection.hpp"
#include "cli/report/json_head.hpp"
#include "cli/report/row_page.hpp"
#include "cli/report/rule_page.hpp"
#include "rules/words/rule_row.hpp"

#include <utility>

#include <nlohmann/json.hpp>

namespace maclint::cli {
namespace {

using Json = nlohmann::ordered_json;

Json rows_as_json(const Rule& rule) {
    Json rows = Json::array();
    for (const RuleRow& row : rows_of(rule)) {
        Json entries = Json::array();
        for (const RowForCode& entry : row.rows)
            entries.push_back({{"says", sentence_of(entry)},
                               {"where", where_of(entry)},
                               {"severity", name_of(entry.row->severity)},
                               {"aliases", entry.row->aliases},
                               {"source", entry.row->source}});
        rows.push_back(
            {{"key", row.key}, {"on_by_default", row.on_by_default()}, {"entries", std::move(entries)}});
    }
    return rows;
}

Json exemptions_as_json(const Rule& rule) {
    Json exemptions = Json::array();
    for (const RuleExemption& record : rule.exemptions)
        exemptions.push_back({{"name", record.name},
                              {"why", record.why},
                              {"dialect", record.wanted_by.dialect},
                              {"complete", record.wanted_by.complete},
                              {"program", record.wanted_by.text}});
    return exemptions;
}

} // namespace

Json rule_as_json(const Rule& rule) {
    Json out = {{"code", rule.code},
                {"name", rule.name},
                {"aliases", rule.aliases},
                {"family", family_of(rule)},
                {"summary", rule.summary},
                {"why", rule.why},
                {"severity", name_of(rule.severity)},
                {"precision", name_of(rule.precision)},
                {"on_by_default", rule.on_by_default}};
    if (const std::string page = page_url(rule); !page.empty()) out["url"] = page;
    out["exemptions"] = exemptions_as_json(rule);
    out["rows"] = rows_as_json(rule);
    return out;
}

std::string json_rules() {
    Json list = Json::array();
    for (const Rule* rule : all_rules()) list.push_back(rule_as_json(*rule));
    Json out = json_head();
    out["rules"] = std::move(list);
    return json_text(out);
}

} // namespace maclint::cli
