"""The changes change what they say and nothing else, and a maclint that minds one of them is found out."""
import os
import random
import stat
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from changing import corpus, verdicts
from changing.changes import CHANGES, pieces
from changing.compare import Match
from changing.exempt import EXEMPT, TELLS_A_PIECE
from changing.runs import Maclint
from changing.smallest import smallest
from changing.text import Edit, Places, Program, apply, insert

HERE = Path(__file__).resolve().parent
MACLINT = Path(os.environ.get('MACLINT', HERE.parents[1] / 'build' / 'maclint'))

MACRO = '''%
O9001(ROW)
N10 IF[#24EQ#0]GOTO90
#3000=1(X IS MISSING)
G65P9002X1.5(CALL)
IF[#1 EQ 2]THENGOTO10
G71 P10 Q90 U.2
DPRNT[X#1[53] Y]
M98P9003Q10
N90 G91 G1 X#24
M99 P10
%
end of tape
'''
SHAFT = '''%shaft.nc
PROGRAM HEAD
#UNIT METRIC
MACHINING
N1 T3 G95 F0.25 [tool 3]
N2 IF #l1 > 2
N3 THEN
N4 L"SUB 1" V1
N5 ENDIF
N6 G810 NS7 NE9
END
'''


def fanuc(text=MACRO):
    return Program(Path('a/O9001.nc'), 'fanuc', text)


def dinplus(text=SHAFT):
    return Program(Path('a/shaft.nc'), 'dinplus', text)


def changed(name, program, seed=1):
    edits = CHANGES[name].edits(program, random.Random(seed))
    return None if edits is None else apply(program.text, edits)


class Text(unittest.TestCase):
    def test_pieces_are_the_whole_text(self):
        for program in (fanuc(), dinplus(), fanuc(''), fanuc('G0X1.'), fanuc('%\n'), dinplus('N1 G0 [open\nX')):
            self.assertEqual(''.join(piece.text for piece in pieces(program)), program.text)

    def test_places_count_what_stayed(self):
        text, edits = 'N10 X1.', [Edit(1, 3, '100'), Edit(3, 4, ''), insert(7, '(K)')]
        self.assertEqual(apply(text, edits), 'N100X1.(K)')
        places = Places(text, edits)
        self.assertEqual([places.of_old(at) for at in (0, 1, 3, 4, 7)], [0, 1, 1, 1, 4])
        self.assertEqual([places.of_new(at) for at in (0, 1, 4, 7, 10)], [0, 1, 1, 4, 4])


class Changing(unittest.TestCase):
    def test_line_ends(self):
        self.assertEqual(changed('line-ends-crlf', fanuc('O1\nM30\n')), 'O1\r\nM30\r\n')
        self.assertEqual(changed('line-ends-cr', dinplus('N1 G0\r\nEND\r\n')), 'N1 G0\rEND\r')
        self.assertIsNone(changed('line-ends-lf', fanuc('O1\r\nM30\n')), 'mixed line ends are left alone')
        self.assertEqual(changed('final-line-end', fanuc('O1\nM30\n')), 'O1\nM30')
        self.assertEqual(changed('final-line-end', fanuc('O1\nM30')), 'O1\nM30\n')

    def test_letters_of_texts_stay(self):
        small = changed('small-letters', fanuc())
        for text in ('o9001(ROW)', 'if[#24eq#0]goto90', '#3000=1(X IS MISSING)', 'DPRNT[X#1[53] Y]'):
            self.assertIn(text, small)
        self.assertIn('if #l1 > 2', changed('small-keywords', dinplus()))
        self.assertIn('"SUB 1"', changed('small-keywords', dinplus()))
        self.assertIn('PROGRAM HEAD', changed('small-keywords', dinplus()))

    def test_comments_stay_away_from_alarms_titles_and_calls(self):
        for seed in range(20):
            text = changed('comment-at-end', fanuc(), seed)
            for line in ('O9001(ROW)\n', '#3000=1(X IS MISSING)\n', 'G65P9002X1.5(CALL)\n'):
                self.assertIn(line, text)
            self.assertIn('\n#UNIT METRIC\n', changed('comment-at-end', dinplus(), seed))

    def test_blanks_do_not_join_numbers_or_letters(self):
        for seed in range(20):
            self.assertIn('X1.5 2.', changed('blanks-out', fanuc('G0 X1.5 2. Y\n'), seed))
            self.assertIn('X Y1.', changed('blanks-out', fanuc('G0 X Y1. Z2.\n'), seed))
            self.assertIn('DPRNT[X#1[53] Y]', changed('blanks-out', fanuc(), seed))
        self.assertEqual(changed('blanks-out', fanuc('IF [#1 EQ 2] THEN GOTO 5\n'), 4).replace(' ', ''), 'IF[#1EQ2]THENGOTO5\n')

    def test_blanks_do_not_part_a_number_from_a_letter_typed_for_a_zero(self):
        for seed in range(20):
            self.assertIn('M3O', changed('blanks-in', dinplus('MACHINING\nN1 G0 X5Z2\nN2 M3O\nEND\n'), seed))

    def test_blanks_do_not_part_numbers_texts_or_words_of_other_languages(self):
        for seed in range(20):
            text = changed('blanks-in', fanuc('ENDIF\nX10.5 #1LTE5\n%'), seed)
            for word in ('ENDIF', '10.5', 'LTE'):
                self.assertIn(word, text)
            self.assertIn('L"SUB 1"', changed('blanks-wider', dinplus(), seed))

    def test_numbers_change_with_all_that_names_them(self):
        text = changed('renumbered', fanuc())
        for line in ('N11 IF[#24EQ#0]GOTO91', 'THENGOTO11', 'G71 P11 Q91 U.2', 'M98P9003Q11', 'N91 G91', 'M99 P11', 'O9001', 'G65P9002'):
            self.assertIn(line, text)
        self.assertIn('N7 G810 NS8 NE10', changed('renumbered', dinplus()))
        for text in ('N1 GOTO#1\n', 'N1 M99P#1\n', 'N1 GOTO[1+#2]\n', 'N9999\n'):
            self.assertIsNone(changed('renumbered', fanuc(text)), text)

    def test_text_outside_of_the_tape_stays(self):
        for name, change in CHANGES.items():
            if 'fanuc' in change.languages and not name.startswith(('line-ends', 'final', 'tape')):
                text = changed(name, fanuc())
                self.assertTrue(text is None or 'end of tape' in text, name)


def finding(code, begin, end, message='Wrong.', severity='error'):
    return {'code': code, 'severity': severity, 'message': message, 'range': {'bytes': [begin, end]}, 'related': [], 'file': 'a/O9001.nc'}


class Comparing(unittest.TestCase):
    def compared(self, name, text, edits, before, after):
        lost, new = Match(CHANGES[name], fanuc(text), edits).compare(before, after)
        return [f['code'] for f in lost], [f['code'] for f in new]

    def test_a_place_moves_with_its_block(self):
        text, edits = 'O1\nX1.\n', [insert(3, '(K)\n')]
        before = [finding('MAC1', 3, 6, "'X1.' on line 2.")]
        moved = [finding('MAC1', 7, 10, "'X1.' on line 3.")]
        self.assertEqual(self.compared('comment-lines', text, edits, before, moved), ([], []))
        for other in (finding('MAC1', 7, 9, "'X1.' on line 3."), finding('MAC1', 7, 10, "'X1.' on line 4."),
                      finding('MAC1', 7, 10, "'X2.' on line 3."), finding('MAC1', 7, 10, "'X1.' on line 3.", 'note'),
                      finding('MAC2', 7, 10, "'X1.' on line 3.")):
            self.assertEqual(self.compared('comment-lines', text, edits, before, [other]), (['MAC1'], [other['code']]))
        self.assertEqual(self.compared('comment-lines', text, edits, before * 2, moved), (['MAC1'], []))

    def test_quotations_may_have_other_blanks_capitals_and_numbers(self):
        same = lambda name, one, other: Match(CHANGES[name], fanuc('O1'), []).same_words(one, other)
        self.assertTrue(same('blanks-in', "'G0X1.'", "'G 0 X1.'"))
        self.assertTrue(same('small-letters', "'G0X1.'", "'g0x1.'"))
        self.assertFalse(same('blanks-in', "'G0X1.'", "'g0x1.'"))
        self.assertTrue(same('renumbered', "'GOTO10' finds no N10", "'GOTO11' finds no N11"))
        self.assertFalse(same('blanks-in', "'GOTO10'", "'GOTO11'"))
        self.assertTrue(same('comment-at-end', "'X1.'", "'X1.(K)'"))

    def test_exemptions_have_reasons_and_name_changes(self):
        self.assertLessEqual(set(EXEMPT), set(CHANGES))
        for reasons in [*EXEMPT.values(), TELLS_A_PIECE]:
            for code, reason in reasons.items():
                self.assertRegex(code, r'^(MAC|DIN)\d{3}$')
                self.assertGreater(len(reason), 20)


class Drawing(unittest.TestCase):
    def test_takes_as_many_of_both_languages(self):
        programs = [Program(Path(f'{language}{number}'), language, '') for language, count in (('fanuc', 30), ('dinplus', 6))
                    for number in range(count)]
        languages = [program.language for program in corpus.drawn(programs, 20, 1)]
        self.assertEqual((languages.count('fanuc'), languages.count('dinplus')), (14, 6))
        self.assertEqual(corpus.drawn(programs, 20, 1), corpus.drawn(programs, 20, 1))
        self.assertNotEqual(corpus.drawn(programs, 20, 1), corpus.drawn(programs, 20, 2))


FAKE = '''#!{python}
"""Finds each N block that moves, and minds what it is told to."""
import json, re, sys
from pathlib import Path
files = [name for name in sys.argv[sys.argv.index('--') + 1:]] if '--' in sys.argv else ['a/O9001.nc']
if '-' in sys.argv[1:]:
    text_of = lambda name: sys.stdin.buffer.read().decode('latin-1')
else:
    text_of = lambda name: Path(name).read_bytes().decode('latin-1')
findings, suppressed = [], []
for name in files:
    text = text_of(name)
    if {minds}:
        continue
    for match in re.finditer('N[ \\t]*[0-9]+[^\\r\\n]*X[ \\t]*[0-9.]+', text, re.I):
        entry = dict(code='MAC900', severity='error', message='Moves.', file=name, related=[],
                     range=dict(bytes=[match.start(), match.end()]))
        allowed = 'ALLOW MAC900' in text[match.start():text.find('\\n', match.start())]
        (suppressed if allowed else findings).append(entry)
print(json.dumps(dict(findings=findings, suppressed=suppressed, notices=[])))
'''
MOVES = '%\nO1\nN10 G1 X1.\nG0 Y2.\nN20 X5. F1\nM30\n%\n'


class FoundOut(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = Path(held.name)

    def fake(self, minds):
        """A maclint that finds nothing where the Python expression holds."""
        path = self.folder / 'maclint'
        path.write_text(FAKE.replace('{python}', sys.executable).replace('{minds}', minds))
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        return Maclint(path, self.folder / 'work')

    def differences(self, name, minds):
        return verdicts.try_change(self.fake(minds), CHANGES[name], [fanuc(MOVES)], 1)[0]

    def test_nothing_where_no_change_matters(self):
        for name in CHANGES:
            self.assertEqual(self.differences(name, 'False'), [], name)

    def test_whoever_drops_a_finding(self):
        for name, minds in (('line-ends-crlf', r"'\r\n' in text"), ('blanks-in', r"re.search('[NGX] |\t', text[6:])"), ('small-letters', "'g' in text"),
                            ('comment-lines', "'(K)' in text"), ('renumbered', "'N11' in text"), ('byte-order-mark', r"text[0] == '\xef'")):
            found = self.differences(name, minds)
            self.assertEqual([len(difference.lost) for difference in found], [2], name)

    def test_is_shown_by_as_few_edits_as_it_takes(self):
        maclint = self.fake("re.search('X[ \\t]+5', text)")
        found = next(found for found in (verdicts.try_change(maclint, CHANGES['blanks-in'], [fanuc(MOVES)], seed)[0] for seed in range(30))
                     if found)
        edits = smallest(maclint, CHANGES['blanks-in'], found[0]).edits
        self.assertEqual([apply(MOVES, edits).split('\n')[4].replace('\t', ' ').replace('  ', ' ')], ['N20 X 5. F1'])

    def test_who_does_not_obey_a_comment_that_allows(self):
        self.assertEqual(verdicts.try_allow(self.fake('False'), [fanuc(MOVES)], 1)[0], [])
        deaf = self.fake('False')
        path = Path(deaf.executable)
        path.write_text(path.read_text().replace("'ALLOW MAC900' in", "'NOTHING' in"))
        self.assertEqual(len(verdicts.try_allow(deaf, [fanuc(MOVES)], 1)[0]), 1)
        self.assertEqual(len(verdicts.try_allow(self.fake("'MACLINT' in text"), [fanuc(MOVES)], 1)[0]), 1, 'the other finding is lost, too')

    def test_who_minds_the_order_of_files_or_how_they_come(self):
        one, files = fanuc(MOVES), [Program(Path(f'a/O{number}.nc'), 'fanuc', MOVES) for number in range(8)]
        unsorted = self.fake('False')
        self.assertEqual(len(verdicts.try_order(unsorted, files, 1)[0]), 3)
        path = Path(unsorted.executable)
        path.write_text(path.read_text().replace('for name in files:', 'for name in sorted(files):'))
        self.assertEqual(verdicts.try_order(unsorted, files, 1)[0], [])
        self.assertEqual(verdicts.try_stdin(self.fake('False'), [one], 1)[0], [])
        self.assertEqual(len(verdicts.try_stdin(self.fake("'-' in sys.argv[1:]"), [one], 1)[0]), 1)


class WholeRun(unittest.TestCase):
    def run_script(self, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            return subprocess.run([sys.executable, '-B', str(HERE / 'metamorphic.py'), '--maclint', str(MACLINT), '--folder', folder,
                                   *arguments], capture_output=True, text=True, check=False)

    @unittest.skipUnless(MACLINT.exists(), 'maclint is not built')
    def test_passes_on_some_of_our_own_programs(self):
        done = self.run_script('6', '3', '--program', 'own/', '--shared', '/nowhere')
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn('3 Fanuc programs, 3 in DIN PLUS, seed 3', done.stdout)


if __name__ == '__main__':
    unittest.main()
