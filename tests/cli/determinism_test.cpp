//! Equal programs give equal reports, byte for byte: for any number of threads, any order of folders, twice.
#include "tests/support/in_repository.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using namespace std::string_literals;
using namespace std::string_view_literals;

/// Texts that say the same to the parse cache, to the eye or to a decoder, and are not the same.
constexpr std::array odd_blocks = {"#1=5(A\0B)\n"sv,
                                   "#1=5(A-B)\n"sv,
                                   "#1=5(A\xFF\xC3)\n"sv,
                                   "#1=5(A\xE2\x82)\n"sv,
                                   "G65P2003A#1(\x9B"sv,
                                   "31m)\n"sv,
                                   "GOTO99(\xF0\x9F)\n"sv,
                                   "IF[#1EQ#0]GOTO98\n"sv,
                                   "#100=#2/#3(\0\0\0\0)\n"sv,
                                   "X1.\xA0Y2.\n"sv,
                                   "#5=[#6\0+1]\n"sv,
                                   "WHILE[#7LT5]DO1\n"sv,
                                   "#7=#7+1\n"sv,
                                   "END1\n"sv,
                                   "G1 X#26 F#9\r\n"sv,
                                   "M98P2001\n"sv,
                                   "(NEVER CLOSED\n"sv,
                                   "\0\0\n"sv,
                                   "#KEY \"A[B\"\n"sv,
                                   "[A\0B] #g1=#l2\n"sv};

/// A text with NULs is one only where they are tape, or come after what a glance takes for a program.
std::string with_odd_blocks(std::string text, std::size_t first, std::size_t count) {
    const bool nul_is_seen = text.size() < 65'536;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string_view block = odd_blocks[(first + i * 3) % odd_blocks.size()];
        if (!nul_is_seen || block.find('\0') == std::string_view::npos) text += block;
    }
    return text;
}

std::string odd_program(int number) {
    std::string text = "\0\0%\nO"s + std::to_string(number) + "\n";
    if (number % 20 == 0)
        while (text.size() < 65'536) text += "G1 X1. Y2. F100\n";
    return with_odd_blocks(text, static_cast<std::size_t>(number) * 7, 12) + "M99\n%\n\0\0\0"s;
}

std::string odd_dinplus_program(int number) {
    std::string text = "MACHINING\n";
    if (number % 20 == 0)
        while (text.size() < 65'536) text += "N1 G1 X1 Z-2\n";
    return with_odd_blocks(text, static_cast<std::size_t>(number), 6) + "N90 M30\nEND\n";
}

class Determinism : public InRepository {
  protected:
    void SetUp() override {
        InRepository::SetUp();
        for (int i = 0; i < 24; ++i) {
            const std::string name =
                std::string(1, static_cast<char>('a' + i % 3)) + "/O" + std::to_string(2000 + i);
            folder.write(name + ".nc", odd_program(2000 + i % 20)); // some numbers twice
            folder.write(name + ".ncs", odd_dinplus_program(i));
        }
    }

    [[nodiscard]] Finished run(const std::string& format, std::vector<std::string> paths,
                               const char* jobs) const {
        paths.insert(paths.begin(), {"--no-timestamps", "--format", format, "--jobs", jobs});
        return InRepository::run(paths);
    }
};

TEST_F(Determinism, NeitherThreadsNorTheOrderOfFoldersNorChanceChangeAByte) {
    for (const std::string format :
         {"text", "concise", "json", "sarif", "github", "gitlab", "junit", "checkstyle"}) {
        const Finished first = run(format, {"a", "b", "c"}, "1");
        EXPECT_EQ(first.status, 1);
        EXPECT_GT(first.out.size(), 5000U);
        const auto expect_same = [&](const Finished& other, const std::string& how) {
            EXPECT_EQ(first.status, other.status) << format << ", " << how;
            EXPECT_TRUE(first.out == other.out) << format << ", " << how;
            EXPECT_EQ(first.err, other.err) << format << ", " << how;
        };
        expect_same(run(format, {"a", "b", "c"}, "1"), "again");
        for (const char* jobs : {"2", "3", "8", "8"}) expect_same(run(format, {"a", "b", "c"}, jobs), jobs);
        expect_same(run(format, {"c", "a", "b"}, "1"), "another order");
        expect_same(run(format, {"c", "b", "a", "b"}, "8"), "another order, a folder twice");
    }
}

} // namespace
} // namespace maclint::test
