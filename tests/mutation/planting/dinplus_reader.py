"""The blocks, words and sections of a DIN PLUS program, read by the planter alone."""
import re
from dataclasses import dataclass, field

SECTIONS = {
    'PROGRAM HEAD': 'HEAD', 'PROGRAMMKOPF': 'HEAD', 'TURRET': 'TURRET', 'REVOLVER': 'TURRET', 'MAGAZINE': 'TURRET',
    'MAGAZIN': 'TURRET',
    'CHUCKING EQUIPMENT': 'CHUCK', 'SPANNMITTEL': 'CHUCK', 'CONTOUR': 'CONTOUR', 'KONTUR': 'CONTOUR',
    'BLANK': 'BLANK', 'ROHTEIL': 'BLANK', 'AUXIL_BLANK': 'AUXIL_BLANK', 'HILFSROHTEIL': 'AUXIL_BLANK', 'FINISHED': 'FINISHED', 'FERTIGTEIL': 'FINISHED',
    'AUXIL_CONTOUR': 'AUXIL', 'HILFSKONTUR': 'AUXIL', 'FACE_C': 'FACE_C', 'STIRN': 'FACE_C', 'FACE_Y': 'FACE_Y', 'STIRN_Y': 'FACE_Y',
    'REAR_C': 'REAR_C', 'RUECKSEITE': 'REAR_C', 'REAR_Y': 'REAR_Y', 'RUECKSEITE_Y': 'REAR_Y', 'LATERAL_C': 'LATERAL_C',
    'MANTEL': 'LATERAL_C', 'LATERAL_Y': 'LATERAL_Y', 'MANTEL_Y': 'LATERAL_Y', 'CONST': 'CONST', 'VAR': 'VAR',
    'MACHINING': 'MACHINING', 'BEARBEITUNG': 'MACHINING', 'SUBPROGRAM': 'SUBPROGRAM', 'UNTERPROGRAMM': 'SUBPROGRAM',
    'END': 'END', 'ENDE': 'END',
}
SECTION = re.compile('(' + '|'.join(sorted(SECTIONS, key=len, reverse=True)) + r')(?=\s|$)')
TURNED = ('BLANK', 'AUXIL_BLANK', 'FINISHED', 'AUXIL')  # contours in the plane of turning
SURFACES = ('FACE_C', 'FACE_Y', 'REAR_C', 'REAR_Y', 'LATERAL_C', 'LATERAL_Y')
RUN = ('MACHINING', 'SUBPROGRAM')
HEAD = re.compile(r'\s*((?:\$\d\s*)*)(?:/\d*\s*)?(?:N\s*(\d+)(?!\S))?\s*')
TOKEN = re.compile(r'(?:"[^"]*"|\([^)]*\)|\S)+')
WORD = re.compile(r'([A-Z]{1,3})(i?)("[^"]*"|[-+?#_(\d.].*|)$')
KEYWORD = re.compile(r'(?:IF|THEN|ELSE|ENDIF|WHILE|ENDWHILE|SWITCH|CASE|DEFAULT|BREAK|ENDSWITCH|RETURN|UNIT|END_OF_UNIT|BLOCKSTART|BLOCKEND'
                     r'|PRINT|INPUT|WINDOW)\b')
NUMBER = re.compile(r'-?(?:\d+\.?\d*|\.\d+)$')


@dataclass
class Word:
    letter: str
    incremental: bool
    value: str
    begin: int  # columns in its line
    end: int

    @property
    def name(self):
        return self.letter + ('i' if self.incremental else '')

    @property
    def number(self):
        return float(self.value) if NUMBER.match(self.value) else None


@dataclass
class Block:
    line: int  # from 0
    code: str  # blanks where comments are
    head: int  # columns before its first word
    slides: str
    number: int | None
    section: str
    part: int  # counts the sections of the program
    words: list = field(default_factory=list)  # none of keywords, assignments and calls

    @property
    def text(self):
        return self.code[self.head:].strip()

    @property
    def end(self):
        return len(self.code.rstrip())

    @property
    def place(self):
        """Of the table of words: contours are told elsewhere than machining."""
        return 'm' if self.section in RUN else 'c'

    def get(self, name):
        return next((word for word in self.words if word.name == name), None)

    def codes(self, letter='G'):
        return [int(word.number) for word in self.words if word.letter == letter and word.number is not None]

    def has(self, *codes):
        """Whether one of them, as 'G96' or 'M14', stands in the block."""
        return any(int(code[1:]) in self.codes(code[0]) for code in codes)


class Program:
    """`codes`: the lines with blanks where comments are."""

    def __init__(self, codes):
        self.codes = codes
        self.blocks, self.heads = [], []  # heads: (name, line) of the sections
        section = ''
        for line, code in enumerate(codes):
            found = SECTION.match(code.strip())
            if found:
                section = SECTIONS[found.group(1)]
                self.heads.append((section, line))
            elif code.strip() and section:
                self.blocks.append(block_of(line, code, section, len(self.heads) - 1))
        self.whole = {'HEAD', 'MACHINING', 'END'} <= {name for name, _ in self.heads}

    def run(self):
        """The blocks that the control runs in turn: those of MACHINING, without those of subprograms."""
        return [block for block in self.blocks if block.section == 'MACHINING']

    def numbered(self):
        return {block.number: block for block in self.blocks if block.number is not None}

    def free_number(self):
        return max(self.numbered(), default=0) + 7

    def names_of_contours(self):
        """(name, line, columns) of the contours that have one."""
        for _, line in self.heads:
            named = re.search(r'\bID\s*"([^"]*)"', self.codes[line])
            if named and not re.match(r'\s*T', self.codes[line]):
                yield named.group(1), line, named.span(1)
        for block in self.blocks:
            name = block.get('ID')
            if name and block.has('G308'):
                yield name.value.strip('"'), block.line, (name.begin + 3, name.end - 1)


def block_of(line, code, section, part):
    head = HEAD.match(code)
    block = Block(line, code, head.end(), head.group(1).replace(' ', ''), int(head.group(2)) if head.group(2) else None, section, part)
    text = code[block.head:]
    if section in ('HEAD', 'CHUCK') or KEYWORD.match(text) or text.startswith(('#', '_')) or text.startswith('L"'):
        return block
    for token in TOKEN.finditer(code, block.head):
        word = WORD.match(token.group())
        if not word:
            block.words = []  # not to be read: no place
            return block
        block.words.append(Word(word.group(1), bool(word.group(2)), word.group(3), *token.span()))
    return block


def put(block, word, value):
    """The word with another value."""
    return [(block.line, (word.begin + len(word.name), word.end), value)]


def without(block, word):
    """The block without the word and the blank before it."""
    begin = word.begin
    while begin > block.head and block.code[begin - 1] == ' ':
        begin -= 1
    return [(block.line, (begin, word.end), '')]


def with_more(block, text):
    return [(block.line, (block.end, block.end), f' {text}')]


def emptied(block):
    return [(block.line, (block.head, block.end), '')]


def exchanged(first, second):
    """What the two blocks say changes its place; their numbers and slides stay."""
    return [(first.line, (first.head, first.end), second.code[second.head:second.end]),
            (second.line, (second.head, second.end), first.code[first.head:first.end])]


def plain(number):
    """A number as a program has it."""
    return f'{number:.3f}'.rstrip('0').rstrip('.')
