//! Numbers of programs and blocks of the Fanuc family.
#include "analyzer/dialect/number_limits.hpp"

#include <algorithm>
#include <iterator>

namespace maclint {
namespace {

struct Row {
    std::string_view model;
    NumberLimits limits;
};

// Program numbers of five to eight digits are an option.
// clang-format off
constexpr Row rows[] = {
    // model         O0     last O    last N    source
    {"fanuc",      {false, 99999999, 99999999, "MAN-PB129; GH-ALM 074, 1128: the longest of all series"}},
    {"fanuc-16i",  {false, 99999999,    99999, "MAN-PB129"}},
    {"fanuc-0i-c", {false, 99999999,    99999, "MAN-PB129: as 16i"}},
    {"fanuc-0i-d", {false, 99999999, 99999999, "GH-ALM 074, 1128"}},
    {"fanuc-30i",  {false, 99999999, 99999999, "GH-ALM 074, 1128"}},
    {"nct",        {true,  99999999,    99999, "NCT-9"}},
};
// clang-format on

} // namespace

const NumberLimits* number_limits(const ControlModel& control) {
    const auto* row = std::ranges::find(rows, control.model, &Row::model);
    return row == std::end(rows) ? nullptr : &row->limits;
}

} // namespace maclint
