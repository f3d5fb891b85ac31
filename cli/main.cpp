//! The entry point.
#include "analyzer/source/platform/console.hpp"
#include "analyzer/source/platform/threads.hpp"
#include "cli/out_of_memory.hpp"
#include "cli/run.hpp"
#include "cli/terminal.hpp"

// jemalloc reads it, where it is linked: what is free goes back to the system, and a run under a limit of
// memory gets by with a tenth less.
extern "C" {
extern const char* const malloc_conf;
const char* const malloc_conf = "retain:false";
}

namespace {

/// Before all other initialisers: in theirs CLI11 throws and jemalloc faults when they get no memory.
[[gnu::constructor(101)]] void require_memory() {
    if (!maclint::platform::has_memory_to_start()) maclint::cli::end_out_of_memory();
}

} // namespace

int main(int argc, char** argv) {
    using namespace maclint;
    cli::end_run_without_memory();
    try {
        int status = cli::exit_error;
        if (platform::run_with_stack([&] { status = cli::run(platform::arguments(argc, argv)); }))
            return status;
    } catch (...) { // not even the arguments fit into memory
    }
    cli::end_out_of_memory();
}
