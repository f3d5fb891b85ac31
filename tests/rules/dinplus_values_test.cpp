//! DIN PLUS: variables, names, functions, calls, tools and marks, beyond the examples.
#include "tests/rules/din_findings.hpp"

#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>

namespace maclint {
namespace {

using test::din_findings;
using test::din_lines;
using test::din_speaks;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string din_message(std::string_view code, const std::string& block) {
    const auto found = din_findings(code, "MACHINING\n" + block + "\n");
    return found.empty() ? "" : found.front().message();
}

TEST(DinplusWrongBlocks, EachRaisesItsRule) {
    std::ifstream file(MACLINT_SOURCE_DIR "/grammar/dinplus/test/wrong-blocks.txt");
    ASSERT_TRUE(file);
    std::size_t blocks = 0;
    for (std::string line; std::getline(file, line);) {
        const std::size_t tab = line.find('\t');
        if (tab == std::string::npos) continue;
        const std::string code = line.substr(tab + 1);
        ASSERT_NE(find_rule(code), nullptr) << line;
        EXPECT_TRUE(din_speaks(code, line.substr(0, tab))) << line;
        ++blocks;
    }
    EXPECT_GT(blocks, 190U);
}

// ---- which variables there are

TEST(DinplusVariables, AreThoseOfTheManual) {
    for (const char* variable :
         {"#l1",      "#l99",   "#c1",     "#c30",     "#g1",       "#g199",      "#g200",   "#g299",
          "#g500",    "#g815",  "#g950",   "#i1",      "#i39",      "#i99",       "#m99(X)", "#d12(S)",
          "#w0(WTL)", "#t3(1)", "#n0(CW)", "#n601(1)", "#a10(Z,1)", "#e0(\"A\")", "#L1",     "# l1"})
        EXPECT_FALSE(din_speaks("MAC202", std::string("N5 #l1=") + variable)) << variable;
    EXPECT_FALSE(din_speaks("MAC202", "N5 #x20=\"A\""));
}

TEST(DinplusVariables, OnesThatNoListHoldsAreDoubtfulOnly) {
    const auto severity = [](const std::string& block) {
        return din_findings("MAC202", "MACHINING\n" + block + "\n").front().severity;
    };
    EXPECT_EQ(severity("N5 #l100=5"), Severity::error);
    EXPECT_EQ(severity("N5 #g300=5"), Severity::note);
    EXPECT_EQ(severity("N5 #l1=#i35"), Severity::note);
}

TEST(DinplusVariables, TheCureNamesThoseThatThereAre) {
    EXPECT_THAT(din_message("MAC202", "N5 #c31=5"), HasSubstr("#c1 to #c30"));
    EXPECT_THAT(din_message("MAC202", "N5 #l1=#g300"), HasSubstr("#g1 to #g299"));
    EXPECT_THAT(din_message("MAC202", "N5 #l1=#i40"), HasSubstr("#i1 to #i34, #i36, #i38 to #i39, #i99"));
}

TEST(DinplusVariables, OfOthersMayBeReadAndNotStored) {
    EXPECT_FALSE(din_speaks("DIN303", "N5 #l1=#g810"));
    EXPECT_FALSE(din_speaks("MAC203", "N5 #l1=#i99"));
    EXPECT_FALSE(din_speaks("MAC203", "N5 #m4(Z)=350"));
    EXPECT_FALSE(din_speaks("MAC203", "N5 #d3(X)=0.5"));
    EXPECT_TRUE(din_speaks("MAC203", "N5 #i99=5"));
}

TEST(DinplusVariables, SelectorsAndNumbersAreKnownInAnyCase) {
    EXPECT_FALSE(din_speaks("DIN336", "N5 #l1=#w0(wtl)"));
    EXPECT_FALSE(din_speaks("DIN336", "N5 #l1=#W1(RS,\"ID\")"));
    EXPECT_FALSE(din_speaks("DIN336", "N5 #l1=#n707(X,1)"));
    EXPECT_FALSE(din_speaks("DIN336", "N5 #l1=#t3(1)"));
}

TEST(DinplusIndex, MayBeAVariableOrANumber) {
    EXPECT_FALSE(din_speaks("DIN315", "N5 #l1=#g(#c2)"));
    EXPECT_FALSE(din_speaks("DIN315", "N5 G1 Z#m(#l1)(Z)"));
    EXPECT_FALSE(din_speaks("DIN315", "N5 #l98(200+1)"));
    EXPECT_FALSE(din_speaks("DIN315", "N5 #l1=#t(3,\"001\")"));
}

// ---- texts and numbers

TEST(DinplusTexts, AreJoinedAndComparedWithTexts) {
    EXPECT_FALSE(din_speaks("DIN305", "N5 #x3=#x3+#x2"));
    EXPECT_FALSE(din_speaks("DIN305", "N5 #x2=TIME(\"h:m:s\")+STRING(#i21)"));
    EXPECT_FALSE(din_speaks("DIN305", "N5 #x1=STRING(12.43,1)"));
    EXPECT_FALSE(din_speaks("DIN305", "N5 IF #x2<>\"_EMPTY\""));
    EXPECT_FALSE(din_speaks("DIN305", "N5 PRINT(\"a\",#l1,#x1)"));
    EXPECT_FALSE(din_speaks("DIN305", "N5 #x1=#w1(ID)"));
}

TEST(DinplusTexts, AreUnknownWhereTheProgramAloneDoesNotTell) {
    EXPECT_FALSE(din_speaks("DIN305", "N5 #l1=PARA(\"\",\"A\",\"b\")"));
    EXPECT_FALSE(din_speaks("DIN305", "N5 #x1=PARA(\"\",\"A\",\"b\",0)"));
    EXPECT_FALSE(din_speaks("DIN305", "N5 #x1=#i99"));
    EXPECT_FALSE(din_speaks("DIN305", "N5 #x1=#i99+STRING(5)"));
    EXPECT_FALSE(din_speaks("DIN305", "N5 L\"A\" V1 ID#x1 AT\"B\""));
}

TEST(DinplusTexts, ANameHasTheTypeOfItsVariable) {
    const std::string var = "VAR\n#_name=#x1\n#_size=#l1\n#_own=5\nMACHINING\n";
    EXPECT_THAT(din_lines("DIN305", var + "N5 #_name=5\nEND\n"), ElementsAre(6));
    EXPECT_THAT(din_lines("DIN305", var + "N5 #_size=\"A\"\nEND\n"), ElementsAre(6));
    EXPECT_THAT(din_lines("DIN305", var + "N5 #_name=\"A\"\nN6 #_size=5\nN7 #_own=\"A\"\nEND\n"), IsEmpty());
}

TEST(DinplusWholeNumbers, TakeWhatBothReadingsOfTheManualAllow) {
    EXPECT_FALSE(din_speaks("DIN307", "N5 #g200=32768"));
    EXPECT_FALSE(din_speaks("DIN307", "N5 #g200=-32768"));
    EXPECT_FALSE(din_speaks("DIN306", "N5 #g200=2.0"));
    EXPECT_FALSE(din_speaks("DIN306", "N5 #g200=#l1/2"));
    EXPECT_FALSE(din_speaks("DIN307", "N5 #g100=70000"));
}

// ---- names

TEST(DinplusNames, HaveAtMostTwentyCharactersBehindTheUnderscore) {
    const auto in_const = [](const std::string& name) {
        return din_lines("DIN308", "CONST\n_" + name + "=2\nMACHINING\nEND\n");
    };
    EXPECT_THAT(in_const("abcdefghij0123456789"), IsEmpty());
    EXPECT_THAT(in_const("abcdefghij0123456789x"), ElementsAre(2));
    EXPECT_THAT(in_const("wurzel_2"), IsEmpty());
    EXPECT_THAT(in_const("Wurzel_2"), ElementsAre(2));
    EXPECT_THAT(din_lines("DIN308", "VAR\n#_Feed=#l1\nMACHINING\nEND\n"), ElementsAre(2));
    EXPECT_THAT(din_lines("DIN308", "MACHINING\n#l1=_Feed\nEND\n"), IsEmpty()); // told where it is defined
}

TEST(DinplusNames, OfConstantsAreKnownFromTheirDefinitionOn) {
    EXPECT_THAT(din_lines("DIN309", "CONST\n_b=_a+1\n_a=2\nMACHINING\nEND\n"), ElementsAre(2));
    EXPECT_THAT(din_lines("DIN309", "CONST\n_a=2*_pi\n_b=_a+1\nMACHINING\nEND\n"), IsEmpty());
    EXPECT_THAT(din_lines("DIN309", "%A.ncs\nCONST\n_b=_a+1\nMACHINING\nRETURN\n"),
                IsEmpty()); // the caller's
}

TEST(DinplusNames, NobodyDeclaredAreToldInMainProgramsAndTheirOwnSubprograms) {
    const std::string var = "VAR\n#_size=#l1\nMACHINING\n";
    EXPECT_THAT(din_lines("DIN312", var + "G0 X#_size\nG0 X_size\nG0 X#_sise\nG0 X_pi\nEND\n"),
                ElementsAre(6));
    EXPECT_THAT(
        din_lines("DIN312", var + "L\"A\"\nM30\nSUBPROGRAM \"A\"\nG0 X#_size\nG0 X#_sise\nRETURN\nEND\n"),
        ElementsAre(8));
    EXPECT_THAT(din_lines("DIN312", "%A.ncs\nMACHINING\nG0 X#_size\nRETURN\n"), IsEmpty());
    EXPECT_THAT(din_lines("DIN312", "VAR\n#_size==#\nMACHINING\nG0 X#_size\nEND\n"),
                IsEmpty()); // nobody can read it
    EXPECT_THAT(din_lines("DIN312", "VAR\n#_size\nMACHINING\nG0 X#_size\nEND\n"), IsEmpty());
    EXPECT_THAT(din_lines("DIN312", "MACHINING\nIF DEF(_size)\nTHEN\nENDIF\nEND\n"), IsEmpty());
}

TEST(DinplusNames, ToldAsUndeclaredAreNotToldAsUnset) {
    EXPECT_THAT(din_lines("MAC209", "VAR\n#_size=#l1\nMACHINING\nG0 X#_sise\nM30\nEND\n"), IsEmpty());
}

TEST(DinplusConstants, KeepTheirValue) {
    EXPECT_THAT(din_lines("DIN311", "CONST\n_a=2\nMACHINING\n_a=3\nEND\n"), ElementsAre(4));
    EXPECT_THAT(din_lines("DIN311", "CONST\n_a=2\nMACHINING\n#l1=_a\nEND\n"), IsEmpty());
}

TEST(DinplusConstants, OfTheControlAreThoseOfItsList) {
    for (const char* name : {"__n0_x", "__n40_g", "__n148_o", "__n150_z", "__n97_s", "__N95_F", "__la"})
        EXPECT_FALSE(din_speaks("DIN337", std::string("N5 #l1=") + name)) << name;
}

TEST(DinplusTests, AskForWhatTheyAreMadeFor) {
    EXPECT_FALSE(din_speaks("DIN338", "N5 IF DVDEF(__n97_s)"));
    EXPECT_FALSE(din_speaks("DIN338", "N5 IF NDEF(__la) OR DEF(l1)"));
    EXPECT_FALSE(din_speaks("DIN338", "N5 IF DVDEF(_posx)")); // CONST may have given it the name
    EXPECT_THAT(din_message("DIN338", "N5 IF DVDEF(__la)"), HasSubstr("'DEF(__la)'"));
    EXPECT_THAT(din_message("DIN338", "N5 IF NDEF(__n0_x)"), HasSubstr("'DVDEF(__n0_x)'"));
}

TEST(DinplusAliases, OfOneVariableAreToldOnce) {
    EXPECT_THAT(din_lines("DIN314", "VAR\n#_a=#l1\n#_b=#l1(5)\n#_c=#l2\n#_d=#c1\nMACHINING\nEND\n"),
                ElementsAre(3));
}

// ---- statements

TEST(DinplusConditions, MayBeTwo) {
    EXPECT_FALSE(din_speaks("DIN403", "N5 IF (#l1==1) AND (#l2==2)"));
    EXPECT_FALSE(din_speaks("DIN403", "N5 IF DEF(__la) OR (#l1>2)"));
    EXPECT_FALSE(din_speaks("DIN413", "N5 SWITCH (#l1)"));
    EXPECT_FALSE(din_speaks("DIN413", "N5 SWITCH #w0(WT)"));
}

TEST(DinplusConditions, CompareOrAsk) {
    EXPECT_FALSE(din_speaks("DIN422", "N5 IF BITSET(0,#l1)"));
    EXPECT_FALSE(din_speaks("DIN422", "N5 IF (DEF(__la))"));
    EXPECT_FALSE(din_speaks("DIN422", "N5 WHILE (#l1<5)"));
}

TEST(DinplusNumbers, KeepTenFiguresAndSevenDecimals) {
    EXPECT_FALSE(din_speaks("DIN019", "N5 #l1=1234567890.1234567"));
    EXPECT_FALSE(din_speaks("DIN019", "N5 #l1=00000000000001"));
    EXPECT_FALSE(din_speaks("DIN018", "N5 #l1 = #l2 + 3"));
}

TEST(DinplusCalls, PassWhatTheManualLists) {
    EXPECT_FALSE(din_speaks("DIN512", "N5 L\"A\" V1 Q2 LA1 LZ2 BS3 JC4 ID\"B\" AT\"C\" LN40"));
    EXPECT_FALSE(din_speaks("DIN515", "N5 L\"A\" V1 LN40"));
    EXPECT_FALSE(din_speaks("DIN515", "N5 L\"A\" V1 LN#l1"));
    EXPECT_FALSE(din_speaks("DIN516", "N5 L\"A\" V1 Q#l1"));
    EXPECT_FALSE(din_speaks("DIN509", "N5 L\"measure_pos_move.ncs\" V1"));
    EXPECT_FALSE(din_speaks("DIN509", "N5 L\"A_LOCAL_NAME_OF_MORE_THAN_16\""));
}

TEST(DinplusDescriptions, AreCountedOverAllListsOfAFile) {
    std::string text = "%A.ncs\n[//]\n";
    const std::string_view letters = "abcdefhijkoprsuwxyz";
    for (const char letter : letters) text += std::string("[l") + letter + "=1; s=Text]\n";
    EXPECT_THAT(din_lines("DIN514", text + "[//]\nMACHINING\nRETURN\n"), IsEmpty());
    EXPECT_THAT(
        din_lines("DIN514", text + "[//]\n[//]\n[la=1; s=Again]\n[lq=1; s=Text]\n[//]\nMACHINING\nRETURN\n"),
        ElementsAre(24, 25));
}

TEST(DinplusDescriptions, CountCharactersAndNotBytes) {
    const auto with = [](const std::string& description) {
        return din_lines("DIN514", "%A.ncs\n[//]\n" + description + "\n[//]\nMACHINING\nRETURN\n");
    };
    EXPECT_THAT(with("[la=1; s=Stangendurchm. in Länge]"), IsEmpty());   // 24
    EXPECT_THAT(with("[la=1; s=ääääääääääääääääääääääääx]"), IsEmpty()); // 25
    EXPECT_THAT(with("[la=1; s=ääääääääääääääääääääääääxy]"), ElementsAre(3));
    EXPECT_THAT(with("[la=8; s=Text]"), ElementsAre(3));
    EXPECT_THAT(with("[a remark of somebody]"), IsEmpty());
}

TEST(DinplusDescriptions, HaveTwoMarks) {
    EXPECT_THAT(din_lines("DIN014", "%A.ncs\n[//]\n[la=1; s=Text]\nMACHINING\nRETURN\n"), ElementsAre(2));
    EXPECT_THAT(din_lines("DIN014", "%A.ncs\n[//]\n[//]\n[//]\nMACHINING\nRETURN\n"), ElementsAre(4));
}

TEST(DinplusLeftovers, AreBlocksInRemarksWithAWarning) {
    EXPECT_TRUE(din_speaks("DIN123", "[WARNING N120 G81 #T1(X)]"));
    EXPECT_TRUE(din_speaks("DIN123", "[WARNUNG: G59 X5]"));
    EXPECT_FALSE(din_speaks("DIN123", "[WARNING: the bar turns]"));
    EXPECT_FALSE(din_speaks("DIN123", "[N120 G81 X5]"));
}

TEST(DinplusGroups, MayStandInGroups) {
    EXPECT_FALSE(din_speaks("DIN016", "BLOCKSTART\nBLOCKSTART\nBLOCKEND\nBLOCKEND"));
    EXPECT_TRUE(din_speaks("DIN016", "BLOCKSTART\nBLOCKSTART\nBLOCKEND"));
}

// ---- sections, tools, slides

TEST(DinplusSections, AreOfOneLanguage) {
    EXPECT_THAT(din_lines("DIN104", "ROHTEIL\nFERTIGTEIL\nVAR\nCONST\nBEARBEITUNG\nENDE\n"), IsEmpty());
    EXPECT_THAT(din_lines("DIN104", "ROHTEIL\nFINISHED\nBEARBEITUNG\nENDE\n"), ElementsAre(2));
    EXPECT_THAT(din_lines("DIN104", "BLANK\nFINISHED PART\nMACHINING\nEND\n"), IsEmpty());
}

TEST(DinplusSections, OfToolsAndOfSkippedBlocksAreTheirOwn) {
    EXPECT_THAT(din_lines("DIN115", "MAGAZINE\nID\"A\"\nTURRET 1\nTURRET 2\nMACHINING\nEND\n"),
                ElementsAre(3));
    EXPECT_THAT(din_lines("DIN020", "BLANK\n/1 N1 G20 X5\nMACHINING\n/159 N2 G0 X5\nEND\n"), ElementsAre(2));
}

TEST(DinplusTools, OfAListHoldTheirEdgesApart) {
    EXPECT_THAT(din_lines("DIN117", "TURRET 1\nT1 ID\"A\"\nT1.1 ID\"A\"\nT1.0 ID\"B\"\nMACHINING\nEND\n"),
                ElementsAre(4));
    EXPECT_THAT(din_lines("DIN118", "TURRET 1\nT1 ID\"A\"\nMACHINING\nT1.2\nT#l1\nT0\nT5\nEND\n"),
                ElementsAre(7));
    EXPECT_THAT(din_lines("DIN118", "MACHINING\nT5\nEND\n"), IsEmpty());
    EXPECT_THAT(
        din_lines("DIN118",
                  "TURRET 1\nT1 ID\"A\"\nMACHINING\nL\"A\"\nM30\nSUBPROGRAM \"A\"\nT1\nT2\nRETURN\nEND\n"),
        ElementsAre(8));
}

TEST(DinplusMarks, AreSetByTheSlideThatIsWaitedFor) {
    const std::string head = "PROGRAM HEAD\n#SLIDE $1$2\nMACHINING\n";
    EXPECT_THAT(din_lines("DIN902", head + "$1 N1 G62 Q2 H5\n$2 N2 G162 H6\nEND\n"), ElementsAre(4));
    EXPECT_THAT(din_lines("DIN902", head + "$1 N1 G62 Q2 H5\n$1 N2 G162 H5\nEND\n"), ElementsAre(4));
    EXPECT_THAT(din_lines("DIN902", head + "$1 N1 G62 Q2 H5\n$2 N2 G162 H5\nEND\n"), IsEmpty());
    EXPECT_THAT(din_lines("DIN902", head + "$1 N1 G62 Q2 H5\nN2 G162 H5\nEND\n"), IsEmpty());
    EXPECT_THAT(din_lines("DIN902", head + "$1 N1 G62 Q2 H5\n$2 N2 G162 H#l1\nEND\n"), IsEmpty());
}

TEST(DinplusSlides, AreThoseOfTheHead) {
    const std::string head = "PROGRAM HEAD\n#SLIDE $1$2\nMACHINING\n";
    EXPECT_THAT(din_lines("DIN905", head + "$1 N1 G0 X5\n$1$3 N2 G0 X5\n$2 N3 G0 X6\nEND\n"), ElementsAre(5));
    EXPECT_THAT(din_lines("DIN905", "MACHINING\n$3 N1 G0 X5\nEND\n"), IsEmpty()); // no head tells
}

TEST(DinplusSlides, CountSharedVariablesOnceEach) {
    const std::string head = "PROGRAM HEAD\n#SLIDE $1$2\nMACHINING\n";
    EXPECT_THAT(din_lines("DIN319", head + "#g1=#g1+1\n$1$2 #g1=#g1+1\n$2 #g1=#g1+1\nEND\n"),
                ElementsAre(4, 5));
    EXPECT_THAT(din_lines("DIN319", head + "#g1=5\n#l1=#l1+1\n#c1=#c1+1\nEND\n"),
                IsEmpty()); // the same twice, or apart
    EXPECT_THAT(din_lines("DIN319", head + "ASSIGNMENT $1\n#g1=#g1+1\nASSIGNMENT\nEND\n"), IsEmpty());
    EXPECT_THAT(din_lines("DIN319", "MACHINING\n#g1=#g1+1\nEND\n"), IsEmpty());
}

TEST(DinplusSubprograms, HaveANameEach) {
    const std::string main = "MACHINING\nM30\nSUBPROGRAM \"A\"\nRETURN\n";
    EXPECT_THAT(din_lines("DIN510", main + "SUBPROGRAM \"a\"\nRETURN\nEND\n"), ElementsAre(5));
    EXPECT_THAT(din_lines("DIN510", main + "SUBPROGRAM \"B\"\nRETURN\nEND\n"), IsEmpty());
    EXPECT_THAT(din_lines("DIN504",
                          "MACHINING\nL\"a\" V1\nL\"a\" V0\nL\"b\" V1\nM30\nSUBPROGRAM \"A\"\nRETURN\nEND\n"),
                ElementsAre(2));
}

} // namespace
} // namespace maclint
