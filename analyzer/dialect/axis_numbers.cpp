//! The rows of FANUC and its kin.
#include "analyzer/dialect/axis_numbers.hpp"

#include <algorithm>

namespace maclint {
namespace {

constexpr AxisNumbers of_fanuc[] = {
    // first, last, of a set, code of the first set, source
    {5001, 5020, 20, {}, "SEED-001:1373"}, {5021, 5040, 20, {}, "SEED-001:1374"},
    {5041, 5060, 20, {}, "SEED-001:1375"}, {5061, 5080, 20, {}, "SEED-001:1376"},
    {5081, 5100, 20, {}, "SEED-001:1377"}, {5101, 5120, 20, {}, "SEED-001:1378"},
    {5201, 5220, 20, {}, "SEED-001:1383"}, {5221, 5340, 20, 54, "SEED-001:1384-1389"},
};

} // namespace

const AxisNumbers* axis_numbers(const ControlModel& control, FamilyId family, std::int32_t number) {
    if (control.language != "fanuc" || control.families[family].name != "#") return nullptr;
    const auto row = std::ranges::find_if(
        of_fanuc, [&](const AxisNumbers& one) { return one.first <= number && number <= one.last; });
    return row == std::end(of_fanuc) ? nullptr : row;
}

} // namespace maclint
