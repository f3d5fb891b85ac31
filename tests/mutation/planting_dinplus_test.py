"""Each slip that is planted in whole DIN PLUS programs, and what is no slip."""
import unittest
from pathlib import Path

from planting import dinplus_kinds, edit, report
from planting.dinplus import code_of, plants
from planting.dinplus_reader import Program
from planting.plants import KINDS, Plant
from planting.workspace import Corpus, File

HEAD = '''PROGRAM HEAD
TURRET 1
T1 ID"A"
T2 ID"B"
BLANK
N1 G20 X80 Z60 K2
FINISHED
N2 G0 X0 Z0
N3 G1 X40 BR-1
N4 G2 X60 Z-10 R10
N5 G22 Z-30 I36 Ki-2
N6 G1 Z-50
N7 G1 X0
N8 G1 Z0'''.split('\n')
FACE = '''FACE_C Z0
N10 G308 ID"HOLES" P-5
N11 G402 Q4 K30 A0 XK0 YK0
N12 G300 B5 P5
N13 G309
N14 G308 ID"POCKET" P-5
N15 G100 XK0 YK0
N16 G101 XK10 YK0
N17 G101 XK10 YK10
N18 G101 XK0 YK0
N19 G309'''.split('\n')


def whole(*machining, geometry=(), head=HEAD, after=()):
    return [*head, *geometry, 'MACHINING', *machining, *after, 'END']


def found(kind, lines):
    """For each place of a class the new lines, with what is between them left out, and the reason why it is none."""
    return [([new for _, new in sorted(edit.apply(lines, edits).items())], harmless)
            for name, edits, harmless in plants(lines, {}) if name == kind]


SLIDES = [HEAD[0], '#SLIDE $1$2', *HEAD[1:]]
# (class, program, new lines of its first place that is a defect)
SLIPS = [
    ('din-word-missing', whole('N20 G26 S3000', 'M30'), ['N1 G20 Z60 K2']),
    ('din-word-twice', whole('M30'), ['N1 G20 X80 Z60 K2 K25']),
    ('din-decimal-comma', whole('N20 G95 F0.25 G1 Z-5 [cut]'), ['N20 G95 F0,25 G1 Z-5 [cut]']),
    ('din-word-value', whole('N20 G14 Q0 D2 [away]'), ['N20 G14 Q0 D3 [away]']),
    ('din-word-unknown', whole('N20 G14 Q0 [away]'), ['N1 G20 X80 Z60 K2 KC1']),
    ('din-words-exclude', whole('M30'), ['N5 G22 Z-30 I36 Ki-2 X5']),
    ('din-section-gone', whole('M30'), ['']),
    ('din-pocket-not-begun', whole('M30', geometry=FACE), ['N10 ']),
    ('din-pocket-not-ended', whole('M30', geometry=FACE), ['N13 ']),
    ('din-contour-without-start', whole('M30'), ['N2 ']),
    ('din-pattern-behind-figure', whole('M30', geometry=FACE), ['N11 G300 B5 P5', 'N12 G402 Q4 K30 A0 XK0 YK0']),
    ('din-g80-removed', whole('N20 G810 P2', 'N21 G0 X40 Z0', 'N22 G1 Z-5', 'N23 G80'), ['N23 ']),
    ('din-sections-exchanged', whole('M30'), ['FINISHED', 'BLANK']),
    ('din-tool-before-retract', whole('N20 G820 NS3 NE3 P2', 'N21 G14 Q0', 'N22 T2'), ['N21 T2', 'N22 G14 Q0']),
    ('din-codes-exchanged', whole('N20 G910 V0 D1', 'N21 G911 V0'), ['N20 G911 V0', 'N21 G910 V0 D1']),
    ('din-c-axis-gone', whole('N20 M14', 'N21 G110 C0'), ['N20 ']),
    ('din-spindle-gone', whole('N20 G97 S500 M3', 'N21 G1 Z-5'), ['N20 G97 S500']),
    ('din-spindle-stopped', whole('N20 G97 S500 M3', 'N21 G1 Z-5'), ['N20 G97 S500 M5']),
    ('din-feed-gone', whole('N20 G97 S500 G95 F0.2 M3', 'N21 G1 Z-5'), ['N20 G97 S500 M3']),
    ('din-speed-gone', whole('N20 G97 S500 M3', 'N21 G1 Z-5'), ['N20 G97 M3']),
    ('din-tool-gone', whole('N20 T1', 'N21 G1 Z-5'), ['N20 ']),
    ('din-limit-gone', whole('N20 G26 S3000', 'N21 G96 S200', 'N22 G820 NS3 NE3'), ['N20 ']),
    ('din-lateral-diameter-gone', whole('N20 G120 X60', 'N21 G110 CY5'), ['N20 ']),
    ('din-probe-start-gone', whole('N20 G910 V0', 'N21 G911 V0'), ['N20 ']),
    ('din-measured-value-gone', whole('N20 G787 NF1', 'N21 G788 NF1 P1'), ['N20 ']),
    ('din-change-point-gone', whole('N20 G140 D1 X200 Z300', 'N21 G14 Q0 D1'), ['N20 ']),
    ('din-plane-gone', whole('N20 G19', 'N21 G841 NS3 P2', 'N22 G18'), ['N20 ']),
    ('din-coupling-left', whole('N20 G720 S0 H3 Q1', 'N21 G720 H0'), ['N21 ']),
    ('din-eccentric-left', whole('N20 G726 H1 Q0', 'N21 G725 H1 Q0', 'N22 G726 H0 Q0', 'N23 G725 H0 Q0'), ['N22 ']),
    ('din-override-left', whole('N20 G919 Q0 H1', 'N21 G919 Q0 H0'), ['N21 ']),
    ('din-tcpm-left', whole('N20 G928 H1 D1', 'N21 G928 H0'), ['N21 ']),
    ('din-zone-left', whole('N20 G995 H1 ID"XZ0"', 'N21 G995'), ['N21 ']),
    ('din-zone-off-left', whole('N20 G60 Q1', 'N21 G60 Q0'), ['N21 ']),
    ('din-interrupted-feed-left', whole('N20 G64 E0.1 F1', 'N21 G64'), ['N21 ']),
    ('din-probe-left', whole('N20 G910 V0', 'N21 G913'), ['N21 ']),
    ('din-c-axis-left', whole('N20 M14', 'N21 M15', 'N22 G97 S500 M3'), ['N21 ']),
    ('din-attribute-left', whole('M30', head=[*HEAD[:8], 'N30 G38 E0.5', HEAD[8], 'N31 G38', *HEAD[9:]]), ['N31 ']),
    ('din-reference-nowhere', whole('N20 G820 NS3 NE3'), ['N20 G820 NS27 NE3']),
    ('din-reference-to-machining', whole('N20 G820 NS3 NE3'), ['N20 G820 NS20 NE3']),
    ('din-reference-to-start', whole('N20 G845 NS16 P1', geometry=FACE), ['N20 G845 NS15 P1']),
    ('din-reference-to-other-section', whole('N20 G820 NS3 NE3', geometry=FACE), ['N20 G820 NS3 NE10']),
    ('din-reference-to-other-kind', whole('N20 G870 NS5'), ['N20 G870 NS3']),
    ('din-contour-name', whole('N20 G845 ID"POCKET" P1', geometry=FACE), ['N20 G845 ID"POCKE" P1']),
    ('din-position-mark', whole('N20 G840 Q0 NS16 A1 NF1', 'N21 G71 NF1 ZE-5', geometry=FACE), ['N21 G71 NF2 ZE-5']),
    ('din-tool-not-in-turret', whole('N20 T2'), ['N20 T3']),
    ('din-tool-edge', whole('N20 T2'), ['N20 T2.12']),
    ('din-pocket-twice', whole('M30'), ['T1 ID"B"']),
    ('din-contour-name-twice', whole('N20 G72 ID"HOLES"', geometry=FACE), ['N14 G308 ID"HOLES" P-5']),
    ('din-name-mistyped', whole('N20 G0 Z#_dz', 'N21 G0 X_safe', head=[*HEAD[:4], 'CONST', '_safe=2', *HEAD[4:]]), ['N21 G0 X_safz']),
    ('din-m97-one-slide', whole('$1$2 N20 M97', head=SLIDES), ['$2 N20 M97']),
    ('din-mark-mistyped', whole('$1 N20 G162 H5', '$2 N21 G62 Q1 H5', head=SLIDES), ['$1 N20 G162 H1']),
    ('din-mark-gone', whole('$1 N20 G162 H5', '$2 N21 G62 Q1 H5', head=SLIDES), ['$1 N20 ']),
    ('din-slide-unknown', whole('$2 N20 G14 Q0', head=SLIDES), ['$3 N20 G14 Q0']),
    ('din-slide-gone', whole('$1 N20 #l1=#l1+1', '$1 N21 #g1=#g1+1', head=SLIDES), [' N21 #g1=#g1+1']),
    ('din-arc-radius', whole('M30'), ['N4 G2 X60 Z-10 R5.657']),
    ('din-arc-centre', whole('N20 G0 X40 Z0', 'N21 G2 X60 Z-10 I10 K0'), ['N21 G2 X60 Z-10 I14 K0']),
    ('din-arc-end', whole('N20 G0 X40 Z0', 'N21 G2 X60 Z-10 I10 K0'), ['N21 G2 X67 Z-10 I10 K0']),
    ('din-arc-closed', whole('M30'), ['N4 G2 X40 Z0 R10']),
    ('din-chamfer-long', whole('M30'), ['N3 G1 X40 BR-25']),
    ('din-across-axis', whole('M30'), ['N3 G1 X-40 BR-1']),
    ('din-pocket-opened', whole('N20 G845 ID"POCKET" P1', geometry=FACE), ['N18 ']),
    ('din-outside-blank', whole('M30'), ['N1 G20 X36 Z60 K2']),
    ('din-ends-crossed', whole('N20 IF #l1<2', 'N21 THEN', 'N22 WHILE #l1<2', 'N23 ENDWHILE', 'N24 ENDIF'), ['N23 ENDIF', 'N24 ENDWHILE']),
    ('din-branch-twice', whole('N20 IF #l1<2', 'N21 THEN', 'N22 ELSE [else]', 'N23 ENDIF'), ['N22 ELSE\nELSE [else]']),
    ('din-three-conditions', whole('N20 IF (#l1<2) OR (#l1>5)'), ['N20 IF (#l1<2) OR (#l1>5) AND (#l1>0)']),
    ('din-case-twice', whole('N20 SWITCH #l1', 'N21 CASE 1', 'N22 BREAK', 'N23 CASE 2', 'N24 BREAK', 'N25 ENDSWITCH'), ['N23 CASE 1']),
    ('din-end-early', whole('N20 IF #l1<2', 'N21 M5', 'N22 T1', 'N23 ENDIF', 'N24 G14 Q0 [away]', 'N25 T2'),
     ['N24 G14 Q0\nM30 [away]']),
    ('din-loop-never', whole('N20 #l1=0', 'N21 WHILE #l1<3', 'N22 ENDWHILE'), ['N21 WHILE #l1>3']),
    ('din-variable-renamed', whole('N20 #l1=5', 'N21 G0 X#l1'), ['N21 G0 X#l90']),
    ('din-recursion', whole('N20 L"SUB"', 'N21 M30', after=['SUBPROGRAM "SUB"', 'N30 G0 X5', 'N31 RETURN']), ['N31 L"SUB"\nRETURN']),
]
# (class, program, why its place is none; '' where there is no place at all)
NONE = [
    ('din-word-missing', whole('N20 G110 C0', head=[*HEAD[:5], *HEAD[6:]]), ''),  # C keeps its last value
    ('din-tool-before-retract', whole('N20 G820 NS3 NE3', 'N21 G0 X200', 'N22 G14 Q0', 'N23 T2'), 'the slide may have left the work before'),
    ('din-section-gone', whole('M30', head=[*HEAD[:6], *HEAD[13:]], geometry=[*FACE, *FACE]), 'the section before it is of its kind'),
    ('din-spindle-gone', whole('N20 M3', 'N21 M5', 'N22 G1 Z-5'), ''),  # it stands already
    ('din-c-axis-gone', whole('N20 M14', 'N21 L"SUB"', 'N22 G110 C0'), ''),  # the subprogram may do it
    ('din-c-axis-gone', whole('N20 M14', 'N21 M14', 'N22 G110 C0'), 'it stands twice before it is needed'),
    ('din-limit-gone', whole('N20 G26 S3000', 'N21 G96 S200', 'N22 G810 NS6 NE6'),
     'no cycle faces to the axis, and the speed does not rise without end'),
    ('din-c-axis-left', whole('N20 M14', 'N21 M15', 'N22 M30'), ''),
    ('din-attribute-left', whole('M30', head=[*HEAD[:8], 'N30 G10 RH6.3', HEAD[8], 'N31 G10', 'N32 G95 F0.1', *HEAD[9:]]),
     'another one follows'),
    ('din-m97-one-slide', whole('$1$2$3 N20 M97', head=SLIDES), ''),  # two of them may meet
    ('din-mark-gone', whole('$1 N20 G162 H5', '$2 N21 G162 H5', head=SLIDES), 'nobody waits for this mark alone'),
    ('din-slide-gone', whole('$1 N20 #l1=#l1+1', head=SLIDES), ''),  # each slide has its own
    ('din-pocket-twice', whole('M30', head=[*HEAD[:3], 'TURRET 2', *HEAD[3:]]), ''),  # each turret has its own places
    ('din-contour-name-twice', whole('N20 G72 NS11', geometry=FACE), ''),  # nothing asks for the name
    ('din-reference-to-start', whole('N20 G845 NS17 P1', geometry=FACE), ''),  # the contour begins elsewhere
    ('din-pocket-opened', whole('N20 G840 ID"POCKET"', geometry=FACE), ''),  # an open contour may be milled along
    ('din-arc-centre', whole('N20 G0 X40 Z0', 'N21 G17', 'N22 G2 X40 Y0 I10 J0'), ''),  # in another plane
    ('din-outside-blank', whole('M30', head=[*HEAD[:5], 'N1 G21 X80', *HEAD[6:]]), ''),
    ('din-variable-renamed', whole('N20 IF NDEF(l1)'), ''),
    ('din-loop-never', whole('N20 #l1=3', 'N21 WHILE #l1<3', 'N22 ENDWHILE'), ''),
]


class Slips(unittest.TestCase):
    def test_each_class_plants_what_it_says(self):
        for kind, lines, expected in SLIPS:
            with self.subTest(kind):
                real = [new for new, harmless in found(kind, lines) if not harmless]
                self.assertTrue(real, 'no place')
                self.assertEqual(real[0], expected)

    def test_each_class_has_its_program(self):
        self.assertEqual({kind for kind, *_ in SLIPS}, {row[0] for _, _, rows in dinplus_kinds.ROWS for row in rows})

    def test_what_the_manual_allows_is_no_slip(self):
        for kind, lines, reason in NONE:
            with self.subTest(kind, reason=reason):
                places = found(kind, lines)
                if reason:
                    self.assertIn(reason, {harmless for _, harmless in places})
                else:
                    self.assertEqual(places, [])

    def test_a_part_of_a_program_is_no_place(self):
        self.assertEqual(found('din-tool-gone', ['MACHINING', 'N1 T1', 'N2 G1 Z-5 F0.2', 'M30', 'END']), [])

    def test_programs_of_others_get_no_slips(self):
        lines = whole('N20 T1', 'N21 G1 Z-5', 'M30')
        self.assertIn('din-tool-gone', {kind for kind, *_ in plants(lines, {})})
        self.assertNotIn('din-tool-gone', {kind for kind, *_ in plants(lines, {}, clean=False)})
        for name, wanted in (('own-dinplus', True), ('dinplus', False)):
            path = Path('A.nc')
            corpus = Corpus(name, 'dinplus', [File(path, '\n'.join(lines))])
            self.assertEqual('din-tool-gone' in {plant.kind for plant in corpus.plants(path)}, wanted)


class Reader(unittest.TestCase):
    def test_words_and_sections(self):
        program = Program(code_of(['PROGRAMMKOPF', '#EINHEIT METRISCH', 'FERTIGTEIL', '$1 N 12 G1 Xi-0.5 BR(2+1)*_r', 'BEARBEITUNG',
                                   '/1 N13 L"SUB" LA2', 'N14 #l1=5', 'N15 G72 ID"RING M8" [all', 'of them] G80', 'ENDE']))
        self.assertEqual([name for name, _ in program.heads], ['HEAD', 'FINISHED', 'MACHINING', 'END'])
        self.assertTrue(program.whole)
        block = program.blocks[1]
        self.assertEqual((block.number, block.slides, block.place), (12, '$1', 'c'))
        self.assertEqual([(word.name, word.value) for word in block.words], [('G', '1'), ('Xi', '-0.5'), ('BR', '(2+1)*_r')])
        self.assertEqual([[word.value for word in block.words] for block in program.blocks[2:]], [[], [], ['72', '"RING M8"'], ['80']])


class Bars(unittest.TestCase):
    @staticmethod
    def results(kind, found_ones, missed):
        verdicts = ['found'] * found_ones + ['missed'] * missed
        return [(Plant(kind, Path('own-dinplus/A.nc'), {0: ''}, half=half), verdict, [])
                for verdict, half in zip(verdicts, ('tune', 'hold', 'hold'))]

    def test_a_class_has_a_bar_of_its_own(self):
        kind = 'din-tool-edge'
        self.assertEqual(KINDS[kind].severity, 'error')
        self.assertEqual(report.below(self.results(kind, 1, 1)), [kind])
        self.assertEqual(report.below(self.results(kind, 2, 0)), [])
        self.assertFalse(report.passes(self.results(kind, 1, 1)))
        dinplus_kinds.BARS[kind], old = 0.5, dinplus_kinds.BARS.get(kind)
        try:
            self.assertTrue(report.passes(self.results(kind, 1, 1)))
        finally:
            dinplus_kinds.BARS.pop(kind) if old is None else dinplus_kinds.BARS.update({kind: old})

    def test_its_bar_asks_for_both_halves(self):
        one_half = [result for result in self.results('din-tool-edge', 1, 1) if result[0].half == 'hold']
        self.assertEqual(report.below(one_half), [])

    def test_its_places_do_not_count_for_its_severity(self):
        self.assertEqual(report.by_severity(self.results('din-tool-edge', 0, 3), 'error'), [])

    def test_bars_are_those_of_classes(self):
        self.assertLessEqual(set(dinplus_kinds.BARS), set(KINDS))


if __name__ == '__main__':
    unittest.main()
