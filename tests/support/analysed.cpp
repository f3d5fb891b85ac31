//! Reads and analyses texts for tests.
#include "tests/support/analysed.hpp"

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dialect/dialect.hpp"
#include "analyzer/workspace/outline.hpp"

#include <algorithm>
#include <stdexcept>

namespace maclint::test {
namespace {

WorkspaceFile read_as(std::string_view dialect_name, std::string path, std::string text) {
    const Dialect& dialect = *find_dialect(dialect_name);
    auto source = std::make_shared<const Source>(Source::from_bytes(std::move(path), std::move(text)));
    return {std::make_shared<const ProgramFile>(
                dialect.read(std::move(source), *find_control(dialect.default_control), Extent::whole)),
            true};
}

} // namespace

std::unique_ptr<Workspace> analyse(std::vector<WorkspaceFile> files, FolderOptions options) {
    const bool computed = std::ranges::any_of(files, [](const WorkspaceFile& file) {
        const FileOutline outline = outline_of(*file.file);
        return std::ranges::any_of(outline.programs, [](const ProgramOutline& program) {
            return std::ranges::any_of(program.calls, &CallOutline::is_computed);
        });
    });
    for (WorkspaceFile& file : files) {
        file.complete = options.complete;
        file.may_be_computed = computed;
    }
    return Workspace::analyse(std::move(files), {.jobs = options.jobs, .facts = options.facts});
}

std::unique_ptr<Workspace> analyse_text(std::string_view dialect, std::string text) {
    return analyse({read_as(dialect, "test.nc", std::move(text))}, {.complete = false, .jobs = 1});
}

std::unique_ptr<Workspace> analyse_files(const std::vector<NamedText>& files, FolderOptions options) {
    std::vector<WorkspaceFile> read;
    for (const auto& [path, text] : files) {
        const bool din = path.ends_with(".ncs") || text.find("MACHINING") != std::string::npos;
        read.push_back(read_as(din ? "dinplus" : "fanuc", path, text));
    }
    return analyse(std::move(read), options);
}

std::unique_ptr<Workspace> analyse_fanuc(std::string text) { return analyse_text("fanuc", std::move(text)); }

const ProgramAnalysis& program(const Workspace& workspace, std::string_view name) {
    for (const ProgramAnalysis& analysis : workspace.programs())
        if (analysis.program().name == name) return analysis;
    throw std::runtime_error("no such program");
}

dataflow::Value last_read(const ProgramAnalysis& analysis) {
    const auto reads = analysis.facts().all<dataflow::Read>();
    if (reads.empty()) throw std::runtime_error("nothing is read");
    return reads.back().value;
}

dataflow::Value last_read(const std::string& text) {
    return last_read(analyse_fanuc("O0001\n" + text)->programs().front());
}

std::string text_of(const ProgramAnalysis& analysis, Span span) {
    return std::string(analysis.program().slice(span));
}

std::uint32_t line_of(const ProgramAnalysis& analysis, Offset offset) {
    return analysis.file().source->position(offset).line;
}

std::uint32_t line_of_effect(const ProgramAnalysis& analysis, EffectId effect) {
    return line_of(analysis, analysis.program().effects[effect].span.begin);
}

} // namespace maclint::test
