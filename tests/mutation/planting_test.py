"""The planter plants what it says, leaves out what does no harm, and counts what maclint finds."""
import os
import tempfile
import unittest
from pathlib import Path

from planting import (dinplus, edit, fanuc, fanuc_calls, fanuc_conditions, fanuc_forms, fanuc_jumps, fanuc_loops, fanuc_modal,
                      fanuc_numbers, fanuc_saved, fanuc_variables, report, runs, shows)
from planting.callers import Callers
from planting.judge import Judge
from planting.plants import KINDS, Plant
from planting.workspace import Corpus

DRILL = '''%
O9001(ROW)
IF[#24EQ#0]GOTO9
IF[#26EQ#0]GOTO9
#33=#4003
#34=#4109
#30=1
G90
WHILE[#30LE#11]DO1
G81X[#24*#30]Z#26F#9
#30=#30+1
END1
G80
G#33F#34
M99
N9#3000=1(X OR Z IS MISSING)
%'''


def program(text):
    return fanuc.programs_of(text.split('\n'))[0]


def planted(generator, text, kind):
    """(new lines, why it is harmless) of each plant of this class."""
    lines = text.split('\n')
    return [([new for _, new in sorted(edit.apply(lines, edits).items())], harmless)
            for name, edits, harmless in generator(program(text)) if name == kind]


def loops(read):
    return fanuc_loops.plants(read, set())


def conditions(read):
    return fanuc_conditions.plants(read, set())


class Reader(unittest.TestCase):
    def test_comments_are_blank_and_columns_stay(self):
        self.assertEqual(fanuc.code_of('g1 (x1.) y2.\r'), 'G1       Y2. ')

    def test_a_jump_takes_the_next_block_of_that_number(self):
        jumps = program('O1\nN1G0X1.\nGOTO1\nG0X2.\nN1M30')
        self.assertEqual(jumps.successors[1], [3])

    def test_a_loop_ends_after_its_end(self):
        loop = program('O1\nWHILE[#1LT5]DO1\n#1=#1+1\nEND1\nM30')
        self.assertEqual(loop.successors, [[1, 3], [2], [0], []])

    def test_a_condition_goes_on_and_an_alarm_does_not(self):
        alarm = program('O1\nIF[#1EQ#0]THEN#3000=1\n#3000=2\nM30')
        self.assertEqual(alarm.successors, [[1], [], []])

    def test_a_store_with_a_base_of_100_or_a_common_variable_reaches_no_local(self):
        self.assertEqual([fanuc.reaches_locals(index) for index in ('#1', '2000+#1', '#111+6', '#1+6')], [True, False, False, True])

    def test_a_call_after_a_sequence_number_is_a_call(self):
        self.assertTrue(program('O1\nN300G65P9001').blocks[0].is_call)


class Jumps(unittest.TestCase):
    def test_a_goto_names_no_block(self):
        self.assertEqual(planted(fanuc_jumps.plants, 'O1\nGOTO12\nN12M30', 'goto-nowhere'), [(['GOTO21'], '')])

    def test_a_jump_that_no_path_leads_to_is_left_out(self):
        self.assertEqual(planted(fanuc_jumps.plants, 'O1\nM30\nGOTO12\nN12M30', 'goto-nowhere')[0][1], 'no path leads to this block')

    def test_a_second_label_misleads_only_jumps_that_meet_it_first(self):
        misled = 'O1\nGOTO5\nN3G0X1.\nN5M30'
        safe = 'O1\nGOTO5\nN5G0X1.\nN6M30'
        self.assertEqual(planted(fanuc_jumps.plants, misled, 'label-doubled'), [(['N5G0X1.'], '')])
        self.assertEqual(planted(fanuc_jumps.plants, safe, 'label-doubled'), [(['N5M30'], 'every jump takes the block that was meant')])

    def test_a_branch_becomes_the_other_one(self):
        text = 'O1\nIF[#1EQ1]GOTO4\n#33=#24\nGOTO5\nN4#33=-#24\nN5G0X#33\nM99'
        self.assertEqual(planted(fanuc_jumps.plants, text, 'branch-copied'), [(['#33=-#24'], '')])

    def test_a_cycle_with_another_way_out_is_left_out(self):
        trapped = 'O1\nN1G0X1.\nIF[#100LT5]GOTO1\nM30'
        free = 'O1\nN1G0X1.\nIF[#101EQ1]GOTO9\nIF[#100LT5]GOTO1\nN9M30'
        self.assertEqual(planted(fanuc_jumps.plants, trapped, 'endless-jump'), [(['GOTO1'], '')])
        self.assertTrue(planted(fanuc_jumps.plants, free, 'endless-jump')[0][1])


class Loops(unittest.TestCase):
    def test_steps(self):
        self.assertEqual(planted(loops, DRILL, 'step-removed'), [([''], '')])
        self.assertEqual(planted(loops, DRILL, 'step-sign'), [(['#30=#30-1'], '')])
        self.assertEqual(planted(loops, DRILL, 'step-zero'), [(['#30=#30+0'], '')])

    def test_a_step_becomes_a_fraction_where_a_limit_is_compared(self):
        self.assertEqual(planted(loops, DRILL, 'step-fraction'), [(['#30=#30+0.2'], '')])
        self.assertEqual(planted(loops, 'O1\nN1G0X#1\n#1=#1+1.\nIF[#1LT5]GOTO1\nM30', 'step-fraction'), [(['#1=#1+.05'], '')])
        self.assertEqual(planted(loops, 'O1\n#1=#1+1.\nIF[#1LT5]GOTO1\nN1M30', 'step-fraction'), [])

    def test_the_first_value_of_a_counter_is_removed_where_nothing_else_sets_it(self):
        self.assertEqual(planted(loops, DRILL, 'first-value-removed'), [([''], '')])
        self.assertEqual(planted(loops, DRILL.replace('#30', '#7'), 'first-value-removed'), [])

    def test_a_loop_that_is_left_otherwise_is_no_place(self):
        left = DRILL.replace('#30=#30+1', 'IF[#5001GT5]GOTO9\n#30=#30+1')
        self.assertEqual(planted(loops, left, 'step-removed'), [([''], 'the loop leaves by another jump')])

    def test_a_call_of_a_program_that_is_not_there_may_stop(self):
        calling = DRILL.replace('#30=#30+1', 'G65P7\n#30=#30+1')
        self.assertEqual(planted(loops, calling, 'step-removed')[0][1], 'a called program that is not there may stop')
        found = [reason for kind, _, reason in fanuc_loops.plants(program(calling), {7}) if kind == 'step-removed']
        self.assertEqual(found, [''])

    def test_a_called_program_may_stop_by_what_it_reads_of_the_machine(self):
        calling = DRILL.replace('#30=#30+1', 'G65P7\n#30=#30+1')
        alarm = 'O7\nIF[#%s GT5]GOTO1\nM99\nN1#3000=1'

        def reason(callee):
            return [harmless for kind, _, harmless in fanuc_loops.plants(program(calling), {7}, {7: program(callee)})
                    if kind == 'step-removed']

        self.assertEqual(reason(alarm % '1'), [''])
        self.assertEqual(reason(alarm % '5041'), ['a called program may stop, and reads the machine or waits'])
        self.assertEqual(reason('O7\nM0\nM99'), ['a called program may stop, and reads the machine or waits'])

    def test_a_loop_with_a_block_that_nobody_can_read_is_no_place(self):
        self.assertEqual(planted(loops, DRILL.replace('G81X', '#103=ABS(#24)\nG81X'), 'step-removed')[0][1],
                         'a block of the loop cannot be read')

    def test_a_loop_that_the_control_does_not_enter_is_no_place(self):
        refused = 'O1\nWHILE[#1LT5]DO5\n#1=#1+1\nEND5\nM30'
        self.assertEqual(planted(loops, refused, 'end-removed'), [([''], 'the control stops at the DO before it')])
        self.assertEqual(planted(loops, refused.replace('DO5', 'DO1').replace('END5', 'END1'), 'end-removed'), [([''], '')])

    def test_a_limit_that_the_machine_changes_is_no_place(self):
        waiting = 'O1\n#1=0\nWHILE[#1LT#3001]DO1\n#1=#1+1\nEND1\nM30'
        self.assertEqual(planted(loops, waiting, 'step-removed'), [([''], 'the machine changes what the condition reads')])


class Conditions(unittest.TestCase):
    @staticmethod
    def harmless(text):
        return [reason for _, reason in planted(conditions, text, 'vacancy-as-zero')]

    def test_a_vacancy_test_that_asks_for_0(self):
        self.assertEqual(planted(conditions, 'O1\nIF[#24EQ#0]GOTO8\nG0X#24\nM99\nN8#3000=1', 'vacancy-as-zero'),
                         [(['IF[#24EQ0]GOTO8'], '')])

    def test_each_test_for_vacancy_in_a_block_is_a_place(self):
        self.assertEqual(planted(conditions, 'O1\nIF[[#24EQ#0]OR[#0EQ#25]]GOTO8\nWHILE[#33NE#00]DO1\nEND1\nN8M99', 'vacancy-as-zero'),
                         [(['IF[[#24EQ0]OR[#0EQ#25]]GOTO8'], ''), (['IF[[#24EQ#0]OR[0EQ#25]]GOTO8'], ''), (['WHILE[#33NE0]DO1'], '')])

    def test_a_common_variable_is_a_place_where_the_program_says_that_it_can_be_vacant(self):
        unknown = 'no local variable, and nothing but this test says that it can be vacant'
        self.assertEqual(self.harmless('O1\nIF[#140EQ#0]GOTO8\nG0X#140\nN8M99'), [unknown])
        self.assertEqual(self.harmless('O1\nIF[#140EQ#0]GOTO8\nG0X#140\nN8#140=#0\nM99'), [''])

    def test_what_stands_twice(self):
        self.assertEqual(planted(conditions, 'O1\nIF[[#1EQ0]OR[#2EQ0]]GOTO8\nN8M99', 'part-doubled'),
                         [(['IF[[#1EQ0]OR[#1EQ0]]GOTO8'], '')])
        self.assertEqual(planted(conditions, 'O1\nIF[#1EQ1]THEN#33=4\nIF[#1EQ2]THEN#33=5\nM99', 'case-doubled'),
                         [(['IF[#1EQ1]THEN#33=5'], '')])
        self.assertEqual(planted(conditions, 'O1\nIF[#1EQ1]THEN#33=4\nIF[#1EQ2]THEN#33=#33+5\nM99', 'case-doubled'), [])


class Numbers(unittest.TestCase):
    def test_a_divisor(self):
        divided = 'O1\n#33=[#1+2]/4\nG0X[360/#6]\nM99'
        self.assertEqual(planted(fanuc_numbers.plants, divided, 'divisor-zero'), [(['#33=[#1+2]/0'], '')])
        self.assertEqual(planted(fanuc_numbers.plants, 'O1\n/2G0X1.\nM99', 'divisor-zero'), [])

    def test_angles_and_roots(self):
        self.assertEqual(planted(fanuc_numbers.plants, 'O1\n#1=TAN[30]\nM99', 'tangent-right-angle'), [(['#1=TAN[90.]'], '')])
        self.assertEqual(planted(fanuc_numbers.plants, 'O1\n#1=SQRT[4]\nM99', 'root-negative'), [(['#1=SQRT[-4]'], '')])


class Variables(unittest.TestCase):
    def test_an_assignment_that_is_read(self):
        self.assertIn(([''], ''), planted(fanuc_variables.plants, DRILL, 'assignment-removed'))

    def test_an_assignment_that_nothing_reads_is_left_out(self):
        self.assertEqual(planted(fanuc_variables.plants, 'O1\n#33=5\nM99', 'assignment-removed'),
                         [([''], 'nothing uses the variable afterwards')])

    def test_a_letter_may_bring_an_argument(self):
        self.assertEqual(planted(fanuc_variables.plants, 'O1\n#24=5\nG0X#24\nM99', 'assignment-removed'),
                         [([''], 'an argument may have set it')])

    def test_a_program_without_arguments_may_share_its_callers_locals(self):
        shared = 'the program takes no argument: M98 may call it, and its caller may have set the variable'
        self.assertEqual(planted(fanuc_variables.plants, 'O1\n#33=5\nG0X#33\nM99', 'assignment-removed'), [([''], shared)])
        self.assertEqual(planted(fanuc_variables.plants, 'O1\n#33=5\nG0X#33Z#26\nM99', 'assignment-removed'), [([''], '')])
        self.assertEqual(planted(fanuc_variables.plants, 'O1\n#33=5\nG0X#33\nM30', 'assignment-removed'), [([''], '')])
        self.assertEqual([harmless for _, harmless in planted(fanuc_variables.plants, 'O1\nG0X#101\nM99', 'wrong-variable')], [shared])

    def test_two_blocks_for_two_axes(self):
        self.assertEqual(planted(fanuc_variables.plants, 'O1\n#24=#5001+#24\n#25=#5002+#25\nM99', 'axes-crossed'),
                         [(['#25=#5002+#24'], '')])
        self.assertEqual(planted(fanuc_variables.plants, 'O1\n#24=#5001+#1\n#25=#5002+#1\nM99', 'axes-crossed'), [])

    def test_two_results_in_one_variable(self):
        def stores(text):
            return planted(fanuc_variables.plants, text, 'stores-into-one')

        self.assertEqual(stores('O1\n#33=#1-#2\n#32=#1*2\nG0X#33Y#32\nM99'), [(['#33=#1*2'], '')])
        self.assertEqual(stores('O1\n#33=#1-#2\n#32=#33*2\nG0X#33Y#32\nM99'), [(['#33=#33*2'], 'the second reads, or may read, what the first has set')])
        self.assertEqual(stores('O1\n#33=5\n#32=#33*2\nG0X#33Y#32\nM99'), [])

    def test_one_case_of_two(self):
        cases = 'O1\nIF[#1EQ1]GOTO1\n#33=2\nGOTO2\nN1#33=3\nN2G0X#33\nM99'
        self.assertEqual(planted(fanuc_variables.plants, cases, 'case-removed'), [([''], ''), (['N1'], '')])

    def test_a_variable_that_is_set_to_0_and_only_counted_is_left_out(self):
        counted = 'O1\n#33=0\n#33=#33+#1\nIF[#33GT5]GOTO1\nG0X1.\nN1M99'
        self.assertEqual([harmless for _, harmless in planted(fanuc_variables.plants, counted, 'case-removed')][0],
                         'it is set to 0, and vacant counts as 0 in every use')


class Calls(unittest.TestCase):
    MAIN = 'O1\nG65P2X1.Z-5.\nM30'

    @staticmethod
    def plants(kind, *texts):
        programs = [program(text) for text in texts]
        return [(edit.apply(texts[0].split('\n'), edits), harmless)
                for name, edits, harmless in fanuc_calls.plants(programs[0], {1, 2}, Callers(programs)) if name == kind]

    def test_a_return_that_becomes_an_end(self):
        called = 'O2\nG0Z5.\nM99'
        self.assertEqual(self.plants('return-ends', called, 'O1\nM98P2\nG0X1.\nM30'), [({2: 'M30'}, '')])
        self.assertEqual(self.plants('return-ends', called, 'O1\nM98P2\nM30'), [({2: 'M30'}, 'nothing follows the call')])

    def test_callers_that_may_be_of_another_control_are_none(self):
        def reason(main, called, *others):
            programs = [fanuc.programs_of(text.split('\n'), Path(folder))[0] for text, folder in
                        [('O2\nG0Z5.\nM99', called), ('O1\nM98P2\nG0X1.\nM30', main), *others]]
            return [harmless for kind, _, harmless in fanuc_calls.plants(programs[0], {1, 2}, Callers(programs)) if kind == 'return-ends']

        unknown = ['another program has its number, or its callers stand in a folder beside it: nobody can tell']
        self.assertEqual(reason('mill', 'mill'), [''])
        self.assertEqual(reason('mill', 'mill/subs'), [''])
        self.assertEqual(reason('mill', 'lathe'), unknown)
        self.assertEqual(reason('mill', 'mill', ('O2\nG0Z9.\nM99', 'mill')), unknown)

    def test_a_letter_that_the_callee_reckons_with(self):
        self.assertEqual(self.plants('letter-left-out', self.MAIN, 'O2\nG0Z[#26+5.]\nM99'), [({1: 'G65P2X1.'}, '')])

    def test_a_call_of_blocks_of_the_program_itself_is_no_place(self):
        self.assertEqual(self.plants('recursion', 'O1\nM97P20\nM30\nN20G0X1.\nM99'), [])
        self.assertEqual(self.plants('recursion', 'O1\nM98P20\nM30'), [({1: 'M98P1'}, '')])

    def test_a_letter_that_the_callee_tests_may_be_left_out(self):
        self.assertEqual(self.plants('letter-left-out', self.MAIN, 'O2\nIF[#26EQ#0]THEN#26=1.\nG0Z[#26+5.]\nM99'), [])

    def test_an_end_that_runs_into_another_is_left_out(self):
        self.assertEqual(self.plants('return-removed', 'O2\nIF[#1EQ1]GOTO1\nM99\nN1M99')[0][1], 'the control runs on into another M99')

    def test_a_return_is_missed_where_something_says_that_it_belongs_there(self):
        main, macro, two = 'O2\nG0X1.\nM99', 'O2\nG0X#24\nM99', 'O2\nIF[#501EQ1]GOTO1\nM99\nN1G0X1.\nM99'
        harmless = 'nothing else says that the program is called: it has no caller of its control, no argument, no other end'
        self.assertEqual([reason for _, reason in self.plants('return-removed', main)], [harmless])
        self.assertEqual([reason for _, reason in self.plants('return-removed', main, 'O1\nM98P2\nM30')], [''])
        self.assertEqual([reason for _, reason in self.plants('return-removed', macro)], [''])
        self.assertEqual(self.plants('return-removed', two)[1][1], '')
        self.assertEqual(self.plants('return-removed', 'O2\nIF[#1EQ1]GOTO1\nM99\nN1M30')[0][1],
                         'the control runs on into the end of the part')

    def test_callers_that_say_the_mode_anew_are_not_hurt(self):
        hurt, safe = 'O1\nG65P2\nG0X1.\nM30', 'O1\nG65P2\nG90G0X1.\nM30'
        callee = program('O2\nG91G0X1.\nM99')
        self.assertFalse(Callers([program(hurt), callee]).none_is_hurt('mode-left', 2))
        self.assertTrue(Callers([program(safe), callee]).none_is_hurt('mode-left', 2))
        self.assertFalse(Callers([callee]).none_is_hurt('mode-left', 2))

    def test_a_move_to_the_reference_point_needs_no_feed(self):
        callee = program('O2\nG1Z#26F#9\nM99')
        self.assertTrue(Callers([program('O1\nG65P2\nG91G28Z0\nM30'), callee]).none_is_hurt('feed-left', 2))
        self.assertFalse(Callers([program('O1\nG65P2\nG91Z5.\nM30'), callee]).none_is_hurt('feed-left', 2))


class Modal(unittest.TestCase):
    @staticmethod
    def plants(kind, text):
        lines = text.split('\n')
        return [([new for _, new in sorted(edit.apply(lines, edits).items())], harmless)
                for name, edits, harmless in fanuc_modal.plants(program(text), lines) if name == kind]

    def test_a_mode_is_left_only_when_it_is_not_the_customary_one(self):
        incremental, absolute = ('O2\n#3=#4003\n%s\nG0Z1.\nG#3\nM99' % code for code in ('G91', 'G90'))
        self.assertEqual(self.plants('mode-left', incremental), [([''], '')])
        self.assertEqual([harmless for _, harmless in self.plants('mode-left', absolute)],
                         ['what is left is the customary code, or unknown'])

    def test_what_is_saved_late_changes_places_with_the_change(self):
        self.assertEqual(self.plants('saved-late', 'O2\n#3=#4003\nG91\nG0Z1.\nG#3\nM99'), [(['G91', '#3=#4003'], '')])

    def test_the_callers_motion_code_ends_a_cycle(self):
        self.assertEqual(self.plants('cancel-removed', 'O2\n#1=#4001\nG81Z#26R#18\nG80\nG#1\nM99'), [])
        self.assertEqual(self.plants('cancel-removed', 'O2\n#1=#4003\nG81Z#26R#18\nG80\nG#1\nM99'), [([''], '')])

    def test_a_call_in_between_makes_a_leftover_unknown(self):
        self.assertEqual(self.plants('cancel-removed', 'O2\nG41D1\nM98P7\nG40\nM99'), [])
        self.assertEqual(self.plants('cancel-removed', 'O2\nG41D1\nG1X1.\nG40\nM99'), [([''], '')])


class SavedState(unittest.TestCase):
    SAVING = 'O2\n#3=#4003\n#33=#4109\nG91\nG1Z1.F100\nN5G#3F#33\nM99'

    def plants(self, kind, text=SAVING):
        return planted(fanuc_saved.plants, text, kind)

    def test_a_return_goes_round_the_block_that_puts_back(self):
        self.assertEqual(self.plants('return-early'), [(['N5M99\nG#3F#33'], '')])
        self.assertEqual(self.plants('return-skipped'), [(['/N5M99\nG#3F#33'], '')])

    def test_a_block_that_only_puts_back_is_left_out(self):
        self.assertEqual(self.plants('restore-removed'), [(['N5'], '')])
        self.assertEqual(self.plants('restore-removed', self.SAVING.replace('G#3', 'G#3X5.')), [])
        self.assertEqual(self.plants('restore-removed', self.SAVING.replace('\nM99', 'M99')), [(['N5M99'], '')])

    def test_a_group_that_is_only_set_to_its_customary_code_is_a_class_of_its_own(self):
        only = 'O2\n#3=#4003\nG90\nG1Z1.\nG#3\nM99'
        self.assertEqual(self.plants('restore-removed-customary', only), [([''], '')])
        self.assertEqual(self.plants('restore-removed', only), [])

    def test_each_saving_variable_is_exchanged(self):
        self.assertEqual(self.plants('saved-other-group'), [(['#3=#4001'], '')])
        self.assertEqual(self.plants('saved-wrong'), [(['#3=#4109'], ''), (['#33=#4119'], ''), (['#33=#4001'], '')])

    def test_what_is_saved_and_never_put_back_is_no_place(self):
        self.assertEqual(self.plants('saved-wrong', 'O2\n#3=#4003\nG91\nX#3\nM99'), [])

    def test_incremental_is_planted_where_nothing_says_absolute_before_the_exit(self):
        self.assertEqual(planted(lambda read: fanuc_modal.plants(read, []), 'O2\nG0X1.\nM99', 'incremental-left'), [(['G91G0X1.'], '')])
        self.assertEqual(planted(lambda read: fanuc_modal.plants(read, []), 'O2\nG0X1.\nG90Z5.\nM99', 'incremental-left'), [])


class Chains(unittest.TestCase):
    @staticmethod
    def plants(text, kind):
        return [(edit.apply(text.split('\n'), edits), added) for name, edits, _, *added in fanuc_calls.chains(program(text), {8801})
                if name == kind]

    def test_a_chain_of_files_stands_behind_the_first_move(self):
        [(changes, [added])] = self.plants('O1\nG90\nG0X1.\nM30', 'too-deep-macros')
        self.assertEqual(changes, {2: 'G65P8802\nG0X1.'})
        self.assertEqual(sorted(added), [f'O880{digit}.nc' for digit in '23456'])
        self.assertEqual(added['O8805.nc'], '%\nO8805\nG4X.1\nG65P8806\nM99\n%\n')

    def test_a_chain_may_stand_in_one_file_or_in_the_programs_own(self):
        [(_, [added])] = self.plants('O1\nG0X1.\nM30', 'too-deep-subprograms')
        self.assertEqual(added['O8802.nc'].count('M98P'), 10)
        [(changes, added)] = self.plants('O1\nG90\nG21\nG0X1.\nM30', 'too-deep-macros')
        self.assertEqual((changes[4].split('\n')[:2], added), (['M30', 'O8802'], []))


class Lines(unittest.TestCase):
    def test_lines_that_are_added_do_not_count(self):
        plant = Plant('return-early', Path('own/a'), {2: 'M99\nG#3', 5: 'M30\nO2\nM99'}, before=['', ''])
        self.assertEqual([plant.line_before(line) for line in range(1, 11)], [1, 2, 3, 3, 4, 5, 6, 6, 6, 7])

    def test_a_line_shows_a_defect_that_names_what_is_changed(self):
        lines = 'O1\n#30=1\nN5WHILE[#30LT5]DO1\n#33=2\nEND1\nG0X#33\nM30'.split('\n')
        self.assertEqual(shows.lines_that_show(lines, {1: ''}, 'loops'), {2, 3})
        self.assertEqual(shows.lines_that_show(lines, {4: ''}, 'loops'), {3, 5})
        self.assertEqual(shows.lines_that_show(lines, {3: ''}, 'calls'), {4, 6, 7})

    def test_what_runs_off_shows_at_the_last_block_of_its_program(self):
        lines = 'O1\nG0X1.\nM99\nO2\nG0X2.\nM30\n%'.split('\n')
        self.assertEqual(shows.lines_that_show(lines, {2: ''}, 'calls'), {2, 3, 6})

    def test_modal_state_shows_at_the_exits_and_at_what_puts_back(self):
        lines = 'O1\n#3=#4003\nG91\nG0Z1.\nG#3\nM99'.split('\n')
        self.assertEqual(shows.lines_that_show(lines, {2: 'G90'}, 'saved state'), {3, 5, 6})


class Forms(unittest.TestCase):
    @staticmethod
    def plants(kind, text):
        return planted(lambda read: fanuc_forms.plants(read, text.split('\n')), text, kind)

    def test_what_is_missing(self):
        self.assertEqual(self.plants('value-lost', 'O1\nG1X5.Y10.\nM30'), [(['G1XY10.'], '')])
        self.assertEqual(self.plants('double-sharp', 'O1\n#[#1]=5\nM30'), [(['##1=5'], '')])
        self.assertEqual(self.plants('condition-open', 'O1\nIF[#1EQ2]GOTO5\nN5M30'), [(['IF #1EQ2 GOTO5'], '')])
        self.assertEqual(self.plants('logic-outside', 'O1\nIF[[#1EQ2]AND[#3EQ4]]GOTO5\nN5M30'),
                         [(['IF [#1EQ2]AND[#3EQ4] GOTO5'], '')])
        self.assertEqual(self.plants('then-removed', 'O1\nIF[#1EQ2]THEN #3=4\nM30'), [(['IF[#1EQ2]#3=4'], '')])
        self.assertEqual(self.plants('function-open', 'O1\n#1=SIN[#2]*3\nM30'), [(['#1=SIN #2*3'], '')])

    def test_what_is_too_much(self):
        self.assertEqual(self.plants('jump-letter', 'O1\nGOTO 5\nN5M30'), [(['GOTO N5'], '')])
        self.assertEqual(self.plants('jump-and-words', 'O1\nGOTO5\nN5M30'), [(['GOTO5 M8'], '')])
        self.assertEqual(self.plants('sign-doubled', 'O1\n#1=#2+#3\nM30'), [(['#1=#2++#3'], '')])
        self.assertEqual(self.plants('line-end-lost', 'O1\n#1=5\nG0X#1\nM30'), [(['#1=5 G0X#1', ''], '')])

    def test_another_maker_may_take_it(self):
        self.assertEqual(self.plants('jump-letter', 'O1(HAAS VF2)\nGOTO5\nN5M30')[0][1],
                         'the control of another maker may take it')


class DinPlus(unittest.TestCase):
    TEXT = 'MACHINING\nN1 #l1=0\nN2 WHILE #l1<5\nN3 G1 Zi-1\nN4 #l1=#l1+1\nN5 ENDWHILE\nN6 L"BORE" LA#l1 LB2\nN7 M30\nEND'

    def plants(self, kind, callee=('G0 X#__la Z#__lb',)):
        lines = self.TEXT.split('\n')
        return [([new for _, new in sorted(edit.apply(lines, edits).items())], harmless)
                for name, edits, harmless in dinplus.plants(lines, {'BORE': list(callee)}) if name == kind]

    def test_structure_and_steps(self):
        self.assertEqual(self.plants('din-while-open'), [(['N5 '], '')])
        self.assertEqual(self.plants('din-step-sign'), [(['N4 #l1=#l1-1'], '')])
        self.assertEqual(self.plants('din-end-removed'), [([''], '')])

    def test_a_letter_that_the_subprogram_asks_for_may_be_left_out(self):
        self.assertEqual(self.plants('din-letter-removed')[0], (['N6 L"BORE"  LB2'], ''))
        asked = self.plants('din-letter-removed', ['IF DEF(__la)', 'G0 X#__la Z#__lb'])
        self.assertEqual(asked[0][1], 'the callee looks whether it is passed')

    def test_a_comment_may_go_on_over_lines(self):
        self.assertEqual(dinplus.code_of(['N1 M5 [off', 'N2 M30', ' ] N3']), ['N1 M5     ', '      ', '   N3'])


class Judging(unittest.TestCase):
    """With the executable that MACLINT names."""

    def setUp(self):
        if 'MACLINT' not in os.environ:
            self.skipTest('MACLINT does not name the executable')
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        folder = Path(temporary.name)
        (folder / 'programs').mkdir()
        (folder / 'programs' / 'row').write_text(DRILL)  # no usual name
        self.corpora = {'own': Corpus.read(folder / 'programs', 'own', 'fanuc')}
        self.judge = Judge(Path(os.environ['MACLINT']).resolve(), folder / 'work', 1)

    def verdicts(self, plants):
        return [verdict for verdict, _ in self.judge.judge(self.corpora, plants, lambda done: None)]

    def test_most_is_found_in_a_clean_program(self):
        plants = [plant for plant in self.corpora['own'].plants(Path('row')) if not plant.harmless]
        kinds = {plant.kind for plant, verdict in zip(plants, self.verdicts(plants)) if verdict == 'found'}
        self.assertLessEqual({'label-removed', 'goto-nowhere', 'step-removed', 'step-sign', 'feed-left', 'bracket-unclosed'}, kinds)

    def test_a_change_without_a_defect_is_missed(self):
        self.assertEqual(self.verdicts([Plant('step-removed', Path('own/row'), {7: 'G90G0'}, before=['G90'])]), ['missed'])

    def test_a_finding_of_another_class_is_no_find(self):
        self.assertEqual(self.verdicts([Plant('step-removed', Path('own/row'), {2: 'IF[#24EQ#0]GOTO8'}, before=[''])]), ['missed'])

    def test_a_finding_on_a_line_that_shows_nothing_is_no_find(self):
        lines = DRILL.split('\n')
        plant = Plant('step-removed', Path('own/row'), {10: ''}, before=[lines[10]])
        self.assertEqual(self.verdicts([plant]), ['found'])
        self.corpora['own'].shown = lambda plant: {3}
        self.assertEqual(self.verdicts([plant]), ['missed'])

    def test_a_program_for_another_control_is_not_linted(self):
        file = self.corpora['own'].files[Path('row')]
        file.text = '%\nO0019 ; Number of the program\nG0 G17 G40 ; Takes the plane (G17), and no radius\n' \
                    '; Takes no length, and the first (G54) of the offsets\n#1=-5 ; Depth\nG65 P9810 Z#1 ; Measures\n' \
                    'IF[#1EQ1]GOTO5\nN5 M30 ; Ends it\n%'
        self.assertEqual(self.verdicts([Plant('goto-nowhere', Path('own/row'), {6: 'IF[#1EQ1]GOTO6'}, before=[''])]), ['not linted'])

    def test_what_was_known_before_is_no_place(self):
        plant = Plant('goto-nowhere', Path('own/row'), {2: 'IF[#24EQ#0]GOTO8'}, before=[''])
        file = self.corpora['own'].files[Path('row')]
        file.text = file.text.replace('IF[#24EQ#0]GOTO9', 'IF[#24EQ#0]GOTO7')
        self.assertEqual(self.verdicts([plant]), ['known before'])


class WhatRunsShow(unittest.TestCase):
    @staticmethod
    def reason(answer, kind='vacancy-as-zero'):
        return runs.reason(Plant(kind, Path('own/row'), {1: ''}), answer + ' line=0')

    def test_a_plant_counts_unless_runs_that_come_there_do_the_same(self):
        self.assertEqual(self.reason('blocks runs=9 touching=9 lines=9 led=9'), runs.SAME)
        self.assertEqual(self.reason('values runs=9 touching=9 lines=9 led=9'), '')
        self.assertEqual(self.reason('variables runs=9 touching=9 lines=9 led=9'), '')
        self.assertEqual(self.reason('runs=9 touching=0 lines=9 led=9'), '')
        self.assertEqual(self.reason('runs=9 touching=9 lines=9 led=4'), '')
        self.assertEqual(self.reason('unknown cannot read'), '')

    def test_what_no_run_can_come_to_is_left_out(self):
        self.assertEqual(self.reason('unreachable runs=9 touching=0 lines=9 led=9'), runs.UNREACHED)
        self.assertEqual(self.reason('unreadable runs=9 touching=0 lines=9 led=9'), 'a block before it cannot be read')

    def test_what_is_left_at_the_end_is_another_code(self):
        self.assertEqual(self.reason('values runs=9 touching=9 lines=9 led=9', 'return-early'), runs.SAME_STATE)
        self.assertEqual(self.reason('values codes runs=9 touching=9 lines=9 led=9', 'return-early'), '')
        self.assertEqual(self.reason('values runs=9 touching=9 lines=9 led=9', 'mode-left'), runs.SAME_STATE)


class Halves(unittest.TestCase):
    def test_an_author_is_in_one_half_with_all_that_he_wrote(self):
        corpus = Corpus('macros', 'fanuc', [])
        halves = {author: {corpus.half(Path(f'{author}__{name}/O{name}.nc')) for name in range(9)} for author in 'abcdefghijkl'}
        self.assertTrue(all(len(found) == 1 for found in halves.values()))
        self.assertEqual(set().union(*halves.values()), {'tune', 'hold'})

    def test_of_unknown_authors_each_program_is_one(self):
        corpus = Corpus('own', 'fanuc', [])
        self.assertEqual({corpus.half(Path(f'O{name}.nc')) for name in range(9)}, {'tune', 'hold'})
        self.assertEqual({corpus.half(Path(f'unknown__index/O{name}.nc')) for name in range(9)}, {'tune', 'hold'})


class Report(unittest.TestCase):
    @staticmethod
    def results(found, missed, kind, half=''):
        plant = Plant(kind, Path('own/row'), {1: 'GOTO8'}, before=['GOTO9'], half=half)
        return [(plant, 'found', [])] * found + [(plant, 'missed', [])] * missed

    def test_bars(self):
        self.assertTrue(report.passes(self.results(19, 1, 'step-sign')))
        self.assertFalse(report.passes(self.results(18, 2, 'step-sign')))
        self.assertFalse(report.passes(self.results(198, 2, 'goto-nowhere')))
        self.assertTrue(report.passes(self.results(199, 1, 'goto-nowhere')))

    def test_the_half_that_nobody_tunes_on_decides(self):
        tuned, held = self.results(1, 9, 'step-sign', 'tune'), self.results(19, 1, 'step-sign', 'hold')
        self.assertTrue(report.passes(tuned + held))
        self.assertFalse(report.passes(tuned))

    def test_saved_state_has_a_bar_of_its_own(self):
        others = self.results(300, 0, 'step-sign')
        self.assertTrue(report.passes(others + self.results(9, 1, 'return-early')))
        self.assertFalse(report.passes(others + self.results(8, 2, 'return-early')))

    def test_what_is_not_linted_counts_nowhere(self):
        plant = Plant('goto-nowhere', Path('own/row'), {1: ''}, before=[''])
        self.assertEqual(report.share([(plant, 'not linted', []), (plant, 'found', [])]), 1.0)

    def test_every_class_names_its_rules(self):
        for kind in KINDS.values():
            self.assertTrue(kind.rules and kind.what, kind.name)


if __name__ == '__main__':
    unittest.main()
