//! Picks frames and controls for examples.
#include "rules/words/example_frames.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>

namespace maclint {

const ExampleFrame& frame_of(const ControlModel& control) {
    const auto* const frame = std::ranges::find_if(example_frames, [&](const ExampleFrame& one) {
        return one.language == control.language && one.machine == control.machine &&
               one.code_system == control.code_system;
    });
    return frame != example_frames.end()
               ? *frame
               : *std::ranges::find(example_frames, control.language, &ExampleFrame::language);
}

const ControlModel& example_control(const RowForCode& row) {
    const std::string_view names = row.row->controls.empty() ? row.table->controls : row.row->controls;
    const ControlModel* control = find_control(find_dialect(row.table->language)->default_control);
    for (const std::string_view name : words_of(names)) {
        control = find_control(name);
        if (!control->assumed) break;
    }
    if (row.table->machine == Machine::lathe && control->machine != Machine::lathe)
        control = control->lathe_of(row.row->systems.empty() ? 'A' : row.row->systems.view().front());
    return *control;
}

} // namespace maclint
