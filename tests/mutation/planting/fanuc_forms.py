"""Fanuc blocks that the control does not take as they are: what is missing, or stands where nothing may stand."""
import re

from .edit import put
from .fanuc import closing
from .flow import unreached

WORD = re.compile(r'(?<![A-Z#])([XYZRFIJK])(\s*-?(?:\d+\.?\d*|\.\d+))(?=\s|$|[A-Z])')
INDIRECT = re.compile(r'#(\[)\s*#\s*\d+\s*(\])')
CONDITION = re.compile(r'(?:IF|WHILE)\s*(\[)')
LOGIC = re.compile(r'\]\s*(?:AND|OR)\s*\[')
THEN = re.compile(r'THEN\s*(?=#)')
JUMP = re.compile(r'GOTO\s*(?=(\d+)\s*$)')
ARGUMENT = re.compile(r'(?<!#)(?:SIN|COS|TAN|SQRT|ABS|ROUND|FIX|FUP)(\[)\s*(?:#\s*\d+|\d+\.?\d*)\s*(\])')
SUM = re.compile(r'=.*?(?<=[\d\]])\s*([+-])\s*(?=#)')
STORE = re.compile(r'#\s*\d+\s*=[^A-Z]*$')
OTHER_MAKER = re.compile(r'\b(?:NCT|HAAS|NGC)\b|#8550|(?:G103|G154|G187|M97)(?!\d)|#3\d{4}\.\d')
WORDS = re.compile(r'\s*G[0-3]\s*[XYZ]')


def plants(program, lines):
    other_maker = 'the control of another maker may take it' if OTHER_MAKER.search('\n'.join(lines).upper()) else ''
    for index, block in enumerate(program.blocks):
        reason = unreached(program, index) or other_maker
        for name, edits in of_block(block):
            yield name, edits, reason
        after = program.blocks[index + 1] if index + 1 < len(program.blocks) else None
        if after is not None and stores_alone(block) and WORDS.match(after.code) and after.line == block.line + 1:
            end = len(lines[block.line].rstrip())
            yield ('line-end-lost', put(block, (end, end), ' ' + lines[after.line].strip())
                   + put(after, (0, len(lines[after.line].rstrip())), ''), reason)


def stores_alone(block):
    return STORE.search(block.code.rstrip()) is not None and not block.conditional and not block.skipped


def of_block(block):
    code = block.code
    word = WORD.search(code) if '=' not in code and '<' not in code else None
    if word:
        yield 'value-lost', put(block, word.span(2), '')
    indirect = INDIRECT.search(code)
    if indirect:
        yield 'double-sharp', put(block, indirect.span(1), '') + put(block, indirect.span(2), '')
    condition = CONDITION.search(code)
    if condition:
        opened, closed = condition.start(1), closing(code, condition.start(1))
        joined = LOGIC.search(code, opened, closed) is not None and code[opened + 1:].lstrip().startswith('[')
        yield ('logic-outside' if joined else 'condition-open',
               put(block, (opened, opened + 1), ' ') + put(block, (closed, closed + 1), ' '))
    for name, pattern, new in (('then-removed', THEN, ''), ('jump-letter', JUMP, 'GOTO N')):
        match = pattern.search(code)
        if match:
            yield name, put(block, match.span(), new)
    if JUMP.search(code):
        end = len(code.rstrip())
        yield 'jump-and-words', put(block, (end, end), ' M8')
    argument = ARGUMENT.search(code)
    if argument:
        yield 'function-open', put(block, argument.span(1), ' ') + put(block, argument.span(2), '')
    total = SUM.search(code)
    if total:
        yield 'sign-doubled', put(block, total.span(1), total.group(1) * 2)
