//! The tables of the plain scanner: addresses are one or two capitals, comments stand in square brackets.
#include "analyzer/dialect/dinplus/plain.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/dinplus/tables.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <string_view>

namespace maclint::dinplus {
namespace {

using syntax::AddressId;
using syntax::PlainCode;
using syntax::PlainStart;
using syntax::PlainTables;

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";

/// The control's longest block is far shorter; the reader parses none that is longer.
constexpr std::uint32_t longest = 4096;

/// Two letters that are no address: operators, IF, and those that the letter O for a 0 makes of G, M and T.
constexpr std::string_view no_addresses[] = {"EQ", "GE", "GT", "IF", "LT", "OR", "GO", "MO", "TO"};
/// Pairs that are told apart while scanning; all others count as one.
constexpr std::string_view common_pairs[] = {"XK", "YK", "ZK", "NS", "NE", "NF", "XS", "ZS", "XE",
                                             "ZE", "XA", "ZA", "AC", "WC", "RC", "IC", "KC", "JC",
                                             "AT", "BS", "BE", "WS", "BR", "BP", "BF", "EC", "EW",
                                             "XR", "ZR", "FK", "DX", "DZ", "HC", "HF", "PC", "WE"};
/// Codes have up to three digits.
constexpr std::size_t codes = 1000;
/// The moves of a contour have a kind each, so that nobody reads them again who asks for another code.
constexpr std::size_t moves_of_contours[] = {0, 1, 2, 3, 12, 13, 100, 101, 102, 103, 110, 111, 112, 113};
constexpr AddressId first_pair = 26;
constexpr AddressId other_pair = 63;
static_assert(first_pair + std::size(common_pairs) <= other_pair);

/// NS and NE beside a code that takes them for blocks of a contour.
constexpr std::uint8_t block_name = syntax::plain_traits::first_own;

syntax::CodeSet::Kind kind_of_code(std::size_t which, std::size_t code) {
    constexpr std::size_t of_g = 96;
    const auto* const move = std::ranges::find(moves_of_contours, code);
    if (which != 0) return syntax::CodeSet::kind_of(which, code);
    if (move != std::end(moves_of_contours))
        return static_cast<syntax::CodeSet::Kind>(move - std::begin(moves_of_contours));
    return static_cast<syntax::CodeSet::Kind>(std::size(moves_of_contours) +
                                              code % (of_g - std::size(moves_of_contours)));
}

PlainTables::Row& row_of(PlainTables& tables, std::string_view address) {
    if (address.size() == 1) return tables.bytes[static_cast<unsigned char>(address.front())];
    return tables.pairs[PlainTables::pair(address[0], address[1])];
}

void set_bytes(PlainTables& tables, std::string_view bytes, PlainStart start) {
    for (const char c : bytes) tables.bytes[static_cast<unsigned char>(c)].start = start;
}

/// The bit of the codes that contradict this one; 0: none does.
std::uint32_t exclusive_bit(char letter, std::size_t code) {
    const std::vector<ExclusiveCodes>& rows = control().exclusive_codes;
    assert(rows.size() <= 32 && "a bit for each row");
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].letter == letter &&
            std::ranges::find(rows[i].codes, static_cast<double>(code)) != rows[i].codes.end())
            return std::uint32_t{1} << i;
    return 0;
}

/// Every address begins a word whose number means nothing.
PlainTables descriptions() {
    PlainTables tables{};
    set_bytes(tables, " \t", PlainStart::blank);
    set_bytes(tables, "\r\n", PlainStart::end);
    set_bytes(tables, "[", PlainStart::comment);
    set_bytes(tables, "Nn", PlainStart::block_number);
    for (std::size_t i = 0; i < letters.size(); ++i) {
        tables.names[i] = letters.substr(i, 1);
        if (letters[i] == 'N') continue;
        row_of(tables, letters.substr(i, 1)) = {.start = PlainStart::number, .id = static_cast<AddressId>(i)};
    }
    tables.pairs.assign(PlainTables::letters * PlainTables::letters,
                        {.start = PlainStart::number, .id = other_pair});
    for (std::size_t i = 0; i < std::size(common_pairs); ++i) {
        const auto id = static_cast<AddressId>(first_pair + i);
        tables.names[id] = common_pairs[i];
        row_of(tables, common_pairs[i]).id = id;
    }
    for (const std::string_view pair : no_addresses) row_of(tables, pair) = {};
    for (const char c : std::string_view("GMT")) tables.may_repeat.add(static_cast<AddressId>(c - 'A'));
    // Codes of descriptions set nothing, but rules ask where they stand.
    for (const std::uint8_t which : {std::uint8_t{0}, std::uint8_t{1}}) {
        const char letter = which == 0 ? 'G' : 'M';
        auto& row = row_of(tables, std::string_view(&letter, 1));
        row.start = PlainStart::code;
        row.which = which;
        for (std::size_t code = 0; code < codes; ++code)
            tables.codes[which].rows.push_back(
                {.kind = kind_of_code(which, code), .exclusive = exclusive_bit(letter, code)});
    }
    tables.comment_end = ']';
    tables.incremental = 'i';
    tables.not_after_number = 'O';
    tables.longest = longest;
    tables.is_directive = addresses_maclint;
    return tables;
}

/// What a code does beyond setting a group; those that need an effect of their own are not plain.
PlainCode plain_code(char letter, std::size_t code) {
    namespace scanned = syntax::plain_traits;
    const auto number = static_cast<double>(code);
    const CodeFact* fact = find_code(letter, number);
    const unsigned traits = fact == nullptr ? 0 : fact->traits;
    constexpr unsigned own =
        off_by_word | feed_word | speed_word | approaches | synchronises | pauses | ends | restarts;
    unsigned plain = letter == 'G' ? scanned::no_axes : 0U; // any G code ends what axis words go on with
    if ((traits & own) != 0) plain |= scanned::not_plain;
    if ((traits & moves) != 0) plain |= scanned::moves;
    if ((traits & block_words) != 0) plain |= block_name;
    const bool sets = fact == nullptr || (traits & sets_group) != 0;
    const auto group = sets ? control().group_of(letter, number) : std::nullopt;
    // Rules ask for the state in front of the words that set the other groups, and mark these words.
    if (group && control().groups[*group].role != ModalRole::motion) plain |= scanned::not_plain;
    return {group.value_or(syntax::no_group), static_cast<std::uint8_t>(plain),
            kind_of_code(letter == 'G' ? 0 : 1, code), exclusive_bit(letter, code)};
}

PlainTables commands() {
    PlainTables tables = descriptions();
    for (syntax::PlainCodes& of_letter : tables.codes) of_letter.rows.clear();
    for (const std::string_view axis : {"X", "Z", "Y", "C", "B", "XK", "YK", "U", "V", "W"})
        row_of(tables, axis).start = PlainStart::axis;
    row_of(tables, "NS").traits = block_name;
    row_of(tables, "NE").traits = block_name;
    row_of(tables, "T") = {}; // changes the tool
    for (const std::uint8_t which : {std::uint8_t{0}, std::uint8_t{1}}) {
        const std::string_view letter = which == 0 ? "G" : "M";
        for (std::size_t code = 0; code < codes; ++code)
            tables.codes[which].rows.push_back(plain_code(letter.front(), code));
    }
    return tables;
}

} // namespace

const syntax::PlainTables& plain_tables(std::uint8_t section) {
    static const PlainTables of_commands = commands();
    static const PlainTables of_descriptions = descriptions();
    assert(section <= plain_sections::descriptions);
    return section == plain_sections::commands ? of_commands : of_descriptions;
}

} // namespace maclint::dinplus
