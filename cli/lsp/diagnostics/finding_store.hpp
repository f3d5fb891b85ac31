//! What was last found in the documents.
#pragma once

#include "rules/finding.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli::lsp {

/// Findings that count, of one version of a document.
struct DocumentFindings {
    std::int64_t version;
    std::string dialect; ///< that the text was read in
    std::vector<Finding> findings;
};

/// May be asked on several threads.
class FindingStore {
  public:
    void set(const std::string& path, DocumentFindings findings);
    void remove(std::string_view path);
    /// Those of that version; nullptr: they are not known.
    [[nodiscard]] std::shared_ptr<const DocumentFindings> find(std::string_view path,
                                                               std::int64_t version) const;

  private:
    mutable std::mutex mutex_;
    std::map<std::string, std::shared_ptr<const DocumentFindings>, std::less<>> by_path_;
};

} // namespace maclint::cli::lsp
