//! The explicit list of all rules, in the order of their codes. A new rule is one line here.
#include "analyzer/program/tables.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

// One row a rule, in the order of their codes.
// clang-format off
#define MACLINT_RULES(RULE) \
    RULE(unused_suppression)                    /* MAC001 */ \
    RULE(unknown_rule_in_suppression)           /* MAC002 */ \
    RULE(unreadable_file)                       /* MAC003 */ \
    RULE(oversized_block)                       /* MAC004 */ \
    RULE(other_control)                         /* MAC005 */ \
    RULE(unterminated_comment)                  /* MAC102 */ \
    RULE(lower_case_code)                       /* MAC104 */ \
    RULE(letter_o_for_zero)                     /* MAC106 */ \
    RULE(too_many_digits)                       /* MAC107 */ \
    RULE(address_without_value)                 /* MAC109 */ \
    RULE(text_after_percent)                    /* MAC112 */ \
    RULE(space_inside_number)                   /* MAC115 */ \
    RULE(parenthesis_as_bracket)                /* MAC116 */ \
    RULE(bracket_mismatch)                      /* MAC117 */ \
    RULE(unknown_keyword)                       /* MAC118 */ \
    RULE(symbolic_comparison)                   /* MAC119 */ \
    RULE(unreadable_block)                      /* MAC121 */ \
    RULE(unreached_text)                        /* MAC122 */ \
    RULE(unknown_code)                          /* MAC123 */ \
    RULE(not_on_this_control)                   /* MAC124 */ \
    RULE(percent_in_comment)                    /* MAC125 */ \
    RULE(decimal_comma)                         /* MAC126 */ \
    RULE(format_of_output)                      /* MAC127 */ \
    RULE(real_time_macro)                       /* MAC128 */ \
    RULE(assignment_for_comparison)             /* MAC129 */ \
    RULE(assignment_to_null_variable)           /* MAC201 */ \
    RULE(variable_number_out_of_range)          /* MAC202 */ \
    RULE(write_to_read_only_variable)           /* MAC203 */ \
    RULE(double_hash)                           /* MAC206 */ \
    RULE(uninitialised_local)                   /* MAC209 */ \
    RULE(argument_not_passed)                   /* MAC210 */ \
    RULE(argument_unused)                       /* MAC211 */ \
    RULE(dead_store)                            /* MAC213 */ \
    RULE(overwritten_conditional)               /* MAC214 */ \
    RULE(crossed_axes)                          /* MAC215 */ \
    RULE(common_stale_read)                     /* MAC216 */ \
    RULE(common_clobber)                        /* MAC217 */ \
    RULE(zero_test_misses_vacant)               /* MAC220 */ \
    RULE(vacant_in_relational_comparison)       /* MAC221 */ \
    RULE(vacancy_lost_in_arithmetic)            /* MAC222 */ \
    RULE(unchecked_offset_number)               /* MAC225 */ \
    RULE(vacancy_test_never_true)               /* MAC228 */ \
    RULE(bare_number_for_variable)              /* MAC229 */ \
    RULE(ratio_as_length)                       /* MAC230 */ \
    RULE(read_of_write_only_variable)           /* MAC231 */ \
    RULE(suppression_value)                     /* MAC232 */ \
    RULE(value_for_number)                      /* MAC233 */ \
    RULE(code_of_other_group)                   /* MAC234 */ \
    RULE(jump_target_missing)                   /* MAC301 */ \
    RULE(goto_suspicious_target)                /* MAC302 */ \
    RULE(jump_into_loop)                        /* MAC303 */ \
    RULE(goto_number_format)                    /* MAC305 */ \
    RULE(goto_extra_words)                      /* MAC307 */ \
    RULE(while_without_do)                      /* MAC311 */ \
    RULE(do_without_end)                        /* MAC312 */ \
    RULE(end_without_do)                        /* MAC313 */ \
    RULE(loop_number_out_of_range)              /* MAC314 */ \
    RULE(loops_nested_too_deep)                 /* MAC315 */ \
    RULE(crossed_loops)                         /* MAC316 */ \
    RULE(loop_number_reuse_nested)              /* MAC317 */ \
    RULE(do_without_while)                      /* MAC318 */ \
    RULE(infinite_loop_unchanged)               /* MAC319 */ \
    RULE(infinite_loop_step)                    /* MAC320 */ \
    RULE(loop_never_executes)                   /* MAC321 */ \
    RULE(loop_exit_only_by_equality)            /* MAC322 */ \
    RULE(if_without_brackets)                   /* MAC324 */ \
    RULE(if_without_then)                       /* MAC325 */ \
    RULE(then_multiple_statements)              /* MAC326 */ \
    RULE(then_nc_statement)                     /* MAC327 */ \
    RULE(logic_outside_condition)               /* MAC329 */ \
    RULE(macro_and_nc_same_block)               /* MAC332 */ \
    RULE(m99_p_missing_label)                   /* MAC333 */ \
    RULE(endless_jump_loop)                     /* MAC336 */ \
    RULE(equal_branches)                        /* MAC337 */ \
    RULE(profile_block_missing)                 /* MAC338 */ \
    RULE(branch_falls_through)                  /* MAC339 */ \
    RULE(region_words_unpaired)                 /* MAC340 */ \
    RULE(remark_names_other_block)              /* MAC341 */ \
    RULE(loop_without_effect)                   /* MAC342 */ \
    RULE(call_without_program_number)           /* MAC401 */ \
    RULE(program_not_found)                     /* MAC402 */ \
    RULE(words_before_call)                     /* MAC403 */ \
    RULE(forbidden_argument)                    /* MAC404 */ \
    RULE(argument_order_ijk)                    /* MAC405 */ \
    RULE(argument_missing_decimal)              /* MAC408 */ \
    RULE(macro_calls_nested_too_deep)           /* MAC410 */ \
    RULE(subprogram_calls_nested_too_deep)      /* MAC411 */ \
    RULE(recursive_call)                        /* MAC412 */ \
    RULE(g66_not_cancelled)                     /* MAC413 */ \
    RULE(g67_without_g66)                       /* MAC414 */ \
    RULE(reference_under_modal_call)            /* MAC415 */ \
    RULE(m98_p_format)                          /* MAC417 */ \
    RULE(m98_with_arguments)                    /* MAC418 */ \
    RULE(two_calls_one_block)                   /* MAC423 */ \
    RULE(words_beside_modal_return)             /* MAC425 */ \
    RULE(start_block_missing)                   /* MAC426 */ \
    RULE(illegal_program_number)                /* MAC452 */ \
    RULE(duplicate_program_number)              /* MAC453 */ \
    RULE(missing_program_end)                   /* MAC455 */ \
    RULE(missing_m99)                           /* MAC456 */ \
    RULE(end_in_subprogram)                     /* MAC457 */ \
    RULE(unreachable_code)                      /* MAC460 */ \
    RULE(fallthrough_into_alarm)                /* MAC461 */ \
    RULE(duplicate_sequence_number)             /* MAC462 */ \
    RULE(sequence_number_zero)                  /* MAC463 */ \
    RULE(sequence_number_range)                 /* MAC464 */ \
    RULE(n_not_first)                           /* MAC465 */ \
    RULE(call_ends_in_alarm)                    /* MAC470 */ \
    RULE(file_and_number_differ)                /* MAC471 */ \
    RULE(argument_without_parameter)            /* MAC472 */ \
    RULE(modal_state_not_restored)              /* MAC501 */ \
    RULE(compensation_or_transform_left_active) /* MAC502 */ \
    RULE(feed_or_speed_not_restored)            /* MAC503 */ \
    RULE(motion_mode_not_restored)              /* MAC504 */ \
    RULE(restore_from_wrong_variable)           /* MAC505 */ \
    RULE(saved_value_lost)                      /* MAC506 */ \
    RULE(saved_state_never_restored)            /* MAC507 */ \
    RULE(cancel_order)                          /* MAC509 */ \
    RULE(compensation_without_move)             /* MAC510 */ \
    RULE(compensation_started_on_arc)           /* MAC511 */ \
    RULE(no_move_blocks_in_compensation)        /* MAC513 */ \
    RULE(modal_group_conflict)                  /* MAC514 */ \
    RULE(single_block_suppression_not_restored) /* MAC515 */ \
    RULE(data_not_closed)                       /* MAC516 */ \
    RULE(saved_after_change)                    /* MAC517 */ \
    RULE(modal_state_forced)                    /* MAC518 */ \
    RULE(offset_not_restored)                   /* MAC519 */ \
    RULE(offset_of_another_tool)                /* MAC520 */ \
    RULE(compensation_without_offset)           /* MAC521 */ \
    RULE(impossible_arc)                        /* MAC522 */ \
    RULE(word_missing)                          /* MAC523 */ \
    RULE(incremental_after_reference)           /* MAC524 */ \
    RULE(thread_under_surface_speed)            /* MAC525 */ \
    RULE(feed_of_the_other_mode)                /* MAC526 */ \
    RULE(code_forbidden_here)                   /* MAC527 */ \
    RULE(tool_change_unprepared)                /* MAC528 */ \
    RULE(chamfer_or_corner)                     /* MAC529 */ \
    RULE(tapping_order)                         /* MAC530 */ \
    RULE(mode_kept_across_change)               /* MAC531 */ \
    RULE(cycle_depth_above_level)               /* MAC532 */ \
    RULE(profile_cannot_be_turned)              /* MAC533 */ \
    RULE(turret_turned_at_work)                 /* MAC534 */ \
    RULE(plane_changed_under_compensation)      /* MAC535 */ \
    RULE(position_as_increment)                 /* MAC536 */ \
    RULE(integer_word_decimal)                  /* MAC551 */ \
    RULE(missing_decimal_motion)                /* MAC552 */ \
    RULE(feed_missing)                          /* MAC553 */ \
    RULE(spindle_missing)                       /* MAC554 */ \
    RULE(rapid_through_work)                    /* MAC555 */ \
    RULE(full_circle_by_radius)                 /* MAC558 */ \
    RULE(duplicate_address)                     /* MAC559 */ \
    RULE(safety_line_missing)                   /* MAC562 */ \
    RULE(spindle_or_coolant_left_on)            /* MAC563 */ \
    RULE(canned_cycle_data_mode)                /* MAC564 */ \
    RULE(canned_k0_misuse)                      /* MAC565 */ \
    RULE(dwell_format)                          /* MAC566 */ \
    RULE(return_through_zero)                   /* MAC567 */ \
    RULE(length_offset_missing)                 /* MAC568 */ \
    RULE(canned_cycle_over_tool_change)         /* MAC569 */ \
    RULE(surface_speed_without_clamp)           /* MAC570 */ \
    RULE(modal_code_as_number)                  /* MAC574 */ \
    RULE(words_exclude_each_other)              /* MAC575 */ \
    RULE(value_not_allowed)                     /* MAC576 */ \
    RULE(word_without_partner)                  /* MAC577 */ \
    RULE(code_not_alone)                        /* MAC578 */ \
    RULE(word_not_taken)                        /* MAC579 */ \
    RULE(blocks_out_of_order)                   /* MAC580 */ \
    RULE(word_not_listed)                       /* MAC581 */ \
    RULE(codes_not_together)                    /* MAC582 */ \
    RULE(too_many_words)                        /* MAC584 */ \
    RULE(feed_under_rapid)                      /* MAC585 */ \
    RULE(left_switched_on)                      /* MAC586 */ \
    RULE(shop_limits)                           /* MAC587 */ \
    RULE(alarm_number_out_of_range)             /* MAC601 */ \
    RULE(missing_argument_validation)           /* MAC604 */ \
    RULE(position_read_ahead)                   /* MAC605 */ \
    RULE(lookahead_output)                      /* MAC606 */ \
    RULE(skip_not_checked)                      /* MAC607 */ \
    RULE(look_ahead_limit_left_on)              /* MAC614 */ \
    RULE(position_for_touch)                    /* MAC615 */ \
    RULE(bracket_depth)                         /* MAC701 */ \
    RULE(division_by_zero)                      /* MAC702 */ \
    RULE(domain_error)                          /* MAC703 */ \
    RULE(right_angle_tangent)                   /* MAC704 */ \
    RULE(function_needs_bracket)                /* MAC706 */ \
    RULE(angle_in_radians)                      /* MAC707 */ \
    RULE(boolean_in_variable)                   /* MAC709 */ \
    RULE(float_equality)                        /* MAC710 */ \
    RULE(float_loop_counter)                    /* MAC711 */ \
    RULE(double_operator)                       /* MAC716 */ \
    RULE(constant_condition)                    /* MAC718 */ \
    RULE(duplicate_subcondition)                /* MAC719 */ \
    RULE(redundant_recompute)                   /* MAC720 */ \
    RULE(missing_tolerance)                     /* MAC726 */ \
    RULE(tolerance_inside_abs)                  /* MAC727 */ \
    RULE(logic_before_comparison)               /* MAC728 */ \
    RULE(function_arguments)                    /* MAC729 */ \
    RULE(block_number_too_long)                  /* DIN004 */ \
    RULE(block_must_be_alone)                    /* DIN008 */ \
    RULE(foreign_comment_style)                  /* DIN013 */ \
    RULE(param_description_unbalanced)           /* DIN014 */ \
    RULE(unit_unbalanced)                        /* DIN015 */ \
    RULE(block_group_unbalanced)                 /* DIN016 */ \
    RULE(value_with_blank)                       /* DIN018 */ \
    RULE(number_out_of_format)                   /* DIN019 */ \
    RULE(skip_level_outside_machining)           /* DIN020 */ \
    RULE(missing_machining)                      /* DIN101 */ \
    RULE(missing_end)                            /* DIN102 */ \
    RULE(content_after_end)                      /* DIN103 */ \
    RULE(localized_section_word)                 /* DIN104 */ \
    RULE(section_order)                          /* DIN105 */ \
    RULE(section_repeated)                       /* DIN106 */ \
    RULE(contour_group_missing)                  /* DIN108 */ \
    RULE(section_parameter)                      /* DIN109 */ \
    RULE(turret_and_magazine)                    /* DIN115 */ \
    RULE(duplicate_tool_pocket)                  /* DIN117 */ \
    RULE(tool_not_in_turret)                     /* DIN118 */ \
    RULE(tool_edge_range)                        /* DIN119 */ \
    RULE(converted_leftovers)                    /* DIN123 */ \
    RULE(second_contour)                         /* DIN204 */ \
    RULE(contour_name_missing)                   /* DIN205 */ \
    RULE(finished_outside_blank)                 /* DIN209 */ \
    RULE(recess_off_line)                        /* DIN213 */ \
    RULE(undercut_before_slope)                  /* DIN217 */ \
    RULE(level_unbalanced)                       /* DIN225 */ \
    RULE(full_circle_arc)                        /* DIN229 */ \
    RULE(corner_longer_than_line)                /* DIN239 */ \
    RULE(milled_contour_open)                    /* DIN241 */ \
    RULE(figure_size)                            /* DIN243 */ \
    RULE(holes_run_together)                     /* DIN244 */ \
    RULE(contour_behind_cycle)                   /* DIN246 */ \
    RULE(contour_name_twice)                     /* DIN247 */ \
    RULE(reserved_global)                        /* DIN303 */ \
    RULE(string_number_mismatch)                 /* DIN305 */ \
    RULE(integer_global_fraction)                /* DIN306 */ \
    RULE(integer_overflow)                       /* DIN307 */ \
    RULE(name_rule)                              /* DIN308 */ \
    RULE(const_before_definition)                /* DIN309 */ \
    RULE(const_var_after_machining)              /* DIN310 */ \
    RULE(const_reassigned)                       /* DIN311 */ \
    RULE(undeclared_name)                        /* DIN312 */ \
    RULE(var_alias_collision)                    /* DIN314 */ \
    RULE(index_is_expression)                    /* DIN315 */ \
    RULE(interpolation_read_early)               /* DIN317 */ \
    RULE(calc_without_slide)                     /* DIN319 */ \
    RULE(bitset_range)                           /* DIN321 */ \
    RULE(window_range)                           /* DIN322 */ \
    RULE(def_with_hash)                          /* DIN323 */ \
    RULE(assign_vs_compare)                      /* DIN326 */ \
    RULE(input_not_variable)                     /* DIN329 */ \
    RULE(transfer_value_unchecked)               /* DIN330 */ \
    RULE(transfer_value_unknown)                 /* DIN331 */ \
    RULE(plc_variable_type)                      /* DIN333 */ \
    RULE(unknown_selector)                       /* DIN336 */ \
    RULE(unknown_internal_constant)              /* DIN337 */ \
    RULE(other_vacancy_test)                     /* DIN338 */ \
    RULE(if_unbalanced)                          /* DIN401 */ \
    RULE(then_missing)                           /* DIN402 */ \
    RULE(too_many_conditions)                    /* DIN403 */ \
    RULE(while_unbalanced)                       /* DIN404 */ \
    RULE(loop_variable_uninitialised)            /* DIN407 */ \
    RULE(switch_unbalanced)                      /* DIN409 */ \
    RULE(case_without_break)                     /* DIN410 */ \
    RULE(duplicate_case)                         /* DIN411 */ \
    RULE(default_position)                       /* DIN412 */ \
    RULE(switch_not_variable)                    /* DIN413 */ \
    RULE(m99_target)                             /* DIN415 */ \
    RULE(shift_adds_up)                          /* DIN418 */ \
    RULE(condition_without_comparison)           /* DIN422 */ \
    RULE(else_twice)                             /* DIN423 */ \
    RULE(v1_on_local)                            /* DIN504 */ \
    RULE(return_in_main)                         /* DIN507 */ \
    RULE(sub_name_length)                        /* DIN509 */ \
    RULE(duplicate_sub)                          /* DIN510 */ \
    RULE(too_many_transfer_values)               /* DIN511 */ \
    RULE(unknown_transfer_letter)                /* DIN512 */ \
    RULE(param_description_limits)               /* DIN514 */ \
    RULE(ln_misuse)                              /* DIN515 */ \
    RULE(repeat_count)                           /* DIN516 */ \
    RULE(state_leak_from_sub)                    /* DIN519 */ \
    RULE(radius_comp_not_cancelled)              /* DIN619 */ \
    RULE(g16_not_reset)                          /* DIN632 */ \
    RULE(g920_not_reset)                         /* DIN634 */ \
    RULE(arc_geometry)                           /* DIN662 */ \
    RULE(contour_reference_missing)              /* DIN704 */ \
    RULE(two_contours_named)                     /* DIN705 */ \
    RULE(wrong_kind_of_block)                    /* DIN706 */ \
    RULE(thread_without_pitch)                   /* DIN720 */ \
    RULE(pilot_mark_undefined)                   /* DIN819 */ \
    RULE(plane_of_contour)                       /* DIN833 */ \
    RULE(sync_mark_unmatched)                    /* DIN902 */ \
    RULE(sync_deadlock)                          /* DIN903 */ \
    RULE(slide_not_in_head)                      /* DIN905 */ \
    RULE(g30_left_active)                        /* DIN906 */ \
    RULE(result_unchecked)                       /* DIN930 */ \
    RULE(second_measuring_move)                  /* DIN951 */ \
    RULE(foreign_control_word)                   /* SIN104 */ \
    RULE(missing_equals)                         /* SIN105 */ \
    RULE(remark_without_semicolon)               /* SIN106 */ \
    RULE(remark_in_parentheses)                  /* SIN107 */ \
    RULE(colon_in_jump)                          /* SIN109 */ \
    RULE(two_blocks_in_a_line)                   /* SIN110 */ \
    RULE(control_word_not_alone)                 /* SIN111 */ \
    RULE(label_at_structure)                     /* SIN112 */ \
    RULE(bad_identifier)                         /* SIN113 */ \
    RULE(name_is_taken)                          /* SIN114 */ \
    RULE(text_too_long)                          /* SIN115 */ \
    RULE(block_too_long)                         /* SIN116 */ \
    RULE(unknown_g_code)                         /* SIN117 */ \
    RULE(too_many_functions)                     /* SIN120 */ \
    RULE(malformed_case)                         /* SIN123 */ \
    RULE(split_declaration)                      /* SIN124 */ \
    RULE(definition_after_code)                  /* SIN201 */ \
    RULE(undefined_name)                         /* SIN202 */ \
    RULE(misspelled_name)                        /* SIN203 */ \
    RULE(unknown_system_variable)                /* SIN204 */ \
    RULE(index_out_of_range)                     /* SIN207 */ \
    RULE(wrong_dimensions)                       /* SIN208 */ \
    RULE(type_clash)                             /* SIN209 */ \
    RULE(fraction_into_int)                      /* SIN210 */ \
    RULE(int_overflow)                           /* SIN211 */ \
    RULE(too_many_initial_values)                /* SIN213 */ \
    RULE(ambiguous_label)                        /* SIN302 */ \
    RULE(for_never_runs)                         /* SIN303 */ \
    RULE(case_value_twice)                       /* SIN304 */ \
    RULE(repetition_marks)                       /* SIN305 */ \
    RULE(missing_reference_argument)             /* SIN402 */ \
    RULE(fewer_arguments)                        /* SIN403 */ \
    RULE(reference_needs_variable)               /* SIN404 */ \
    RULE(extern_differs)                         /* SIN405 */ \
    RULE(arguments_without_proc)                 /* SIN407 */ \
    RULE(other_program_name)                     /* SIN408 */ \
    RULE(cycle_under_compensation)               /* SIN411 */ \
    RULE(cycle_planes)                           /* SIN412 */ \
    RULE(stop_under_compensation)                /* SIN501 */ \
    RULE(tool_change_under_compensation)         /* SIN502 */ \
    RULE(frame_replaces)                         /* SIN504 */ \
    RULE(position_as_distance)                   /* SIN505 */ \
    RULE(tapping_without_position)               /* SIN506 */ \
    RULE(action_on_local_variable)               /* SIN601 */ \
    RULE(action_id)                              /* SIN602 */ \
    RULE(action_left)                            /* SIN603 */ \
    RULE(difference_compared_with_zero)          /* SIN701 */
// clang-format on

namespace maclint {
namespace rules {

#define MACLINT_DECLARE(name) extern const Rule name;
MACLINT_RULES(MACLINT_DECLARE)
#undef MACLINT_DECLARE

} // namespace rules

namespace {

#define MACLINT_ADDRESS(name) &rules::name,
constexpr auto list = std::to_array<const Rule*>({MACLINT_RULES(MACLINT_ADDRESS)});
#undef MACLINT_ADDRESS

bool equal_without_case(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

} // namespace

std::span<const Rule* const> all_rules() { return list; }

bool applies_to(const Rule& rule, const ControlModel& control) {
    if (!control.rules_tried.empty() && !std::ranges::binary_search(control.rules_tried, rule.code))
        return false;
    return std::ranges::all_of(rule.needs, [&](Capability capability) { return control.has(capability); });
}

bool lists_code(std::string_view codes, std::string_view code) {
    for (std::size_t begin = 0; begin < codes.size();) {
        const std::size_t end = std::min(codes.find(' ', begin), codes.size());
        if (equal_without_case(codes.substr(begin, end - begin), code)) return true;
        begin = end + 1;
    }
    return false;
}

const Rule* find_rule(std::string_view code_or_name) {
    const auto found = std::ranges::find_if(list, [&](const Rule* rule) {
        return equal_without_case(rule->code, code_or_name) || equal_without_case(rule->name, code_or_name) ||
               lists_code(rule->aliases, code_or_name);
    });
    return found == list.end() ? nullptr : *found;
}

} // namespace maclint
