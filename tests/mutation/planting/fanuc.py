"""Reads Fanuc programs: as much as is needed to plant defects and to see which of them do no harm.

It knows nothing of maclint, so that the two do not share their mistakes.
"""
import re
from dataclasses import dataclass, field
from pathlib import Path

ARGUMENTS = {1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 13, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26}
OTHER_LOCALS = {10, 12, 14, 15, 16, *range(27, 34)}  # no letter passes them
HEAD = re.compile(r'\s*(?P<skip>/\s*\d?)?\s*(?:N\s*(?P<label>\d+))?')
START = re.compile(r'\s*(?:<[^>]*>|[O:])\s*(\d+)')
VARIABLE = re.compile(r'#\s*(\d+)(?![\d.])')
STORE = re.compile(r'#\s*(\d+)\s*=')
INDIRECT_STORE = re.compile(r'#\s*\[(.*)\]\s*=(?!.*\bIF\b)')
GOTO = re.compile(r'GOTO\s*(?:(\d+)(?![\d.])|([#\[]))')
WHILE = re.compile(r'WHILE\s*\[')
DO = re.compile(r'DO\s*(\d+)')
END = re.compile(r'END\s*(\d+)')
CALL = re.compile(r'(M\s*0*9[78]|G\s*0*65|G\s*0*66(?:\.1)?)(?![\d.])')
OWN_CODE = re.compile(r'G\s*[1-9]\d\d(?![\d.])')  # of the machine's maker: mostly a macro of his
NUMBER_CALLED = re.compile(r'P\s*(\d+)(?![\d.])')
RETURN = re.compile(r'M\s*0*99(?!\d)')
PROGRAM_END = re.compile(r'M\s*0*(?:30|2)(?!\d)')
ALARM = re.compile(r'#\s*3000\s*=')
STOP = re.compile(r'M\s*0*[01](?!\d)|#\s*3006\s*=')


def code_of(text):
    """The line in capitals with blanks where comments are, column by column."""
    out, depth = [], 0
    for char in text:
        depth += char == '('
        out.append(char if depth == 0 and char not in '\r\n;' else ' ')
        depth -= char == ')' and depth > 0
    return ''.join(out).upper()


@dataclass
class Block:
    line: int  # in the file, from 0
    code: str
    label: int = None
    skipped: bool = False
    stores: list = field(default_factory=list)  # numbers of variables
    reads: list = field(default_factory=list)  # (variable, column)
    target: int = None  # of a GOTO with a literal number
    jumps: bool = False
    computed: bool = False
    conditional: bool = False
    loop: int = None
    loop_condition: str = ''
    end: int = None
    leaves: bool = False  # M99, M30 or an alarm, without a condition
    stores_anywhere: bool = False

    @property
    def is_call(self):
        return CALL.search(self.code) is not None

    @property
    def may_call(self):
        return self.is_call or OWN_CODE.search(self.code) is not None

    @property
    def uses_frame_of_caller(self):
        return re.search(r'M\s*0*9[78](?!\d)', self.code) is not None


def closing(code, opened):
    """The column of the bracket that closes the one at `opened`."""
    depth = 0
    for column in range(opened, len(code)):
        depth += (code[column] == '[') - (code[column] == ']')
        if depth == 0:
            return column
    return len(code) - 1


def reaches_locals(index):
    """Whether a store with this index may hit a local: not with a base of 100 or more, nor with a common variable in it."""
    numbers = [int(n) for n in re.findall(r'(?<![#\d.])(\d{3,})', index)]
    commons = [int(n) for n in VARIABLE.findall(index) if int(n) >= 100]
    return not numbers and not commons


def read_block(line, code):
    head = HEAD.match(code)
    block = Block(line, code, label=int(head['label']) if head['label'] else None, skipped=bool(head['skip']))
    block.conditional = 'IF' in code
    stored = {match.start() for match in STORE.finditer(code)} if '=' in code else set()
    block.stores = [int(match.group(1)) for match in STORE.finditer(code)]
    block.reads = [(int(m.group(1)), m.start()) for m in VARIABLE.finditer(code) if m.start() not in stored and int(m.group(1))]
    indirect = INDIRECT_STORE.search(code)
    block.stores_anywhere = bool(indirect) and reaches_locals(indirect.group(1))
    jump = GOTO.search(code)
    if jump:
        block.jumps, block.computed = True, jump.group(1) is None
        block.target = int(jump.group(1)) if jump.group(1) else None
    loop, end = DO.search(code), END.search(code)
    block.loop = int(loop.group(1)) if loop and not jump else None
    block.end = int(end.group(1)) if end and not WHILE.search(code) else None
    repeated = WHILE.search(code)
    if repeated:
        block.loop_condition = code[repeated.end() - 1:closing(code, repeated.end() - 1) + 1]
    leaving = RETURN.search(code) or PROGRAM_END.search(code) or ALARM.search(code)
    block.leaves = bool(leaving) and not block.conditional and not block.skipped
    return block


class Program:
    """One O number: its blocks, and where the control goes from each."""

    def __init__(self, number, blocks, folder=Path()):
        self.number, self.blocks, self.folder = number, blocks, folder
        self.labels = {}
        for index, block in enumerate(blocks):
            if block.label is not None:
                self.labels.setdefault(block.label, []).append(index)
        self.match_loops()
        self.successors = [self.next_of(index) for index in range(len(blocks))]
        self.reachable = self.reach([0]) if blocks else set()

    def match_loops(self):
        self.end_of, self.start_of, opened = {}, {}, []
        for index, block in enumerate(self.blocks):
            if block.end is not None and opened and self.blocks[opened[-1]].loop == block.end:
                start = opened.pop()
                self.end_of[start], self.start_of[index] = index, start
            elif block.loop is not None:
                opened.append(index)

    def target_of(self, index, label):
        """The block that a GOTO at this index takes: the next one of that number, from the start when none follows."""
        places = self.labels.get(label, [])
        after = [place for place in places if place > index]
        return after[0] if after else places[0] if places else None

    def next_of(self, index):
        block, after = self.blocks[index], [index + 1] if index + 1 < len(self.blocks) else []
        if block.leaves:
            return []
        if block.jumps:
            targets = [place for places in self.labels.values() for place in places] if block.computed else \
                [place for place in [self.target_of(index, block.target)] if place is not None]
            return targets + (after if block.conditional or block.skipped else [])
        if index in self.start_of:
            return [self.start_of[index]]
        if index in self.end_of and block.loop_condition:
            leaves = self.end_of[index] + 1
            return after + ([leaves] if leaves < len(self.blocks) else [])
        return after

    def reach(self, starts, stop=lambda index: False):
        """Blocks that the control may come to; it does not go on after one at which it stops."""
        seen, waiting = set(starts), list(starts)
        while waiting:
            index = waiting.pop()
            if stop(index):
                continue
            for after in self.successors[index]:
                if after not in seen:
                    seen.add(after)
                    waiting.append(after)
        return seen

    def body(self, start):
        return range(start + 1, self.end_of[start])

    def loops(self):
        return sorted(self.end_of.items())

    @property
    def returns(self):
        """Whether somebody may call it."""
        return any(RETURN.search(block.code) for block in self.blocks)

    @property
    def is_macro(self):
        """Returns to a caller and never ends the part."""
        return self.returns and not any(PROGRAM_END.search(block.code) for block in self.blocks)

    def has_exit(self, index):
        """Whether the control may stop or leave at this block."""
        block = self.blocks[index]
        return bool(block.leaves or not self.successors[index] or block.is_call or block.skipped or STOP.search(block.code)
                    or RETURN.search(block.code) or ALARM.search(block.code) or PROGRAM_END.search(block.code))


def programs_of(lines, folder=Path()):
    """The programs of a file; lines before the first number belong to one without a number."""
    programs, number, blocks = [], None, []
    for line, text in enumerate(lines):
        code = code_of(text)
        start = START.match(code)
        if start:
            programs.append(Program(number, blocks, folder))
            number, blocks = int(start.group(1)), []
            code = ' ' * start.end() + code[start.end():]
        if code.strip() and not code.lstrip().startswith(('%', '&', '<')):
            blocks.append(read_block(line, code))
    programs.append(Program(number, blocks, folder))
    return [program for program in programs if program.blocks]


def calls_of(lines):
    """Numbers of the programs that a file calls."""
    called = set()
    for text in lines:
        code = code_of(text)
        if CALL.search(code):
            called |= {int(number) for number in NUMBER_CALLED.findall(code)}
            called |= {int(number[-4:]) for number in NUMBER_CALLED.findall(code) if len(number) > 4}
    return called
