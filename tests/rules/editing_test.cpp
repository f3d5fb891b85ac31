//! An engine that keeps what it knows finds after each edit what one finds that begins anew.
#include "cli/engine/engine.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/folder.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text) {
    Lines lines;
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

std::string text_of(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

/// "O9001", the first in the text; empty: there is none.
std::string program_number(const std::string& text) {
    for (const std::string& line : lines_of(text))
        if (line.starts_with('O')) return line.substr(0, line.find_first_not_of("0123456789", 1));
    return {};
}

/// Files that lie in a folder and texts that an editor holds, changed by chance.
class EditedFolder {
  public:
    explicit EditedFolder(unsigned seed)
        : dice_(seed) {
        const fs::path corpus = fs::path(MACLINT_SOURCE_DIR) / "corpus";
        for (const char* kind : {"fanuc/good", "fanuc/defects", "dinplus/good", "sinumerik/good"})
            for (const auto& entry : fs::recursive_directory_iterator(corpus / kind))
                if (entry.is_regular_file() && entry.path().extension() != ".md")
                    write(entry.path().lexically_relative(corpus).generic_string(), read_file(entry.path()));
        for (const auto& [name, text] : files_)
            for (std::string& line : lines_of(text)) blocks_.push_back(std::move(line));
    }

    /// One thing that people do; the name of the file that they look at then.
    std::string edit() {
        std::string name = any_file();
        switch (dice_.below(8)) {
        case 0: return save(name);
        case 1: return move(name);
        case 2: configure(); return name;
        case 3: renumber(name); return name;
        default: change_blocks(name); return name;
        }
    }

    /// As it is now; findings are wanted of what the editor holds and of `name`.
    cli::Snapshot snapshot(cli::Settings& settings, const std::string& name) const {
        auto found = cli::discover({folder_.path().string()}, "", settings);
        cli::Snapshot snapshot = cli::snapshot_of(std::move(found.files), settings);
        for (cli::SnapshotFile& file : snapshot.files) {
            const std::string inner = file.input.path.substr(folder_.path().string().size() + 1);
            const auto open = open_.find(inner);
            file.input.asked = open != open_.end() || inner == name;
            if (open != open_.end()) file.text = Source::from_bytes(file.input.path, open->second);
        }
        return snapshot;
    }

    [[nodiscard]] bool take_configured() { return std::exchange(configured_, false); }

  private:
    void write(const std::string& name, const std::string& text) {
        const fs::path path = folder_.write(name, text);
        fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(1));
        files_[name] = text;
    }

    std::string any_file() {
        return std::next(files_.begin(), static_cast<std::ptrdiff_t>(dice_.below(files_.size())))->first;
    }

    std::string& open(const std::string& name) {
        if (open_.size() > 3) open_.clear();
        return open_.try_emplace(name, files_.at(name)).first->second;
    }

    void change_blocks(const std::string& name) {
        std::string& text = open(name);
        Lines lines = lines_of(text);
        const auto at = static_cast<std::ptrdiff_t>(dice_.below(lines.size() + 1));
        if (dice_.below(2) == 0 || at == std::ssize(lines))
            lines.insert(lines.begin() + at, blocks_[dice_.below(blocks_.size())]);
        else
            lines.erase(lines.begin() + at);
        text = text_of(lines);
    }

    /// The program gets the number of another one, so that calls lead elsewhere.
    void renumber(const std::string& name) {
        const std::string number = program_number(files_.at(any_file()));
        std::string& text = open(name);
        const std::string before = program_number(text);
        if (!number.empty() && !before.empty()) text.replace(text.find(before), before.size(), number);
    }

    std::string save(const std::string& name) {
        std::string text = open(name);
        open_.erase(name);
        write(name, text);
        return name;
    }

    std::string move(const std::string& name) {
        std::string other = (name.starts_with("moved/") ? "fanuc/good/" : "moved/") +
                            fs::path(name).filename().generic_string();
        if (files_.contains(other)) return name;
        write(other, files_.at(name));
        fs::remove(folder_.path() / name);
        files_.erase(name);
        open_.erase(name);
        return other;
    }

    void configure() {
        static constexpr const char* configurations[] = {R"({"complete": true})", R"({"ignore": ["MAC3"]})",
                                                         R"({"control": "fanuc-30i"})", "{}"};
        folder_.write(dice_.below(2) == 0 ? ".maclint.json" : "fanuc/good/.maclint.json",
                      configurations[dice_.below(std::size(configurations))]);
        configured_ = true;
    }

    TemporaryFolder folder_;
    Dice dice_;
    std::map<std::string, std::string> files_, open_;
    Lines blocks_;
    bool configured_ = false;
};

/// All that a report says of them, in its order.
std::vector<std::string> told(const cli::Result& result) {
    std::vector<std::string> all;
    for (const auto& [finding, suppressed] : result.findings) {
        std::string text = finding.source->path() + ":" + std::to_string(finding.span.begin) + " " +
                           std::string(finding.rule->code) + " " + finding.message() +
                           (suppressed ? " suppressed" : "");
        for (const RelatedLocation& step : finding.path)
            text += "; " + std::to_string(step.span.begin) + " " + step.text;
        for (const RelatedLocation& place : finding.related)
            text += "; " + place.source->path() + ":" + std::to_string(place.span.begin) + " " + place.text;
        all.push_back(std::move(text));
    }
    return all;
}

class Editing : public testing::TestWithParam<unsigned> {};

TEST_P(Editing, FindsWhatARunFromNothingFinds) {
    EditedFolder folder(GetParam());
    cli::Progress progress(cli::Progress::Shown::never);
    cli::Engine kept({.jobs = 2, .kept_bytes = 100'000'000}, progress);
    auto settings = std::make_unique<cli::Settings>(cli::Overrides{});
    std::size_t findings = 0;
    for (int round = 0; round < 40; ++round) {
        const std::string name = folder.edit();
        if (folder.take_configured()) settings = std::make_unique<cli::Settings>(cli::Overrides{});
        const auto warm = told(kept.analyse(folder.snapshot(*settings, name)));
        cli::Settings own({});
        const auto cold = told(cli::Engine({.jobs = 1}, progress).analyse(folder.snapshot(own, name)));
        ASSERT_EQ(warm, cold) << "after edit " << round << " of " << name;
        findings += cold.size();
    }
    EXPECT_GT(findings, 20U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Editing, testing::Range(1U, 6U));

} // namespace
} // namespace maclint::test
