//! MAC562: blocks that the shop demands of each program.
#include "analyzer/machine/demands.hpp"
#include "rules/machine/demanded_place.hpp"
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule safety_line_missing{
    .code = "MAC562",
    .name = "safety-line-missing",
    .summary =
        "A block that the configuration demands is missing at the start, before a tool change or at the end",
    .why =
        "A program that takes over what the one before has left works as long as nobody changes the order of "
        "jobs. Which blocks prevent that is the shop's choice: what the configuration does not name is not "
        "demanded.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"start", "Missing at the start: '{0}' does not stand before '{1}', the first move.",
                  "Write it before the first move, as \"at-start\" demands."},
                 {"change",
                  "Missing before the tool change: '{0}' stands nowhere between the last cut and '{1}'.",
                  "Write it before the change, as \"before-tool-change\" demands."},
                 {"change_under",
                  "Missing before the tool change: '{0}', because {2} of line {3} is still in "
                  "force at '{1}'.",
                  "Write it before the change, as \"before-tool-change\" demands."},
                 {"end", "Missing at the end: '{0}' stands nowhere between the last cut and '{1}'.",
                  "Write it before the end, as \"at-end\" demands."},
                 {"end_under",
                  "Missing at the end: '{0}', because {2} of line {3} is still in force at '{1}'.",
                  "Write it before the end, as \"at-end\" demands."}},
    .bad = {Example("fanuc", R"nc(
O9562(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G0 X0 Y0
G43 H1 Z50. M8
G1 Z-5. F200.
G0 Z50. M9
T2 M6
S1200 M3
G43 H2 Z50. M8
G1 Z-5. F200.
G0 Z50.
M30
)nc")
                .on_control_with(R"("before-tool-change": ["M5", "M9"], "at-end": ["M9", "G28 Z0"])")},
    .good =
        {Example("fanuc", R"nc(
O9562(PLATE)
G90 G17 G40 G80 G54
T1 M6
S3000 M3
G0 X0 Y0
G43 H1 Z50. M8
G1 Z-5. F200.
G0 Z50. M9
M5
T2 M6
S1200 M3
G43 H2 Z50. M8
G1 Z-5. F200.
G0 Z50. M9
G91 G28 Z0
M30
)nc")
             .on_control_with(
                 R"("at-start": ["G17 G40 G80"], "before-tool-change": ["M5", "M9"], "at-end": ["M9", "G28 Z0"])")},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

using Place = DemandedBlock::Place;

struct Messages {
    std::string_view nowhere, under;
};
Messages messages_of(Place place) {
    switch (place) {
    case Place::start: return {"start", "start"}; // only what stands there counts
    case Place::tool_change: return {"change", "change_under"};
    case Place::end: break;
    }
    return {"end", "end_under"};
}

void check(const MachineStep& at, Reporter& reporter) {
    const ControlModel& control = at.analysis.control();
    if (control.demands == nullptr || control.demands->blocks.empty() || !at.analysis.is_main()) return;
    const auto place = place_of(at);
    if (!place) return;
    const machine::State& state = place == Place::tool_change ? at.before() : at.after();
    for (std::size_t i = 0; i < control.demands->blocks.size(); ++i) {
        const DemandedBlock& demanded = control.demands->blocks[i];
        const auto missed =
            demanded.place == place ? machine::missed(at.step, state, control, i) : std::nullopt;
        if (!missed) continue;
        const auto [nowhere, under] = messages_of(*place);
        if (missed->in_force == nullptr) {
            reporter.report(at.cause(), at.block(), nowhere, {demanded.text, at.quoted_block()});
            continue;
        }
        const machine::Known& other = *missed->in_force;
        reporter
            .report(at.cause(), at.block(), under,
                    {demanded.text, at.quoted_block(), missed->letter + number_word(other.value),
                     at.line_of(other)})
            .related.push_back(at.at(other, "it stands here"));
    }
}

} // namespace
} // namespace maclint::rules
