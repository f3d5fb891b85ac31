//! Look-ups of names.
#include "analyzer/program/names.hpp"

namespace maclint {

std::int32_t Names::number_of(std::string_view name) {
    if (const auto known = find(name)) return *known;
    const auto number = static_cast<std::int32_t>(names_.size());
    names_.emplace_back(name);
    numbers_.emplace(name, number);
    return number;
}

std::optional<std::int32_t> Names::find(std::string_view name) const {
    const auto known = numbers_.find(name);
    return known == numbers_.end() ? std::nullopt : std::optional(known->second);
}

std::string_view Names::operator[](std::int32_t number) const {
    const auto index = static_cast<std::size_t>(number);
    return index < names_.size() ? std::string_view(names_[index]) : std::string_view();
}

} // namespace maclint
