"""The blocks, definitions and parameters of a SINUMERIK program, read by the planter alone."""
import re
from dataclasses import dataclass, field

HEAD = re.compile(r'\s*(?:/\d?\s*)?(?:N\s*(\d+)\s*)?')
LABEL = re.compile(r'([A-Z_]{2}\w*)\s*:(?!=)\s*', re.I)
NAME = re.compile(r'(?<![\w$])[A-Z_]{2}\w*', re.I)
NUMBER = r'-?(?:\d+\.?\d*|\.\d+)'
WORD = re.compile(rf'(?<![\w$"])([A-Z])({NUMBER})(?![\w.=])')  # an address of one letter with a plain number
STRUCTURE = re.compile(r'(IF|ELSE|ENDIF|FOR|ENDFOR|WHILE|ENDWHILE|LOOP|ENDLOOP|REPEAT|UNTIL)\b')
CLOSERS = {'IF': 'ENDIF', 'FOR': 'ENDFOR', 'WHILE': 'ENDWHILE', 'LOOP': 'ENDLOOP', 'REPEAT': 'UNTIL'}
LOOPS = ('FOR', 'WHILE', 'LOOP', 'REPEAT')
JUMP = re.compile(r'\b(GOTO[FBCS]?)\s+([A-Z_]{2}\w*)(?=\s|$)')
ENDS = re.compile(r'(?<![\w$])(?:RET|M17|M30|M2)(?!\w)')
TYPES = ('INT', 'REAL', 'BOOL', 'CHAR', 'STRING', 'AXIS', 'FRAME')
DEFINED = re.compile(rf'DEF\s+(?:NCK\s+|CHAN\s+)?({"|".join(TYPES)})(\[\d+\])?\s+')
PARAMETER = re.compile(rf'\s*(VAR\s+)?({"|".join(TYPES)})(\[\d+\])?\s+([A-Z_]\w*)(\[[^\]]*\])?')
PROC = re.compile(r'PROC\s+([A-Z_]\w*)\s*')


def code_of(line):
    """The line without its comment, blanks in its place."""
    inside = False
    for at, char in enumerate(line):
        if char == '"':
            inside = not inside
        elif char == ';' and not inside:
            return line[:at] + ' ' * (len(line) - at)
    return line


def bare_of(code):
    """The code with blanks for what is between quotes."""
    return re.sub(r'"[^"]*"', lambda text: '"' + ' ' * (len(text.group()) - 2) + '"', code)


@dataclass
class Variable:
    type: str
    sizes: tuple  # of an array
    line: int
    span: tuple  # of the name in its line
    whole: tuple  # of the name with its sizes and first value
    reference: bool = False
    parameter: int = 0  # its place, from 1


@dataclass
class Block:
    line: int  # from 0
    code: str
    bare: str
    head: int  # columns before the first word
    number: int | None
    label: str = ''
    label_span: tuple = (0, 0)
    inside: list = field(default_factory=list)  # the structures around it, each with the block that opens it

    @property
    def text(self):
        return self.bare[self.head:].rstrip()

    @property
    def end(self):
        return len(self.code.rstrip())

    @property
    def word(self):
        """The word of a structure that it is: 'IF' none that jumps."""
        found = STRUCTURE.match(self.text)
        word = found.group(1) if found else ''
        if word == 'IF' and JUMP.search(self.text) or word == 'IF' and 'GOTO' in self.text:
            return ''
        return '' if word == 'REPEAT' and self.text.strip() != 'REPEAT' else word

    @property
    def jump(self):
        return JUMP.search(self.text)

    @property
    def definition(self):
        return re.match(r'(?:DEF|EXTERN|PROC|REDEF|DEFINE)\b', self.text)

    @property
    def action(self):
        """Whether it is a synchronised action."""
        return re.search(r'(?<!\w)DO\s', self.bare) is not None

    def has(self, *codes):
        return any(re.search(rf'(?<![\w$]){code}(?![\w\[])', self.text) for code in codes)

    def find(self, pattern):
        """A match in its text, with the columns of the line."""
        return re.compile(pattern).search(self.bare, self.head)

    def each(self, pattern):
        return re.compile(pattern).finditer(self.bare, self.head)

    def depth(self, column):
        """Of brackets at a column."""
        before = self.bare[self.head:column]
        return sum(map(before.count, '([')) - sum(map(before.count, ')]'))

    def words(self):
        """The words of one letter and a plain number outside of brackets."""
        if self.definition or self.action:
            return []
        return [word for word in WORD.finditer(self.bare, self.head) if self.depth(word.start()) == 0]

    def number_of(self, letter):
        """What a word says, when it is a plain number."""
        return next((float(word.group(2)) for word in self.words() if word.group(1) == letter), None)

    def calls(self, names):
        """(name, columns of its arguments or None) of the calls of programs."""
        for found in self.each(r'(?<![\w$])([A-Z_]\w+)'):
            if found.group(1) in names and self.depth(found.start()) == 0 and not self.definition:
                yield found.group(1), arguments(self, found.end())


class Program:
    """`name`: that of the file."""

    def __init__(self, name, lines, main):
        self.name, self.main, self.lines = name.upper(), main, [line.rstrip('\r') for line in lines]
        self.blocks = [block for block in map(block_of, range(len(lines)), self.lines) if block.code.strip()]
        self.variables, self.parameters = {}, []
        self.proc = next((block for block in self.blocks if PROC.match(block.text)), None)
        self.save = self.proc is not None and re.search(r'\bSAVE\b', self.proc.text) is not None
        self.named = {name for block in self.blocks for name in NAME.findall(block.bare)}
        self.named |= {found.group() for block in self.blocks for found in block.each(r'(?<![\w$])L\d+(?![\w.=])')}
        self.read_definitions()
        self.nest()

    def read_definitions(self):
        if self.proc:
            opened = self.proc.bare.find('(')
            spans = split(self.proc.bare, opened + 1, closing(self.proc.bare, opened)) if opened >= 0 else []
            for place, (begin, end) in enumerate(spans, 1):
                found = PARAMETER.match(self.proc.bare, begin, end)
                if found:
                    variable = Variable(found.group(2), sizes(found.group(5)), self.proc.line, found.span(4), (begin, end),
                                        bool(found.group(1)), place)
                    self.parameters.append(variable)
                    self.variables[found.group(4)] = variable
        for block in self.blocks:
            defined = DEFINED.match(block.text)
            if not defined:
                continue
            for begin, end in split(block.bare, block.head + defined.end(), block.end):
                found = re.compile(r'\s*([A-Z_]\w*)(\[[^\]]*\])?').match(block.bare, begin, end)
                if found:
                    self.variables[found.group(1)] = Variable(defined.group(1), sizes(found.group(2)), block.line, found.span(1), (begin, end))

    def nest(self):
        opened = []
        for block in self.blocks:
            if block.word in CLOSERS.values() and opened:
                opened.pop()
            block.inside = list(opened)
            if block.word in CLOSERS:
                opened.append(block)

    def body(self, opener):
        """The blocks between a structure's ends."""
        return [block for block in self.blocks if opener in block.inside]

    def closer(self, opener):
        body = self.body(opener)
        after = self.blocks.index(body[-1] if body else opener) + 1
        return self.blocks[after] if after < len(self.blocks) else None

    def labels(self, name):
        return [block for block in self.blocks if block.label == name]

    def at(self, block, step=1):
        place = self.blocks.index(block) + step
        return self.blocks[place] if 0 <= place < len(self.blocks) else None

    def after(self, block):
        return self.blocks[self.blocks.index(block) + 1:]

    def before(self, block):
        return self.blocks[:self.blocks.index(block)]

    def first(self):
        """The first block that does something."""
        return next((block for block in self.blocks if not block.definition), None)


def block_of(line, text):
    code = code_of(text)
    head = HEAD.match(code)
    block = Block(line, code, bare_of(code), head.end(), int(head.group(1)) if head.group(1) else None)
    label = LABEL.match(block.bare, block.head)
    if label and not re.match(r'\s*(?:DEF|DEFINE)\b', code):
        block.label, block.label_span, block.head = label.group(1), label.span(1), label.end()
    return block


def sizes(text):
    return tuple(int(part) for part in re.findall(r'\d+', text or ''))


def closing(text, opened):
    """Where the bracket that opens there is closed, or the end."""
    depth = 0
    for at in range(opened, len(text)):
        depth += (text[at] in '([') - (text[at] in ')]')
        if depth == 0:
            return at
    return len(text.rstrip())


def split(text, begin, end):
    """The parts between commas outside of brackets."""
    parts, depth, start = [], 0, begin
    for at in range(begin, end):
        depth += (text[at] in '([') - (text[at] in ')]')
        if text[at] == ',' and depth == 0:
            parts.append((start, at))
            start = at + 1
    return parts + [(start, end)]


def arguments(block, column):
    """The columns of each argument of a call whose name ends there; None without brackets."""
    if block.bare[column:column + 1] != '(':
        return None
    return split(block.bare, column + 1, closing(block.bare, column))


def slip(name):
    """Two letters of a name exchanged, in its middle."""
    for at in range(len(name) // 2, len(name) - 1):
        if name[at] != name[at + 1]:
            return name[:at] + name[at + 1] + name[at] + name[at + 2:]
    return name + name[-1]


def put(block, span, text):
    return [(block.line, span, text)]


def cut(block, match, group=0, text=''):
    return [(block.line, match.span(group), text)]


def emptied(block):
    return [(block.line, (block.head, block.end), '')]


def gone(block):
    return [(block.line, (0, len(block.code)), '')]


def added_behind(block, text):
    return [(block.line, (block.end, block.end), f'\n{text}')]


def added_before(block, text):
    return [(block.line, (0, 0), f'{text}\n')]


def more(block, text):
    return [(block.line, (block.end, block.end), f' {text}')]
