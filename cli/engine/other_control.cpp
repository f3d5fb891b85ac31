//! What was misread shows in findings of all rules, so all of them are withheld.
#include "cli/engine/other_control.hpp"

#include "analyzer/dialect/other_control.hpp"
#include "analyzer/program/model.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <map>

namespace maclint::cli {
namespace {

constexpr std::string_view misread = "MAC005";

} // namespace

std::vector<Finding> other_control(const ProgramFile& file, const Dialect& dialect) {
    if (file.control->language != find_dialect("fanuc")->name) return {}; // DIN PLUS is told by its sections
    const auto found = find_other_control(file);
    if (!found) return {};
    const Rule& rule = *find_rule(misread);
    Reporter reporter(rule);
    std::string marks;
    for (const OtherControl::Mark& mark : found->marks)
        marks += (marks.empty() ? "" : ", ") + mark.text + " on line " +
                 std::to_string(file.source->position(mark.place.begin).line);
    const Span first = found->marks.front().place;
    const bool named = !found->name.empty();
    const std::string what = named
                                 ? std::string(found->name)
                                 : std::to_string(found->unreadable) + " of " + std::to_string(found->blocks);
    Finding& finding = reporter.report({file, first}, first, named ? "marks" : "share",
                                       {what, marks, std::string(dialect.name), ""});
    for (std::size_t i = 1; i < found->marks.size(); ++i)
        finding.related.push_back({file.source, found->marks[i].place,
                                   "this cannot be read as " + std::string(dialect.name) + ", either"});
    return reporter.take();
}

std::vector<FilteredFinding> withhold_misread(std::vector<FilteredFinding> findings) {
    const auto speaks = [](const FilteredFinding& filtered) {
        return filtered.finding.rule->code == misread && !filtered.suppressed;
    };
    std::map<const Source*, std::size_t> withheld;
    for (const FilteredFinding& filtered : findings)
        if (speaks(filtered)) withheld.emplace(filtered.finding.source.get(), 0);
    if (withheld.empty()) return findings;
    std::erase_if(findings, [&](const FilteredFinding& filtered) {
        const auto file = withheld.find(filtered.finding.source.get());
        if (file == withheld.end() || filtered.finding.rule->code == misread) return false;
        if (!filtered.suppressed) ++file->second;
        return true;
    });
    for (FilteredFinding& filtered : findings)
        if (speaks(filtered))
            filtered.finding.arguments.back() = counted(withheld[filtered.finding.source.get()], "finding");
    return findings;
}

} // namespace maclint::cli
