//! Reads a SINUMERIK file.
#pragma once

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/program/model.hpp"

#include <memory>

namespace maclint::sinumerik {

/// Several programs stand in an archive, each behind a line `%_N_NAME_MPF`; any other file holds one.
[[nodiscard]] ProgramFile read(std::shared_ptr<const Source> source, const ControlModel& control,
                               Extent extent);

} // namespace maclint::sinumerik
