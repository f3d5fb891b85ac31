//! Hand-made findings for the tests of reports.
#pragma once

#include "cli/report/report.hpp"

#include <memory>
#include <string>
#include <string_view>

namespace maclint {
struct ProgramFile;
}

namespace maclint::test {

/// A file and findings in it, made without reading or checking anything.
class HandMade {
  public:
    HandMade(std::string path, std::string text);

    [[nodiscard]] const std::shared_ptr<const Source>& source() const { return source_; }
    /// The first place of `part` in the text.
    [[nodiscard]] Span place_of(std::string_view part) const;
    /// Puts a finding at the first place of `part` into the report: MAC002, "Unknown rule: there is no
    /// 'part'. …".
    Finding& add(std::string_view part, Severity severity);
    [[nodiscard]] cli::Report& report() { return report_; }

  private:
    std::shared_ptr<const Source> source_;
    std::shared_ptr<const ProgramFile> file_;
    cli::Report report_;
};

} // namespace maclint::test
