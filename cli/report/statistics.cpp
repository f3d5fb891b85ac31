//! Counts in maps, then sorted: by number, and by code or path where numbers are equal.
#include "cli/report/statistics.hpp"

#include "cli/config/rule_words.hpp"
#include "cli/text/shown.hpp"
#include "rules/words/rule_row.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

namespace maclint::cli {
namespace {

/// Whoever wants all asks for JSON.
constexpr std::size_t most_files = 20;

std::string right_aligned(std::size_t number, std::size_t width) {
    const std::string digits = std::to_string(number);
    return std::string(width - std::min(width, digits.size()), ' ') + digits;
}

template<class Counts>
std::size_t widest_number(const Counts& counts) {
    return counts.empty() ? 0 : std::to_string(counts.front().findings).size();
}

} // namespace

Statistics statistics_of(const Report& report) {
    std::map<std::pair<std::string, Severity>, RuleCount> rules;
    std::unordered_map<const Source*, std::size_t> files;
    for (const auto* findings : {&report.findings, &report.not_shown}) {
        for (const auto& [finding, suppressed] : *findings) {
            if (suppressed) continue;
            ++rules
                  .try_emplace({code_with_key(finding), finding.severity}, finding.rule, finding.row,
                               finding.severity, 0U)
                  .first->second.findings;
            ++files[finding.source.get()];
        }
    }
    Statistics statistics;
    for (const auto& [key, count] : rules) statistics.rules.push_back(count);
    for (const auto& [source, count] : files) statistics.files.push_back({source, count});
    std::ranges::stable_sort(statistics.rules, std::ranges::greater(), &RuleCount::findings);
    std::ranges::sort(statistics.files, [](const FileCount& a, const FileCount& b) {
        return a.findings != b.findings ? a.findings > b.findings : a.source->path() < b.source->path();
    });
    return statistics;
}

std::string statistics_text(const Report& report) {
    const auto [rules, files] = statistics_of(report);
    std::string out = "findings by rule:\n";
    for (const auto& [rule, row, severity, findings] : rules)
        out += "  " + right_aligned(findings, widest_number(rules)) + "  " +
               (row == nullptr ? std::string(rule->code) : row->name()) + " " + std::string(rule->name) +
               " (" + std::string(name_of(severity)) + ")\n";
    if (rules.empty()) out += "  none\n";
    out += "findings by file:\n";
    for (std::size_t i = 0; i < std::min(files.size(), most_files); ++i)
        out += "  " + right_aligned(files[i].findings, widest_number(files)) + "  " +
               shown(files[i].source->path()) + "\n";
    if (files.empty()) out += "  none\n";
    if (files.size() > most_files)
        out += "  and " + counted(files.size() - most_files, "more file").append("\n");
    return out;
}

} // namespace maclint::cli
