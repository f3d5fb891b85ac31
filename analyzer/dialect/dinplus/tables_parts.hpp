//! The parts of which the control is put together.
#pragma once

#include "analyzer/program/tables.hpp"

#include <span>
#include <vector>

namespace maclint::dinplus {

[[nodiscard]] std::vector<SectionKind> section_kinds();
[[nodiscard]] std::vector<VariableSpace> variable_spaces();
[[nodiscard]] std::vector<VariableFamily> variable_families();
[[nodiscard]] std::vector<ModalGroup> modal_groups();
[[nodiscard]] std::vector<ExclusiveCodes> exclusive_codes();
[[nodiscard]] std::span<const Switch> switch_rows();

} // namespace maclint::dinplus
