//! Runs one rule over one text.
#include "tests/rules/raised.hpp"

#include "tests/support/analysed.hpp"

#include <array>

namespace maclint::test {
namespace {

template<class Take>
auto each_finding(std::string_view code, std::string text, const Take& take) {
    const auto workspace = analyse_fanuc(std::move(text));
    std::vector<decltype(take(std::declval<const Finding&>()))> taken;
    for (const Finding& finding : run_rules(*workspace, {{find_rule(code)}}, 1))
        taken.push_back(take(finding));
    return taken;
}

std::uint32_t line(const Source& source, Span span) { return source.position(span.begin).line; }

} // namespace

std::vector<std::uint32_t> lines_raised(std::string_view code, std::string text) {
    return each_finding(code, std::move(text),
                        [](const Finding& finding) { return line(*finding.source, finding.span); });
}

std::vector<std::string> messages_raised(std::string_view code, std::string text) {
    return each_finding(code, std::move(text), [](const Finding& finding) { return finding.message(); });
}

std::vector<std::string> judged(std::string_view code, const std::string& text) {
    constexpr std::array names{"note ", "warning ", "error "};
    const auto workspace = analyse_fanuc(text);
    std::vector<std::string> out;
    for (const Finding& finding : run_rules(*workspace, {{find_rule(code)}}, 1))
        out.push_back(names.at(static_cast<std::size_t>(finding.severity)) +
                      std::to_string(finding.source->position(finding.span.begin).line));
    return out;
}

std::vector<std::uint32_t> path_raised(std::string_view code, std::string text) {
    const auto paths = each_finding(code, std::move(text), [](const Finding& finding) {
        std::vector<std::uint32_t> lines;
        for (const RelatedLocation& step : finding.path) lines.push_back(line(*step.source, step.span));
        return lines;
    });
    return paths.size() == 1 ? paths.front() : std::vector<std::uint32_t>{};
}

} // namespace maclint::test
