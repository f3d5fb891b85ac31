//! Look-ups of names.
#include "analyzer/program/names.hpp"

#include <algorithm>

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

std::int32_t SharedNames::number_of(std::string_view name) {
    // FNV-1a; the hash of the standard library may be another one in every run.
    std::uint64_t hash = 0xCBF29CE484222325;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3;
    constexpr unsigned bits_of_number = 31;
    const auto number = static_cast<std::int32_t>((hash ^ hash >> bits_of_number) & 0x7FFFFFFF);
    const auto known = names_.try_emplace(number, name).first;
    if (known->second != name) {
        const Numbered other(number, name);
        if (std::ranges::find(others_, other) == others_.end()) others_.push_back(other);
    }
    return number;
}

std::string_view SharedNames::operator[](std::int32_t number) const {
    const auto found = names_.find(number);
    return found == names_.end() ? std::string_view() : std::string_view(found->second);
}

std::vector<SharedNames::Numbered> SharedNames::all() const {
    std::vector<Numbered> all(names_.begin(), names_.end());
    all.insert(all.end(), others_.begin(), others_.end());
    return all;
}

} // namespace maclint
