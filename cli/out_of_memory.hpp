//! The end of a run that gets no memory.
#pragma once

namespace maclint::cli {

/// Says so in one line and ends the process with status 2, at once, from any thread: no report is begun, and
/// the file of one that is being written is taken away.
[[noreturn]] void end_out_of_memory() noexcept;

/// From now on this is how the process ends where an exception cannot go: in tree-sitter, and out of what
/// must not throw.
void end_run_without_memory();

} // namespace maclint::cli
