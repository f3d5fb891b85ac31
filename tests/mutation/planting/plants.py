"""What a plant is, and the table of all classes of defects."""
from dataclasses import dataclass, field

from . import dinplus_kinds, sinumerik_kinds

ERROR, WARNING, NOTE = 'error', 'warning', 'note'
RANK = {NOTE: 0, WARNING: 1, ERROR: 2}


@dataclass(frozen=True)
class Kind:
    """A class of defects: one row of the table below."""
    name: str
    group: str
    rules: tuple  # any of them finds it; the first is the one that is meant
    severity: str  # whose bar its places count for
    what: str
    own_bar: bool = False  # the class has a bar of its own, and is not counted with those of its severity


@dataclass
class Plant:
    """One defect in one place of one program."""
    kind: str
    path: object  # of the program, in its corpus
    changes: dict  # number of the line, from 0, to its new text
    harmless: str = ''  # why the changed program has no defect, or none that can be told from its text
    least: str = WARNING  # the least severity of a finding that counts
    complete: bool = False  # the folder is declared to hold every program of the control
    before: list = field(default_factory=list)
    half: str = ''  # of the authors: 'tune' or 'hold'
    shown: str = ''  # what runs of both programs show
    added: dict = field(default_factory=dict)  # further programs by path


    @property
    def line(self):
        return min(self.changes) + 1

    def text(self, lines):
        """The changed program, of the unchanged lines."""
        return '\n'.join(self.changes.get(number, line) for number, line in enumerate(lines))

    def line_before(self, line):
        """The line of the unchanged program for one of the changed program, from 1 on."""
        added = 0
        for number, text in sorted(self.changes.items()):
            added += min(text.count('\n'), max(line - added - number - 1, 0))
        return line - added

    def difference(self):
        return [mark + text.strip() for number, old in zip(sorted(self.changes), self.before)
                for mark, text in (('- ', old), ('+ ', shortened(self.changes[number]))) if text.strip()]


def shortened(text):
    lines = text.strip().split('\n')
    return ' / '.join(lines[:3]) + (' …' if len(lines) > 3 else '')


def table(group, severity, rows, own_bar=False):
    return [Kind(name, group, tuple(rules.split()), severity, what, own_bar) for name, rules, what in rows]


LEFT = 'MAC501 MAC503 MAC504 MAC507 MAC519'  # what a program leaves that it should put back

KINDS = {kind.name: kind for kind in [
    *table('jumps', ERROR, [
        ('goto-nowhere', 'MAC301', 'two digits of a GOTO exchanged, or one wrong: no block has that number'),
        ('label-removed', 'MAC301', 'the number of a block that a GOTO names is gone'),
        ('jump-into-loop', 'MAC303', 'a GOTO from outside names a block inside a loop'),
        ('endless-jump', 'MAC336 MAC319', 'the condition of the only jump out of a cycle of blocks is gone'),
    ]),
    *table('jumps', WARNING, [
        ('label-doubled', 'MAC462', 'a block gets a number that a GOTO already names, and the GOTO takes this one'),
        ('branch-copied', 'MAC337', 'of two branches the first does what the second does'),
    ]),
    *table('loops', ERROR, [
        ('end-wrong', 'MAC312 MAC313 MAC314 MAC316', 'END with the number of another loop'),
        ('end-removed', 'MAC312', 'END is gone'),
        ('do-removed', 'MAC311 MAC313', 'WHILE without DO'),
        ('while-removed', 'MAC313', 'the WHILE block is gone, its END is left'),
        ('loop-number', 'MAC314', 'loop number 4'),
        ('step-removed', 'MAC319', 'the step of the loop is gone'),
        ('step-elsewhere', 'MAC319', 'the step goes to another variable'),
        ('condition-elsewhere', 'MAC319 MAC718 MAC209', 'WHILE tests a variable that the loop does not change'),
    ]),
    *table('loops', WARNING, [
        ('step-sign', 'MAC320 MAC319', 'the step goes the other way'),
        ('step-zero', 'MAC320 MAC319', 'the step is 0'),
        ('step-fraction', 'MAC711', 'a step of 0.1, 0.2 or .05 up or down to a limit (LT, LE, GT, GE)'),
        ('first-value-removed', 'MAC209 MAC321', 'the assignment that gives the counter of a loop its first value is gone'),
        ('step-guard-removed', 'MAC320', 'an argument is a step, and nothing asks any more whether it is 0'),
    ]),
    *table('conditions', WARNING, [
        ('vacancy-as-zero', 'MAC220', '0 where #0 was in a test for vacancy'),
        ('zero-as-vacancy', 'MAC228', 'EQ #0 where EQ 0 was, on a variable that is set'),
        ('guard-inverted', 'MAC209 MAC220 MAC718 MAC228', 'NE #0 where EQ #0 was: on it goes with the vacant variable'),
        ('guard-repeated', 'MAC718', 'a guard tests what the guard before it has tested'),
        ('part-doubled', 'MAC719', 'of two comparisons in a condition the second is the first again'),
        ('case-doubled', 'MAC719', 'of two cases for one variable the second asks for that of the first'),
        ('distance-equal', 'MAC710', 'a distance is compared with EQ 0 instead of a tolerance'),
    ]),
    *table('conditions', ERROR, [
        ('vacancy-of-result', 'MAC222', 'the result of arithmetic is compared with #0'),
        ('comparison-symbol', 'MAC119', '= or > where EQ or GT was'),
    ]),
    *table('variables', WARNING, [
        ('assignment-removed', 'MAC209', 'the only assignment of a variable is gone'),
        ('case-removed', 'MAC209', 'the assignment of one case is gone'),
        ('wrong-variable', 'MAC209', 'a word takes a variable that nothing sets'),
        ('axes-crossed', 'MAC215', 'of two blocks for two axes one takes the variable of the other'),
        ('stores-into-one', 'MAC213 MAC214 MAC209', 'of two blocks that calculate the second sets the variable of the first'),
    ]),
    *table('variables', ERROR, [
        ('null-assigned', 'MAC201', '#0 is assigned'),
    ]),
    *table('numbers', ERROR, [
        ('divisor-zero', 'MAC702', 'a number by which a block divides is 0'),
        ('root-negative', 'MAC703', 'the root of a number with the wrong sign'),
    ]),
    *table('numbers', WARNING, [
        ('tangent-right-angle', 'MAC704', 'TAN[90.]'),
    ]),
    *table('saved state', WARNING, [
        ('return-early', f'{LEFT} MAC502', 'M99 in front of the block that puts back what was saved'),
        ('return-skipped', f'{LEFT} MAC502', '/M99 in front of the block that puts back what was saved'),
        ('restore-removed', f'{LEFT} MAC502', 'the block that puts back what was saved is gone'),
        ('restore-removed-customary', LEFT, 'the same of a group that the program only sets to its customary code'),
        ('saved-other-group', f'MAC505 {LEFT}', 'a motion code is saved from #4003, and so on: the copy is put back as another group'),
    ]),
    *table('saved state', ERROR, [
        ('saved-wrong', f'MAC505 MAC574 {LEFT}', 'the feed is saved from #4119 or #4001, the mode from #4109'),
    ]),
    *table('modal', WARNING, [
        ('incremental-left', 'MAC501', 'G91 in front of a move of a called program, and nothing puts G90 back'),
        ('mode-left', LEFT, 'the G code that puts a modal group back is gone'),
        ('feed-left', LEFT, 'the F word that puts the feed back is gone'),
        ('speed-left', LEFT, 'the S word that puts the speed back is gone'),
        ('saved-late', 'MAC517', 'the mode is saved after the block that changes it'),
        ('saved-lost', 'MAC506 MAC209 MAC319', 'the variable with the saved mode is used for something else before it is put back'),
        ('cancel-removed', 'MAC502 MAC501 MAC413 MAC569', 'G40, G69, G50.1, G15, G50 or G67 is gone'),
        ('single-block-left', 'MAC515', '#3003=0 or #3004=0 is gone'),
        ('group-conflict', 'MAC514', 'G90 and G91, or G17 and G18, in one block'),
        ('address-twice', 'MAC559', 'Y is written X'),
    ]),
    *table('calls', ERROR, [
        ('program-missing', 'MAC402', 'a call of a program that is not there'),
        ('recursion', 'MAC412 MAC410 MAC411', 'a program calls itself'),
        ('too-deep-macros', 'MAC410', 'a call of a macro that calls another one, and so on, five levels deep'),
        ('too-deep-subprograms', 'MAC411', 'the same of subprograms, eleven levels deep'),
        ('call-without-number', 'MAC401', 'P is gone'),
        ('return-removed', 'MAC456', 'M99 is gone'),
        ('alarm-removed', 'MAC456', 'the alarm at the end is gone, and the control runs on over the end'),
    ]),
    *table('calls', WARNING, [
        ('modal-call-left', 'MAC413', 'G67 is gone'),
        ('letter-left-out', 'MAC210 MAC209', 'the only call of a program leaves out a letter that it reckons with and never tests'),
        ('return-ends', 'MAC457', 'M30 where M99 was, in a program that another one calls'),
    ]),
    *table('spelling', ERROR, [
        ('bracket-unclosed', 'MAC117 MAC121 MAC118', 'a ] is gone'),
        ('bracket-unopened', 'MAC117 MAC121 MAC118', 'a [ is gone'),
        ('round-brackets', 'MAC116', 'SIN(30) for SIN[30]'),
        ('letter-for-zero', 'MAC106', 'O where 0 was'),
        ('decimal-comma', 'MAC126 MAC121 MAC118', '1,5 for 1.5'),
        ('comment-unclosed', 'MAC102', 'the ) of a comment is gone'),
        ('keyword', 'MAC118 MAC121 MAC106', 'WHLIE, TEHN, EQU, G0TO'),
    ]),
    *table('forms', ERROR, [
        ('value-lost', 'MAC109', 'the number of a word is gone'),
        ('double-sharp', 'MAC206', '##1 for #[#1]'),
        ('jump-letter', 'MAC305', 'GOTO N5 for GOTO5'),
        ('jump-and-words', 'MAC307', 'M8 after a GOTO'),
        ('condition-open', 'MAC324', 'the brackets of a condition are gone'),
        ('then-removed', 'MAC325', 'THEN is gone'),
        ('logic-outside', 'MAC329', 'the outer brackets of two conditions are gone'),
        ('line-end-lost', 'MAC332', 'the end of line after an assignment is gone'),
        ('function-open', 'MAC706', 'SIN #1 for SIN[#1]'),
        ('sign-doubled', 'MAC716', '#1++#2 for #1+#2'),
    ]),
    *table('DIN PLUS', ERROR, [
        ('din-section-removed', 'DIN101', 'MACHINING is gone'),
        ('din-end-removed', 'DIN102', 'END is gone'),
        ('din-return-removed', 'MAC456', 'RETURN is gone'),
        ('din-if-open', 'DIN401', 'ENDIF is gone'),
        ('din-if-gone', 'DIN401 DIN402', 'IF is gone, its ENDIF is left'),
        ('din-then-removed', 'DIN402', 'THEN is gone'),
        ('din-while-open', 'DIN404', 'ENDWHILE is gone'),
        ('din-while-gone', 'DIN404', 'WHILE is gone, its ENDWHILE is left'),
        ('din-switch-open', 'DIN409', 'ENDSWITCH is gone'),
        ('din-unit-open', 'DIN015', 'END_OF_UNIT is gone'),
        ('din-joined', 'DIN008', 'THEN stands in the block of IF'),
        ('din-assigned', 'DIN326', '= in a condition'),
        ('din-compared', 'DIN326', '== where a value is stored'),
        ('din-contour-nowhere', 'DIN704', 'NS or NE names a block that is not there'),
        ('din-restart-nowhere', 'DIN415', 'M99 NS names a block that is not there'),
        ('din-bracket-unclosed', 'MAC117 MAC121', 'a ) is gone'),
        ('din-bracket-unopened', 'MAC117 MAC121', 'a ( is gone'),
        ('din-compensation-left', 'DIN619 DIN519', 'G40 is gone'),
        ('din-plane-left', 'DIN632 DIN519', 'G16 that ends the tilted plane is gone'),
        ('din-shift-left', 'DIN634 DIN519', 'G980 is gone'),
        ('din-program-missing', 'MAC402', 'a call of a subprogram that is not there'),
    ]),
    *table('DIN PLUS', WARNING, [
        ('din-break-removed', 'DIN410', 'BREAK of a branch that is not the last is gone'),
        ('din-def-hash', 'DIN323', 'DEF(#__la)'),
        ('din-assignment-removed', 'MAC209 DIN407', 'the only assignment of a variable is gone'),
        ('din-case-removed', 'MAC209', 'the assignment on one side of IF is gone'),
        ('din-step-removed', 'MAC319', 'the step of the loop is gone'),
        ('din-step-sign', 'MAC320 MAC319', 'the step goes the other way'),
        ('din-step-zero', 'MAC320 MAC319', 'the step is 0'),
        ('din-conversion-left', 'DIN906 DIN519', 'G30 H0 is gone'),
        ('din-letter-removed', 'DIN330', 'a call leaves out what the subprogram uses without DEF'),
        ('din-letter-unknown', 'DIN331 DIN330', 'a transfer value of another letter, which no word of a call passes'),
    ]),
    *(kind for group, severity, rows in dinplus_kinds.ROWS for kind in table(f'DIN PLUS: {group}', severity, rows, own_bar=True)),
    *(kind for group, severity, rows in sinumerik_kinds.ROWS for kind in table(f'SINUMERIK: {group}', severity, rows, own_bar=True)),
]}
