//! Looks words and codes up in the scanner's tables.
#include "rules/words/scanned.hpp"

#include "rules/words/word_list.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace maclint {

syntax::AddressSet scanned_surely(const syntax::PlainTables& tables, std::string_view list) {
    syntax::AddressSet set;
    for (std::size_t id = 0; id < tables.names.size(); ++id)
        if (!tables.names[id].empty() && has_word(list, tables.names[id]))
            set.add(static_cast<syntax::AddressId>(id));
    return set;
}

syntax::AddressSet scanned_maybe(const syntax::PlainTables& tables, std::string_view list) {
    syntax::AddressSet set = scanned_surely(tables, list);
    const auto words = words_of(list);
    if (set.size() == static_cast<int>(words.size())) return set;
    for (std::size_t id = 0; id < tables.names.size(); ++id)
        if (tables.names[id].empty()) set.add(static_cast<syntax::AddressId>(id));
    return set;
}

syntax::CodeSet::Kind scanned_kind(const syntax::PlainTables* tables, const RowForCode& row) {
    const std::size_t which = row.letter == 'G' ? 0 : 1;
    if (tables == nullptr) return syntax::CodeSet::kind_of(which, static_cast<std::uint64_t>(row.code));
    const syntax::PlainCodes& codes = tables->codes[which];
    const double steps = std::pow(10.0, codes.decimals);
    const auto place = static_cast<std::size_t>(std::llround(row.code * steps));
    return place < codes.rows.size() ? codes.rows[place].kind
                                     : syntax::CodeSet::kind_of(which, static_cast<std::uint64_t>(row.code));
}

} // namespace maclint
