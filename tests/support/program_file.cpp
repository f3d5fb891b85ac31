//! The one place where such a file is more than a name.
#include "tests/support/program_file.hpp"

#include "analyzer/program/model.hpp"

#include <utility>

namespace maclint::test {

std::shared_ptr<const ProgramFile> file_of(std::shared_ptr<const Source> source) {
    auto file = std::make_shared<ProgramFile>();
    file->source = std::move(source);
    return file;
}

} // namespace maclint::test
