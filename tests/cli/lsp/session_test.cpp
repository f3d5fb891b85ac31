//! The phases of a session, and messages that make no sense.
#include "tests/cli/lsp/scripted_session.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using cli::lsp::Server;
using testing::ElementsAre;

int code_of(const Json& answer) { return answer["error"]["code"].get<int>(); }

TEST(LspSession, SaysWhatItCanInTheEncodingThatTheClientWants) {
    ScriptedSession session;
    const Json answer = session.begin({{"general", {{"positionEncodings", {"utf-32", "utf-8", "utf-16"}}}}});
    EXPECT_EQ(answer["capabilities"]["positionEncoding"], "utf-8");
    EXPECT_EQ(answer["capabilities"]["textDocumentSync"]["change"], 2);
    EXPECT_EQ(answer["serverInfo"]["name"], "maclint");
    ScriptedSession other;
    EXPECT_EQ(other.begin(Json::object())["capabilities"]["positionEncoding"], "utf-16");
}

TEST(LspSession, AnswersWhatComesTooEarlyTooLateOrTwiceWithAnError) {
    ScriptedSession session;
    EXPECT_EQ(code_of(session.ask("textDocument/codeAction", Json::object())), -32002);
    session.send("textDocument/didOpen", Json::object());
    session.begin(Json::object());
    EXPECT_EQ(code_of(session.ask("initialize", Json::object())), -32600);
    EXPECT_EQ(code_of(session.ask("textDocument/unheardOf", Json::object())), -32601);
    session.send("$/unheardOf", Json::object());
    EXPECT_TRUE(session.result("shutdown", Json()).is_null());
    EXPECT_EQ(code_of(session.ask("textDocument/codeAction", Json::object())), -32600);
}

TEST(LspSession, RefusesParametersThatAreMissingOrOfAnotherKind) {
    ScriptedSession session;
    session.begin(Json::object());
    EXPECT_EQ(code_of(session.ask("textDocument/codeAction", Json::array())), -32602);
    EXPECT_EQ(code_of(session.ask("textDocument/codeAction", {{"textDocument", {{"uri", 5}}}})), -32602);
    EXPECT_EQ(code_of(session.ask("textDocument/codeAction", {{"textDocument", {{"uri", "file:///O1.nc"}}}})),
              -32602);
    session.send("textDocument/didChange", {{"textDocument", {{"uri", "file:///O1.nc"}, {"version", 2}}}});
    EXPECT_THAT(session.next("window/logMessage")["params"]["message"].get<std::string>(),
                testing::HasSubstr("is not open"));
}

TEST(LspSession, AnswersEachTextThatIsNoMessageOnce) {
    ScriptedSession session;
    session.begin(Json::object());
    const std::size_t before = session.said().size();
    for (const char* text : {"", "{", "\xFF\xFE", "{\"jsonrpc\":\"2.0\"", "nul"}) session.send_text(text);
    for (const char* text : {"[]", "5", "{}", "{\"method\":5,\"id\":1}", "{\"method\":\"x\",\"id\":{}}"})
        session.send_text(text);
    session.send_text("{\"jsonrpc\":\"2.0\",\"id\":\"maclint-1\",\"result\":null}"); // an answer to ours
    std::vector<int> codes;
    const auto said = session.said();
    for (std::size_t i = before; i < said.size(); ++i)
        if (said[i].contains("error")) codes.push_back(code_of(said[i]));
    EXPECT_THAT(codes,
                ElementsAre(-32700, -32700, -32700, -32700, -32700, -32600, -32600, -32600, -32600, -32600));
    session.send_text(std::string(100000, '['));
    EXPECT_TRUE(session.result("shutdown", Json()).is_null());
}

TEST(LspServer, CancelsWhatWaits) {
    std::vector<Json> said;
    Server server([&](const std::string& body) { said.push_back(Json::parse(body)); }, {});
    server.receive(R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{}})");
    server.receive(R"({"jsonrpc":"2.0","id":"a","method":"textDocument/hover","params":{}})");
    server.receive(R"({"jsonrpc":"2.0","method":"$/cancelRequest","params":{"id":"b"}})");
    EXPECT_EQ(server.waiting(), 2U);
    server.receive(R"({"jsonrpc":"2.0","method":"$/cancelRequest","params":{"id":"a"}})");
    EXPECT_EQ(server.waiting(), 1U);
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(said[0]["id"], "a");
    EXPECT_EQ(code_of(said[0]), -32800);
}

TEST(LspServer, EndsWithSuccessOnlyAfterShutdown) {
    Server server([](const std::string&) {}, {});
    server.receive(R"({"jsonrpc":"2.0","method":"exit"})");
    server.handle_next();
    EXPECT_TRUE(server.is_done());
    EXPECT_EQ(server.exit_status(), 1);
    Server other([](const std::string&) {}, {});
    for (const char* method : {"initialize", "shutdown"}) {
        other.receive(Json({{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}}).dump());
        other.handle_next();
    }
    EXPECT_EQ(other.exit_status(), 0);
}

} // namespace
} // namespace maclint::test
