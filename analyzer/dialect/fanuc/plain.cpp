//! The tables of the plain scanner: addresses are single letters of any case, comments stand in parentheses.
#include "analyzer/dialect/fanuc/plain.hpp"

#include "analyzer/dialect/ascii.hpp"

#include <cstddef>
#include <limits>

namespace maclint::fanuc {
namespace {

using syntax::PlainStart;
using syntax::PlainTables;

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";

/// A speed beside a code that makes it a limit.
constexpr std::uint8_t speed_as_limit = syntax::plain_traits::first_own;

std::uint8_t plain_traits_of(std::uint16_t traits) {
    namespace scanned = syntax::plain_traits;
    unsigned plain = 0;
    if ((traits & (own_effect | synchronises)) != 0) plain |= scanned::not_plain;
    if ((traits & (no_axes | no_words)) != 0) plain |= scanned::no_axes;
    if ((traits & limits_speed) != 0) plain |= speed_as_limit;
    return static_cast<std::uint8_t>(plain);
}

/// Both cases of the addresses.
void set(PlainTables& tables, std::string_view addresses, PlainTables::Row row) {
    for (const char c : addresses) {
        row.id = static_cast<syntax::AddressId>(c - 'A');
        tables.bytes[static_cast<unsigned char>(c)] = row;
        tables.bytes[static_cast<unsigned char>(c - 'A' + 'a')] = row;
    }
}

void set_bytes(PlainTables& tables, std::string_view bytes, PlainStart start) {
    for (const char c : bytes) tables.bytes[static_cast<unsigned char>(c)].start = start;
}

} // namespace

PlainTables plain_tables(const CodeTable& codes) {
    PlainTables tables{};
    set_bytes(tables, " \t", PlainStart::blank);
    set_bytes(tables, "\r\n;", PlainStart::end);
    set_bytes(tables, "(", PlainStart::comment);
    // Numbers of other forms are looked at one by one.
    constexpr std::uint8_t most_digits = 8;
    constexpr syntax::PlainForm any{.most_digits = most_digits};
    constexpr syntax::PlainForm whole{
        .unsigned_only = true, .without_point = true, .most_digits = most_digits};
    set(tables, "ABCIJKUVWXYZ", {.start = PlainStart::axis, .form = any});
    set(tables, "EPQR", {.start = PlainStart::number, .form = any});
    set(tables, "DHLT", {.start = PlainStart::number, .form = whole});
    set(tables, "G", {.start = PlainStart::code, .which = 0});
    set(tables, "M", {.start = PlainStart::code, .which = 1, .form = whole});
    set(tables, "F",
        {.start = PlainStart::value,
         .which = codes.feed,
         .form = {.unsigned_only = true, .most_digits = most_digits}});
    set(tables, "S",
        {.start = PlainStart::value, .which = codes.speed, .traits = speed_as_limit, .form = whole});
    set(tables, "N", {.start = PlainStart::block_number});
    if (codes.tool_changes_at_once || codes.tool_calls_program) set(tables, "T", {});
    for (std::size_t i = 0; i < letters.size(); ++i) tables.names[i] = letters.substr(i, 1);
    for (const char c : std::string_view("GM"))
        tables.may_repeat.add(static_cast<syntax::AddressId>(c - 'A'));

    tables.codes[0] = {.rows = {}, .decimals = 1};
    for (std::size_t i = 0; i < codes.g.size(); ++i) // of tenths
        tables.codes[0].rows.push_back(
            {codes.g[i].group, plain_traits_of(codes.g[i].traits), syntax::CodeSet::kind_of(0, i / 10)});
    tables.codes[1] = {.rows = {}, .decimals = 0};
    for (std::size_t i = 0; i < codes.m.size(); ++i) {
        const GroupId group = i < codes.m_groups.size() ? codes.m_groups[i] : no_group;
        tables.codes[1].rows.push_back({group, plain_traits_of(codes.m[i]), syntax::CodeSet::kind_of(1, i)});
    }

    tables.comment_end = ')';
    tables.blanks_after_address = true;
    tables.longest = std::numeric_limits<std::uint32_t>::max();
    tables.is_directive = addresses_maclint;
    return tables;
}

} // namespace maclint::fanuc
