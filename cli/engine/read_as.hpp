//! What a file was taken for.
#pragma once

#include <string>

namespace maclint::cli {

/// Names of the dialect that a file was read in and of the control that it was checked for.
struct ReadAs {
    std::string dialect, control;
};

} // namespace maclint::cli
