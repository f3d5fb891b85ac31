//! Speaks to the language server in this process, message by message.
#pragma once

#include "cli/lsp/protocol/json.hpp"
#include "cli/lsp/server/server.hpp"
#include "tests/support/folder.hpp"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::test {

using cli::lsp::Json;

/// A server with a folder, and all that it says.
class ScriptedSession {
  public:
    ScriptedSession();
    ScriptedSession(const ScriptedSession&) = delete;
    ScriptedSession& operator=(const ScriptedSession&) = delete;
    ~ScriptedSession();

    /// `initialize` with these capabilities, then `initialized`; gives the server's.
    Json begin(Json capabilities);
    /// The bytes of one message, whatever they are, and what they make the server do.
    void send_text(const std::string& body);
    void send(std::string_view method, Json params);
    /// The whole answer to a request.
    Json ask(std::string_view method, Json params);
    /// "result" of it.
    Json result(std::string_view method, Json params);

    [[nodiscard]] std::string uri(const std::string& name) const;
    /// Opens a text under that name in the folder, with version 1.
    void open(const std::string& name, const std::string& text, const std::string& language);
    /// The whole text anew, with the next version.
    void change(const std::string& name, const std::string& text, int version);
    /// What is published of the file in that version; a test that waits ten seconds fails.
    Json diagnostics(const std::string& name, std::optional<int> version);
    /// The first message of that method that has not been taken; waits as above.
    Json next(std::string_view method);
    /// All that was said so far.
    [[nodiscard]] std::vector<Json> said() const;

    TemporaryFolder folder;

  private:
    std::optional<Json> take(const std::function<bool(const Json&)>& wanted);
    Json wait_for(const std::function<bool(const Json&)>& wanted, const std::string& what);

    mutable std::mutex mutex_;
    std::condition_variable came_;
    std::vector<Json> messages_; ///< that nobody has taken
    std::vector<Json> all_;
    int next_id_ = 1;
    std::unique_ptr<cli::lsp::Server> server_;
};

/// `{"line": …, "character": …}`
[[nodiscard]] Json place(int line, int character);
/// "2:0-2:7", a range as people write it.
[[nodiscard]] std::string shown(const Json& range);
/// "MAC301 2:0-2:7", a diagnostic each.
[[nodiscard]] std::vector<std::string> shown_findings(const Json& diagnostics);

} // namespace maclint::test
