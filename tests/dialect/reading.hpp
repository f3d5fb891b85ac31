//! Reads small programs for tests, and describes what became of them.
#pragma once

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/program/dump.hpp"

#include <memory>
#include <string>
#include <string_view>

namespace maclint::test {

/// A file of that name and text, read for a control.
inline ProgramFile read_as(std::string_view control, std::string path, std::string_view text) {
    auto source = std::make_shared<const Source>(Source::from_bytes(std::move(path), std::string(text)));
    const ControlModel& model = *find_control(control);
    return find_dialect(model.language)->read(std::move(source), model, Extent::whole);
}

inline ProgramFile read(std::string_view text) { return read_as("fanuc", "O1.nc", text); }

/// The blocks of the only program and the irregularities, one a line.
inline std::string lower(const ProgramFile& file) {
    std::string out = describe(file);
    if (file.programs.size() == 1) out.erase(0, out.find('\n') + 1);
    while (!out.empty() && out.back() == '\n') out.pop_back();
    return out;
}
inline std::string lower(std::string_view text) { return lower(read(text)); }

} // namespace maclint::test
