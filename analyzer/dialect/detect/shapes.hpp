//! Marks that are more than a fixed text: each looks at one line.
#pragma once

#include "analyzer/dialect/detect/line.hpp"

namespace maclint::detect {

// ---- lines of plain words ----
bool tool_feed_and_speed_in_one_block(const Line& line); ///< `T3 G95 F0.25 G96 S200`, DIN PLUS
bool cycle_of_three_digits(const Line& line);            ///< `G810`, `G402`
bool tool_change_point(const Line& line);                ///< `G14 Q0`
bool c_axis_rapid_alone(const Line& line);               ///< `G110 C0`
bool tolerance_of_g64(const Line& line);                 ///< `G64 P0.01`
bool probing_move(const Line& line);                     ///< `G38.2`
bool offset_by_l20(const Line& line);                    ///< `G10 L20`
bool digital_output(const Line& line);                   ///< `M62 P1`
bool extrusion(const Line& line);                        ///< `G1 X1 E0.5`
bool extruder_zero(const Line& line);                    ///< `G92 E0`
bool heater(const Line& line);                           ///< `M104 S200`
bool work_offset_by_g15(const Line& line);               ///< `G15 H1`
bool macro_call(const Line& line);                       ///< `G65 P9100`
bool citizen_cycle(const Line& line);                    ///< `G650`, Citizen
bool tool_in_hundreds(const Line& line);                 ///< `T200`, Citizen
bool language_switch(const Line& line);                  ///< `G291`, SINUMERIK

// ---- other code ----
bool program_number(const Line& line);       ///< `O1234` and no more
bool loop(const Line& line);                 ///< `WHILE[…]DO1`
bool goto_after_condition(const Line& line); ///< `IF[…]GOTO10`, `IF[…]THEN`
bool o_word(const Line& line);               ///< `o100 sub`, `o<name> call`
bool klartext_function(const Line& line);    ///< `FN 0: Q1 = +5`
bool klartext_line(const Line& line);        ///< `L X+10 R0 FMAX`
bool ends_in_star(const Line& line);         ///< `N10 G00 X+5 *`
bool r_parameter(const Line& line);          ///< `R10=`
bool array_element(const Line& line);        ///< `DEPTH[3]=`
bool macro_definition(const Line& line);     ///< `DEFINE MIST AS M27`
bool condition_row(const Line& line);        ///< `E001=10 16 15`
bool setting(const Line& line);              ///< `$H`, `$120=50`
bool osp_file_name(const Line& line);        ///< `$PART.MIN%`
bool osp_variable(const Line& line);         ///< `VC1=`
bool remark(const Line& line);               ///< `; text` that is no block

bool path_mark(const Line& line);       ///< `$1` alone, lathes of several paths
bool path_wait(const Line& line);       ///< `!L1`, `!2L1`
bool assigns_l(const Line& line);       ///< `L1=197`, TRAUB
bool value_of_l(const Line& line);      ///< `G59X0ZL1`, `Z-[L2+1.35]`, TRAUB
bool open_directive(const Line& line);  ///< `[BILLET X60 Z70`, Denford
bool alignment_block(const Line& line); ///< `:10 G0 X5`, `:G70`, Acramatic
bool fadal_variable(const Line& line);  ///< `#V1=`, `#R2`
bool fagor_head(const Line& line);      ///< `%SHAFT,MX,`
bool fagor_register(const Line& line);  ///< `P1=K5`, older FAGOR
bool fagor_statement(const Line& line); ///< `(IF P1 EQ 0 GOTO N100)`, `(CALL 12)`
bool fagor_parameter(const Line& line); ///< `(P100=P101+5)`

// ---- DIN PLUS ----
bool section_word(const Line& line);
bool end_of_program_word(const Line& line);
bool variable_with_letter(const Line& line);    ///< `#l1`, `#n95(F)`
bool named_variable(const Line& line);          ///< `#_depth`
bool incremental_address(const Line& line);     ///< `Zi-5`
bool address_of_two_letters(const Line& line);  ///< `BR2`, `XK5`
bool unknown_coordinate(const Line& line);      ///< `X?`
bool slide(const Line& line);                   ///< `$1 N10`
bool file_name(const Line& line);               ///< `%part.nc`
bool bracketed_remark(const Line& line);        ///< `[text]`
bool elided_number(const Line& line);           ///< `N.. G1`, as manuals print it
bool words_in_round_brackets(const Line& line); ///< `(ROUGH OUTSIDE)`, which no DIN PLUS is

} // namespace maclint::detect
