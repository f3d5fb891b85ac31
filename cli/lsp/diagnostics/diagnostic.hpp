//! A finding as the protocol has it.
#pragma once

#include "cli/lsp/documents/line_table.hpp"
#include "cli/lsp/protocol/json.hpp"
#include "rules/finding.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace maclint::cli::lsp {

/// Makes diagnostics of one run; files that many findings lead to have their lines counted once.
class DiagnosticWriter {
  public:
    /// `uri_of` names files by their paths.
    DiagnosticWriter(PositionEncoding encoding, std::function<std::string(const std::string& path)> uri_of)
        : encoding_(encoding)
        , uri_of_(std::move(uri_of)) {}

    /// Range, severity, code, message, further places and the steps that lead there.
    [[nodiscard]] Json write(const Finding& finding);
    [[nodiscard]] const LineTable& lines_of(const std::shared_ptr<const Source>& source);

  private:
    [[nodiscard]] Json location(const std::shared_ptr<const Source>& source, Span span);
    [[nodiscard]] Json related(const Finding& finding);

    PositionEncoding encoding_;
    std::function<std::string(const std::string& path)> uri_of_;
    std::map<const Source*, std::pair<std::shared_ptr<const Source>, std::unique_ptr<LineTable>>> lines_;
};

} // namespace maclint::cli::lsp
