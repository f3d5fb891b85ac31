//! Warnings and notes are for whoever can change the program.
#include "cli/gate/vendor_code.hpp"

#include "cli/text/shown.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

namespace maclint::cli {
namespace {

/// What is said of the file as a whole, as that it is for another control.
bool is_of_whole_file(const Finding& finding) {
    constexpr std::array<std::string_view, 2> codes{"MAC003", "MAC005"};
    return std::ranges::find(codes, finding.rule->code) != codes.end();
}

const VendorProgram* program_of(const Finding& finding, const std::vector<VendorProgram>& programs) {
    const auto found = std::ranges::find_if(programs, [&](const VendorProgram& program) {
        return program.source == finding.source.get() && program.text.contains(finding.span.begin);
    });
    return found == programs.end() ? nullptr : &*found;
}

} // namespace

std::optional<Notice> withhold_vendor_code(Result& result) {
    std::set<const VendorProgram*> programs;
    std::size_t warnings = 0;
    std::size_t notes = 0;
    for (FilteredFinding& filtered : result.findings) {
        const Finding& finding = filtered.finding;
        if (filtered.suppressed || finding.severity == Severity::error || is_of_whole_file(finding)) continue;
        const VendorProgram* program = program_of(finding, result.vendor);
        if (program == nullptr) continue;
        programs.insert(program);
        ++(finding.severity == Severity::warning ? warnings : notes);
        filtered.suppressed = Suppression{.vendor = true};
    }
    if (programs.empty()) return std::nullopt;
    std::string counts = warnings == 0 ? "" : counted(warnings, "warning");
    if (notes != 0) counts += (counts.empty() ? "" : " and ") + counted(notes, "note");
    return Notice{NoticeKind::vendor, "",
                  counts + " in " + counted(programs.size(), "program") +
                      " of a maker (vendor code) not shown: --vendor shows " +
                      (warnings + notes == 1 ? "it." : "them.")};
}

} // namespace maclint::cli
