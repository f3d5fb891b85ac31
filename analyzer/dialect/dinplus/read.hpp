//! Reads a DIN PLUS file into programs.
#pragma once

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/program/model.hpp"

#include <memory>

namespace maclint::dinplus {

/// The main part is one program, every SUBPROGRAM section another.
[[nodiscard]] ProgramFile read(std::shared_ptr<const Source> source, const ControlModel& control,
                               Extent extent);

} // namespace maclint::dinplus
