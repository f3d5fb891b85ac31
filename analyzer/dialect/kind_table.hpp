//! Maps a grammar's symbol and field numbers, which change whenever it is generated, to fixed enumerations.
#pragma once

#include "analyzer/syntax/tree.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint {

/// The kind of every symbol of the grammar; what `names` does not hold is `otherwise`.
template<class Kind>
std::vector<Kind> kinds_by_symbol(syntax::Grammar grammar,
                                  std::span<const std::pair<std::string_view, Kind>> names, Kind otherwise) {
    const std::uint16_t count = syntax::symbol_count(grammar);
    std::vector<Kind> table(count, otherwise);
    for (std::uint16_t symbol = 0; symbol < count; ++symbol) {
        if (!syntax::symbol_is_named(grammar, symbol)) continue;
        const std::string_view name = syntax::symbol_name(grammar, symbol);
        const auto row = std::ranges::find(names, name, &std::pair<std::string_view, Kind>::first);
        if (row != names.end()) table[symbol] = row->second;
    }
    return table;
}

/// The enumerator of every field number.
template<class Field>
std::array<Field, 256> fields_by_number(syntax::Grammar grammar,
                                        std::span<const std::pair<std::string_view, Field>> names) {
    std::array<Field, 256> table{};
    for (const auto& [name, field] : names) {
        const std::uint16_t number = syntax::field_number(grammar, name);
        if (number != 0 && number < table.size()) table[number] = field;
    }
    return table;
}

} // namespace maclint
