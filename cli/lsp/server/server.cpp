//! JSON-RPC 2.0, and the phases of a session.
#include "cli/lsp/server/server.hpp"

#include "cli/lsp/server/lifecycle.hpp"
#include "cli/lsp/server/methods.hpp"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

namespace maclint::cli::lsp {
namespace {

bool is_id(const Json& id) { return id.is_string() || id.is_number_integer(); }

Json id_of(const Json& message) {
    const Json* id = find(message, {"id"});
    return id != nullptr && is_id(*id) ? *id : Json();
}

/// What the client answers to a request of ours.
bool is_answer(const Json& message) {
    return message.is_object() && !message.contains("method") &&
           (message.contains("result") || message.contains("error"));
}

bool is_message(const Json& message) {
    const Json *method = find(message, {"method"}), *id = find(message, {"id"});
    return method != nullptr && method->is_string() && (id == nullptr || is_id(*id));
}

const Json& params_of(const Json& message) {
    static const Json none = Json::object();
    const Json* params = find(message, {"params"});
    return params == nullptr ? none : *params;
}

} // namespace

void Server::receive(const Received& received) {
    if (const auto* fault = std::get_if<TransportFault>(&received))
        return session_.outbox.fail(nullptr, {ErrorCode::parse_error, fault->message});
    Json message = Json::parse(std::get<std::string>(received), nullptr, false);
    if (message.is_discarded())
        return session_.outbox.fail(
            nullptr,
            {ErrorCode::parse_error, "A message is no JSON in UTF-8. Send it as JSON-RPC 2.0 has it."});
    if (is_answer(message)) return;
    if (!is_message(message))
        return session_.outbox.fail(id_of(message), {ErrorCode::invalid_request,
                                                     "A message is neither a request nor a notification. "
                                                     "Send an object with 'jsonrpc' and 'method'."});
    if (member(message, "method") == "$/cancelRequest") return cancel(params_of(message));
    waiting_.push_back(std::move(message));
}

void Server::cancel(const Json& params) {
    const Json id = id_of(params);
    const auto found = std::ranges::find_if(
        waiting_, [&](const Json& message) { return !id.is_null() && id_of(message) == id; });
    if (found == waiting_.end()) return;
    waiting_.erase(found);
    session_.outbox.fail(id, {ErrorCode::cancelled, "The client has cancelled the request."});
}

void Server::handle_next() {
    const Json message = std::move(waiting_.front());
    waiting_.pop_front();
    const std::string& method = string_in(message, "method");
    if (message.contains("id"))
        handle_request(message, method);
    else
        handle_notification(message, method);
}

void Server::handle_request(const Json& message, const std::string& method) {
    const Json id = id_of(message);
    try {
        session_.outbox.respond(id, answer(method, params_of(message)));
    } catch (const ResponseError& error) {
        session_.outbox.fail(id, error);
    } catch (const std::bad_alloc&) {
        session_.outbox.fail(id, {ErrorCode::request_failed, "There is not enough memory for it."});
    } catch (const std::exception& error) {
        session_.outbox.fail(id, {ErrorCode::internal_error, "Something went wrong inside maclint (" +
                                                                 std::string(error.what()) +
                                                                 "). Please report it."});
    }
}

Json Server::answer(const std::string& method, const Json& params) {
    if (phase_ == Phase::before_initialize && method != "initialize")
        throw ResponseError{ErrorCode::not_initialized, "'" + method + "' came before 'initialize'."};
    if (phase_ == Phase::shut_down || (phase_ == Phase::running && method == "initialize"))
        throw ResponseError{ErrorCode::invalid_request, "'" + method + "' cannot come here."};
    if (method == "initialize") {
        Json result = initialize(session_, params);
        phase_ = Phase::running;
        return result;
    }
    if (method == "shutdown") {
        phase_ = Phase::shut_down;
        was_shut_down_ = true;
        return nullptr;
    }
    if (const Handler handler = request_handler(method)) return handler(session_, params);
    throw ResponseError{ErrorCode::method_not_found, "There is no method '" + method + "'."};
}

/// What cannot be done is written into the client's log: nobody waits for an answer.
void Server::handle_notification(const Json& message, const std::string& method) {
    if (method == "exit") {
        phase_ = Phase::done;
        return;
    }
    if (phase_ != Phase::running) return;
    const Handler handler = notification_handler(method);
    if (handler == nullptr) return;
    try {
        handler(session_, params_of(message));
    } catch (const ResponseError& error) {
        session_.outbox.log("maclint: " + method + ": " + error.message);
    } catch (const std::bad_alloc&) {
        session_.outbox.show_once("maclint: there is not enough memory for a text. Close large ones.");
    }
}

} // namespace maclint::cli::lsp
