//! What several codes of DIN PLUS say. Numbers are lines of the manual.
#pragma once

#include "rules/words/book_lines.hpp"

namespace maclint::code_books {

// clang-format off
// Something must be on before.
inline constexpr BookLine wants_c_axis =
    book::refused(20044, "the C axis does not turn").while_off("C axis").also("DIN652");
inline constexpr BookLine wants_c_axis_to_mill =
    book::refused(23179, "the part does not turn with the tool").under("G18").while_off("C axis").also("DIN652");
inline constexpr BookLine wants_feed =
    book::refused(10346, "no feed has been given").when("-F").while_off("feed").as(Severity::error).also("DIN605");
inline constexpr BookLine wants_reference_diameter =
    book::refused(16288, "nobody knows the diameter that CY is measured on").when("CY").while_off("reference diameter").also("DIN654");
inline constexpr BookLine wants_speed =
    book::refused(10346, "no speed has been given").when("-S").while_off("speed").also("DIN606");
inline constexpr BookLine wants_speed_limit =
    book::refused(12598, "the speed rises to the highest of the machine").when("X<0.001").under("G96").while_off("speed limit").also("DIN602");
inline constexpr BookLine wants_spindle =
    book::refused(10346, "the tool cuts with no spindle turning").when("-M").while_off("main spindle, spindle 1, spindle 2, spindle 3").also("DIN604");
inline constexpr BookLine wants_spindle_per_revolution =
    book::refused(10346, "the tool cuts with no spindle turning").when("-M").under("G95 G93").while_off("main spindle, spindle 1, spindle 2, spindle 3, measuring").also("DIN604");
inline constexpr BookLine wants_spindle_at_angle =
    book::refused(16777, "the spindle stands at no angle").while_off("C axis, spindle at an angle").also("DIN813");
inline constexpr BookLine wants_tool =
    book::refused(10343, "nobody knows which tool is at the part").when("-T").while_off("tool").as(Severity::error).also("DIN603");
inline constexpr BookLine wants_tool_lengths =
    book::refused(18163, "the slide moves without the length of its tool").while_on("suspension of zero points and tool lengths");
inline constexpr BookLine wants_zero_points =
    book::refused(18157, "positions count from the zero point of the machine").while_on("suspension of zero points");

// Something must be off, or another code in force.
inline constexpr BookLine in_turning_plane =
    book::refused(23177, "it turns in the XZ plane").under("G17 G19").also("DIN633");
inline constexpr BookLine in_xy_plane =
    book::refused(23173, "it works in the XY plane").under("G18 G19").as(Severity::error).also("DIN832");
inline constexpr BookLine in_y_plane =
    book::refused(23167, "it mills in the XY or the YZ plane").under("G18").as(Severity::error).also("DIN832");
inline constexpr BookLine in_yz_plane =
    book::refused(23181, "it works in the YZ plane").under("G17 G18").as(Severity::error).also("DIN832");
inline constexpr BookLine kept_in_hdt_mode =
    book::refused(18566, "zero points and tool lengths stay as they are in HDT mode").while_on("HDT mode").as(Severity::error).also("DIN915");
inline constexpr BookLine no_b_in_hdt_mode =
    book::refused(18556, "the B axis cannot move in HDT mode").when("B").while_on("HDT mode").as(Severity::error).also("DIN915");
inline constexpr BookLine no_shift_in_tilted_plane =
    book::refused(23218, "no other shift is allowed in a tilted plane").while_on("tilted plane").as(Severity::error).also("DIN631");
inline constexpr BookLine no_y_in_hdt_mode =
    book::refused(18556, "a move in Y runs along X in HDT mode").when("Y").while_on("HDT mode").also("DIN915");
inline constexpr BookLine not_as_c_axis =
    book::refused(20045, "a spindle that is a C axis does not turn").while_on("C axis").also("DIN653");
inline constexpr BookLine not_tilted =
    book::refused(25497, "nothing is turned in a tilted plane").while_on("tilted plane");
inline constexpr BookLine not_under_constant_cutting_speed =
    book::refused(12598, "the speed changes with the diameter, and the lead with it").under("G96").also("DIN723");
inline constexpr BookLine side_changes_with_tip =
    book::refused(13057, "the side of the compensation changes with the tip").under("G41 G42").also("DIN622");
inline constexpr BookLine turns_speed_over =
    book::refused(12609, "the control leaves the constant cutting speed for the tool, and the speed jumps").under("G96").also("DIN609");
inline constexpr BookLine without_c_axis =
    book::refused(20045, "the C axis holds the spindle").while_on("C axis").also("DIN653");
inline constexpr BookLine without_compensation =
    book::refused(12663, "the cycle compensates by itself").under("G41 G42").as(Severity::error).also("DIN618");

// A block of a contour that a cycle names is of the right kind [20803].
inline constexpr BookLine names_hole =
    book::names_none("NS", "G401 G402 G411 G412 G471 G472 G481 G482 G301 G302 G303 G304 G305 G307 G311 G312 G313 G314 G315 G317 G0 G1 G2 G3 G12 G13 G306 G316 G22 G23 G24 G25 G34 G37", "G49 G300 G310", 20812, "it drills holes, and a pattern is named by its hole").also("DIN228");
inline constexpr BookLine names_milled_contour =
    book::names_none("NS", "G401 G402 G411 G412 G471 G472 G481 G482 G0 G1 G2 G3 G12 G13 G22 G23 G24 G25 G34 G37 G49 G300 G310 G306 G316 G100 G110 G170 G180", "G301 G304 G311 G314", 20818, "it mills figures and contours of the face or the lateral surface").also("DIN228");
inline constexpr BookLine names_turning_contour =
    book::names_none("NS", "G301 G302 G303 G304 G305 G307 G311 G312 G313 G314 G315 G317 G300 G310 G49 G306 G316 G401 G402 G411 G412 G471 G472 G481 G482", "G1", 20805, "it machines turning contours");
// clang-format on

inline constexpr BookLine not_while_speed_swings =
    book::refused(18167, "the lead of the thread follows the speed").while_on("swinging speed");

} // namespace maclint::code_books
