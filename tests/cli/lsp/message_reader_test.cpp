//! Framing: whole messages out of any pieces, and one fault for whatever is none.
#include "cli/lsp/transport/message_reader.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli::lsp {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

/// What comes out when the bytes come in pieces of that size; faults begin with '!'.
std::vector<std::string> read_in_pieces(std::string_view bytes, std::size_t size) {
    MessageReader reader;
    std::vector<std::string> out;
    for (std::size_t at = 0; at < bytes.size(); at += size) {
        reader.feed(bytes.substr(at, size));
        while (auto received = reader.next()) {
            const auto* fault = std::get_if<TransportFault>(&*received);
            out.push_back(fault != nullptr ? "!" + fault->message : std::get<std::string>(*received));
        }
    }
    return out;
}

TEST(MessageReader, GivesWholeMessagesOutOfAnyPieces) {
    const std::string bytes = framed("{\"a\":1}") +
                              "Content-Type: application/vscode-jsonrpc; charset=utf-8\r\n" +
                              framed("\xC3\xA4") + "content-length:2\n\n{}" + framed("");
    for (const std::size_t size : {1U, 2U, 3U, 7U, 1000U})
        EXPECT_THAT(read_in_pieces(bytes, size), ElementsAre("{\"a\":1}", "\xC3\xA4", "{}", "")) << size;
}

TEST(MessageReader, TellsOfRubbishOnceAndGoesOnWithTheNextMessage) {
    for (const std::string& rubbish :
         {std::string("hello\r\n\r\nagain\r\n\r\n"), "Content-Length: x\r\n\r\n" + framed("").substr(0, 0),
          std::string("Content-Length: -5\r\n\r\n{}{}{}"), std::string(10000, 'x'),
          std::string("Content-Length: 99999999999999999999999\r\n\r\n")})
        for (const std::size_t size : {1U, 5U, 100000U}) {
            const auto out = read_in_pieces(rubbish + framed("{}"), size);
            EXPECT_THAT(out, ElementsAre(StartsWith("!What came begins no message"), "{}"))
                << rubbish << size;
        }
    EXPECT_THAT(read_in_pieces("Content-Length: 5\r\n\r\n{}", 4), IsEmpty()); // it waits for the rest
}

TEST(MessageReader, PassesOverWhatIsTooLarge) {
    const std::string bytes = "Content-Length: " + std::to_string(MessageReader::most_body + 1) + "\r\n\r\n";
    MessageReader reader;
    reader.feed(bytes);
    EXPECT_TRUE(std::holds_alternative<TransportFault>(*reader.next()));
    const std::string part(std::size_t{1} << 20U, 'x');
    for (std::size_t fed = 0; fed < MessageReader::most_body; fed += part.size()) {
        reader.feed(part);
        ASSERT_FALSE(reader.next());
    }
    reader.feed("x" + framed("{}"));
    EXPECT_EQ(std::get<std::string>(*reader.next()), "{}");
}

TEST(MessageReader, SurvivesManyHeadsThatAreNone) {
    std::string bytes;
    for (int i = 0; i < 200000; ++i) bytes += "Content-Length:\n\n";
    EXPECT_EQ(read_in_pieces(bytes + framed("{}"), 1U << 16U).size(), 2U);
}

} // namespace
} // namespace maclint::cli::lsp
