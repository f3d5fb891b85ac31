//! `maclint controls`: the controls, and what is known of each.
#include "cli/commands/commands.hpp"
#include "cli/report/control_page.hpp"
#include "cli/terminal.hpp"

namespace maclint::cli {

int run_controls(const ControlsRequest& request) {
    const bool as_json = request.format == ListFormat::json;
    if (request.control == nullptr)
        return print_text(as_json ? json_controls() : plain_controls(output_width()));
    const PageStyle style{colour_for_output(request.colour), output_width()};
    return print_text(as_json ? json_control(*request.control) : plain_control_page(*request.control, style));
}

} // namespace maclint::cli
