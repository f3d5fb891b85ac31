//! maclint_runs: answers, for a changed program, whether it does the same as the unchanged one; a line each.
//!
//! A question is a line with tabs between: the file, the changed text's file, changed lines ("12,13"), added
//! lines
//! ("12:1" or nothing), then all files of both workspaces as FILE or NAME=FILE, further files of the changed
//! one as +NAME=FILE. The first column is the name of the program's file among them.
#include "tests/execution/compared_runs.hpp"

#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace maclint::test;

std::string content_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
    return parts;
}

NamedText named(const std::string& part) {
    const std::size_t equals = part.find('=');
    return {part.substr(0, equals), content_of(part.substr(equals + 1))};
}

std::uint32_t number(const std::string& text) { return static_cast<std::uint32_t>(std::stoul(text)); }

/// The workspace of the last question, which mostly serves the next one, too.
struct Last {
    std::string unchanged;
    std::unique_ptr<RunsOf> runs;
};

Comparison answer(Last& last, const std::vector<std::string>& parts) {
    ChangedLines changes{parts.at(0), {}, {}};
    for (const std::string& line : split(parts.at(2), ',')) changes.lines.push_back(number(line));
    for (const std::string& one : split(parts.at(3), ',')) {
        const std::size_t colon = one.find(':');
        changes.added.emplace_back(number(one.substr(0, colon)), number(one.substr(colon + 1)));
    }
    std::vector<NamedText> added;
    std::string unchanged;
    for (std::size_t i = 4; i < parts.size(); ++i)
        if (parts[i].starts_with('+'))
            added.push_back(named(parts[i].substr(1)));
        else
            unchanged += parts[i] + '\t';
    if (unchanged != last.unchanged) {
        std::vector<NamedText> files;
        for (const std::string& part : split(unchanged, '\t')) files.push_back(named(part));
        last = {unchanged, std::make_unique<RunsOf>(std::move(files))};
    }
    return last.runs->compare(content_of(parts.at(1)), added, changes);
}

} // namespace

int main() {
    Last last;
    for (std::string question; std::getline(std::cin, question);) {
        try {
            const Comparison found = answer(last, split(question, '\t'));
            std::cout << (found.values ? "values " : "") << (found.codes_at_end ? "codes " : "")
                      << (found.variables_at_end ? "variables " : "") << (found.blocks ? "blocks " : "")
                      << (found.reachable ? "" : "unreachable ") << (found.unreadable ? "unreadable " : "")
                      << "runs=" << found.runs << " touching=" << found.touching << " lines=" << found.lines
                      << " led=" << found.led_to << " line=" << found.line << std::endl;
        } catch (const std::exception& failure) {
            std::cout << "unknown " << failure.what() << std::endl;
        }
    }
}
