//! Comments that speak to maclint: they change which findings are allowed, and no finding.
#include "analyzer/program/model.hpp"
#include "fuzz/harness.hpp"
#include "tests/support/linted.hpp"

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

using namespace maclint;

namespace {

using Found = std::multiset<std::tuple<std::string_view, Offset, Offset>>;

/// All but those on the comments themselves; of a cause that stands in several places each place, as a
/// comment that allows the first leaves the others told.
Found found_in(const std::string& text, const Dialect* dialect) {
    cli::Overrides overrides;
    overrides.dialect = dialect;
    Found found;
    for (const cli::FilteredFinding& filtered : test::lint_texts({{"O1.nc", text}}, overrides).findings) {
        const Finding& finding = filtered.finding;
        if (finding.rule->code == "MAC001" || finding.rule->code == "MAC002") continue;
        found.emplace(finding.rule->code, finding.span.begin, finding.span.end);
        for (const RelatedLocation& repeat : finding.repeats)
            found.emplace(finding.rule->code, repeat.span.begin, repeat.span.end);
    }
    return found;
}

/// The same text, whose comments speak to nobody.
std::string without_directives(std::string text, const Dialect& dialect) {
    constexpr std::string_view word = "MACLINT";
    const auto source = std::make_shared<const Source>(Source::from_bytes("O1.nc", text));
    const ProgramFile file = dialect.read(source, *find_control(dialect.default_control), Extent::whole);
    const auto same = [](char a, char b) { return (a >= 'a' && a <= 'z' ? a - 'a' + 'A' : a) == b; };
    for (const DirectiveComment& comment : file.comments) {
        const std::string_view inside = source->bytes(comment.span);
        const auto found = std::ranges::search(inside, word, same);
        if (!found.empty())
            text[comment.span.begin + static_cast<std::size_t>(found.begin() - inside.begin())] = '-';
    }
    return text;
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(fuzz::text_of(data, size));
    const Dialect& dialect = *find_dialect(fuzz::choice(text, 2) == 0 ? "fanuc" : "dinplus");
    const Found with = found_in(text, &dialect);
    const Found without = found_in(without_directives(text, dialect), &dialect);
    for (const auto& finding : with)
        if (!without.contains(finding))
            fuzz::fail("a comment makes a finding: " + std::string(std::get<0>(finding)));
    for (const auto& finding : without)
        if (!with.contains(finding))
            fuzz::fail("a comment hides a finding: " + std::string(std::get<0>(finding)));
    return 0;
}
