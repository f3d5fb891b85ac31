//! What .maclint.json may say, and what its author is told when it says something else.
#include "analyzer/program/shop_demands.hpp"
#include "analyzer/program/tables.hpp"
#include "cli/config/configuration.hpp"
#include "cli/config/json_tree.hpp"
#include "cli/config/settings.hpp"
#include "tests/support/folder.hpp"

#include <chrono>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

std::shared_ptr<const Configuration> load(const TemporaryFolder& folder, std::string_view text) {
    auto result = load_configuration(folder.write(".maclint.json", text), Reach::of_folder(folder.path()));
    if (const auto* notice = std::get_if<Notice>(&result)) ADD_FAILURE() << notice->message;
    return std::get<0>(result);
}

std::string refusal(std::string_view text) {
    const TemporaryFolder folder;
    auto result = load_configuration(folder.write(".maclint.json", text), Reach::of_folder(folder.path()));
    const auto* notice = std::get_if<Notice>(&result);
    return notice == nullptr ? "accepted" : notice->message;
}

const RuleState& state(const FileSettings& settings, std::string_view code) {
    return settings.rules->of(*find_rule(code));
}

TEST(JsonTree, KnowsWhereKeysAndValuesStand) {
    const std::string_view text = "// head\n{ \"a\\\"b\": [\"x\", 12] }";
    const auto parsed = parse_json(text);
    const auto& object = std::get<JsonNode::Object>(std::get<JsonNode>(parsed).value);
    ASSERT_EQ(object.size(), 1U);
    EXPECT_EQ(object[0].key, "a\"b");
    EXPECT_EQ(text.substr(object[0].key_span.begin, object[0].key_span.length()), "\"a\\\"b\"");
    const auto& list = std::get<JsonNode::Array>(object[0].node.value);
    EXPECT_EQ(text.substr(list[0].span.begin, list[0].span.length()), "\"x\"");
    EXPECT_EQ(text.substr(list[1].span.begin, list[1].span.length()), "12");
}

TEST(JsonTree, KnowsWhereNumbersStandWhateverFollows) {
    for (const std::string_view text :
         {"-1.5e+2", "[-1.5e+2]", "[-1.5e+2,3]", "[-1.5e+2\n]", "[-1.5e+2/**/]"}) {
        const auto parsed = parse_json(text);
        const auto* node = &std::get<JsonNode>(parsed);
        if (const auto* list = std::get_if<JsonNode::Array>(&node->value)) node = &list->front();
        EXPECT_EQ(text.substr(node->span.begin, node->span.length()), "-1.5e+2") << text;
    }
}

TEST(JsonTree, RefusesWhatIsNoJson) {
    EXPECT_TRUE(std::holds_alternative<JsonError>(parse_json("")));
    EXPECT_TRUE(std::holds_alternative<JsonError>(parse_json("{\"a\":}")));
    EXPECT_TRUE(std::holds_alternative<JsonError>(parse_json("{\"a\":1,\"a\":2}")));
    EXPECT_TRUE(std::holds_alternative<JsonError>(parse_json(std::string(100'000, '['))));
    EXPECT_TRUE(std::holds_alternative<JsonError>(parse_json("\"\xFF\"")));
}

TEST(JsonTree, TakesACommaBeforeAClosingBracket) {
    const auto parsed = parse_json("{ \"a\": [1, 2, /* last, */ ], // and\n \"b,]\": \",}\\\",}\", }");
    ASSERT_TRUE(std::holds_alternative<JsonNode>(parsed));
    const auto& object = std::get<JsonNode::Object>(std::get<JsonNode>(parsed).value);
    ASSERT_EQ(object.size(), 2U);
    EXPECT_EQ(std::get<JsonNode::Array>(object[0].node.value).size(), 2U);
    EXPECT_EQ(std::get<std::string>(object[1].node.value), ",}\",}");
    EXPECT_TRUE(std::holds_alternative<JsonError>(parse_json("[1,,]")));
    EXPECT_TRUE(std::holds_alternative<JsonError>(parse_json("{\"a\": 1 \"b\": 2}")));
}

TEST(Configuration, TellsWhatToWriteInPlaceOfWhatIsNoJson) {
    EXPECT_EQ(refusal("{\n 'select': []}"),
              "line 2, column 2: texts stand in double quotes. Write \" in place of '.");
    EXPECT_EQ(refusal("{\n \"exclude\": [old]}"),
              "line 2, column 14: a word has no quotes. Write it in \" \".");
    EXPECT_THAT(
        refusal("{ \"exclude\": [\"mill\\*.nc\"]}"),
        AllOf(HasSubstr("a backslash stands for nothing here"), HasSubstr("Write '/' between folders")));
    EXPECT_THAT(refusal("{ \"exclude\": [\"a\" \"b\"]}"), HasSubstr("a comma is missing before this"));
    EXPECT_THAT(refusal("{ \"exclude\": [\"a\"]"), HasSubstr("the file ends too early"));
}

TEST(Configuration, RefusesBackslashesInGlobs) {
    for (const char* text :
         {R"({"exclude": ["mill\\*.nc"]})", R"({"include": ["mill\\*.nc"]})",
          R"({"vendor": ["!mill\\*.nc"]})", R"({"files": [{"glob": "mill\\*.nc", "control": "fanuc"}]})",
          R"({"per-file-ignores": {"mill\\*.nc": ["MAC501"]}})"})
        EXPECT_THAT(refusal(text), HasSubstr(R"(Write "mill/*.nc".)")) << text;
}

TEST(Configuration, SaysWhereRulesBelongThatStandAtTheWrongPlace) {
    EXPECT_THAT(refusal(R"({"MAC501": "off"})"),
                HasSubstr(R"(Write "ignore": [ "MAC501" ] to switch it off)"));
    EXPECT_THAT(refusal(R"({"severity": {"MAC501": "off"}})"), HasSubstr(R"(or "ignore": [ "MAC501" ])"));
    EXPECT_THAT(refusal(R"({"severity": {"MAC501": "default"}})"), HasSubstr("leave it out"));
    EXPECT_THAT(refusal(R"({"rules": {"MAC501": "off"}})"), HasSubstr("'select', 'ignore' and 'severity'"));
    EXPECT_THAT(refusal(R"({"control": "fanuc-30i"})"), HasSubstr(R"("files": [ { "glob": "**", "control")"));
    EXPECT_THAT(refusal(R"({"ignores": ["MAC501"]})"), HasSubstr("switched off in 'ignore'"));
    EXPECT_THAT(refusal(R"({"sevrity": {}})"), HasSubstr("Did you mean 'severity'?"));
}

TEST(Configuration, RefusesLimitsBelowZeroButForPositions) {
    const auto with = [](std::string_view limits) {
        return refusal(R"({"controls": {"M": {"model": "fanuc-16i", "limits": )" + std::string(limits) +
                       "}}}");
    };
    EXPECT_THAT(with(R"({"speed": -5})"), HasSubstr("'speed' is -5, and nothing is less than 0"));
    EXPECT_THAT(with(R"({"tool": [-1, 24]})"), HasSubstr("'tool' is -1"));
    EXPECT_THAT(with(R"({"feed-per-minute": [-20, -10]})"), HasSubstr("'feed-per-minute' is -20"));
    EXPECT_EQ(with(R"({"Z": [-410, -5], "X": -5, "speed": 0})"), "accepted");
}

TEST(Configuration, KnowsWhichFileOfAChainSaysWhat) {
    const TemporaryFolder folder;
    folder.write("shop.json", R"({"ignore": ["MAC501"], "vendor": ["old"], "severity": {"MAC502": "error"},
        "files": [{"glob": "*.nc", "control": "fanuc-16i"}], "per-file-ignores": {"*.nc": ["MAC503"]}})");
    const auto configuration =
        load(folder, R"({"extends": "shop.json", "complete": true, "severity": {"MAC301": "note"}})");
    EXPECT_THAT(configuration->said_in("complete"), testing::EndsWith(".maclint.json: complete"));
    EXPECT_THAT(configuration->said_in("vendor"), testing::EndsWith("shop.json: vendor"));
    EXPECT_THAT(configuration->said_in("ignore"), testing::EndsWith("/shop.json: ignore"));
    Settings settings({});
    const auto file = settings.for_file((folder.path() / "O1.nc").string());
    EXPECT_THAT(file->controls.front().reason, HasSubstr("/shop.json: files '*.nc'"));
    const auto reason = [&](std::string_view code) { return file->rules->reason_of(state(*file, code)); };
    EXPECT_THAT(reason("MAC501"), testing::EndsWith("/shop.json: ignore"));
    EXPECT_THAT(reason("MAC502"), testing::EndsWith("/shop.json: severity"));
    EXPECT_THAT(reason("MAC503"), HasSubstr("/shop.json: per-file-ignores"));
    EXPECT_THAT(reason("MAC301"), testing::EndsWith(".maclint.json: severity"));
}

TEST(Configuration, SaysWhichControlAndDialectFilesAreFor) {
    const TemporaryFolder folder;
    folder.write(".maclint.json", R"({
        // the lathe has one macro level more
        "controls": {"L1": {"model": "fanuc-16i", "limits": {"macro-calls": 5}}},
        "files": [{"glob": "lathe/**", "control": "L1", "dialect": "fanuc"}]})");
    Settings settings({});
    const auto lathe = settings.for_file((folder.path() / "lathe/O1.nc").string());
    ASSERT_TRUE(lathe);
    ASSERT_EQ(lathe->controls.size(), 1U);
    EXPECT_EQ(lathe->controls.front().control->limits.macro_calls, 5);
    EXPECT_FALSE(lathe->controls.front().control->assumed);
    EXPECT_EQ(lathe->dialect, find_dialect("fanuc"));
    const auto mill = settings.for_file((folder.path() / "mill/O1.nc").string());
    ASSERT_TRUE(mill);
    EXPECT_THAT(mill->controls, IsEmpty());
}

TEST(Configuration, GivesAControlOfTheShopItsLathe) {
    const TemporaryFolder folder;
    const auto configuration = load(folder, R"({"controls": {
        "any": {"model": "fanuc-30i", "limits": {"macro-calls": 9}},
        "turning": {"model": "fanuc-30i", "machine": "lathe", "limits": {"macro-calls": 9}},
        "milling": {"machine": "mill", "model": "fanuc-30i"},
        "lathe": {"model": "fanuc-30i-lathe"},
        "nct": {"model": "nct"}}})");
    const ControlModel& any = *configuration->control("any");
    EXPECT_EQ(any.machine, Machine::mill);
    ASSERT_EQ(any.lathes.size(), 3U);
    EXPECT_EQ(any.lathes.front()->machine, Machine::lathe);
    EXPECT_EQ(any.lathes.front()->name, "fanuc-30i-lathe");
    EXPECT_EQ(any.lathes.front()->limits.macro_calls, 9);
    EXPECT_FALSE(any.lathes.front()->assumed);
    EXPECT_THAT(any.lathes.front()->description, HasSubstr("any (FANUC Series 30i"));
    EXPECT_EQ(configuration->control("turning")->machine, Machine::lathe);
    EXPECT_EQ(configuration->control("turning")->limits.macro_calls, 9);
    EXPECT_EQ(configuration->control("milling")->machine, Machine::mill);
    EXPECT_THAT(configuration->control("milling")->lathes, IsEmpty())
        << "the user knows better than the text";
    EXPECT_EQ(configuration->control("lathe")->machine, Machine::lathe);
    EXPECT_THAT(configuration->control("nct")->lathes, IsEmpty());
    EXPECT_THAT(refusal(R"({"controls": {"L1": {"model": "nct", "machine": "lathe"}}})"),
                HasSubstr("'nct' is not known for a lathe"));
    EXPECT_THAT(refusal(R"({"controls": {"L1": {"model": "haas-lathe", "machine": "mill"}}})"),
                HasSubstr("'haas-lathe' is not known for a mill"));
    EXPECT_THAT(refusal(R"({"controls": {"L1": {"model": "haas", "machine": "grinder"}}})"),
                HasSubstr("Write mill or lathe"));
}

TEST(Configuration, NamesTheGcodeSystemOfALathe) {
    const TemporaryFolder folder;
    const auto configuration = load(folder, R"({"controls": {
        "turning": {"gcode-system": "B", "machine": "lathe", "model": "fanuc-30i"},
        "either": {"model": "fanuc-30i", "gcode-system": "C"},
        "lathe": {"model": "fanuc-30i-lathe", "gcode-system": "A"}}})");
    EXPECT_EQ(configuration->control("turning")->code_system, 'B');
    EXPECT_EQ(configuration->control("either")->machine, Machine::mill);
    ASSERT_EQ(configuration->control("either")->lathes.size(), 1U) << "the text tells the machine alone";
    EXPECT_EQ(configuration->control("either")->lathes.front()->code_system, 'C');
    EXPECT_EQ(configuration->control("lathe")->code_system, 'A');
    EXPECT_THAT(refusal(R"({"controls": {"c": {"model": "fanuc-30i", "gcode-system": "D"}}})"),
                HasSubstr("Write A, B or C"));
    EXPECT_THAT(refusal(R"({"controls": {"c": {"model": "haas", "gcode-system": "B"}}})"),
                HasSubstr("'haas' is not known with G code system B"));
}

TEST(Configuration, SetsLoopNumbersAndBlockIf) {
    const TemporaryFolder folder;
    const auto configuration = load(folder, R"({"controls": {
        "plus": {"model": "fanuc-0i-d", "block-if": true, "limits": {"loop-numbers": 15}},
        "old": {"model": "mitsubishi", "block-if": false}, "plain": {"model": "mitsubishi"}}})");
    EXPECT_TRUE(configuration->control("plus")->has_block_if);
    EXPECT_EQ(configuration->control("plus")->limits.last_loop_number, 15);
    EXPECT_FALSE(configuration->control("old")->has_block_if);
    EXPECT_TRUE(configuration->control("plain")->has_block_if);
    EXPECT_THAT(refusal(R"({"controls": {"c": {"model": "haas", "block-if": "yes"}}})"),
                HasSubstr("'block-if' must be true or false"));
}

TEST(Configuration, NamesTheMCodesThatStopLookAhead) {
    const TemporaryFolder folder;
    const auto configuration = load(folder, R"({"controls": {
        "named": {"model": "fanuc-30i", "stops-look-ahead": ["M25", "M40-M49"]},
        "none": {"model": "fanuc-30i", "stops-look-ahead": []},
        "unknown": {"model": "fanuc-30i"}}})");
    const MachineFunctions& named = configuration->control("named")->functions;
    EXPECT_TRUE(named.may_stop_look_ahead(25) && named.may_stop_look_ahead(40) &&
                named.may_stop_look_ahead(49));
    EXPECT_FALSE(named.may_stop_look_ahead(8) || named.may_stop_look_ahead(26) ||
                 named.may_stop_look_ahead(50));
    EXPECT_FALSE(configuration->control("none")->functions.may_stop_look_ahead(25));
    EXPECT_TRUE(configuration->control("unknown")->functions.may_stop_look_ahead(25));
    EXPECT_TRUE(configuration->control("named")->lathes.front()->functions.may_stop_look_ahead(25));
    EXPECT_FALSE(configuration->control("named")->lathes.front()->functions.may_stop_look_ahead(8));
    for (const char* bad : {"25", "M", "G25", "M2.5", "M-5", "M49-M40", "M40-49", "M40-", "M99999999999"})
        EXPECT_THAT(refusal(std::string(R"({"controls": {"c": {"model": "nct", "stops-look-ahead": [")") +
                            bad + R"("]}}})"),
                    AllOf(HasSubstr(bad), HasSubstr("is no M code")))
            << bad;
    EXPECT_THAT(refusal(R"({"controls": {"c": {"model": "nct", "stops-look-ahead": "M25"}}})"),
                HasSubstr("must be a list"));
    EXPECT_THAT(refusal(R"({"controls": {"c": {"model": "nct", "stops-look-ahead": [25]}}})"),
                HasSubstr("must be a text"));
}

TEST(Configuration, TakesWhatTheShopDemands) {
    const TemporaryFolder folder;
    const auto configuration = load(folder, R"({"controls": {
        "mill": {"model": "fanuc-30i", "limits": {"speed": [50, 8000], "X": [-5.5, 600], "macro-calls": 3},
                 "at-end": ["G91G28 z0", "T"]},
        "plain": {"model": "fanuc-30i", "limits": {"macro-calls": 3}}}})");
    const ControlModel* mill = configuration->control("mill");
    ASSERT_NE(mill->demands, nullptr);
    EXPECT_EQ(mill->limits.macro_calls, 3);
    EXPECT_EQ(mill->demands->limits.speed.least, 50);
    EXPECT_EQ(mill->demands->limits.travel[0].greatest, 600);
    ASSERT_EQ(mill->demands->blocks.size(), 2U);
    const auto& words = mill->demands->blocks[0].words;
    ASSERT_EQ(words.size(), 3U);
    EXPECT_TRUE(words[1].letter == 'G' && words[1].number == 28 && words[2].letter == 'Z');
    EXPECT_FALSE(mill->demands->blocks[1].words[0].number);
    ASSERT_EQ(mill->lathes.size(), 3U);
    EXPECT_EQ(mill->lathes[0]->demands, mill->demands);
    EXPECT_EQ(configuration->control("plain")->demands, nullptr);
}

TEST(Configuration, TellsWhatIsNoDemand) {
    const auto of_control = [](const std::string& keys, const std::string& model) {
        return refusal(R"({"controls": {"c": {"model": ")" + model + "\", " + keys + "}}}");
    };
    EXPECT_THAT(of_control(R"("limits": {"speed": [8000, 50]})", "haas"), HasSubstr("Write the least first"));
    for (const char* bad : {"\"50\"", "[50]", "[1, 2, 3]", "[null, 3]", "true"})
        EXPECT_THAT(of_control(R"("limits": {"speed": )" + std::string(bad) + "}", "haas"),
                    HasSubstr("'speed' must be the greatest number, or the least and the greatest"))
            << bad;
    EXPECT_THAT(of_control(R"("limits": {"sped": 5})", "haas"), HasSubstr("Did you mean 'speed'?"));
    EXPECT_THAT(of_control(R"("at-end": "M9")", "haas"), HasSubstr("'at-end' must be a list of blocks"));
    for (const char* bad : {"", " ", "M", "N10 M9", "M9;", "(OFF)", "G28 Z[0]", "Z--1", "9"})
        EXPECT_THAT(of_control(R"("at-end": [")" + std::string(bad) + "\"]", "haas"),
                    HasSubstr("an entry of 'at-end' is no block of plain words"))
            << bad;
    EXPECT_THAT(of_control(R"("at-ends": [])", "haas"), HasSubstr("Did you mean 'at-end'?"));
    EXPECT_THAT(of_control(R"("at-end": ["M9"])", "dinplus"),
                HasSubstr("'at-end' is not known for the control"));
}

TEST(Configuration, TellsUnknownKeysWithTheirPlaceAndTheLikelyOne) {
    EXPECT_THAT(refusal("{\n  \"selct\": []\n}"), AllOf(HasSubstr("line 2, column 3"), HasSubstr("'selct'"),
                                                        HasSubstr("Did you mean 'select'?")));
    EXPECT_THAT(refusal(R"({"controls": {"L1": {"modle": "fanuc"}}})"), HasSubstr("has no 'model'"));
    EXPECT_THAT(refusal(R"({"controls": {"L1": {"model": "fanuc-16"}}})"),
                HasSubstr("Did you mean 'fanuc-16i'?"));
    EXPECT_THAT(refusal(R"({"files": [{"glob": "*", "control": "L1"}]})"), HasSubstr("no control 'L1'"));
    EXPECT_THAT(refusal(R"({"files": [{"control": "fanuc"}]})"), HasSubstr("no 'glob'"));
    EXPECT_THAT(refusal(R"({"files": [{"glob": "*", "dialect": "fanu"}]})"),
                HasSubstr("Did you mean 'fanuc'?"));
    EXPECT_THAT(refusal(R"({"severity": {"MAC301": "fatal"}})"), HasSubstr("error, warning or note"));
    EXPECT_THAT(refusal(R"({"encoding": "utf8"})"), HasSubstr("Did you mean 'utf-8'?"));
    EXPECT_THAT(refusal(R"({"words": {"M 53": "conveyor"}})"), HasSubstr("'M 53' is no word of a program"));
    EXPECT_THAT(refusal(R"({"words": {"M8": "a", "m08": "b"}})"), HasSubstr("says what 'M8' is twice"));
    EXPECT_THAT(refusal(R"({"words": {"M8": 8}})"), HasSubstr("what a word means must be a text"));
    EXPECT_THAT(refusal(R"({"words": ["M8"]})"), HasSubstr("'words' must be an object"));
    EXPECT_THAT(refusal(R"({"spacing": {"words": "two"}})"), HasSubstr("'words' is \"one\" or \"none\""));
    EXPECT_THAT(refusal(R"({"spacing": {"brackets": "one"}})"), HasSubstr("takes \"none\" alone"));
    EXPECT_THAT(refusal(R"({"spacing": {"word": "one"}})"), HasSubstr("Did you mean 'words'?"));
    EXPECT_THAT(refusal(R"({"ignore": "MAC301"})"), HasSubstr("must be a list"));
    EXPECT_THAT(refusal(R"({"complete": 1})"), HasSubstr("true or false"));
    EXPECT_THAT(refusal(R"({"known-names": ["A*B"]})"), HasSubstr("letters, digits and _"));
    EXPECT_THAT(refusal(R"({"known-names": ["*"]})"), HasSubstr("letters, digits and _"));
    EXPECT_THAT(refusal("{"), HasSubstr("the file ends too early"));
}

TEST(Configuration, RefusesWordsThatNameNoRuleWhereverTheyStand) {
    for (const std::string_view text :
         {R"({"select": ["MAC5", "MAC3O1"]})", R"({"ignore": ["MAC3O1"]})",
          R"({"severity": {"MAC3O1": "note"}})", R"({"per-file-ignores": {"*.nc": ["MAC3O1"]}})"})
        EXPECT_THAT(refusal(text), AllOf(HasSubstr("column " + std::to_string(text.find("\"MAC3O1\"") + 1)),
                                         HasSubstr("there is no rule 'MAC3O1'. Did you mean 'MAC301'?")))
            << text;
    EXPECT_THAT(refusal(R"({"select": ["JUMP"]})"),
                HasSubstr("Did you mean 'jump-target-missing' or 'jump-into-loop'?"));
    EXPECT_THAT(refusal(R"({"select": ["all", "mac3", "Jump-Into-Loop"]})"), "accepted");
}

/// Every text that a configuration may hold, with a hole in its place.
const std::vector<std::string>& texts() {
    static const std::vector<std::string> all = {
        R"({"extends": @})",
        R"({"baseline": @})",
        R"({"encoding": @})",
        R"({"words": {@: "conveyor"}})",
        R"({"words": {"M53": @}})",
        R"({"spacing": {"words": @}})",
        R"({"include": [@]})",
        R"({"exclude": ["a", @]})",
        R"({"select": [@]})",
        R"({"ignore": [@]})",
        R"({"severity": {@: "note"}})",
        R"({"severity": {"MAC301": @}})",
        R"({"per-file-ignores": {@: ["MAC301"]}})",
        R"({"per-file-ignores": {"*": [@]}})",
        R"({"files": [{"glob": @}]})",
        R"({"files": [{"glob": "*", "control": @}]})",
        R"({"files": [{"glob": "*", "dialect": @}]})",
        R"({"controls": {@: {"model": "fanuc-16i"}}})",
        R"({"controls": {"c": {"model": @}}})",
        R"({"controls": {"c": {"model": "fanuc-16i", "machine": @}}})",
        R"({"controls": {"c": {"model": "fanuc-16i", "stops-look-ahead": [@]}}})"};
    return all;
}

TEST(Configuration, RefusesTextsThatNameNothingWhereverTheyStand) {
    for (const std::string& text : texts())
        for (const auto& [value, reason] : {std::pair(R"("")", " is empty."),
                                            {R"(" \t")", " is empty."},
                                            {R"("a\u0000b")", " holds a NUL"}}) {
            const std::size_t hole = text.find('@');
            const std::string whole = std::string(text).replace(hole, 1, value);
            EXPECT_THAT(refusal(whole),
                        AllOf(testing::StartsWith("line 1, column " + std::to_string(hole + 1) + ": "),
                              HasSubstr(reason), testing::EndsWith(".")))
                << whole;
        }
}

TEST(Configuration, TakesTextsOfAnyLength) {
    const std::string longest = '"' + std::string(100'000, 'x') + '"';
    for (const std::string& text : texts()) {
        const std::string message = refusal(std::string(text).replace(text.find('@'), 1, longest));
        EXPECT_TRUE(message == "accepted" || message.ends_with('.') || message.ends_with('?')) << text;
    }
}

/// A list of `count` texts, made by `make` of their numbers.
template<class Make>
std::string list_of(int count, const Make& make) {
    std::string list;
    for (int i = 0; i < count; ++i) list += (i == 0 ? "" : ",") + make(std::to_string(i));
    return list;
}

/// What took a minute, or a gigabyte, when each was compared with all others or made at once.
TEST(Configuration, OfAHundredThousandKeysAndControlsIsReadInSeconds) {
    constexpr int many = 100'000;
    const auto begun = std::chrono::steady_clock::now();
    EXPECT_THAT(refusal("{" + list_of(many, [](const auto& i) { return "\"k" + i + "\":1"; }) + ",\"k7\":1}"),
                HasSubstr("the key 'k7' stands here a second time"));
    EXPECT_THAT(
        refusal("{\"controls\":{" +
                list_of(many, [](const auto& i) { return "\"c" + i + "\":{\"model\":\"nct\"}"; }) +
                "},\"files\":[" +
                list_of(many,
                        [](const auto& i) { return R"({"glob":"a)" + i + R"(","control":"c)" + i + "\"}"; }) +
                "],\"per-file-ignores\":{" +
                list_of(many, [](const auto& i) { return "\"" + i + "*\":[\"ALL\"]"; }) + "}}"),
        "accepted");
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(30));
}

TEST(Configuration, OfTenThousandGlobsIsAskedOfAThousandFilesInSeconds) {
    const TemporaryFolder folder;
    const auto glob = [](const char* before, const char* behind) {
        return list_of(10'000, [&](const auto& i) { return '"' + (before + i) + behind + '"'; });
    };
    folder.write(
        ".maclint.json",
        "{\"exclude\":[" + glob("old", "*.nc") + "," + glob("**/a/", ".nc") + "],\"files\":[" +
            list_of(10'000, [](const auto& i) { return R"({"glob":"*/x)" + i + R"(/*","control":"nct"})"; }) +
            "],\"per-file-ignores\":{" +
            list_of(10'000, [](const auto& i) { return "\"*" + i + ".nc\":[\"ALL\"]"; }) + "}}");
    Settings settings({});
    const auto begun = std::chrono::steady_clock::now();
    for (int i = 0; i < 1'000; ++i) {
        const std::string path =
            (folder.path() / ("b/x" + std::to_string(i) + "/O" + std::to_string(i) + ".nc")).string();
        const auto found = settings.for_file(path);
        ASSERT_EQ(found->controls.size(), 1U) << path;
        ASSERT_FALSE(state(*found, "MAC301").on) << path;
        ASSERT_FALSE(found->configuration->exclude.takes(path)) << path;
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(20));
}

TEST(Configuration, TakesOfManyEntriesTheLastForEachLanguage) {
    const TemporaryFolder folder;
    folder.write(".maclint.json", R"({"files": [{"glob": "*", "control": "fanuc-16i"},
        {"glob": "O*", "control": "dinplus"}, {"glob": "*", "control": "fanuc-30i", "dialect": "fanuc"},
        {"glob": "*.nc", "dialect": "auto"}, {"glob": "P*", "dialect": "fanuc", "control": "nct"}]})");
    Settings settings({});
    const auto found = settings.for_file((folder.path() / "O1.nc").string());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->dialect, nullptr);
    EXPECT_THAT(found->dialect_reason, testing::EndsWith(".maclint.json: files '*.nc'"));
    EXPECT_EQ(control_for(*find_dialect("fanuc"), found->controls)->control->name, "fanuc-30i");
    EXPECT_EQ(control_for(*find_dialect("dinplus"), found->controls)->control->name, "dinplus");
}

TEST(Configuration, RefusesToSelectNothing) {
    EXPECT_THAT(refusal("{\n \"select\": []}"),
                AllOf(HasSubstr("line 2, column "), HasSubstr("'select' is empty")));
    EXPECT_THAT(refusal(R"({"ignore": [], "include": [], "exclude": [], "files": [], "controls": {}})"),
                "accepted");
}

TEST(Configuration, OfTheNearestFolderUpwardHolds) {
    const TemporaryFolder folder;
    folder.write(".maclint.json", R"({"ignore": ["MAC301"]})");
    folder.write("a/.maclint.json", R"({"ignore": ["MAC303"]})");
    Settings settings({});
    const auto near = settings.for_file((folder.path() / "a/b/O1.nc").string());
    const auto far = settings.for_file((folder.path() / "c/O1.nc").string());
    EXPECT_TRUE(state(*near, "MAC301").on);
    EXPECT_FALSE(state(*near, "MAC303").on);
    EXPECT_FALSE(state(*far, "MAC301").on);
}

TEST(Configuration, ExtendsAnotherAndReplacesItsLists) {
    const TemporaryFolder folder;
    folder.write(
        "shop.json",
        R"({"ignore": ["MAC301"], "complete": true, "severity": {"MAC501": "error", "MAC503": "note"}})");
    const auto configuration =
        load(folder, R"({"extends": "shop.json", "ignore": ["MAC303"], "severity": {"MAC501": "note"}})");
    ASSERT_EQ(configuration->ignore.size(), 1U);
    EXPECT_EQ(configuration->ignore[0].word, "MAC303");
    EXPECT_TRUE(configuration->complete);
}

TEST(Configuration, MergesTheWordsOfTheShopByOneSpelling) {
    const TemporaryFolder folder;
    folder.write("shop.json", R"({"words": {"M8": "coolant", "#0550": "probe"}})");
    const auto configuration = load(folder, R"({"extends": "shop.json", "words": {"m08": "gun drill"}})");
    EXPECT_EQ(configuration->words, (ShopWords{{"M8", "gun drill"}, {"#550", "probe"}}));
    EXPECT_EQ(*meaning_in(configuration->words, "M008"), "gun drill");
    EXPECT_EQ(meaning_in(configuration->words, "M80"), nullptr);
    EXPECT_EQ(one_spelling("g054.10"), "G54.10");
    EXPECT_EQ(one_spelling("M00"), "M0");
    EXPECT_EQ(one_spelling("M 8"), std::nullopt);
}

TEST(Configuration, GivesTheNearerFileAndTheNarrowerWordTheLastWordOnSeverities) {
    const TemporaryFolder folder;
    folder.write("shop.json", R"({"severity": {"MAC3": "note", "MAC7": "note", "MAC502": "error"}})");
    folder.write(".maclint.json", R"({"extends": "shop.json",
        "severity": {"MAC301": "error", "MAC501": "error", "MAC5": "note", "MAC711": "error"}})");
    Settings settings({});
    const auto own = settings.for_file((folder.path() / "O1.nc").string());
    ASSERT_TRUE(own);
    EXPECT_EQ(state(*own, "MAC301").severity, Severity::error);
    EXPECT_EQ(state(*own, "MAC303").severity, Severity::note);
    EXPECT_EQ(state(*own, "MAC501").severity, Severity::error);
    EXPECT_EQ(state(*own, "MAC502").severity, Severity::note);
    EXPECT_EQ(state(*own, "MAC711").severity, Severity::error);
    EXPECT_EQ(state(*own, "MAC220").severity, std::nullopt);
}

TEST(Configuration, ThatExtendsItselfIsRefused) {
    EXPECT_THAT(refusal(R"({"extends": ".maclint.json"})"), HasSubstr("circle"));
}

TEST(Settings, LayTheCommandLineOverTheConfiguration) {
    const TemporaryFolder folder;
    folder.write(".maclint.json",
                 R"({"select": ["MAC3"], "ignore": ["MAC303"], "per-file-ignores": {"O9*": ["MAC301"]}})");
    const std::string file = (folder.path() / "O1.nc").string();
    Settings configured({});
    EXPECT_TRUE(state(*configured.for_file(file), "MAC301").on);
    EXPECT_FALSE(state(*configured.for_file(file), "MAC303").on);
    EXPECT_FALSE(state(*configured.for_file(file), "MAC501").on);
    EXPECT_FALSE(state(*configured.for_file((folder.path() / "O9001.nc").string()), "MAC301").on);
    Overrides overrides;
    overrides.select = {"jump-into-loop"};
    overrides.severity = {{"MAC303", Severity::note}};
    Settings overridden(overrides);
    EXPECT_TRUE(state(*overridden.for_file(file), "MAC303").on);
    EXPECT_EQ(state(*overridden.for_file(file), "MAC303").severity, Severity::note);
    EXPECT_FALSE(state(*overridden.for_file(file), "MAC301").on);
}

TEST(Settings, OfAFileUnderAWrongConfigurationAreNotKnown) {
    const TemporaryFolder folder;
    folder.write(".maclint.json", "{]");
    Settings settings({});
    EXPECT_FALSE(settings.for_file((folder.path() / "O1.nc").string()));
    EXPECT_FALSE(settings.for_file((folder.path() / "O2.nc").string()));
    EXPECT_EQ(settings.take_notices().size(), 1U);
    EXPECT_THAT(settings.take_notices(), IsEmpty());
}

} // namespace
} // namespace maclint::cli
