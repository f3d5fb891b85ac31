//! Reads a file of the Fanuc family into programs.
#pragma once

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/program/model.hpp"

#include <memory>

namespace maclint::fanuc {

/// Dialect::read. Content that only a lathe has turns a mill control into its lathe twin.
[[nodiscard]] ProgramFile read(std::shared_ptr<const Source> source, const ControlModel& control,
                               Extent extent);

} // namespace maclint::fanuc
