//! Findings carry a rule of the registry, because reports number rules by it.
#include "tests/cli/reports.hpp"

#include "analyzer/program/model.hpp"
#include "rules/rule.hpp"

namespace maclint::test {

HandMade::HandMade(std::string path, std::string text) {
    auto file = std::make_shared<ProgramFile>();
    file->source = std::make_shared<const Source>(Source::from_bytes(std::move(path), std::move(text)));
    report_.files.push_back(file->source);
    file_ = std::move(file);
}

const std::shared_ptr<const Source>& HandMade::source() const { return file_->source; }

Span HandMade::place_of(std::string_view part) const {
    const auto at = static_cast<Offset>(source()->bytes().find(part));
    return {at, at + static_cast<Offset>(part.size())};
}

Finding& HandMade::add(std::string_view part, Severity severity) {
    Finding finding{.rule = find_rule("MAC002"),
                    .cause = {*file_, place_of(part)},
                    .severity = severity,
                    .source = source(),
                    .span = place_of(part),
                    .message_id = "unknown",
                    .arguments = {source()->to_utf8(part)},
                    .related = {},
                    .path = {},
                    .fix = {}};
    return report_.findings.emplace_back(cli::FilteredFinding{std::move(finding), std::nullopt}).finding;
}

} // namespace maclint::test
