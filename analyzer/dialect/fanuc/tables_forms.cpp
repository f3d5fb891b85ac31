//! Ways of writing at which the controls of the family differ.
#include "analyzer/dialect/fanuc/tables.hpp"
#include "analyzer/program/faults.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace maclint::fanuc {
namespace {

constexpr std::size_t model_count = 8;
/// The columns of the table.
constexpr std::array<std::string_view, model_count> models = {
    "fanuc", "fanuc-16i", "fanuc-0i-c", "fanuc-0i-d", "fanuc-30i", "nct", "haas", "mitsubishi"};

/// Controls that write as another one does.
constexpr std::pair<std::string_view, std::string_view> alike[] = {{"haas-1999", "haas"},
                                                                   {"mazak-eia", "mitsubishi"}};

struct Form {
    SyntaxErrorKind form;
    std::array<Reading, model_count> readings;
    [[maybe_unused]] std::string_view source;
};

struct FaultForm {
    std::string_view fault;
    std::array<Reading, model_count> readings;
    [[maybe_unused]] std::string_view source;
};

constexpr Reading takes = Reading::takes, stops = Reading::stops, quiet = Reading::unknown,
                  doubt = Reading::doubtful;

// clang-format off
constexpr Form rows[] = {
    // form                                         fanuc  16i    0i-C   0i-D   30i    NCT    Haas   Mits.  source
    {SyntaxErrorKind::letter_o,                    {stops, stops, stops, stops, stops, stops, stops, stops}, "CSDN-VAR"},
    {SyntaxErrorKind::letter_o_or_jump,            {stops, stops, stops, stops, stops, stops, stops, stops}, "CSDN-VAR"},
    {SyntaxErrorKind::missing_value,               {stops, stops, stops, stops, stops, doubt, doubt, doubt}, "CSDN-PS; GH-ALM 005"},
    {SyntaxErrorKind::double_sharp,                {stops, stops, stops, stops, stops, stops, stops, stops}, "NCT-173"},
    {SyntaxErrorKind::letter_in_jump,              {stops, stops, stops, stops, stops, stops, quiet, quiet}, "IMD-114; NCT-188: n is a number, a variable or a formula"},
    {SyntaxErrorKind::words_after_jump,            {stops, stops, stops, stops, stops, quiet, quiet, quiet}, "T; GH-ALM 127"},
    {SyntaxErrorKind::condition_without_brackets,  {stops, stops, stops, stops, stops, stops, stops, stops}, "SEED-001:300; HAAS-118: expressions stand in [ ]"},
    {SyntaxErrorKind::condition_alone,             {stops, stops, stops, stops, stops, quiet, quiet, quiet}, "SEED-001:375-385; GH-ALM 1137"},
    {SyntaxErrorKind::consequence_without_then,    {stops, stops, stops, stops, stops, takes, takes, quiet}, "SEED-001:383; NCT: SEED-002:360; Haas: T"},
    {SyntaxErrorKind::words_after_then,            {doubt, stops, stops, doubt, doubt, quiet, takes, quiet}, "T: alarm 127 of older series"},
    {SyntaxErrorKind::more_after_then,             {stops, stops, stops, stops, stops, quiet, quiet, quiet}, "SEED-001:381; NCT: SEED-002:459 leaves doubt"},
    {SyntaxErrorKind::logic_outside_brackets,      {stops, stops, stops, stops, stops, takes, quiet, quiet}, "CNCWIKI-LOGIC; NCT: SEED-002:334"},
    {SyntaxErrorKind::words_beside_statement,      {stops, stops, stops, stops, stops, quiet, takes, quiet}, "GH-ALM 127; Haas: T, it takes some"},
    {SyntaxErrorKind::statement_beside_statement,  {doubt, doubt, doubt, doubt, doubt, quiet, quiet, quiet}, "T"},
    {SyntaxErrorKind::jump_beside_statement,       {stops, stops, stops, stops, stops, quiet, quiet, quiet}, "T: a shop mended it in nine programs after trials at its FANUC"},
    {SyntaxErrorKind::function_without_brackets,   {stops, stops, stops, stops, stops, takes, quiet, quiet}, "SEED-001:263-275; NCT: NCT-188, SEED-002:354"},
    {SyntaxErrorKind::comparison_as_value,         {stops, stops, stops, stops, stops, quiet, takes, quiet}, "SINHA-EXP; HAAS-118: all expressions set a conditional value"},
    {SyntaxErrorKind::sign_after_sign,             {stops, stops, stops, stops, stops, quiet, quiet, quiet}, "T; GH-ALM 1125"},
    {SyntaxErrorKind::missing_construct,           {stops, stops, stops, stops, stops, stops, stops, takes}, "ISORP; block IF of Mitsubishi: CNCWIKI-LOGIC, second hand; of the newest 30i and 0i by an option, off"},
    {SyntaxErrorKind::condition_before_return,     {stops, stops, stops, stops, stops, stops, takes, quiet}, "HAAS-118: a condition in a block of its own words"},
};

/// Forms of which the parser makes nothing special, by what the control stops at.
constexpr FaultForm fault_rows[] = {
    // fault                        fanuc  16i    0i-C   0i-D   30i    NCT    Haas   Mits.  source
    {faults::character,            {quiet, stops, stops, stops, stops, quiet, quiet, quiet}, "CSDN-PS 009; GH-ALM 009; T: &F2 is a word of some lathes"},
    {faults::block_number_misplaced,     {doubt, doubt, doubt, stops, stops, stops, quiet, quiet}, "NCT-173, NCT-188: N stands first; T: alarm 1013"},
    {faults::digits,               {quiet, stops, stops, quiet, quiet, quiet, quiet, quiet}, "CSDN-PS 003: eight figures"},
    {faults::expression,           {stops, stops, stops, stops, stops, quiet, quiet, quiet}, "IMD-114; GH-ALM 1125"},
    {faults::argument,             {stops, stops, stops, stops, stops, quiet, quiet, quiet}, "GH-ALM 1120"},
    {faults::output_form,          {stops, stops, stops, stops, stops, quiet, quiet, quiet}, "GH-ALM 1143"},
    {faults::long_name,            {quiet, quiet, quiet, stops, stops, quiet, quiet, quiet}, "GH-ALM 1142"},
    {faults::suffix,               {quiet, quiet, quiet, stops, stops, quiet, quiet, quiet}, "GH-ALM 1099"},
    {faults::long_variable_name,   {quiet, quiet, quiet, stops, stops, quiet, quiet, quiet}, "GH-ALM 1097, 1142"},
};
// clang-format on

/// The column of the control; nothing where the table has none.
std::optional<std::size_t> column_of(const ControlModel& control) {
    const auto* kin =
        std::ranges::find(alike, control.model, &std::pair<std::string_view, std::string_view>::first);
    const auto* model = std::ranges::find(models, kin == std::end(alike) ? control.model : kin->second);
    if (model == models.end()) return std::nullopt;
    return static_cast<std::size_t>(model - models.begin());
}

const Form& row_of(SyntaxErrorKind form) {
    const auto* row = std::ranges::find(rows, form, &Form::form);
    assert(row != std::end(rows));
    return *row;
}

} // namespace

Reading reading_of(const ControlModel& control, SyntaxErrorKind form) {
    const std::optional<std::size_t> column = column_of(control);
    return column ? row_of(form).readings[*column] : Reading::unknown;
}

Reading reading_of(const ControlModel& control, std::string_view fault) {
    const std::optional<std::size_t> column = column_of(control);
    const auto* row = std::ranges::find(fault_rows, fault, &FaultForm::fault);
    assert(row != std::end(fault_rows));
    return column ? row->readings[*column] : Reading::unknown;
}

std::string controls_that_take(SyntaxErrorKind form) {
    std::string names;
    const auto add = [&](std::string_view model) {
        if (!names.empty()) names += " or ";
        names += model;
    };
    for (std::size_t i = 0; i < model_count; ++i) {
        if (row_of(form).readings[i] != takes) continue;
        add(models[i]);
        for (const auto& [model, like] : alike)
            if (like == models[i] && !model.starts_with(like)) add(model); // "haas" stands for "haas-1999"
    }
    return names;
}

} // namespace maclint::fanuc
