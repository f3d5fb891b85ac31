//! Keys of rows, and the rows by their keys.
#include "rules/words/rule_row.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "rules/words/row_switch.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

namespace maclint {
namespace {

std::string joined(std::string_view list, std::string_view separator) {
    std::string text;
    for (const std::string_view word : words_of(list))
        text += (text.empty() ? "" : std::string(separator)) + std::string(word);
    return text;
}

/// "-WITHOUT-C-AXIS"; empty where the row names no switch.
std::string switch_in_key(std::string_view begin, std::string_view name) {
    if (name.empty()) return {};
    std::string key = std::string(begin) + in_capitals(name);
    std::ranges::replace(key, ' ', '-');
    return key;
}

/// "G83" for the row's code, then ".Q" for its words and "-P" for those that they are held against; of codes
/// beside which or before which it must not stand, the first.
std::string key_of(const RowForCode& code) {
    const WordRow& row = *code.row;
    if (code.is_of_address()) return std::string(row.words);
    std::string key = code_of(code);
    const bool must_not_precede = row.says == RowStatement::precedes && row.others.empty();
    const bool names_words = row.says != RowStatement::takes_only && row.says != RowStatement::refused &&
                             row.says != RowStatement::precedes && row.says != RowStatement::left_on;
    if (!row.words.empty() && names_words) key += "." + joined(row.words, "+");
    const TableText forbidden = row.says == RowStatement::apart ? row.others
                                : must_not_precede              ? row.words
                                : row.says == RowStatement::encloses || row.says == RowStatement::names_none
                                    ? row.words
                                    : TableText();
    if (!row.others.empty() && row.says != RowStatement::left_on && row.says != RowStatement::precedes &&
        forbidden.empty())
        key += "-" + joined(row.others, "+");
    for (const TableText codes : {forbidden, row.under, row.after})
        if (!codes.empty()) key += "-" + std::string(words_of(codes).front());
    for (const std::string_view condition : words_of(row.when))
        key += condition.starts_with('-') ? "-NO" + std::string(condition.substr(1))
                                          : "-" + std::string(condition);
    if (row.modulo != 0) key += "-REST";
    if (row.says != RowStatement::left_on) key += switch_in_key("-WHILE-", row.while_on);
    key += switch_in_key("-WITHOUT-", first_switch_off(row));
    std::erase_if(key, [](char c) { return std::string_view("=?!|<>").find(c) != std::string_view::npos; });
    return key;
}

const Rule* rule_for(RowStatement says) {
    for (const Rule* rule : all_rules())
        if (const auto* check = std::get_if<RowCheck>(&rule->check); check != nullptr && check->says == says)
            return rule;
    return nullptr;
}

std::vector<RuleRow> make_rows() {
    std::vector<RuleRow> rows;
    std::map<std::pair<const Rule*, std::string>, std::size_t> known;
    for (const WordTable* table : all_word_tables())
        for (const WordRow& row : table->rows)
            for (const std::string_view code : words_of(row.code)) {
                const RowForCode one{table, &row, code.front(), code_number_of(code)};
                const Rule* rule = rule_for(row.says);
                std::string key = key_of(one);
                const auto [place, is_new] = known.try_emplace({rule, key}, rows.size());
                if (is_new) rows.push_back({rule, 0, std::move(key), {}});
                rows[place->second].rows.push_back(one);
            }
    std::ranges::stable_sort(rows, [](const RuleRow& a, const RuleRow& b) {
        return std::pair(a.rule->code, std::string_view(a.key)) <
               std::pair(b.rule->code, std::string_view(b.key));
    });
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].index = i;
    return rows;
}

/// In capitals, without zeros in front of its code.
std::string normal_key(std::string_view written) {
    std::string key = in_capitals(written);
    while (key.size() > 2 && key[1] == '0' && key[2] >= '0' && key[2] <= '9') key.erase(1, 1);
    return key;
}

} // namespace

std::span<const RuleRow> all_rule_rows() {
    static const std::vector<RuleRow> rows = make_rows();
    return rows;
}

std::span<const RuleRow> rows_of(const Rule& rule) {
    if (!std::holds_alternative<RowCheck>(rule.check)) return {}; // most are asked for every program
    const auto all = all_rule_rows();
    const auto [first, last] =
        std::ranges::equal_range(all, rule.code, {}, [](const RuleRow& row) { return row.rule->code; });
    return {first, last};
}

const RuleRow* find_rule_row(std::string_view name) {
    const std::size_t slash = name.find('/');
    if (slash == std::string_view::npos) return nullptr;
    const Rule* rule = find_rule(name.substr(0, slash));
    if (rule == nullptr) return nullptr;
    const auto rows = rows_of(*rule);
    const auto found = std::ranges::find(rows, normal_key(name.substr(slash + 1)), &RuleRow::key);
    return found == rows.end() ? nullptr : &*found;
}

} // namespace maclint
