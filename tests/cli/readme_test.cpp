//! The README shows what maclint prints.
#include "tests/support/linted.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

struct Shown {
    std::string program;
    std::string finding; ///< "error[MAC505]: …", as the README has it
};

/// Programs between fences, each with the finding that stands indented below it.
std::vector<Shown> shown_in(const std::filesystem::path& page) {
    std::ifstream file(page);
    std::vector<Shown> all;
    std::string block;
    bool inside = false;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("```")) {
            inside = !inside;
            if (inside) block.clear();
        } else if (inside) {
            block += line + "\n";
        } else if (line.starts_with("    error[") || line.starts_with("    warning[")) {
            all.push_back({block, line.substr(4)});
        }
    }
    return all;
}

std::string found_in(const std::string& program) {
    const bool din = program.find("MACHINING") != std::string::npos;
    const auto result = lint_texts({{din ? "a.ncs" : "O9001.nc", program}}, {});
    std::string all;
    for (const auto& [finding, suppressed] : result.findings) {
        const char* severity = finding.severity == Severity::error ? "error" : "warning";
        all += std::string(severity) + "[" + std::string(finding.rule->code) + "]: " + finding.message();
    }
    return all;
}

TEST(Readme, ShowsWhatIsPrinted) {
    const auto examples = shown_in("README.md");
    EXPECT_GE(examples.size(), 3U); // a plain program, a macro, DIN PLUS
    for (const auto& [program, finding] : examples) EXPECT_EQ(found_in(program), finding) << program;
}

} // namespace
} // namespace maclint::test
