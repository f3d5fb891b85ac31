//! The entry point.
#include "analyzer/source/platform/console.hpp"
#include "cli/run.hpp"

int main(int argc, char** argv) {
    try {
        return maclint::cli::run(maclint::platform::arguments(argc, argv));
    } catch (...) {
        return 2; // not even the arguments fit into memory
    }
}
