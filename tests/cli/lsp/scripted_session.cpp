//! Messages are taken in the order in which they are asked for.
#include "tests/cli/lsp/scripted_session.hpp"

#include "analyzer/source/platform/paths.hpp"
#include "cli/report/uri.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include <gtest/gtest.h>

namespace maclint::test {

using namespace std::chrono_literals;

ScriptedSession::ScriptedSession() {
    folder.write(".git/HEAD", "");
    server_ = std::make_unique<cli::lsp::Server>(
        [this](const std::string& body) {
            {
                const std::lock_guard lock(mutex_);
                all_.push_back(messages_.emplace_back(Json::parse(body)));
            }
            came_.notify_all();
        },
        cli::lsp::AnalystOptions{.jobs = 2, .pause = 1ms});
}

ScriptedSession::~ScriptedSession() = default;

Json ScriptedSession::begin(Json capabilities) {
    Json params = {{"processId", nullptr},
                   {"rootUri", cli::file_uri(platform::text_of(folder.path()))},
                   {"capabilities", std::move(capabilities)}};
    Json answer = result("initialize", std::move(params));
    send("initialized", Json::object());
    return answer;
}

void ScriptedSession::send_text(const std::string& body) {
    server_->receive(body);
    while (server_->waiting() > 0) server_->handle_next();
}

void ScriptedSession::send(std::string_view method, Json params) {
    send_text(Json({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}}).dump());
}

Json ScriptedSession::ask(std::string_view method, Json params) {
    const int id = next_id_++;
    send_text(
        Json({{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", std::move(params)}}).dump());
    return wait_for(
        [&](const Json& message) { return !message.contains("method") && message.value("id", Json()) == id; },
        std::string(method));
}

Json ScriptedSession::result(std::string_view method, Json params) {
    Json answer = ask(method, std::move(params));
    EXPECT_TRUE(answer.contains("result")) << answer;
    return answer.value("result", Json());
}

std::string ScriptedSession::uri(const std::string& name) const {
    return cli::file_uri(platform::text_of(folder.path()) + "/" + name);
}

void ScriptedSession::open(const std::string& name, const std::string& text, const std::string& language) {
    send("textDocument/didOpen",
         {{"textDocument", {{"uri", uri(name)}, {"languageId", language}, {"version", 1}, {"text", text}}}});
}

void ScriptedSession::change(const std::string& name, const std::string& text, int version) {
    send("textDocument/didChange", {{"textDocument", {{"uri", uri(name)}, {"version", version}}},
                                    {"contentChanges", {{{"text", text}}}}});
}

Json ScriptedSession::diagnostics(const std::string& name, std::optional<int> version) {
    const auto is_it = [&](const Json& message) {
        if (message.value("method", "") != "textDocument/publishDiagnostics") return false;
        const Json& params = message["params"];
        return params["uri"] == uri(name) && (!version || params.value("version", 0) == *version);
    };
    return wait_for(is_it, "diagnostics of " + name)["params"]["diagnostics"];
}

Json ScriptedSession::next(std::string_view method) {
    return wait_for([&](const Json& message) { return message.value("method", "") == method; },
                    std::string(method));
}

std::vector<Json> ScriptedSession::said() const {
    const std::lock_guard lock(mutex_);
    return all_;
}

std::optional<Json> ScriptedSession::take(const std::function<bool(const Json&)>& wanted) {
    const auto found = std::ranges::find_if(messages_, wanted);
    if (found == messages_.end()) return std::nullopt;
    Json message = std::move(*found);
    messages_.erase(found);
    return message;
}

Json ScriptedSession::wait_for(const std::function<bool(const Json&)>& wanted, const std::string& what) {
    std::unique_lock lock(mutex_);
    std::optional<Json> found;
    came_.wait_for(lock, 30s, [&] {
        found = take(wanted);
        return found.has_value();
    });
    EXPECT_TRUE(found) << "nothing came: " << what;
    return found.value_or(Json::object());
}

Json place(int line, int character) { return {{"line", line}, {"character", character}}; }

std::string shown(const Json& range) {
    const auto one = [](const Json& position) {
        return position["line"].dump() + ":" + position["character"].dump();
    };
    return one(range["start"]) + "-" + one(range["end"]);
}

std::vector<std::string> shown_findings(const Json& diagnostics) {
    std::vector<std::string> all;
    for (const Json& diagnostic : diagnostics)
        all.push_back(diagnostic["code"].get<std::string>() + " " + shown(diagnostic["range"]));
    return all;
}

} // namespace maclint::test
