//! The engine: which files it reads, what it keeps, whose completeness counts, and that it stops.
#include "cli/engine/engine.hpp"
#include "tests/support/folder.hpp"

#include <chrono>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::string_view jumps_nowhere = "O1\nG65P2\nGOTO9\nM30\n"; // MAC301 on line 3

class EngineTest : public testing::Test {
  protected:
    /// The folder's files as they are now; findings are wanted of those in `asked`.
    cli::Snapshot snapshot(std::initializer_list<std::string> asked) {
        auto found = cli::discover({folder.path().string()}, "", settings);
        for (cli::InputFile& file : found.files)
            file.asked = std::ranges::any_of(
                asked, [&](const std::string& name) { return file.path.ends_with(name); });
        return cli::snapshot_of(std::move(found.files), settings);
    }

    /// "O1.nc:3 MAC301", in the order of reports.
    std::vector<std::string> places(const cli::Result& result) const {
        std::vector<std::string> all;
        for (const auto& [finding, suppressed] : result.findings)
            all.push_back(finding.source->path().substr(folder.path().string().size() + 1) + ":" +
                          std::to_string(finding.source->position(finding.span.begin).line) + " " +
                          std::string(finding.rule->code));
        return all;
    }

    /// Long enough ago for its time to tell it from what is written now.
    void write_an_hour_ago(const std::string& name, std::string_view text) const {
        const std::filesystem::path path = folder.write(name, text);
        std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now() -
                                                   std::chrono::hours(1));
    }

    TemporaryFolder folder;
    cli::Settings settings{{}};
    cli::Progress progress{cli::Progress::Shown::never};
    cli::Engine engine{{.jobs = 2, .kept_bytes = 1000}, progress};
};

TEST_F(EngineTest, ReadsWholeOnlyWhatCallsConnectWithTheFilesAskedFor) {
    folder.write("O1.nc", jumps_nowhere);
    folder.write("O2.nc", "O2\nG98P3\nM98P3\nM99\n");
    folder.write("O3.nc", "O3\nGOTO7\nM99\n"); // called by O2, not asked for
    folder.write("O4.nc", "O4\nGOTO7\nM30\n");
    folder.write("O5.nc", "O5\nM98P2\nM30\n"); // calls O2
    const auto result = engine.analyse(snapshot({"O1.nc"}));
    EXPECT_THAT(places(result), ElementsAre("O1.nc:3 MAC301"));
    EXPECT_EQ(engine.store().reads(), 4U);
    EXPECT_EQ(result.sources.size(), 1U);
}

TEST_F(EngineTest, FilesThatLieElsewhereChangeNothing) {
    folder.write("a/O1.nc", jumps_nowhere);
    folder.write("a/O2.nc", "O2\nM99\n");
    folder.write("b/O2.nc", "O2\nGOTO7\nM99\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"a/O1.nc", "a/O2.nc"}))), ElementsAre("a/O1.nc:3 MAC301"));
    EXPECT_EQ(engine.store().reads(), 2U);
}

TEST_F(EngineTest, KeepsProgramsWhoseTextStaysAsItIs) {
    folder.write("O1.nc", jumps_nowhere);
    folder.write("O2.nc", "O2\nM99\n");
    const auto first = places(engine.analyse(snapshot({"O1.nc", "O2.nc"})));
    EXPECT_EQ(engine.store().reads(), 2U);
    EXPECT_EQ(places(engine.analyse(snapshot({"O1.nc", "O2.nc"}))), first);
    EXPECT_EQ(engine.store().reads(), 2U);
    folder.write("O2.nc", "O2\nGOTO8\nM99\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"O1.nc", "O2.nc"}))),
                ElementsAre("O1.nc:3 MAC301", "O2.nc:2 MAC301"));
    EXPECT_EQ(engine.store().reads(), 3U);
}

TEST_F(EngineTest, ReadsAgainUnderAnotherConfiguration) {
    folder.write("O1.nc", jumps_nowhere);
    folder.write("O2.nc", "O2\nM99\n");
    static_cast<void>(engine.analyse(snapshot({"O1.nc"})));
    folder.write(".maclint.json", R"({"complete": false})");
    settings = cli::Settings({});
    EXPECT_THAT(places(engine.analyse(snapshot({"O1.nc"}))), ElementsAre("O1.nc:3 MAC301"));
    EXPECT_EQ(engine.store().reads(), 4U);
}

TEST_F(EngineTest, KeepsNoMoreThanItMay) {
    folder.write("O1.nc", jumps_nowhere);
    folder.write("O2.nc", "O2\n(" + std::string(2000, '-') + ")\nM99\n");
    static_cast<void>(engine.analyse(snapshot({"O1.nc"})));
    static_cast<void>(engine.analyse(snapshot({"O1.nc"})));
    EXPECT_EQ(engine.store().reads(), 3U); // O2 twice
}

TEST_F(EngineTest, LetsGoWhatTheLastSnapshotDidNotAskFor) {
    folder.write("O1.nc", jumps_nowhere);
    folder.write("O4.nc", "O4\nM30\n");
    for (const char* asked : {"O1.nc", "O4.nc", "O1.nc"})
        static_cast<void>(engine.analyse(snapshot({asked})));
    EXPECT_EQ(engine.store().reads(), 3U);
}

TEST_F(EngineTest, TakesNoSecondLookAtFilesThatStayAsTheyAre) {
    folder.write("O1.nc", jumps_nowhere);
    write_an_hour_ago("O2.nc", "O2\nM99\n");
    const auto first = places(engine.analyse(snapshot({"O1.nc"})));
    EXPECT_EQ(engine.looks(), 2U);
    EXPECT_EQ(places(engine.analyse(snapshot({"O1.nc"}))), first);
    EXPECT_EQ(engine.looks(), 3U); // what was asked for is always read
    write_an_hour_ago("O2.nc", "O2\nG65P1\nM99\n");
    static_cast<void>(engine.analyse(snapshot({"O1.nc"})));
    EXPECT_EQ(engine.looks(), 5U);
}

TEST_F(EngineTest, ReadsAConnectedFileAgainOnceItHasChanged) {
    folder.write("O1.nc", "O1\nG65P2\nM30\n");
    write_an_hour_ago("O2.nc", "O2\n#100=1\nM99\n");
    for (int round = 0; round < 2; ++round)
        EXPECT_THAT(places(engine.analyse(snapshot({"O1.nc"}))), IsEmpty());
    EXPECT_EQ(engine.store().reads(), 2U);
    write_an_hour_ago("O2.nc",
                      "O2\n#100=#24\n#3000=1(STOP)\n"); // no X is passed, and the call ends in the alarm
    const auto told = places(engine.analyse(snapshot({"O1.nc"})));
    EXPECT_EQ(engine.store().reads(), 3U);
    cli::Engine anew({.jobs = 1}, progress);
    EXPECT_EQ(told, places(anew.analyse(snapshot({"O1.nc"}))));
    EXPECT_THAT(told, Not(IsEmpty()));
}

TEST_F(EngineTest, LooksAgainAtAFileThatMayHaveBeenWrittenInTheSameSecond) {
    folder.write("O1.nc", jumps_nowhere);
    folder.write("O2.nc", "O2\nM99\n");
    for (int round = 0; round < 2; ++round) static_cast<void>(engine.analyse(snapshot({"O1.nc"})));
    EXPECT_EQ(engine.looks(), 4U);
}

TEST_F(EngineTest, LooksAgainUnderAnotherConfiguration) {
    folder.write("O1.nc", jumps_nowhere);
    write_an_hour_ago("O2.nc", "O2\nM99\n");
    static_cast<void>(engine.analyse(snapshot({"O1.nc"})));
    folder.write(".maclint.json", R"({"complete": false})");
    settings = cli::Settings({});
    static_cast<void>(engine.analyse(snapshot({"O1.nc"})));
    EXPECT_EQ(engine.looks(), 4U);
}

TEST_F(EngineTest, EachFolderIsCompleteOrNotForItself) {
    folder.write("mill/.maclint.json", R"({"complete": true})");
    folder.write("mill/O1.nc", "O1\nM98P7\nM30\n"); // no O7
    folder.write("lathe/O1.nc", "O1\nM98P7\nM30\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"O1.nc"}))), ElementsAre("mill/O1.nc:2 MAC402"));
}

TEST_F(EngineTest, FilesOfDefinitionsGiveNamesToTheProgramsByThem) {
    const std::string main = "G0 X=SHOP_WIDTH\nAIR_ON\nG0 X=SHOP_WIDHT2\nM30\n";
    folder.write("mill/A.MPF", main);
    EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), IsEmpty()); // the machine may have them
    folder.write("other/SHOP.DEF", "DEF CHAN REAL SHOP_WIDTH\nM30\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), IsEmpty()); // those of another machine
    folder.write("mill/SHOP.DEF", "DEF CHAN REAL SHOP_WIDTH, SHOP_ROW[5]\nDEFINE AIR_ON AS M27\nM30\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), ElementsAre("mill/A.MPF:3 SIN202"));
    folder.write(".maclint.json", R"({"complete": true, "known-names": ["SHOP_WIDH*"]})");
    settings = cli::Settings({});
    EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), IsEmpty());
    folder.write("mill/SHOP.DEF", "DEF CHAN REAL SHOP_WIDTH\nM30\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), ElementsAre("mill/A.MPF:2 MAC402"));
}

TEST_F(EngineTest, MacrosOfFilesOfDefinitionsLeaveModesWhereTheyOnlySwitch) {
    folder.write("A.MPF", "G54 G17\nTRAORI\nG1 X5 F1000\nCHIPS_AWAY\nM30\n");
    const auto left_with = [&](const std::string& macro) {
        folder.write("SHOP.DEF", "DEF CHAN REAL SHOP_WIDTH\nDEFINE CHIPS_AWAY AS " + macro + "\nM30\n");
        return places(engine.analyse(snapshot({"A.MPF"})));
    };
    EXPECT_THAT(left_with("M9 M28"), ElementsAre("A.MPF:2 MAC502"));
    EXPECT_THAT(left_with("M9 TRAFOOF"), IsEmpty());
    EXPECT_THAT(left_with("M30"), IsEmpty()); // it may end the program before
}

TEST_F(EngineTest, MacrosThatOnlySwitchLeaveThePlaneAndTheTool) {
    folder.write("A.MPF", "G17 G90 G54\nG0 X0 Y0\nCHIPS_AWAY\nG1 F500 X10\nG3 X10 Y20 CR=8\nM30\n");
    folder.write("SHOP.DEF", "DEFINE CHIPS_AWAY AS M27\nM17\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), ElementsAre("A.MPF:5 MAC522"));
    for (const char* body :
         {"TRANS X5", "G0 POCKET", "SUPA G1 X5"}) { // the last one: from where, nobody knows
        folder.write("SHOP.DEF", "DEFINE CHIPS_AWAY AS " + std::string(body) + "\nM17\n");
        EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), IsEmpty()) << body;
    }
}

TEST_F(EngineTest, MacrosOfFilesOfDefinitionsSetWhatTheirWordsSet) {
    const auto with = [&](const std::string& body, const std::string& block) {
        folder.write("A.MPF",
                     "G17 G90 G54\nG0 X0 Y0\n" + block + "\nG0 X0 Y0\nG1 F500 X10\nG3 X10 Y20 CR=8\nM30\n");
        folder.write("SHOP.DEF", "DEFINE PARK_HEAD AS " + body + "\nM17\n");
        return places(engine.analyse(snapshot({"A.MPF"})));
    };
    for (const char* body : {"SUPA G0 Z0 D0", "M6", "G0", "G90 F200"})
        EXPECT_THAT(with(body, "PARK_HEAD"), ElementsAre("A.MPF:6 MAC522")) << body;
    EXPECT_THAT(with("G18", "PARK_HEAD"), ElementsAre("A.MPF:6 MAC558")); // it does not move in its plane
    EXPECT_THAT(with("SUPA G0 Z0 D0", "PARK_HEAD X5"), IsEmpty());
    EXPECT_THAT(with("WAITM(1)", "PARK_HEAD"), IsEmpty());
    // Two files say different things.
    folder.write("OTHER.DEF", "DEFINE PARK_HEAD AS G19\nM17\n");
    EXPECT_THAT(with("G0", "PARK_HEAD"), IsEmpty());
}

TEST_F(EngineTest, MacrosComeBeforeProgramsOfTheirName) {
    folder.write("A.MPF", "G0 X5\nCLEAN_UP\nG0 X9\nM30\n");
    folder.write("CLEAN_UP.SPF", "G0 Z9\nM30\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"CLEAN_UP.SPF"}))), ElementsAre("CLEAN_UP.SPF:2 MAC457"));
    folder.write("SHOP.DEF", "DEFINE CLEAN_UP AS M27\nM17\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"CLEAN_UP.SPF"}))), IsEmpty());
}

TEST_F(EngineTest, MainProgramsAreCalledFromTheirFolderAlone) {
    folder.write(".maclint.json", R"({"complete": true})");
    settings = cli::Settings({});
    folder.write("mill/A.MPF", "G0 X5\nPLATE\nG0 X9\nM30\n");
    folder.write("lathe/PLATE.MPF", "G0 Z9\nM30\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"PLATE.MPF"}))), IsEmpty());
    folder.write("lathe/A.MPF", "G0 X5\nPLATE\nG0 X9\nM30\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"PLATE.MPF"}))), ElementsAre("lathe/PLATE.MPF:2 MAC457"));
}

TEST_F(EngineTest, ArraysOfFilesOfDefinitionsHaveBounds) {
    folder.write("A.MPF",
                 "DEF INT I_\nG0 X=SHOP_ROW[5]\nG0 X=SHOP_ROW[4]\nG0 X=SHOP_MAP[1,3]\nSHOP_ROW[-1]=2\n"
                 "FOR I_=0 TO 5\nG0 X=SHOP_ROW[I_]\nENDFOR\nG0 X=SHOP_ROW[R1]\nM30\n");
    const auto with = [&](const std::string& definitions) {
        folder.write("SHOP.DEF", definitions + "M17\n");
        return places(engine.analyse(snapshot({"A.MPF"})));
    };
    EXPECT_THAT(with("DEF CHAN REAL SHOP_ROW[5]\nDEF NCK REAL SHOP_MAP[2,3]\n"),
                ElementsAre("A.MPF:2 SIN207", "A.MPF:4 SIN207", "A.MPF:5 SIN207", "A.MPF:7 SIN207"));
    EXPECT_THAT(with("DEF CHAN REAL SHOP_ROW[9], SHOP_MAP[2,4]\n"), ElementsAre("A.MPF:5 SIN207"));
    folder.write("OTHER.DEF", "DEF CHAN REAL SHOP_ROW[5]\nM17\n"); // of which machine nobody knows
    EXPECT_THAT(with("DEF CHAN REAL SHOP_ROW[9], SHOP_MAP[2,4]\n"), IsEmpty());
}

TEST_F(EngineTest, VariablesOfFilesOfDefinitionsHaveDimensions) {
    folder.write("A.MPF", "G0 X=SHOP_MAP[1]\nG0 X=SHOP_WAY[0]\nR1=SHOP_NAME[0]\nG0 X=SHOP_MAP[1,2]\nM30\n");
    folder.write("SHOP.DEF", "DEF CHAN REAL SHOP_WAY, SHOP_MAP[2,3]\nDEF NCK STRING[9] SHOP_NAME\nM17\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), ElementsAre("A.MPF:1 SIN208", "A.MPF:2 SIN208"));
    folder.write("OTHER.DEF", "DEF CHAN REAL SHOP_WAY[5]\nM17\n"); // of which machine nobody knows
    EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), ElementsAre("A.MPF:1 SIN208"));
}

TEST_F(EngineTest, AProgramThatIsNotThereIsNoSlipOfOneThatExternNames) {
    folder.write("A.MPF", "EXTERN DRILL_ROW(REAL)\nDRILL_RWO(5)\nM30\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), ElementsAre("A.MPF:2 SIN203"));
    folder.write(".maclint.json", R"({"complete": true})");
    settings = cli::Settings({});
    EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), ElementsAre("A.MPF:2 MAC402"));
}

TEST_F(EngineTest, SingleVariablesOfFilesOfDefinitionsHaveATypeForParameters) {
    folder.write("SHOP.DEF", "DEF CHAN INT SHOP_COUNT\nDEF CHAN REAL SHOP_WAY\nM17\n");
    folder.write("FILL.SPF", "PROC FILL(VAR REAL PLACE)\nPLACE=1\nM17\n");
    folder.write("A.MPF", "FILL(SHOP_COUNT)\nFILL(SHOP_WAY)\nM30\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), ElementsAre("A.MPF:1 SIN404"));
}

TEST_F(EngineTest, NamesAreHeldAgainstThoseOfFilesOfDefinitions) {
    folder.write("SHOP.DEF", "DEF CHAN REAL SHOP_WIDTH\nM17\n");
    folder.write("A.MPF", "G0 X=SHOP_WIDT\nM30\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), ElementsAre("A.MPF:1 SIN203"));
    folder.write("A.MPF", "G0 Y=SHOP_WIDT+SHOP_WIDT\nM30\n"); // no slip: it stands twice
    EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), ElementsAre("A.MPF:1 SIN202"));
}

TEST_F(EngineTest, ArraysOfFilesOfDefinitionsHaveATypeForParameters) {
    folder.write("SHOP.DEF", "DEF CHAN INT SHOP_ROW[5]\nDEF CHAN REAL SHOP_WAY[5]\nM17\n");
    folder.write("FILL.SPF", "PROC FILL(VAR REAL PLACES[])\nPLACES[0]=1\nM17\n");
    folder.write("A.MPF", "FILL(SHOP_ROW)\nFILL(SHOP_WAY)\nM30\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), ElementsAre("A.MPF:1 SIN404"));
}

TEST_F(EngineTest, AxesThatAreArgumentsTheMachineNames) {
    folder.write(".maclint.json", R"({"complete": true})");
    settings = cli::Settings({});
    folder.write("A.MPF", "TRAVEL(AX1,20)\nTRAVEL(AX2,AX3)\nM30\n");
    folder.write("TRAVEL.SPF", "PROC TRAVEL(AXIS MOVED, REAL WAY)\nG91 G0 AX[MOVED]=WAY\nM17\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), ElementsAre("A.MPF:2 SIN202"));
}

TEST_F(EngineTest, ACounterThatNothingDefinesIsTold) {
    folder.write(".maclint.json", R"({"complete": true})");
    settings = cli::Settings({});
    folder.write("A.MPF", "FOR SLOT_NO=1 TO 5\nG91 G0 X5\nENDFOR\nM30\n");
    folder.write("SHOP.DEF", "DEF CHAN REAL SHOP_WIDTH\nM17\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"A.MPF"}))), ElementsAre("A.MPF:1 SIN202"));
}

TEST_F(EngineTest, AComputedCallInTheFolderLeavesOpenWhatIsPassed) {
    folder.write(".maclint.json", R"({"complete": true})");
    folder.write("O1.nc", "O1\nG65P2A1.\nM30\n");
    folder.write("O2.nc", "O2\n#100=#1+#2\nM99\n"); // the only call leaves B out
    EXPECT_THAT(places(engine.analyse(snapshot({"O2.nc"}))), ElementsAre("O2.nc:2 MAC209"));
    folder.write("O3.nc", "O3\nG65P#100A1.B1.\nM30\n");
    EXPECT_THAT(places(engine.analyse(snapshot({"O2.nc"}))), IsEmpty());
}

TEST_F(EngineTest, GivesNothingWhenItIsToldToStop) {
    folder.write("O1.nc", jumps_nowhere);
    std::stop_source stop;
    stop.request_stop();
    const auto result = engine.analyse(snapshot({"O1.nc"}), stop.get_token());
    EXPECT_TRUE(result.cancelled);
    EXPECT_THAT(places(result), IsEmpty());
    EXPECT_FALSE(engine.analyse(snapshot({"O1.nc"})).cancelled);
}

TEST_F(EngineTest, AnOpenTextCountsMoreThanTheFile) {
    folder.write("O1.nc", jumps_nowhere);
    auto files = snapshot({"O1.nc"});
    files.files[0].text = Source::from_bytes(files.files[0].input.path, "O1\nM30\n");
    EXPECT_THAT(places(engine.analyse(files)), IsEmpty());
}

/// What is found, message and path included, file by file.
std::map<std::string, std::vector<std::string>> by_file(const cli::Result& result) {
    std::map<std::string, std::vector<std::string>> files;
    for (const auto& [finding, suppressed] : result.findings) {
        std::string text = finding.message() + (suppressed ? " suppressed" : "");
        for (const RelatedLocation& step : finding.path)
            text += "; " + std::to_string(step.span.begin) + " " + step.text;
        files[finding.source->path()].push_back(std::to_string(finding.span.begin) + " " + text);
    }
    return files;
}

/// Asks for every `each`-th file of the folder alone: the rest of the folder is there all the same.
void expect_same_alone(const std::string& folder, std::size_t each) {
    cli::Settings settings({});
    cli::Progress progress(cli::Progress::Shown::never);
    auto snapshot = cli::snapshot_of(cli::discover({folder}, "", settings).files, settings);
    cli::Engine engine({.jobs = 2, .kept_bytes = 100'000'000}, progress);
    const auto together = by_file(engine.analyse(snapshot));
    for (cli::SnapshotFile& file : snapshot.files) file.input.asked = false;
    for (std::size_t i = 0; i < snapshot.files.size(); i += each) {
        cli::SnapshotFile& file = snapshot.files[i];
        file.input.asked = true;
        const auto alone = by_file(engine.analyse(snapshot));
        file.input.asked = false;
        const auto expected = together.find(file.input.path);
        ASSERT_EQ(alone.size(), expected == together.end() ? 0U : 1U) << file.input.path;
        if (!alone.empty()) {
            ASSERT_EQ(*alone.begin(), *expected);
        }
    }
    EXPECT_GT(snapshot.files.size(), 50U);
}

TEST(EngineOnPrograms, FindsTheSameInAFileAloneAsInAllOfTheFolder) {
    expect_same_alone(MACLINT_SOURCE_DIR "/corpus", 1);
}

TEST(EngineOnPrograms, FindsTheSameInProgramsOfOthers) {
    const std::string folder = MACLINT_SHARED "/corpus/fanuc-macro";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "there is nothing at " << folder;
    expect_same_alone(folder, 7);
}

} // namespace
} // namespace maclint::test
