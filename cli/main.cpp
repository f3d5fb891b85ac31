//! The entry point.
#include "cli/run.hpp"

int main(int argc, char** argv) {
    try {
        return maclint::cli::run({argv + (argc > 0 ? 1 : 0), argv + argc});
    } catch (...) {
        return 2; // not even the arguments fit into memory
    }
}
