//! Baselines that need not be read again while their files stay as they are.
#pragma once

#include "analyzer/source/platform/files.hpp"
#include "cli/gate/baseline_file.hpp"
#include "cli/notice.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <variant>

namespace maclint::cli {

class BaselineStore {
  public:
    /// As read_baseline, from memory where the system says that the file has not changed.
    [[nodiscard]] std::variant<std::shared_ptr<const Baseline>, Notice> read(const std::string& path,
                                                                             NamedBy named_by);
    /// How many files were read.
    [[nodiscard]] std::size_t reads() const { return reads_; }

  private:
    struct Kept {
        platform::FileStamp stamp;
        std::shared_ptr<const Baseline> baseline;
    };
    std::map<std::string, Kept> by_path_;
    std::size_t reads_ = 0;
};

} // namespace maclint::cli
