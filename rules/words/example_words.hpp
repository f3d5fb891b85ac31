//! The words of an example's block, and values for them.
#pragma once

#include "rules/words/word_row.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint {

/// Addresses and values as they are written, in the order of the block.
class ExampleWords {
  public:
    void add(std::string_view address, std::string value) { all_.emplace_back(address, std::move(value)); }
    /// In place of the value that the address has, if it stands there.
    void set(std::string_view address, std::string value);
    /// Whether one of the addresses stands there.
    [[nodiscard]] bool stands(std::string_view addresses) const;
    /// Conditions of rows: WordRow::when.
    [[nodiscard]] bool holds(std::string_view conditions) const;
    [[nodiscard]] auto begin() const { return all_.begin(); }
    [[nodiscard]] auto end() const { return all_.end(); }

  private:
    std::vector<std::pair<std::string, std::string>> all_;
};

[[nodiscard]] bool takes_written(const WordRow& row, const std::string& value);
/// A value that the row takes, and one that it does not.
[[nodiscard]] std::string allowed_value(const WordRow& row);
[[nodiscard]] std::string refused_value(const WordRow& row);

} // namespace maclint
