//! The tables of the plain scanner: addresses are single letters of any case. A block with a remark is not
//! plain: remarks end with their line, and nothing closes them.
#include "analyzer/dialect/sinumerik/plain.hpp"

#include "analyzer/dialect/sinumerik/tables.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace maclint::sinumerik {
namespace {

using syntax::PlainCode;
using syntax::PlainStart;
using syntax::PlainTables;

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
constexpr std::size_t codes = 1000; ///< they have up to three digits

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

/// A code of no group may be a call of the machine's maker.
PlainCode plain_g_code(std::size_t code) {
    PlainCode row;
    row.kind = syntax::CodeSet::kind_of(0, code);
    const auto setting = setting_of("G" + std::to_string(code));
    if (!setting || setting->moves || setting->takes_axes || switches_language(code)) {
        row.traits = syntax::plain_traits::not_plain;
    } else if (setting->sets) {
        row.group = setting->sets->group;
        row.member = static_cast<std::uint8_t>(setting->sets->code);
    }
    return row;
}

PlainCode plain_function(std::size_t number) {
    PlainCode row;
    row.kind = syntax::CodeSet::kind_of(1, number);
    const auto& exclusive = control().exclusive_codes.front().codes; // those of the spindle
    if (std::ranges::find(exclusive, static_cast<double>(number)) != exclusive.end()) row.exclusive = 1;
    if (acts_on_flow(static_cast<double>(number))) row.traits = syntax::plain_traits::not_plain;
    return row;
}

PlainTables make() {
    PlainTables tables{};
    set_bytes(tables, " \t", PlainStart::blank);
    set_bytes(tables, "\r\n", PlainStart::end);
    constexpr std::uint8_t most_digits = 8;
    constexpr syntax::PlainForm any{.most_digits = most_digits};
    set(tables, "ABCIJKUVWXYZ",
        {.start = PlainStart::axis, .form = any}); // a whole circle has its centre alone
    set(tables, "DHT", {.start = PlainStart::number, .form = any});
    const ControlModel& model = control();
    set(tables, "F", {.start = PlainStart::value, .which = *model.group_with(ModalRole::feed), .form = any});
    set(tables, "S", {.start = PlainStart::value, .which = *model.group_with(ModalRole::speed), .form = any});
    set(tables, "G", {.start = PlainStart::code, .which = 0});
    set(tables, "M", {.start = PlainStart::code, .which = 1, .form = {.without_point = true}});
    set(tables, "N", {.start = PlainStart::block_number});
    for (std::size_t i = 0; i < letters.size(); ++i) tables.names[i] = letters.substr(i, 1);
    // Of other addresses the reader hears where they stand twice: of M, too, which it counts.
    tables.may_repeat.add(static_cast<syntax::AddressId>('G' - 'A'));
    for (std::size_t code = 0; code < codes; ++code) {
        tables.codes[0].rows.push_back(plain_g_code(code));
        tables.codes[1].rows.push_back(plain_function(code));
    }
    tables.blanks_after_address = true;
    tables.longest = std::numeric_limits<std::uint32_t>::max();
    return tables;
}

} // namespace

const PlainTables& plain_tables() {
    static const PlainTables tables = make();
    return tables;
}

} // namespace maclint::sinumerik
