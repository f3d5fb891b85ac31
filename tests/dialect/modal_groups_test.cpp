//! The codes of each modal group, against the table of the custom macro reference (section 7).
#include "analyzer/dialect/dialect.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace maclint {
namespace {

struct Row {
    GroupId number; ///< 7 is what #4007 reads
    std::vector<double> codes;
};

void expect_groups(std::string_view control, const std::vector<Row>& rows) {
    const ControlModel& model = *find_control(control);
    for (const Row& row : rows)
        for (const double code : row.codes)
            EXPECT_EQ(model.group_of('G', code), static_cast<GroupId>(row.number - 1))
                << 'G' << code << " on " << control;
}

TEST(ModalGroups, OfMillsHoldTheCodesOfTheReference) {
    expect_groups("fanuc", {{1, {0, 1, 2, 3, 33, 2.2, 3.2, 6.2}},
                            {2, {17, 18, 19}},
                            {3, {90, 91}},
                            {4, {22, 23}},
                            {5, {94, 95}},
                            {6, {20, 21}},
                            {7, {40, 41, 42}},
                            {8, {43, 44, 49}},
                            {9, {73, 74, 76, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89}},
                            {10, {98, 99}},
                            {11, {50, 51}},
                            {12, {66, 67}},
                            {13, {96, 97}},
                            {14, {54, 55, 56, 57, 58, 59, 54.1}},
                            {15, {61, 62, 63, 64}},
                            {16, {68, 69}},
                            {17, {15, 16}},
                            {18, {40.1, 41.1, 42.1, 150, 151, 152}},
                            {20, {160, 161}},
                            {21, {13.1, 12.1}},
                            {22, {50.1, 51.1}}});
}

TEST(ModalGroups, OfLathesWithSystemAHoldTheCodesOfTheReference) {
    expect_groups("fanuc-lathe", {{1, {0, 1, 2, 3, 32, 34, 90, 92, 94}},
                                  {2, {96, 97}},
                                  {4, {68, 69}},
                                  {5, {98, 99}},
                                  {6, {20, 21}},
                                  {7, {40, 41, 42}},
                                  {8, {25, 26}},
                                  {9, {22, 23}},
                                  {10, {80, 83, 84, 85, 87, 88, 89}},
                                  {12, {66, 67}},
                                  {14, {54, 55, 56, 57, 58, 59}},
                                  {16, {17, 18, 19}},
                                  {20, {50.2, 51.2}},
                                  {21, {13.1, 12.1}}});
    EXPECT_EQ(find_control("fanuc-lathe")->group_of('G', 91), std::nullopt); // systems B and C only
}

} // namespace
} // namespace maclint
