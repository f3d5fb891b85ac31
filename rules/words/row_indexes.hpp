//! The rows that run, ready for each control and kind of section that turns up.
#pragma once

#include "rules/words/row_index.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace maclint {

/// Threads may share one.
class RowIndexes {
  public:
    explicit RowIndexes(std::vector<const RuleRow*> rows)
        : rows_(std::move(rows)) {}
    /// All rows of the rules.
    [[nodiscard]] static std::shared_ptr<const RowIndexes> of_all(std::span<const Rule* const> rules);

    /// Made when it is first asked for; good as long as this object is.
    [[nodiscard]] const RowIndex& of(const Program& program, const Section& section) const;

  private:
    using Key = std::tuple<const ControlModel*, const syntax::PlainTables*, std::string_view>;

    std::vector<const RuleRow*> rows_;
    mutable std::mutex mutex_;
    mutable std::map<Key, std::unique_ptr<const RowIndex>> made_;
};

} // namespace maclint
