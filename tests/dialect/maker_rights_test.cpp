//! Remarks that claim rights, and what only looks like it.
#include "analyzer/dialect/maker_rights.hpp"
#include "tests/support/analysed.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

TEST(MakerRights, AreClaimedInSeveralWordsAndLanguages) {
    for (const char* remark :
         {"(COPYRIGHT*1990-2022*MAKER*PLC.*ALL*RIGHTS*RESERVED)", "(Copyright 2018 Maker, Inc.)",
          "(C) 1998 MAKER", "((C) 2010 MAKER LTD)", "((C) 1998 M&H)", "(C 2004 MAKER GMBH)",
          "(\xC2\xA9 MAKER)", "(ALLE RECHTE VORBEHALTEN)", "(TOUS DROITS RESERVES)",
          "(TUTTI I DIRITTI RISERVATI)", "(TODOS LOS DERECHOS RESERVADOS)", "(ALL  RIGHTS-RESERVED)",
          "(\xE7\x89\x88\xE6\x9D\x83\xE6\x89\x80\xE6\x9C\x89 MAKER)"})
        EXPECT_TRUE(claims_rights(remark)) << remark;
}

TEST(MakerRights, AreNotClaimedByTheAddressCOrAMakersName) {
    for (const char* remark : {"(C 2000 CHUCK)",
                               "(MASTERCAM COPYRIGHT 2010)",
                               "(ESPRIT COPYRIGHT DP TECHNOLOGY)",
                               "(DRAWING COPYRIGHT ACME 2010)",
                               "(CHECK COPYRIGHT WITH CUSTOMER)",
                               "(COPYRIGHT: NONE)",
                               "(T5: ENGRAVE COPYRIGHT TEXT)",
                               "(C = ANGLE)",
                               "(C) DRILL MACRO",
                               "(A B C)",
                               "(C90. INDEX)",
                               "(C 2000.)",
                               "(C 2000 MM)",
                               "(C 2000 DEG)",
                               "(C2010 TOOLING)",
                               "(C 1998)",
                               "(RENISHAW PROBE T30)",
                               "(BLUM Z NANO)",
                               "(COPY RIGHT SIDE)",
                               "(MOVE RIGHT)",
                               "",
                               "(POST-PROCESSOR COPYRIGHT 2019 MAKER)",
                               "(CAM COPYRIGHT 2020 MAKER)",
                               "(NO COPYRIGHT)"})
        EXPECT_FALSE(claims_rights(remark)) << remark;
}

/// The programs whose heads claim rights, by their first letters.
std::vector<std::string> with_rights(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    const ProgramFile& file = workspace->programs().front().file();
    std::vector<std::string> names;
    for (const ProgramWithRights& program : programs_with_rights(file))
        names.emplace_back(file.source->bytes(program.program).substr(0, 2));
    return names;
}

TEST(MakerRights, CountInTheHeadOfAProgramOnly) {
    using testing::ElementsAre;
    using testing::IsEmpty;
    EXPECT_THAT(with_rights("%\nO1(BORE)\n\n(F-4012)\n(COPYRIGHT 2020 MAKER)\nG0X1.\nM99\n%\n"),
                ElementsAre("O1"));
    EXPECT_THAT(with_rights("%\nO1(BORE)\nG0X1.\nM99\n(COPYRIGHT 2020 THE AUTHOR)\n%\n"), IsEmpty());
    EXPECT_THAT(with_rights("%\nO1(COPYRIGHT 2020 MAKER)\nM99\nO2(OWN)\nM99\n%\n"), ElementsAre("O1"));
    EXPECT_THAT(with_rights("%\n(COPYRIGHT 2020 MAKER)\nO1(ONE)\nM99\nO2(TWO)\nM99\n%\n"),
                ElementsAre("O1", "O2"));
    EXPECT_THAT(with_rights("%\nO1(ONE) (COPYRIGHT (C) 2020 MAKER) ;\nM99\n%\n"), ElementsAre("O1"));
}

} // namespace
} // namespace maclint
