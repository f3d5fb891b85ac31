//! `./dev bench`: speed beside the parser alone, peak memory, and growth from n to 2n.
#include "bench/editing.hpp"
#include "bench/generate.hpp"
#include "bench/pipeline.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using maclint::bench::lint;

constexpr std::size_t megabyte = 1'000'000;
/// Of everything: the machine has other things to do, too.
constexpr int repetitions = 5;

std::vector<std::string> a_thousand(const std::function<std::string(std::size_t)>& make, std::size_t bytes) {
    return std::vector<std::string>(1000, make(bytes / 1000));
}

void measure(benchmark::State& state, const std::vector<std::string>& files,
             const std::function<void()>& work) {
    std::size_t bytes = 0;
    for (const std::string& file : files) bytes += file.size();
    for ([[maybe_unused]] auto round : state) work();
    state.SetBytesProcessed(static_cast<std::int64_t>(bytes) * state.iterations());
}

void register_work(const std::string& name, const std::vector<std::string>& files,
                   const std::function<void(const std::vector<std::string>&)>& work) {
    benchmark::RegisterBenchmark(
        name.c_str(), [files, work](benchmark::State& state) { measure(state, files, [&] { work(files); }); })
        ->Unit(benchmark::kMillisecond)
        ->Repetitions(repetitions)
        ->ReportAggregatesOnly();
}

void register_speed(const std::string& name, const std::vector<std::string>& files,
                    std::string_view dialect = "fanuc") {
    register_work(name + "/maclint", files, [dialect](const std::vector<std::string>& texts) {
        benchmark::DoNotOptimize(lint(texts, dialect));
    });
    register_work(name + "/parser_alone", files, [dialect](const std::vector<std::string>& texts) {
        for (const std::string& text : texts)
            benchmark::DoNotOptimize(maclint::bench::parse_in_one_piece(text, dialect));
    });
}

/// Peak memory in bytes of a child process that does the work; 0 when there is no child to be had.
std::size_t peak_memory(const std::function<void()>& work) {
    const pid_t child = fork();
    if (child < 0) return 0;
    if (child == 0) {
        work();
        _exit(0);
    }
    rusage usage{};
    int status = 0;
    if (wait4(child, &status, 0, &usage) != child) return 0;
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

void print_memory(const char* name, std::size_t bytes, const std::function<std::string(std::size_t)>& make,
                  std::string_view dialect = "fanuc") {
    // The text is made in the child, too: what it costs to hold it once is taken off.
    const std::size_t empty = peak_memory([&] { benchmark::DoNotOptimize(make(bytes)); });
    const std::size_t full = peak_memory([&] {
        const std::vector<std::string> files{make(bytes)};
        benchmark::DoNotOptimize(lint(files, dialect));
    });
    const double extra = static_cast<double>(full) - static_cast<double>(empty);
    std::printf("%-28s %8.1f MB of text: %8.1f MB beside the text itself (%.2f bytes a byte)\n", name,
                static_cast<double>(bytes) / 1e6, extra / 1e6, extra / static_cast<double>(bytes));
}

double seconds(const std::function<void()>& work) {
    double best = 1e9;
    for (int round = 0; round < repetitions; ++round) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        best =
            std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    return best;
}

void print_growth(const char* name, std::size_t n, const std::function<std::string(std::size_t)>& make,
                  std::string_view dialect = "fanuc") {
    const std::vector<std::string> once{make(n)};
    const std::vector<std::string> twice{make(2 * n)};
    const double a = seconds([&] { benchmark::DoNotOptimize(lint(once, dialect)); });
    const double b = seconds([&] { benchmark::DoNotOptimize(lint(twice, dialect)); });
    std::printf("%-28s n = %8zu: %8.1f ms, 2n: %8.1f ms, growth %.2f\n", name, n, a * 1e3, b * 1e3, b / a);
}

} // namespace

int main(int argc, char** argv) {
    namespace make = maclint::bench;
    std::printf("Peak memory\n");
    print_memory("CAM output", 50 * megabyte, make::cam_output);
    print_memory("macro code", 2 * megabyte, make::macro_code);
    print_memory("DIN PLUS, plain blocks", 10 * megabyte, make::plain_turning, "dinplus");
    print_memory("DIN PLUS", 2 * megabyte, make::expert_program, "dinplus");
    std::printf("\nGrowth from n to 2n (best of five)\n");
    print_growth("size, CAM output (bytes)", 10 * megabyte, make::cam_output);
    print_growth("size, macro code (bytes)", megabyte, make::macro_code);
    print_growth("size, DIN PLUS (bytes)", megabyte, make::expert_program, "dinplus");
    print_growth("jumps", 4000, make::one_program_with_jumps);
    print_growth("variables", 4000, make::one_program_with_variables);
    print_growth("call depth", 1000, make::call_chain);
    const auto noise = [](std::size_t bytes) { return make::line_noise(bytes, 1); };
    print_growth("line noise (bytes)", megabyte / 2, noise);
    print_growth("line noise, DIN PLUS (bytes)", megabyte / 2, noise, "dinplus");
    std::printf("\nFrom an edit to the findings\n");
    maclint::bench::print_editing();
    std::printf("\nSpeed, beside the parser alone on the same text in one piece\n");
    std::fflush(stdout);
    register_speed("cam/one_file", {make::cam_output(10 * megabyte)});
    register_work("cam/every_value/maclint", {make::cam_output(10 * megabyte)},
                  [](const std::vector<std::string>& files) {
                      benchmark::DoNotOptimize(maclint::bench::lint_every_value(files));
                  });
    register_work("cam/thousand_rows/maclint", {make::cam_output(10 * megabyte)},
                  [](const std::vector<std::string>& files) {
                      benchmark::DoNotOptimize(maclint::bench::lint_thousand_rows(files));
                  });
    register_speed("cam/numbered_with_a_jump", {make::numbered_cam_output(10 * megabyte)});
    register_speed("cam/thousand_files", a_thousand(make::cam_output, 10 * megabyte));
    register_speed("macro/one_file", {make::macro_code(2 * megabyte)});
    register_speed("macro/thousand_files", make::macro_files(1000, 4 * megabyte / 1000));
    register_speed("dinplus/one_file", {make::expert_program(2 * megabyte)}, "dinplus");
    register_speed("dinplus/plain", {make::plain_turning(5 * megabyte)}, "dinplus");
    register_speed("dinplus/thousand_files", a_thousand(make::expert_program, 4 * megabyte), "dinplus");
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
