"""Each slip that is planted in SINUMERIK programs, and what is no slip."""
import unittest
from pathlib import Path

from planting import edit, report, sinumerik, sinumerik_kinds
from planting.plants import KINDS, NOTE, Plant
from planting.sinumerik_reader import Program, slip
from planting.sinumerik_text import CARON, CLOSE_QUOTE, OPEN_QUOTE, WIDE_COLON
from planting.workspace import Corpus, File

DRILL = ['PROC DRILL(REAL DEPTH, INT HOLES, VAR INT MADE) SAVE', 'G91 G0 Z=DEPTH', 'MADE=MADE+HOLES', 'M17']
PLAIN = ['G90 G0 X0 Y0', 'G1 X10 F200', 'M17']
MAIN = ['DEF INT MADE', 'N10 G17 G90 G54', 'N20 DRILL(5,2,MADE)', 'N30 PLAIN', 'N40 G0 Z100', 'N50 M30']
LIBRARIES = {'DRILL.SPF': DRILL, 'PLAIN.SPF': PLAIN, 'MAIN.MPF': MAIN}
CONTOUR = ['N10 G17 G90', 'N20 G0 X-10 Y-10', 'N30 G41 G1 X0 Y0 F200', 'N40 G2 X20 Y20 CR=20', 'N50 G1 X40', 'N60 G40 X50 Y30', 'N70 M30']
LOOP = ['DEF REAL PLACES[4]=SET(1,2,3,4)', 'DEF INT ROW', 'N10 FOR ROW=0 TO 3', 'N20 G0 X=PLACES[ROW] Y0', 'N30 ENDFOR', 'N40 M30']
COUNT = ['DEF INT ROW', 'N10 WHILE ROW<4', 'N20 ROW=ROW+1', 'N30 ENDWHILE', 'N40 M30']
JUMP = ['N10 IF R1==2 GOTOF READY', 'N20 G0 X10', 'N30 READY: M30']
CASE = ['N10 CASE R1 OF 1 GOTOF FIRST 2 GOTOF SECOND DEFAULT GOTOF SECOND', 'N20 FIRST: G0 X1', 'N30 SECOND: M30']
KEEP = ['PROC KEEP', 'MODE_=$P_GG[14]', 'PLANE_=$P_GG[6]', 'G91 G18', 'G0 X1', 'G[6]=PLANE_', 'G[14]=MODE_', 'RET']
ACTION = ['ID=1 WHENEVER $AA_IW[Z]>5 DO $R[5]=1', 'ID=2 EVERY $A_IN[3]==1 DO $A_OUT[1]=1', 'G1 X10 F100', 'CANCEL(1,2)', 'RET']
CIRCLE = ['N10 AGAIN: R1=R1+1', 'N20 G0 X=R1', 'N30 IF R1<9 GOTOB AGAIN', 'N40 M30']

# (class, file, program, new lines of its first place that is a defect)
SLIPS = [
    ('sin-equals-in-condition', 'A.MPF', JUMP, ['N10 IF R1=2 GOTOF READY']),
    ('sin-double-equals', 'A.MPF', COUNT, ['N20 ROW==ROW+1']),
    ('sin-comparison-word', 'A.MPF', JUMP, ['N10 IF R1 EQ 2 GOTOF READY']),
    ('sin-comparison-sign', 'A.MPF', ['N10 IF R1<>2 GOTOF READY', *JUMP[1:]], ['N10 IF R1!=2 GOTOF READY']),
    ('sin-then', 'A.MPF', ['IF R1>2 ; large', 'G0 X1', 'ENDIF', 'M30'], ['IF R1>2 THEN ; large']),
    ('sin-foreign-word', 'A.MPF', COUNT, ['N30 WEND']),
    ('sin-equals-gone', 'A.MPF', ['N10 G0 X10 Z=-R1'], ['N10 G0 X10 Z-R1']),
    ('sin-equals-gone', 'A.MPF', ['N10 G0 X=R1'], ['N10 G0 X R1']),
    ('sin-remark-open', 'A.MPF', ['; drills, then taps it', 'M30'], [' drills, then taps it']),
    ('sin-remark-bracket', 'A.MPF', ['N10 G0 X10 ; side', 'M30'], ['N10 G0 X10 (side)']),
    ('sin-wide-colon', 'A.MPF', JUMP, [f'N30 READY{WIDE_COLON} M30']),
    ('sin-jump-colon', 'A.MPF', JUMP, ['N10 IF R1==2 GOTOF READY:']),
    ('sin-two-blocks', 'A.MPF', ['N10 G17 G90', 'N20 G0 X1'], ['N10 G17 G90 N20 G0 X1', '']),
    ('sin-not-alone', 'A.MPF', LOOP, ['N10 FOR ROW=0 TO 3 G0 X=PLACES[ROW] Y0', '']),
    ('sin-head-at-structure', 'A.MPF', LOOP, ['N10 START_OF: FOR ROW=0 TO 3']),
    ('sin-split-definition', 'A.MPF', ['DEF INT ROW, PAD', 'M30'], ['DEF INT ROW,\n PAD']),
    ('sin-case-default', 'A.MPF', CASE, ['N10 CASE R1 OF 1 GOTOF FIRST 2 GOTOF SECOND DEFAULT SECOND']),
    ('sin-case-of', 'A.MPF', CASE, ['N10 CASE R1 OF 1 GOTOF FIRST OF 2 GOTOF SECOND DEFAULT GOTOF SECOND']),
    ('sin-bracket', 'A.MPF', ['N10 X=2*(R1+1)'], ['N10 X=2*(R1+1']),
    ('sin-index-bracket', 'A.MPF', ['N10 R[5]=1'], ['N10 R[5=1']),
    ('sin-quote-gone', 'A.MPF', ['MSG("one; two")'], ['MSG("one; two)']),
    ('sin-quotes-typographic', 'A.MPF', ['MSG("one")'], [f'MSG({OPEN_QUOTE}one{CLOSE_QUOTE})']),
    ('sin-text-long', 'A.MPF', ['MSG("one")'], ['MSG("' + 'mind the clamp ' * 14 + 'one")']),
    ('sin-decimal-comma', 'A.MPF', ['N10 G0 X1.5'], ['N10 G0 X1,5']),
    ('sin-sign-twice', 'A.MPF', ['N10 G0 X-5'], ['N10 G0 X--5']),
    ('sin-letter-o', 'A.MPF', ['N10 G0 X5'], ['N10 GO X5']),
    ('sin-keyword', 'A.MPF', COUNT, ['DFE INT ROW']),
    ('sin-stray-letter', 'A.MPF', ['N10 G0 X5'], [f'{CARON}N10 G0 X5']),
    ('sin-command', 'A.MPF', ['N10 STOPRE'], ['N10 STOPPRE']),
    ('sin-logic-open', 'A.MPF', ['IF (R1==1) AND (R2>2)', 'ENDIF'], ['IF R1==1 AND R2>2']),
    ('sin-late-definition', 'A.MPF', COUNT, ['', 'N10 WHILE ROW<4\nDEF INT ROW']),
    ('sin-name-twice', 'A.MPF', COUNT, ['DEF INT ROW\nDEF INT ROW']),
    ('sin-name-twice', 'DRILL.SPF', DRILL, [DRILL[0] + '\nDEF REAL DEPTH']),
    ('sin-name-form', 'A.MPF', COUNT, ['DEF INT R1_OW', 'N10 WHILE R1_OW<4', 'N20 R1_OW=R1_OW+1']),
    ('sin-name-long', 'A.MPF', ['DEF INT ROW', 'M30'], ['DEF INT ROW_OF_THE_FIRST_SIDE_AND_OF_THE_SECOND']),
    ('sin-name-of-a-word', 'A.MPF', ['DEF INT ROW', 'ROW=2 ; ROW', 'M30'], ['DEF INT SPOS', 'SPOS=2 ; ROW']),
    ('sin-label-of-a-variable', 'A.MPF', ['DEF INT ROW', *JUMP], ['N10 IF R1==2 GOTOF ROW', 'N30 ROW: M30']),
    ('sin-integer-large', 'A.MPF', ['DEF INT ROW', 'ROW=2'], ['ROW=3000000000']),
    ('sin-fraction', 'A.MPF', ['DEF INT ROW', 'ROW=2'], ['ROW=2.5']),
    ('sin-undefined', 'A.MPF', ['DEF INT PAD, ROW', 'ROW=PAD', 'M30'], ['DEF INT  ROW']),
    ('sin-values-too-many', 'A.MPF', LOOP, ['DEF REAL PLACES[4]=SET(1,2,3,4,4)']),
    ('sin-system-variable', 'A.MPF', ['R1=$AA_IW[X]'], ['R1=$AA_IWQ[X]']),
    ('sin-index-beyond', 'A.MPF', [LOOP[0], 'G0 X=PLACES[3]'], ['G0 X=PLACES[4]']),
    ('sin-loop-beyond', 'A.MPF', LOOP, ['N10 FOR ROW=0 TO 4']),
    ('sin-dimensions', 'A.MPF', LOOP, ['N20 G0 X=PLACES[ROW,0] Y0']),
    ('sin-text-for-number', 'A.MPF', COUNT, ['N20 ROW="10"']),
    ('sin-variable-misspelt', 'A.MPF', ['DEF REAL DEPTH', 'G0 Z=DEPTH'], ['G0 Z=DETPH']),
    ('sin-label-renamed', 'A.MPF', JUMP, ['N30 REDAY: M30']),
    ('sin-jump-misspelt', 'A.MPF', JUMP, ['N10 IF R1==2 GOTOF REDAY']),
    ('sin-direction', 'A.MPF', JUMP, ['N10 IF R1==2 GOTOB READY']),
    ('sin-end-gone', 'A.MPF', COUNT, ['N30 ']),
    ('sin-begin-gone', 'A.MPF', COUNT, ['N10 ']),
    ('sin-end-other', 'A.MPF', COUNT, ['N30 ENDFOR']),
    ('sin-ends-crossed', 'A.MPF', [*LOOP[:3], 'IF R1>2', 'ENDIF', *LOOP[3:]], ['', 'N30 ENDFOR\nENDIF']),
    ('sin-else-twice', 'A.MPF', ['IF R1>2', 'ELSE', 'ENDIF'], ['ELSE\nELSE']),
    ('sin-repeat-misspelt', 'A.MPF', ['PAD: G0 X1', 'REPEAT PAD P=3'], ['REPEAT PDA P=3']),
    ('sin-recursion', 'PLAIN.SPF', PLAIN, ['PLAIN\nM17']),
    ('sin-recursion', 'DRILL.SPF', DRILL, ['DRILL(DEPTH,HOLES,MADE)\nM17']),
    ('sin-label-twice', 'A.MPF', ['N5 G17', 'N10 GOTO READY', 'N30 READY: M30'], ['N5 READY: G17']),
    ('sin-step-lost', 'A.MPF', COUNT, ['N20 ']),
    ('sin-step-turned', 'A.MPF', COUNT, ['N20 ROW=ROW-1']),
    ('sin-exit-lost', 'A.MPF', ['LOOP', 'IF R1>2 GOTOF READY', 'ENDLOOP', 'READY: M30'], ['']),
    ('sin-endless-jump', 'A.MPF', CIRCLE, ['N30 GOTOB AGAIN']),
    ('sin-endless-jump', 'A.MPF', ['AGAIN: R1=R1+1', 'IF R1>9 GOTOF READY', 'GOTOB AGAIN', 'READY: M30'], ['']),
    ('sin-for-down', 'A.MPF', LOOP, ['N10 FOR ROW=3 TO 0']),
    ('sin-case-twice', 'A.MPF', CASE, ['N10 CASE R1 OF 1 GOTOF FIRST 1 GOTOF SECOND DEFAULT GOTOF SECOND']),
    ('sin-into-loop', 'A.MPF', [*COUNT[:2], 'N15 STEP_: G0 X1', *COUNT[2:]], ['IF R99==1 GOTOF STEP_\nN10 WHILE ROW<4']),
    ('sin-end-of-program-gone', 'PLAIN.SPF', PLAIN, ['']),
    ('sin-job-end', 'PLAIN.SPF', PLAIN, ['M30']),
    ('sin-program-missing', 'MAIN.MPF', MAIN, ['N20 DRLIL(5,2,MADE)']),
    ('sin-argument-added', 'MAIN.MPF', MAIN, ['N20 DRILL(5,2,MADE,1)']),
    ('sin-argument-text', 'MAIN.MPF', MAIN, ['N20 DRILL("A",2,MADE)']),
    ('sin-reference-left-out', 'MAIN.MPF', MAIN, ['N20 DRILL(5,2)']),
    ('sin-reference-number', 'MAIN.MPF', MAIN, ['N20 DRILL(5,2,0)']),
    ('sin-reference-type', 'MAIN.MPF', MAIN, ['DEF REAL MADE']),
    ('sin-reference-type', 'MAIN.MPF', ['DEF INT ROW, MADE', *MAIN[1:]], ['DEF REAL MADE\nDEF INT ROW']),
    ('sin-arguments-without-proc', 'MAIN.MPF', MAIN, ['N30 PLAIN(5)']),
    ('sin-arguments-without-proc', 'DRILL.SPF', DRILL, ['PROC DRILL SAVE']),
    ('sin-extern-differs', 'MAIN.MPF', MAIN, ['EXTERN DRILL(INT,INT,VAR INT)\nN10 G17 G90 G54']),
    ('sin-proc-name', 'DRILL.SPF', DRILL, [DRILL[0].replace('DRILL', 'DRILL_OLD')]),
    ('sin-modal-call-left', 'A.MPF', ['MCALL CYCLE81(50,0,2,-5,)', 'X10', 'MCALL', 'M30'], ['']),
    ('sin-two-codes', 'A.MPF', CONTOUR, ['N10 G17 G90 G91']),
    ('sin-compensation-on-arc', 'A.MPF', CONTOUR, ['N30 G1 X0 Y0 F200', 'N40 G41 G2 X20 Y20 CR=20']),
    ('sin-compensation-off-arc', 'A.MPF', [*CONTOUR[:4], *CONTOUR[5:]], ['N40 G40 G2 X20 Y20 CR=20', 'N60 X50 Y30']),
    ('sin-side-switched', 'A.MPF', [*CONTOUR[:3], *CONTOUR[4:]], ['N50 G42 G1 X40']),
    ('sin-compensation-at-tool', 'A.MPF', [*CONTOUR[:6], 'T2 D1 M6', 'M30'], ['N60 X50 Y30']),
    ('sin-compensation-at-cycle', 'A.MPF', [*CONTOUR[:6], 'CYCLE81(50,0,2,-5,)', 'M30'], ['N60 X50 Y30']),
    ('sin-compensation-left', 'A.MPF', CONTOUR, ['N60 X50 Y30']),
    ('sin-restore-crossed', 'KEEP.SPF', KEEP, ['G[6]=MODE_']),
    ('sin-restore-gone', 'KEEP.SPF', KEEP, ['']),
    ('sin-saved-late', 'KEEP.SPF', KEEP, ['', 'G91 G18\nMODE_=$P_GG[14]']),
    ('sin-action-variable', 'A.SPF', ACTION, ['ID=1 WHENEVER $AA_IW[Z]>5 DO R5=1']),
    ('sin-action-number', 'A.SPF', ACTION, ['ID=300 WHENEVER $AA_IW[Z]>5 DO $R[5]=1']),
    ('sin-action-number-twice', 'A.SPF', ACTION, ['ID=1 EVERY $A_IN[3]==1 DO $A_OUT[1]=1']),
    ('sin-action-left', 'A.SPF', ACTION, ['']),
    ('sin-save-gone', 'DRILL.SPF', DRILL, [DRILL[0].replace(' SAVE', '')]),
    ('sin-distance-left', 'PLAIN.SPF', PLAIN, ['G91 G1 X10 F200']),
    ('sin-frame-left', 'A.MPF', ['TRANS X10', 'G0 X0', 'TRANS', 'M30'], ['']),
    ('sin-frame-lost', 'A.MPF', ['TRANS X10', 'AROT RPL=30', 'TRANS', 'M30'], ['ROT RPL=30']),
    ('sin-coupling-left', 'A.MPF', ['TRANSMIT(1)', 'G0 X0', 'TRAFOOF', 'M30'], ['']),
    ('sin-rounding-left', 'A.MPF', ['RNDM=3', 'G1 X5', 'RNDM=0', 'M30'], ['']),
    ('sin-speed-without-limit', 'A.MPF', ['LIMS=3000', 'G96 S200 M4', 'M30'], ['']),
    ('sin-tap-without-position', 'A.MPF', ['SPOS=0', 'G331 Z-5 K1', 'M30'], ['']),
    ('sin-address-twice', 'A.MPF', ['G0 X5 ; back'], ['G0 X5 X6.5 ; back']),
    ('sin-radius-closed', 'A.MPF', CONTOUR, ['N40 G2 X0 Y0 CR=20']),
    ('sin-radius-short', 'A.MPF', CONTOUR, ['N40 G2 X20 Y20 CR=11.314']),
    ('sin-centre-beside', 'A.MPF', ['G90 G0 X0 Y0', 'G2 X20 Y20 I20 J0', 'M30'], ['G2 X20 Y20 I48.2843 J0']),
    ('sin-division-by-zero', 'A.MPF', ['R1=R2/5'], ['R1=R2/0']),
    ('sin-division-by-zero', 'A.MPF', ['R1=R2 MOD 5'], ['R1=R2 MOD 0']),
    ('sin-function-arguments', 'A.MPF', ['R1=SQRT(R2)'], ['R1=SQRT(R2,2)']),
    ('sin-function-arguments', 'A.MPF', ['R1=ATAN2(R2,R3)'], ['R1=ATAN2(R2)']),
    ('sin-cycle-misspelt', 'A.MPF', ['MCALL CYCLE82(50,0,2,-15,,1)'], ['MCALL CYCEL82(50,0,2,-15,,1)']),
    ('sin-cycle-depth', 'A.MPF', ['MCALL CYCLE82(50,0,2,-15,,1)'], ['MCALL CYCLE82(50,0,2,15,,1)']),
    ('sin-alarm-number', 'A.MPF', ['SETAL(65101,"R1")'], ['SETAL(5101,"R1")']),
    ('sin-position-as-distance', 'A.MPF', ['G0 X=$P_EP[X]+5'], ['G0 X=IC($P_EP[X]+5)']),
]
# (class, file, program, why its place is none; '' where there is no place at all)
NONE = [
    ('sin-remark-open', 'A.MPF', ['; drills them all twice', 'M30'], 'its words may be macros'),
    ('sin-equals-in-condition', 'A.MPF', ['R1=(R2==2)'], ''),
    ('sin-double-equals', 'A.MPF', ['MSG("R1=5")', 'X=5'], ''),
    ('sin-letter-o', 'A.MPF', ['R10=5', 'MSG("G0")'], ''),
    ('sin-address-twice', 'A.MPF', ['G0 X1=5', 'CYCLE81(50,0,2)'], ''),  # X1 is an axis of its own
    ('sin-bracket', 'A.MPF', ['MSG', '; (one)'], ''),
    ('sin-not-alone', 'A.MPF', ['IF R1>2 GOTOF READY', 'G0 X1', 'READY: M30'], ''),  # a jump, no structure
    ('sin-two-blocks', 'A.MPF', ['N10 G17 ; plane', 'N20 G0 X1'], ''),  # the second would be a remark
    ('sin-dimensions', 'A.MPF', ['DEF STRING[9] WORDS_[4]', 'MSG(WORDS_[1])'], ''),  # the last index of a text is a character
    ('sin-index-beyond', 'A.SPF', ['PROC A(VAR REAL PLACES[4])', 'PLACES[1]=0'], ''),
    ('sin-variable-misspelt', 'A.MPF', ['DEF REAL DEPTH, DETPH', 'DEPTH=0', 'G0 Z=DEPTH'], ''),  # the slip is another variable
    ('sin-values-too-many', 'A.MPF', ['DEF REAL PLACES[4]=SET(1,2)'], ''),  # there is room
    ('sin-fraction', 'A.MPF', ['DEF REAL ROW', 'ROW=2'], ''),
    ('sin-cycle-depth', 'A.MPF', ['CYCLE82(-20,-50,2,-15,,1)'], ''),  # the planes are not where it counts on them
    ('sin-text-for-number', 'A.MPF', ['DEF INT ROW', 'ROW=INDEX(NAME_," ")'], ''),
    ('sin-jump-misspelt', 'A.MPF', ['GOTOC READY', 'READY: M30'], ''),  # it goes on where there is no label
    ('sin-direction', 'A.MPF', ['GOTO READY', 'READY: M30'], ''),
    ('sin-direction', 'A.MPF', ['READY: R1=1', 'GOTOF READY', 'READY: M30'], ''),  # it stands on both sides
    ('sin-step-lost', 'A.MPF', [*COUNT[:3], 'N25 IF R1>5 GOTOF READY', *COUNT[3:], 'READY: M30'], ''),  # another way out
    ('sin-step-lost', 'MAIN.MPF', [*COUNT[:3], 'N25 PLAIN', *COUNT[3:]], ''),  # the program may do it
    ('sin-step-turned', 'A.MPF', [*COUNT[:2], 'N20 ROW=ROW+R1', *COUNT[3:]], ''),  # R1 may be less than 0
    ('sin-endless-jump', 'A.MPF', [*CIRCLE[:2], 'N25 G4 F1', *CIRCLE[2:]], 'it may wait on purpose'),
    ('sin-for-down', 'A.MPF', ['FOR R1=0 TO R2', 'ENDFOR'], ''),
    ('sin-job-end', 'OTHER.SPF', PLAIN, ''),  # nobody calls it
    ('sin-job-end', 'PLAIN.SPF', [PLAIN[0], 'IF R1>2', 'RET', 'ENDIF', 'M17'], 'another path returns'),
    ('sin-end-of-program-gone', 'A.MPF', JUMP[:2] + ['M30'], 'no source says what the control does then'),
    ('sin-end-of-program-gone', 'OTHER.SPF', PLAIN, 'nobody calls it'),
    ('sin-modal-call-left', 'A.MPF', ['MCALL CYCLE81(50,0,2,-5,)', 'X10', 'MCALL', 'MCALL CYCLE82(50,0,2,-5,,1)'], ''),
    ('sin-compensation-left', 'A.SPF', ['PROC A SAVE', *CONTOUR[:6], 'M17'], ''),  # SAVE puts it back
    ('sin-compensation-left', 'A.MPF', [*CONTOUR[:6], 'N65 G41 X0', 'N66 G40 X5', 'M30'], None),
    ('sin-save-gone', 'DRILL.SPF', [*DRILL[:3], 'G90', 'M17'], ''),  # G90 is what it leaves
    ('sin-distance-left', 'DRILL.SPF', DRILL, ''),
    ('sin-frame-left', 'A.SPF', ['PROC A SAVE', 'TRANS X10', 'TRANS', 'RET'], ''),
    ('sin-frame-left', 'A.MPF', ['TRANS X10', 'CALL WORDS_', 'TRANS', 'M30'], 'a computed call may cancel it'),
    ('sin-frame-lost', 'A.MPF', ['TRANS X10', 'G0 X0', 'AROT RPL=30', 'TRANS', 'M30'], ''),  # a move stands between
    ('sin-frame-lost', 'A.MPF', ['TRANS', 'AROT RPL=30', 'TRANS', 'M30'], ''),  # there is nothing to lose
    ('sin-coupling-left', 'A.MPF', ['TRANSMIT(1)', 'TRAFOOF', 'TRACYL(50)', 'TRAFOOF', 'M30'], 'another one follows'),
    ('sin-speed-without-limit', 'A.MPF', ['LIMS=3000', 'G97 S200', 'M30'], ''),
    ('sin-radius-closed', 'A.MPF', ['G0 X=R1 Y0', 'G2 X20 Y20 CR=20'], ''),  # where it begins is not known
    ('sin-radius-closed', 'A.SPF', ['G0 X0 Y0', 'G2 X20 Y20 CR=20'], ''),  # G90 or G91 is the caller's
    ('sin-radius-short', 'A.MPF', ['G18 DIAMON', 'G0 X0 Z0', 'G2 X20 Z-10 CR=10'], ''),  # X is a diameter
    ('sin-action-left', 'A.MPF', ACTION, ''),  # the actions of a main program end with it
    ('sin-action-variable', 'A.MPF', ['R5=1'], ''),
]


def found(kind, name, lines):
    """For each place of a class the new lines, with what is between them left out, and the reason why it is none."""
    files = {**LIBRARIES, name: lines}
    programs = {Path(file).stem: sinumerik.program_of(Path(file), text) for file, text in files.items()}
    return [([new for _, new in sorted(edit.apply(lines, edits).items())], harmless)
            for own, edits, harmless in sinumerik.plants(programs[Path(name).stem], programs, set()) if own == kind]


class Slips(unittest.TestCase):
    def test_each_class_plants_what_it_says(self):
        for kind, name, lines, expected in SLIPS:
            with self.subTest(kind):
                real = [new for new, harmless in found(kind, name, lines) if not harmless]
                self.assertTrue(real, 'no place')
                self.assertEqual(real[0], expected)

    def test_each_class_has_its_program(self):
        self.assertEqual({kind for kind, *_ in SLIPS}, {row[0] for _, _, rows in sinumerik_kinds.ROWS for row in rows})

    def test_what_the_control_takes_is_no_slip(self):
        for kind, name, lines, reason in NONE:
            with self.subTest(kind, lines=lines):
                places = found(kind, name, lines)
                if reason is None:  # only the last one is a place
                    self.assertEqual(len(places), 1)
                elif reason:
                    self.assertIn(reason, {harmless for _, harmless in places})
                else:
                    self.assertEqual(places, [])


class Reader(unittest.TestCase):
    def test_blocks_labels_and_remarks(self):
        program = Program('a', ['/1 N10 START_HERE: G0 X1 ; (N20) G1', 'MSG("a;b") ; c', '; alone', ' IF R1==1', '  X-.5 Y=3 A1=2', ' ENDIF'], True)
        first, text, opens, inside, closes = program.blocks
        self.assertEqual((first.number, first.label, first.text), (10, 'START_HERE', 'G0 X1'))
        self.assertEqual(text.text, 'MSG("   ")')
        self.assertEqual([word.group() for word in inside.words()], ['X-.5'])
        self.assertEqual((opens.word, inside.inside, closes.word, closes.inside), ('IF', [opens], 'ENDIF', []))
        self.assertIs(program.closer(opens), closes)

    def test_definitions_and_parameters(self):
        program = Program('A', ['PROC A(REAL X, VAR INT MADE, STRING[9] NAME_, INT KIND=3, VAR REAL LIST_[4,2]) SAVE',
                                'DEF CHAN REAL DEPTH=-2, PLACES[3,4]=SET(1,2), WIDTH'], False)
        self.assertEqual([(own.type, own.reference, own.sizes) for own in program.parameters],
                         [('REAL', False, ()), ('INT', True, ()), ('STRING', False, ()), ('INT', False, ()), ('REAL', True, (4, 2))])
        self.assertTrue(program.save)
        self.assertEqual({name: own.sizes for name, own in program.variables.items() if not own.parameter},
                         {'DEPTH': (), 'PLACES': (3, 4), 'WIDTH': ()})

    def test_a_jump_behind_if_opens_nothing(self):
        program = Program('A', ['IF R1==1 GOTOF READY', 'IF R1==2 GOTOF "LABEL"<<R1', 'REPEAT READY P=3', 'REPEAT', 'UNTIL R1>2'], True)
        self.assertEqual([block.word for block in program.blocks], ['', '', '', 'REPEAT', 'UNTIL'])

    def test_a_slip_is_another_name(self):
        for name in ('READY', 'AA', 'PAD', 'STEP_', 'ABB'):
            self.assertNotEqual(slip(name), name)


class Programs(unittest.TestCase):
    def corpus(self):
        files = {'MAIN.MPF': MAIN, 'DRILL.SPF': DRILL, 'L10.SPF': ['G0 X1', 'M17'], 'OLD.MPF': ['L10 P2', 'CHIPS_AWAY', 'M30'],
                 'SHOP.DEF': ['DEFINE CHIPS_AWAY AS M27', 'DEF CHAN REAL PITCH', 'M17'], 'ALONE.MPF': ['G0 X=PITCH', 'M30']}
        return Corpus('own-sinumerik', 'sinumerik', [File(Path(name), '\n'.join(lines)) for name, lines in files.items()])

    def test_programs_lie_with_those_they_call_and_with_definitions(self):
        neighbours = {str(path): {str(other) for other in others} for path, others in self.corpus().neighbours.items()}
        self.assertEqual(neighbours['MAIN.MPF'], {'MAIN.MPF', 'DRILL.SPF'})
        self.assertEqual(neighbours['OLD.MPF'], {'OLD.MPF', 'L10.SPF', 'SHOP.DEF'})
        self.assertEqual(neighbours['ALONE.MPF'], {'ALONE.MPF', 'SHOP.DEF'})

    def test_definition_files_get_no_slips(self):
        corpus = self.corpus()
        self.assertEqual(list(corpus.plants(Path('SHOP.DEF'))), [])
        self.assertIn('sin-argument-added', {plant.kind for plant in corpus.plants(Path('MAIN.MPF'))})

    def test_what_the_severity_and_the_folder_must_be(self):
        plants = {plant.kind: plant for plant in self.corpus().plants(Path('MAIN.MPF'))}
        self.assertEqual(plants['sin-end-of-program-gone'].least, NOTE)
        self.assertTrue(plants['sin-program-missing'].complete)
        self.assertTrue(plants['sin-undefined'].complete)
        self.assertFalse(plants['sin-argument-added'].complete)


class Bars(unittest.TestCase):
    def test_errors_are_found_one_and_all(self):
        for kind, severity, bar in (('sin-then', 'error', 1.0), ('sin-proc-name', 'warning', 0.95)):
            self.assertEqual(KINDS[kind].severity, severity)
            self.assertEqual(report.bar_of(kind, KINDS[kind]), sinumerik_kinds.BARS.get(kind, bar))
        results = [(Plant('sin-then', Path('own-sinumerik/A.MPF'), {0: ''}, half=half), verdict, [])
                   for half, verdict in (('tune', 'found'), ('hold', 'missed'))]
        self.assertEqual(report.below(results), ['sin-then'])

    def test_bars_are_those_of_classes(self):
        self.assertLessEqual(set(sinumerik_kinds.BARS), set(KINDS))


if __name__ == '__main__':
    unittest.main()
