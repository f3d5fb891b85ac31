//! Fingerprints by which a finding is known again when its line has moved.
#pragma once

#include "analyzer/source/source.hpp"
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

/// maclint's own fingerprint, version 1: rule, message and the text of the line without blanks and in
/// capitals, numbered when the file holds several. Ask for findings in the order of reports.
class Fingerprints {
  public:
    [[nodiscard]] std::string of(const Finding& finding);

  private:
    std::unordered_map<std::string, std::size_t> seen_;
};

/// Hexadecimal digits that stand for a text.
[[nodiscard]] std::string hash_of(std::string_view text);

} // namespace maclint::cli
