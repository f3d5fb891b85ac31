//! Two variables of which one was meant for the other.
#pragma once

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>

namespace maclint::rules {

/// A variable that is set and read nowhere, and one that is read and set nowhere.
struct MistakenNumber {
    const dataflow::Store* store; ///< the first of the one
    const dataflow::Read* read;   ///< the first of the other
};

/// Only where the second is read behind the first, and the program has one of each among the variables that
/// all programs share until the control is switched off, and their numbers differ in one digit, or in two
/// that are exchanged: the operator and other programs set variables, too, and look at them. No program of
/// the workspace sets or reads them otherwise.
[[nodiscard]] std::optional<MistakenNumber> find_mistaken_number(const ProgramAnalysis& analysis);

} // namespace maclint::rules
