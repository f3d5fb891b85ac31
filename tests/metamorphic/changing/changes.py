"""The changes that must not matter. Each takes a program and a source of chance, and gives edits, or None where it cannot be
made there. What may differ in messages stands beside it."""
import re
from dataclasses import dataclass

from . import dinplus, fanuc
from .numbers import renumber
from .text import Edit, blocks, insert, neighbours

BOTH = ('fanuc', 'dinplus')
LANGUAGES = {'fanuc': fanuc, 'dinplus': dinplus}


@dataclass(frozen=True)
class Change:
    name: str
    languages: tuple
    edits: object  # (program, random.Random) -> list of Edit, or None
    whole: bool = False  # some of its edits without the others change what the program does
    same: str = ''  # what is made equal in messages: 'blanks', 'case', 'zeros', 'numbers'


CHANGES = {}


def change(name, languages=BOTH, same='', whole=False):
    def add(function):
        CHANGES[name] = Change(name, languages, function, whole, same)
        return function
    return add


def pieces(program):
    if program.pieces is None:
        program.pieces = LANGUAGES[program.language].pieces(program.text)
    return program.pieces


def comment_of(program):
    return LANGUAGES[program.language].COMMENT


def some(rng, edits, share=0.5):
    """About this share of the edits, never none of them."""
    picked = [edit for edit in edits if rng.random() < share]
    return picked or edits[:1]


# Line ends

def line_ends(to):
    def edits(program, rng):
        found = {match.group() for match in re.finditer(r'\r\n?|\n\r*', program.text)}
        if len(found) != 1 or found == {to}:
            return None  # no line end, or a file in which CR and LF are mixed and mean what a reader thinks
        return [Edit(match.start(), match.end(), to) for match in re.finditer(r'\r\n?|\n\r*', program.text)]
    return edits


for name, to in (('line-ends-lf', '\n'), ('line-ends-crlf', '\r\n'), ('line-ends-cr', '\r')):
    change(name)(line_ends(to))
change('line-ends-of-tape', ('fanuc',))(line_ends('\n\r\r'))


@change('final-line-end')
def final_line_end(program, rng):
    """Taken away where there is one, put there where there is none."""
    end = re.search(r'(\r\n?|\n\r*)\Z', program.text)
    if end is None:
        return [insert(len(program.text), '\n')] if program.text.strip() else None
    return [Edit(end.start(), end.end(), '')]


@change('semicolons', ('fanuc',), same='semicolons')
def semicolons(program, rng):
    """`;` before the line ends of blocks."""
    if any(piece.kind == 'end' and piece.text == ';' for piece in pieces(program)):
        return None
    return [insert(block[-1].begin, ';') for block in blocks(pieces(program))
            if block[-1].kind == 'end' and has_code(block) and not open_comment(block)]


@change('byte-order-mark')
def byte_order_mark(program, rng):
    try:
        program.text.encode('latin-1').decode('utf-8')
    except UnicodeDecodeError:
        return None
    return None if program.text.startswith('\xef\xbb\xbf') else [insert(0, '\xef\xbb\xbf')]


@change('tape-leader', ('fanuc',), whole=True)
def tape_leader(program, rng):
    """Blank tape before the first mark and after the last one."""
    if program.text.lstrip()[:1] != '%' or not program.text.rstrip('\r\n').endswith('%'):
        return None
    return [insert(0, '\0' * 20), insert(len(program.text), '\0' * 20)]


@change('tape-marks', ('fanuc',), whole=True)
def tape_marks(program, rng):
    """`%` before and after a program that has neither."""
    if '%' in program.text or not re.search(r'^[ \t]*[ON:G][ \t]*\d', program.text, re.MULTILINE | re.IGNORECASE):
        return None  # or no program at all
    if (program.text.endswith(')') or '\n' in program.text) and not program.text.endswith('\n'):
        return [insert(0, '%\n'), insert(len(program.text), '\n%\n')]
    return [insert(0, '%\n'), insert(len(program.text), '%\n')]


# Letters

def letters(to):
    def edits(program, rng):
        return [Edit(piece.begin, piece.end, to(piece.text)) for piece in pieces(program)
                if piece.kind == 'letters' and to(piece.text) != piece.text]
    return edits


change('small-letters', ('fanuc',), same='case')(letters(str.lower))
change('capitals', ('fanuc',), same='case')(letters(str.upper))


DINPLUS_KEYWORDS = re.compile(
    r'IF|THEN|ELSE|ENDIF|WHILE|ENDWHILE|SWITCH|CASE|DEFAULT|BREAK|ENDSWITCH|RETURN|PRINT|INPUT|WINDOW|UNIT|END_OF_UNIT'
    r'|BLOCKSTART|BLOCKEND|SIN|COS|TAN|ASIN|ACOS|ATAN|ABS|ROUND|INT|SQRT|SQRTA|SQRTS|LOGN|EXP|AND|OR')


@change('small-keywords', ('dinplus',), same='case')
def small_keywords(program, rng):
    """Keywords and functions; addresses and section words have capitals."""
    return [Edit(piece.begin, piece.end, piece.text.lower()) for piece in pieces(program)
            if piece.kind == 'letters' and DINPLUS_KEYWORDS.fullmatch(piece.text)]


@change('leading-zeros', same='zeros')
def leading_zeros(program, rng):
    """G1 is G01, M06 is M6."""
    edits = []
    for word, number in neighbours(pieces(program)):
        if number.kind != 'number' or word.kind != 'letters' or word.text.upper() not in ('G', 'M'):
            continue
        if re.fullmatch(r'\d', number.text):
            edits.append(insert(number.begin, '0'))
        elif re.fullmatch(r'0\d', number.text):
            edits.append(Edit(number.begin, number.begin + 1, ''))
    return edits


# Comments

def has_code(block):
    return any(piece.kind in ('letters', 'number', 'sign') for piece in block)


def has_fixed(block):
    return any(piece.kind == 'fixed' for piece in block)


def code_end(block):
    """After the last piece that is neither blank nor the block's end."""
    return next((piece.end for piece in reversed(block) if piece.kind not in ('blank', 'end')), None)


def open_comment(block):
    return any(piece.kind == 'comment' and piece.text[-1:] not in (')', ']') for piece in block)


def takes_comment(block):
    """Not where the next comment is the text of an alarm or a name, belongs to maclint, or is not seen as one."""
    text = ''.join(piece.text for piece in block)
    return has_code(block) and not open_comment(block) and not re.search(
        r'#[ \t]*30(00|06)|^[ \t]*[O:]|M[ \t]*[01]?98|G[ \t]*6[56]|MACLINT', text, re.IGNORECASE)


def line_begins(program):
    """Where a line of its own may stand: before each block that begins a line, inside of the program."""
    before = 'end'
    for block in blocks(pieces(program)):
        if before != 'end' or block[0].kind == 'fixed' or program.text[block[0].begin - 1:block[0].begin] == ';':
            before = block[-1].kind
            continue
        before = block[-1].kind
        if block[0].begin:
            yield block[0].begin


def line_end_of(program):
    return (re.search(r'\r\n?|\n', program.text) or re.match('$', '\n')).group() or '\n'


@change('comment-lines')
def comment_lines(program, rng):
    text = comment_of(program) + line_end_of(program)
    return some(rng, [insert(at, text) for at in line_begins(program)], 0.3)


@change('blank-lines')
def blank_lines(program, rng):
    return some(rng, [insert(at, line_end_of(program)) for at in line_begins(program)], 0.3)


@change('comment-at-end')
def comment_at_end(program, rng):
    return some(rng, [insert(code_end(block), comment_of(program)) for block in blocks(pieces(program)) if takes_comment(block)])


@change('comment-between')
def comment_between(program, rng):
    """Between words of blocks that hold no statement."""
    edits = []
    for block in blocks(pieces(program)):
        if not takes_comment(block) or any(piece.kind == 'sign' and piece.text in '[]()=#,"' or piece.kind == 'fixed' for piece in block):
            continue
        code = [piece for piece in block if piece.kind not in ('blank', 'comment')]
        for left, right in neighbours(code):
            if left.kind == 'number' and right.kind == 'letters' and len(right.text) <= 2 and right.text.upper() != 'N':
                edits.append(insert(right.begin, comment_of(program)))
    return some(rng, edits)


# Blanks

def gaps(program, block):
    """Where blanks may be put in: between two pieces of a block, and within letters between two keywords."""
    code = [piece for piece in block if piece.kind != 'blank']
    depth = 0
    for left, right in neighbours(code):
        depth += left.text == '('
        depth -= left.text == ')'
        touching = left.end == right.begin and right.kind != 'end'
        if touching and (may_part(program, left, right) or program.language == 'dinplus' and in_expression(left, right, depth)):
            yield right.begin
    if program.language == 'fanuc':
        for piece in code:
            if piece.kind == 'letters':
                at = piece.begin
                words = fanuc.keywords_in(piece.text)
                if 'GOTO' in words:
                    yield piece.begin + piece.text.upper().index('GOTO') + 2
                for word, following in zip(words, words[1:]):
                    at += len(word)
                    if len(word) > 1 or len(following) > 1:
                        yield at


def in_expression(left, right, depth):
    """Whether blanks between the two are harmless in DIN PLUS: in parentheses, but not before those of a variable; around `=`."""
    if right.text == '(' or left.text[:1] in '%;/' or left.kind == 'comment' or right.kind == 'comment':
        return False
    return depth > 0 or '=' in (left.text, right.text)


def may_part(program, left, right):
    kinds = {left.kind, right.kind}
    if 'fixed' in kinds and not (program.language == 'dinplus' and left.kind == 'fixed' and left.text[:1] == '"') or right.kind == 'end':
        return False
    if program.language == 'fanuc':
        return True
    letter_o = right.text.upper() == 'O'  # typed for a 0: a blank makes an address of it
    return left.kind == 'number' and right.kind == 'letters' and not letter_o or 'comment' in kinds


@change('blanks-in', same='blanks')
def blanks_in(program, rng):
    edits = [insert(at, rng.choice((' ', '  ', '\t'))) for block in blocks(pieces(program))
             if not folder_line(block) for at in gaps(program, block)]
    return some(rng, edits)


@change('blanks-out', ('fanuc',), same='blanks')
def blanks_out(program, rng):
    edits = []
    for block in blocks(pieces(program)):
        for left, blank, right in zip(block, block[1:], block[2:]):
            if blank.kind == 'blank' and may_join(left, right):
                edits.append(Edit(blank.begin, blank.end, ''))
    return some(rng, edits, 0.8)


def may_join(left, right):
    """Numbers stay apart, and letters where they would be read as other keywords; an address without a number is known by the
    blank behind it."""
    if 'fixed' in (left.kind, right.kind) or left.text == '/' or left.kind == right.kind == 'number':
        return False
    if left.kind == right.kind == 'letters':
        apart = fanuc.keywords_in(left.text) + fanuc.keywords_in(right.text)
        return fanuc.keywords_in(left.text + right.text) == apart and len(apart[len(fanuc.keywords_in(left.text)) - 1]) > 1
    return True


@change('blanks-wider', same='blanks')
def blanks_wider(program, rng):
    """Where there are blanks, more of them, or tabs."""
    return some(rng, [Edit(piece.begin, piece.end, rng.choice((' ', '   ', '\t', ' \t '))) for piece in pieces(program) if piece.kind == 'blank'])


@change('indented')
def indented(program, rng):
    """Blanks at the head and the end of blocks."""
    edits = []
    for block in blocks(pieces(program)):
        if folder_line(block) or not has_code(block) or has_fixed(block) or open_comment(block):
            continue
        edits.append(insert(block[0].begin, '   '))
        if block[-1].kind == 'end':
            edits.append(insert(block[-1].begin, '  '))
    return some(rng, edits)


def folder_line(block):
    return block[0].text.startswith('&')


change('renumbered', same='numbers', whole=True)(renumber)
