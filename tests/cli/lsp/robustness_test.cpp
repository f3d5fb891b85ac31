//! Every request at places and in documents that there are not, in any order, between edits; huge texts.
#include "cli/lsp/features/features.hpp"
#include "tests/cli/lsp/scripted_session.hpp"

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace maclint::test {
namespace {

constexpr int internal_error = -32603;

/// Parameters that fit any request, at one place of a document.
Json params_at(const std::string& uri, const Json& from, const Json& to) {
    return {{"textDocument", {{"uri", uri}, {"version", 1}}},
            {"position", from},
            {"range", {{"start", from}, {"end", to}}},
            {"context", {{"includeDeclaration", true}, {"diagnostics", Json::array()}}},
            {"newName", "OTHER"},
            {"command", "maclint.renumber"},
            {"arguments", {uri}},
            {"item", {{"data", {{"path", "/nowhere"}, {"program", 0}}}}},
            {"data", {{"uri", uri}, {"word", "G1"}}}};
}

/// One answer, which is no confession.
void expect_answer(ScriptedSession& session, std::string_view method, const Json& params) {
    const Json answer = session.ask(method, params);
    EXPECT_NE(answer.contains("result"), answer.contains("error")) << method << params << answer;
    if (answer.contains("error")) {
        EXPECT_NE(answer["error"]["code"], internal_error) << method << params << answer;
    }
}

const std::vector<std::pair<std::string, std::string>>& texts() {
    static const std::vector<std::pair<std::string, std::string>> all = {
        {"fanuc",
         "%\nO1(MAIN)\n#100=5.\nWHILE[#1LT5]DO1\nG65P9100A#100\nEND1\nGOTO50\nN50G83X1.Q#[1]\nT0101\nM30\n"
         "O9100\nG1X[#24+#5041](\xC3\x9C)\nM99\n%\n"},
        {"sinumerik",
         "PROC A(INT B)\nDEF REAL _LEN=5\nANFANG:\nG1 X=_LEN\nIF B>5 GOTOF ENDE\nCALL \"SUB\"\nSUB(5)\n"
         "GOTOB ANFANG\nENDE:\nM30\n"},
        {"dinplus", "%A.nc\nMACHINING\nN1 #l1=SQRT(5)\nN2 G860 NS1 NE2\nN3 L\"SUB\" V1 LA5\nN4 M30\nEND\n"},
        {"fanuc", ""},
        {"fanuc", "\n\n%"},
        {"sinumerik", "\xEF\xBB\xBF;\n"},
        {"fanuc", "O1\n\xFF\xFE#\xC3(\nG65P\nGOTO\n#="}};
    return all;
}

TEST(LspRobustness, AnswersEveryRequestAtEveryPlace) {
    ScriptedSession session;
    session.begin(Json::object());
    int number = 0;
    for (const auto& [language, text] : texts()) {
        const std::string name = "P" + std::to_string(number++) + ".nc";
        session.send("textDocument/didOpen", {{"textDocument",
                                               {{"uri", session.uri(name)},
                                                {"languageId", language},
                                                {"version", 1},
                                                {"text", Json::parse(cli::lsp::text_of(text))}}}});
        for (const cli::lsp::Method& method : cli::lsp::feature_methods())
            for (const int line : {0, 2, 3, 4, 7, 100000})
                for (const int character : {0, 4, 7, 2000000000})
                    expect_answer(session, method.name,
                                  params_at(session.uri(name), place(line, character), place(line + 1, 0)));
    }
}

TEST(LspRobustness, RefusesDocumentsThatAreClosedAndParametersThatAreNone) {
    ScriptedSession session;
    session.begin(Json::object());
    session.open("O1.nc", texts().front().second, "fanuc");
    session.send("textDocument/didClose", {{"textDocument", {{"uri", session.uri("O1.nc")}}}});
    for (const cli::lsp::Method& method : cli::lsp::feature_methods()) {
        expect_answer(session, method.name, params_at(session.uri("O1.nc"), place(2, 2), place(3, 0)));
        for (const Json& params : {Json(), Json(5), Json::array({1}), Json::object(),
                                   Json({{"textDocument", nullptr}, {"item", 5}, {"data", "x"}})})
            expect_answer(session, method.name, params);
        expect_answer(session, method.name, params_at(session.uri("O1.nc"), place(-1, -5), "nowhere"));
    }
}

TEST(LspRobustness, StandsDisorderedMessages) {
    constexpr unsigned seed = 44, rounds = 400;
    std::mt19937 random(seed);
    const auto below = [&](std::size_t most) { return random() % most; };
    ScriptedSession session;
    session.begin(Json::object());
    const auto methods = cli::lsp::feature_methods();
    for (unsigned round = 0; round < rounds; ++round) {
        const auto& [language, text] = texts()[below(3)];
        const std::string name = "O" + std::to_string(below(3)) + ".nc";
        std::string changed = text.substr(below(text.size()));
        if (below(2) == 0) changed.insert(below(changed.size() + 1), texts()[below(3)].second);
        switch (below(5)) {
        case 0:
            session.open(name, Json::parse(cli::lsp::text_of(changed)).get<std::string>(), language);
            break;
        case 1:
            session.change(name, Json::parse(cli::lsp::text_of(changed)).get<std::string>(),
                           static_cast<int>(round));
            break;
        case 2:
            session.send("textDocument/didClose", {{"textDocument", {{"uri", session.uri(name)}}}});
            break;
        default: {
            const Json from = place(static_cast<int>(below(16)), static_cast<int>(below(30)));
            expect_answer(session, methods[below(methods.size())].name,
                          params_at(session.uri(name), from, place(static_cast<int>(below(16)), 0)));
        }
        }
    }
    EXPECT_TRUE(session.result("shutdown", Json()).is_null());
}

TEST(LspRobustness, AnswersInAProgramOfAHundredMegabytes) {
    constexpr std::size_t size = std::size_t{100} << 20U;
    ScriptedSession session;
    session.begin(Json::object());
    std::string message =
        R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":{"textDocument":{"uri":")" +
        session.uri("O1.nc") +
        R"(","languageId":"fanuc","version":1,"text":")"
        R"(%\nO1(LONG)\n#100=5.\nG65P9100A#100\n)";
    const std::string blocks = R"(G1X1.234Y5.678F100\nX2.345Y6.789\nX3.456Y7.891Z-1.\n)";
    while (message.size() < size) message += blocks;
    message += R"(N50T0101\nGOTO50\nM30\n%\n"}}})";
    session.send_text(message);
    for (const cli::lsp::Method& method : cli::lsp::feature_methods()) {
        for (const int line : {3, 1000000})
            expect_answer(session, method.name,
                          params_at(session.uri("O1.nc"), place(line, 2), place(line + 50, 0)));
    }
}

} // namespace
} // namespace maclint::test
