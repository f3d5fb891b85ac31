//! Files without programs, for tests that need to know nothing of the program model.
#pragma once

#include "analyzer/source/source.hpp"

#include <memory>

namespace maclint {
struct ProgramFile;
}

namespace maclint::test {

[[nodiscard]] std::shared_ptr<const ProgramFile> file_of(std::shared_ptr<const Source> source);

} // namespace maclint::test
