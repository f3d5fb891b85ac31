//! Findings carry a rule of the registry, because reports number rules by it.
#include "tests/cli/reports.hpp"

#include "rules/rule.hpp"
#include "tests/support/program_file.hpp"

namespace maclint::test {

HandMade::HandMade(std::string path, std::string text)
    : source_(std::make_shared<const Source>(Source::from_bytes(std::move(path), std::move(text))))
    , file_(file_of(source_)) {
    report_.files.push_back(source_);
}

Span HandMade::place_of(std::string_view part) const {
    const auto at = static_cast<Offset>(source_->bytes().find(part));
    return {at, at + static_cast<Offset>(part.size())};
}

Finding& HandMade::add(std::string_view part, Severity severity) {
    Finding finding{.rule = find_rule("MAC002"),
                    .cause = {*file_, place_of(part)},
                    .severity = severity,
                    .source = source_,
                    .span = place_of(part),
                    .message_id = "unknown",
                    .arguments = {source_->to_utf8(part)},
                    .related = {},
                    .path = {},
                    .fixes = {}};
    return report_.findings.emplace_back(cli::FilteredFinding{std::move(finding), std::nullopt}).finding;
}

} // namespace maclint::test
