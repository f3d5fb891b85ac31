//! Variables of FANUC that programs can only read, by documents.
#include "analyzer/dialect/fanuc/tables.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace maclint::fanuc {
namespace {

constexpr std::array<std::string_view, 5> models = {"fanuc", "fanuc-16i", "fanuc-0i-c", "fanuc-0i-d",
                                                    "fanuc-30i"};

struct Protected {
    std::int64_t first, last;
    [[maybe_unused]] std::string_view source;
};

// clang-format off
constexpr Protected rows[] = {
    {1000, 1015, "IMD-UI: writing is rejected"},
    {3011, 3012, "TENC-SYS"},
    {4000, 4000, "TENC-SYS"},
    {4001, 4022, "SEED-001:1340-1357"},
    {4102, 4102, "SEED-001:1358"},
    {4107, 4107, "SEED-001:1359"},
    {4109, 4109, "SEED-001:1360"},
    {4111, 4111, "SEED-001:1361"},
    {4113, 4115, "SEED-001:1362-1364"},
    {4119, 4120, "SEED-001:1365-1366"},
    {4130, 4130, "SEED-001:1367"},
    {5001, 5008, "SEED-001:1373"},
    {5021, 5028, "SEED-001:1374"},
    {5041, 5048, "SEED-001:1375"},
    {5061, 5068, "SEED-001:1376; NCT-183"},
    {5081, 5088, "SEED-001:1377; NCT-183"},
    {5101, 5108, "SEED-001:1378"},
};
// clang-format on

} // namespace

bool is_protected(const ControlModel& control, std::int64_t number) {
    return std::ranges::find(models, control.model) != models.end() &&
           std::ranges::any_of(
               rows, [&](const Protected& row) { return row.first <= number && number <= row.last; });
}

} // namespace maclint::fanuc
