//! Names and what they stand for, found without looking through all of them.
#pragma once

#include "analyzer/program/variable.hpp"
#include "analyzer/source/text_hash.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace maclint {

/// The names of variables, each with a number of its own: the first one is 0.
class Names {
  public:
    /// The number of a name, which gets one when it is new.
    std::int32_t number_of(std::string_view name);
    [[nodiscard]] std::optional<std::int32_t> find(std::string_view name) const;
    /// Empty for a number that no name has.
    [[nodiscard]] std::string_view operator[](std::int32_t number) const;

  private:
    std::vector<std::string> names_;
    std::unordered_map<std::string, std::int32_t, TextHash, std::equal_to<>> numbers_;
};

/// The names of variables that all programs share. A number is made of the name's letters, so that it is the
/// same in every program and in every run; two names may meet in one number.
class SharedNames {
  public:
    /// A name with its number.
    using Numbered = std::pair<std::int32_t, std::string>;

    std::int32_t number_of(std::string_view name);
    /// A name of that number; empty when none has it.
    [[nodiscard]] std::string_view operator[](std::int32_t number) const;
    /// In no order.
    [[nodiscard]] std::vector<Numbered> all() const;

  private:
    std::unordered_map<std::int32_t, std::string> names_;
    std::vector<Numbered> others_; ///< names whose number another name had before
};

/// Variables by their names.
using VariablesByName = std::unordered_map<std::string, Variable, TextHash, std::equal_to<>>;

struct VariableHash {
    std::size_t operator()(Variable variable) const {
        constexpr unsigned bits_of_number = 32;
        return std::size_t{variable.space} << bits_of_number | static_cast<std::uint32_t>(variable.number);
    }
};

} // namespace maclint
