//! Ways of writing at which the controls of the family differ.
#include "analyzer/dialect/fanuc/tables.hpp"

#include <algorithm>
#include <cassert>

namespace maclint::fanuc {
namespace {

constexpr std::size_t model_count = 7;
/// The columns of the table.
constexpr std::array<std::string_view, model_count> models = {
    "fanuc", "fanuc-16i", "fanuc-0i-c", "fanuc-0i-d", "fanuc-30i", "nct", "haas"};

struct Form {
    SyntaxErrorKind form;
    std::array<Reading, model_count> readings;
    [[maybe_unused]] std::string_view source;
};

constexpr Reading takes = Reading::takes, stops = Reading::stops, quiet = Reading::unknown,
                  doubt = Reading::doubtful;

// clang-format off
constexpr Form rows[] = {
    // form                                         fanuc  16i    0i-C   0i-D   30i    NCT    Haas   source
    {SyntaxErrorKind::letter_o,                    {stops, stops, stops, stops, stops, stops, stops}, "CSDN-VAR"},
    {SyntaxErrorKind::letter_o_or_jump,            {stops, stops, stops, stops, stops, stops, stops}, "CSDN-VAR"},
    {SyntaxErrorKind::missing_value,               {stops, stops, stops, stops, stops, doubt, doubt}, "CSDN-PS; GH-ALM 005"},
    {SyntaxErrorKind::double_sharp,                {stops, stops, stops, stops, stops, stops, stops}, "NCT-173"},
    {SyntaxErrorKind::letter_in_jump,              {stops, stops, stops, stops, stops, stops, quiet}, "IMD-114; NCT-188: n is a number, a variable or a formula"},
    {SyntaxErrorKind::words_after_jump,            {stops, stops, stops, stops, stops, quiet, quiet}, "T; GH-ALM 127"},
    {SyntaxErrorKind::condition_without_brackets,  {stops, stops, stops, stops, stops, stops, stops}, "SEED-001:300; HAAS-118: expressions stand in [ ]"},
    {SyntaxErrorKind::condition_alone,             {stops, stops, stops, stops, stops, quiet, quiet}, "SEED-001:375-385; GH-ALM 1137"},
    {SyntaxErrorKind::consequence_without_then,    {stops, stops, stops, stops, stops, takes, takes}, "SEED-001:383; NCT: SEED-002:360; Haas: T"},
    {SyntaxErrorKind::words_after_then,            {doubt, stops, stops, doubt, doubt, quiet, takes}, "T: alarm 127 of older series"},
    {SyntaxErrorKind::more_after_then,             {stops, stops, stops, stops, stops, quiet, quiet}, "SEED-001:381; NCT: SEED-002:459 leaves doubt"},
    {SyntaxErrorKind::logic_outside_brackets,      {stops, stops, stops, stops, stops, takes, quiet}, "CNCWIKI-LOGIC; NCT: SEED-002:334"},
    {SyntaxErrorKind::words_beside_statement,      {stops, stops, stops, stops, stops, quiet, takes}, "GH-ALM 127; Haas: T, it takes some"},
    {SyntaxErrorKind::statement_beside_statement,  {doubt, doubt, doubt, doubt, doubt, quiet, quiet}, "T"},
    {SyntaxErrorKind::function_without_brackets,   {stops, stops, stops, stops, stops, takes, quiet}, "SEED-001:263-275; NCT: NCT-188, SEED-002:354"},
    {SyntaxErrorKind::comparison_as_value,         {stops, stops, stops, stops, stops, quiet, takes}, "SINHA-EXP; HAAS-118: all expressions set a conditional value"},
    {SyntaxErrorKind::sign_after_sign,             {stops, stops, stops, stops, stops, quiet, quiet}, "T; GH-ALM 1125"},
};
// clang-format on

const Form& row_of(SyntaxErrorKind form) {
    const auto* row = std::ranges::find(rows, form, &Form::form);
    assert(row != std::end(rows));
    return *row;
}

} // namespace

Reading reading_of(const ControlModel& control, SyntaxErrorKind form) {
    const auto* model = std::ranges::find(models, control.model);
    return model == models.end() ? Reading::unknown
                                 : row_of(form).readings[static_cast<std::size_t>(model - models.begin())];
}

std::string controls_that_take(SyntaxErrorKind form) {
    std::string names;
    for (std::size_t i = 0; i < model_count; ++i) {
        if (row_of(form).readings[i] != takes) continue;
        if (!names.empty()) names += " or ";
        names += models[i];
    }
    return names;
}

} // namespace maclint::fanuc
