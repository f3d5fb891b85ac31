//! How Fanuc and its relatives write the numbers of addresses.
#include "rules/words/address_book.hpp"

namespace maclint::address_books {
namespace {

constexpr TableText of_16i = "FANUC 16i/18i/21i", of_30i = "FANUC 30i/0i-D";
constexpr RowAlarm point[] = {{of_16i, "007"}, {of_30i, "007"}};
constexpr RowAlarm minus[] = {{of_16i, "006"}, {of_30i, "006"}};
constexpr RowAlarm digits[] = {{of_16i, "003"}, {of_30i, "003"}};

constexpr TableText named = "fanuc-16i fanuc-0i-c fanuc-0i-d fanuc-30i";
constexpr TableText any_fanuc = "fanuc fanuc-16i fanuc-0i-c fanuc-0i-d fanuc-30i";
constexpr TableText of_haas = "haas haas-1999";
using enum Severity;

// P has no point either, but is left to the codes: a dwell in seconds, an angle, a lead have one on some
// controls. More decimals than the control keeps are cut off, so digits count before the point. A Haas takes
// `S5000.`.
// clang-format off
constexpr AddressLine lines[] = {
    {.addresses = "M",   .means = "machine function", .whole = true, .positive = true, .most_digits = 8, .controls = named,    .severity = error, .source = "CSDN-PS"},
    {.addresses = "S",   .means = "spindle speed",    .whole = true, .positive = true, .most_digits = 8, .controls = named,    .severity = warning, .source = "SINHA-EXP"},
    {.addresses = "T",   .means = "tool",             .whole = true, .positive = true, .most_digits = 8, .controls = named,    .severity = error, .source = "CSDN-PS"},
    {.addresses = "L",   .means = "number of repeats",.whole = true, .positive = true, .most_digits = 8, .controls = named,    .severity = error, .source = "CSDN-PS"},
    {.addresses = "F",   .means = "feed",             .positive = true,                .most_digits = 8, .controls = named,    .severity = error, .source = "CSDN-PS"},
    {.addresses = "X Y Z U V W A B C I J K R Q", .means = "coordinate", .most_digits = 8, .controls = named,    .severity = error, .source = "CSDN-PS"},
    {.addresses = ",A", .means = "angle of a line", .controls = named, .severity = warning, .source = "T"},
    {.addresses = "G",   .means = "code", .most_digits = 4, .controls = any_fanuc, .severity = warning, .source = "T"},
    {.addresses = "P",   .means = "number",           .most_digits = 8, .controls = named, .severity = error, .source = "CSDN-PS"},
    {.addresses = "F",   .means = "feed",             .positive = true,                                 .controls = of_haas,  .severity = warning, .source = "T"},
    {.addresses = "M",   .means = "machine function", .positive = true,                                 .controls = of_haas,  .severity = warning, .source = "T"},
    {.addresses = "S",   .means = "spindle speed",    .positive = true,                                 .controls = of_haas,  .severity = warning, .source = "T"},
    {.addresses = "T",   .means = "tool",             .positive = true,                                 .controls = of_haas,  .severity = warning, .source = "T"},
    {.addresses = "L",   .means = "number of repeats",.positive = true,                                 .controls = of_haas,  .severity = warning, .source = "T"},
};

// On a lathe H is a step of C, D a depth of cut; a text of which nobody knows the control may be of one.
constexpr AddressLine of_mills[] = {
    {.addresses = "H D", .means = "offset number",    .whole = true, .positive = true, .most_digits = 8, .controls = named,    .severity = error, .source = "CSDN-PS"},
};
// clang-format on

} // namespace

extern const AddressBook fanuc{.language = "fanuc",
                               .assumed = "fanuc",
                               .point = point,
                               .minus = minus,
                               .digits = digits,
                               .lines = lines};

extern const AddressBook fanuc_mill{.language = "fanuc",
                                    .machine = Machine::mill,
                                    .assumed = "",
                                    .point = point,
                                    .minus = minus,
                                    .digits = digits,
                                    .lines = of_mills};

} // namespace maclint::address_books
