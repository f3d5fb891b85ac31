//! Fingerprints by which a finding is known again when its line has moved.
#pragma once

#include "analyzer/source/source.hpp"
#include "cli/report/numberless.hpp"
#include "rules/finding.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>

namespace maclint::cli {

/// Hashes of lines as GitHub's upload action computes them (github/codeql-action, src/fingerprints.ts): over
/// the 100 UTF-16 code units from the line's beginning on, blanks and tabs left out, line ends counted as LF;
/// lines with the same hash are numbered. Lines end at LF, CR and CRLF there.
[[nodiscard]] std::map<std::uint32_t, std::string> line_hashes(const Source& source,
                                                               const std::set<std::uint32_t>& wanted);

/// maclint's own fingerprints, version 2: rule and row, message, the text of the line and of the part of it
/// that the finding points at, both without what spacing and renumbering change.
class Fingerprints {
  public:
    /// Of the finding, with a number behind ':' when the file holds several. Ask in the order of reports.
    [[nodiscard]] std::string of(const Finding& finding);
    /// Of one of the finding's places in its file: findings of one cause have several.
    [[nodiscard]] std::string of_place(const Finding& finding, Span place);
    /// The text that the place's fingerprint is made from, for people.
    [[nodiscard]] std::string line_of(const Finding& finding, Span place);

  private:
    Numberless numberless_;
    std::unordered_map<std::string, std::size_t> seen_;
};

/// Hexadecimal digits that stand for a text.
[[nodiscard]] std::string hash_of(std::string_view text);

} // namespace maclint::cli
