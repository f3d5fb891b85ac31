//! How long a check takes after an edit, beside one that begins anew.
#pragma once

namespace maclint::bench {

/// Prints, for edits of files drawn evenly from 2,000 of ours or of the outer corpus, the time from the edit
/// to the findings: the median, what 95 of 100 stay below, and the longest, kept and cold. Apart from these
/// the same for the program with most callers. Milliseconds.
void print_editing();

} // namespace maclint::bench
