//! A head that makes no sense loses the place: bytes are passed over until the next one begins.
#include "cli/lsp/transport/message_reader.hpp"

#include "cli/text/letters.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace maclint::cli::lsp {
namespace {

constexpr std::string_view length_field = "Content-Length:";

struct HeadEnd {
    std::size_t at, length;
};

/// Where the empty line is; clients of a few lines write LF alone.
std::optional<HeadEnd> find_head_end(std::string_view text) {
    const std::size_t crlf = text.find("\r\n\r\n"), lf = text.find("\n\n");
    if (crlf == std::string_view::npos && lf == std::string_view::npos) return std::nullopt;
    return crlf < lf ? HeadEnd{crlf, 4} : HeadEnd{lf, 2};
}

std::optional<std::size_t> number_in(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return std::nullopt;
    text = text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

/// What the field says, in whatever case it is written.
std::optional<std::size_t> length_in(std::string_view head) {
    const std::string wanted = in_lower_case(length_field);
    while (!head.empty()) {
        const std::size_t end = std::min(head.find('\n'), head.size());
        const std::string_view line = head.substr(0, end);
        if (in_lower_case(line.substr(0, wanted.size())) == wanted)
            return number_in(line.substr(wanted.size()));
        head.remove_prefix(std::min(end + 1, head.size()));
    }
    return std::nullopt;
}

} // namespace

void MessageReader::feed(std::string_view bytes) {
    const std::size_t passed = std::min(skipped_, bytes.size());
    skipped_ -= passed;
    buffer_.append(bytes.substr(passed));
}

std::optional<Received> MessageReader::next() {
    while (!wanted_) {
        const bool was_lost = lost_;
        if (lost_ && !skip_lost()) return std::nullopt;
        const Head head = read_head();
        if (head == Head::incomplete) return std::nullopt;
        if (head == Head::wrong && !was_lost) return TransportFault{std::exchange(fault_, {})};
    }
    return take_body();
}

std::optional<Received> MessageReader::take_body() {
    if (buffer_.size() < *wanted_) return std::nullopt;
    std::string rest = buffer_.substr(*wanted_); // the body is the longer part by far
    buffer_.resize(*wanted_);
    std::string body = std::exchange(buffer_, std::move(rest));
    wanted_.reset();
    return body;
}

/// To the next field of length; false where none has come yet.
bool MessageReader::skip_lost() {
    const std::size_t found = buffer_.find(length_field);
    if (found != std::string::npos) {
        buffer_.erase(0, found);
        return true;
    }
    if (buffer_.size() >= length_field.size())
        buffer_.erase(0, buffer_.size() - length_field.size() + 1); // it may have begun
    return false;
}

MessageReader::Head MessageReader::refuse(std::size_t bytes, std::string why) {
    buffer_.erase(0, bytes);
    fault_ = std::move(why);
    return Head::wrong;
}

MessageReader::Head MessageReader::read_head() {
    const auto end = find_head_end(std::string_view(buffer_).substr(0, most_head));
    if (!end && buffer_.size() < most_head) return Head::incomplete;
    const auto length = end ? length_in(std::string_view(buffer_).substr(0, end->at)) : std::nullopt;
    lost_ = !length;
    if (!length)
        return refuse(end ? end->at + end->length : most_head,
                      "What came begins no message. Send Content-Length with a number, an empty line, and so "
                      "many bytes.");
    buffer_.erase(0, end->at + end->length);
    if (*length <= most_body) {
        wanted_ = length;
        buffer_.reserve(*length);
        return Head::read;
    }
    const std::size_t here = std::min(*length, buffer_.size());
    skipped_ = *length - here;
    return refuse(here, "A message of " + std::to_string(*length) +
                            " bytes is too large and was passed over. Send " + std::to_string(most_body) +
                            " at most.");
}

std::string framed(std::string_view body) {
    return "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + std::string(body);
}

} // namespace maclint::cli::lsp
