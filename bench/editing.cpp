//! A folder of 2,000 programs, one of which is open in an editor.
#include "bench/editing.hpp"

#include "bench/generate.hpp"
#include "cli/engine/engine.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace maclint::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t file_count = 2000;
constexpr std::size_t edits = 100;
constexpr std::size_t largest = 60'000; ///< bytes of a text that people write
constexpr std::size_t kept_bytes = 200'000'000;

using Milliseconds = std::chrono::duration<double, std::milli>;

std::string bytes_of(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Long enough ago for its time to tell it from what is written now.
void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
    fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(1));
}

/// Programs of others where they are there, again and again under another folder; else made ones.
void fill(const fs::path& folder) {
    std::vector<fs::path> found;
    for (const char* kind : {"fanuc-macro", "fanuc-plain"}) {
        const fs::path corpus = fs::path(MACLINT_SHARED) / "corpus" / kind;
        if (!fs::exists(corpus)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(corpus))
            if (entry.is_regular_file() && entry.file_size() < largest) found.push_back(entry.path());
    }
    std::ranges::sort(found);
    if (found.empty()) {
        std::size_t number = 0;
        for (const std::string& text : macro_files(file_count, 4000))
            write(folder / (std::to_string(number++) + ".nc"), text);
        return;
    }
    for (std::size_t i = 0; i < file_count; ++i) {
        const fs::path& from = found[i % found.size()];
        write(folder / std::to_string(i / found.size()) / from.parent_path().filename() / from.filename(),
              bytes_of(from));
    }
}

struct Times {
    std::vector<double> kept, cold; ///< milliseconds

    void print(const char* name) {
        std::ranges::sort(kept);
        std::ranges::sort(cold);
        const auto at = [](const std::vector<double>& times, std::size_t percent) {
            return times[(times.size() - 1) * percent / 100];
        };
        std::printf("%-28s kept %7.1f (95 of 100: %7.1f, longest %7.1f) ms, cold %7.1f ms, ratio of the "
                    "medians %.2f\n",
                    name, at(kept, 50), at(kept, 95), kept.back(), at(cold, 50), at(kept, 50) / at(cold, 50));
    }
};

/// The text with a block more somewhere.
std::string edited(const std::string& text, std::mt19937& chance) {
    const std::size_t at = text.find('\n', text.empty() ? 0 : chance() % text.size());
    return at == std::string::npos ? text + "\nG4X1.\n" : text.substr(0, at) + "\nG4X1." + text.substr(at);
}

class Editor {
  public:
    explicit Editor(const fs::path& folder)
        : snapshot_(cli::snapshot_of(cli::discover({folder.string()}, "", settings_).files, settings_)) {
        for (cli::SnapshotFile& file : snapshot_.files) file.input.asked = false;
    }

    /// Edits the file some times, and measures one of these edits.
    void measure(std::size_t place, std::mt19937& chance, Times& times) {
        cli::SnapshotFile& file = snapshot_.files[place];
        file.input.asked = true;
        std::string text = bytes_of(file.input.path);
        for (int round = 0; round < 2; ++round) {
            text = edited(text, chance);
            file.text = Source::from_bytes(file.input.path, text);
            const double kept = run(engine_);
            if (round == 1) times.kept.push_back(kept);
        }
        cli::Engine anew({.jobs = 2}, progress_);
        times.cold.push_back(run(anew));
        file.input.asked = false;
        file.text = std::nullopt;
    }

    [[nodiscard]] std::size_t size() const { return snapshot_.files.size(); }

    /// The file whose check takes longest: it is called by most others, or calls them.
    std::size_t slowest() {
        std::mt19937 chance(1);
        std::size_t found = 0;
        double longest = 0;
        for (std::size_t place = 0; place < std::min<std::size_t>(size(), 700); place += 1) {
            Times times;
            measure_kept(place, times);
            if (times.kept.front() <= longest) continue;
            longest = times.kept.front();
            found = place;
        }
        return found;
    }

  private:
    void measure_kept(std::size_t place, Times& times) {
        snapshot_.files[place].input.asked = true;
        times.kept.push_back(run(engine_));
        snapshot_.files[place].input.asked = false;
    }

    double run(cli::Engine& engine) const {
        const auto begin = std::chrono::steady_clock::now();
        static_cast<void>(engine.analyse(snapshot_));
        return Milliseconds(std::chrono::steady_clock::now() - begin).count();
    }

    cli::Settings settings_{{}};
    cli::Progress progress_{cli::Progress::Shown::never};
    cli::Snapshot snapshot_;
    cli::Engine engine_{{.jobs = 2, .kept_bytes = kept_bytes}, progress_};
};

} // namespace

void print_editing() {
    const fs::path folder = fs::temp_directory_path() / "maclint-editing";
    fs::remove_all(folder);
    fill(folder);
    Editor editor(folder);
    std::mt19937 chance(7);
    Times even, slowest;
    for (std::size_t i = 0; i < edits; ++i) editor.measure(chance() % editor.size(), chance, even);
    const std::size_t place = editor.slowest();
    for (std::size_t i = 0; i < edits / 10; ++i) editor.measure(place, chance, slowest);
    even.print("one of 2,000 files");
    slowest.print("the one that takes longest");
    fs::remove_all(folder);
}

} // namespace maclint::bench
