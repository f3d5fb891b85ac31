"""Typing errors in the text of Fanuc blocks."""
import re

from .edit import put
from .fanuc import closing
from .flow import unreached

KEYWORDS = {'WHILE': 'WHLIE', 'THEN': 'TEHN', 'GOTO': 'G0TO', 'EQ': 'EQU'}
FUNCTION = re.compile(r'(SIN|COS|TAN|ATAN|SQRT|ABS|ROUND|FIX|FUP)\s*(\[)')
ZERO = re.compile(r'(?<=[GMXYZ])0(?=\d|\s|$)|(?<=[XYZ]\d)0(?=\.)')
DECIMAL = re.compile(r'(?<=[XYZF]\d)\.(?=\d)|(?<=[XYZ]-\d)\.(?=\d)')


def plants(program, lines):
    for index, block in enumerate(program.blocks):
        reason = unreached(program, index)
        code = block.code
        if '[' in code and code.count('[') == code.count(']'):
            last = code.rindex(']')
            yield 'bracket-unclosed', put(block, (last, last + 1), ''), reason
            yield 'bracket-unopened', put(block, (code.index('['), code.index('[') + 1), ''), reason
        function = FUNCTION.search(code)
        if function:
            closed = closing(code, function.start(2))
            yield ('round-brackets', put(block, function.span(2), '(') + put(block, (closed, closed + 1), ')'), reason)
        for kind, pattern, new in (('letter-for-zero', ZERO, 'O'), ('decimal-comma', DECIMAL, ',')):
            match = pattern.search(code)
            if match:
                yield kind, put(block, match.span(), new), reason
        for right, wrong in KEYWORDS.items():
            match = re.search(rf'(?<![A-Z]){right}(?![A-Z])', code)
            if match:
                yield 'keyword', put(block, match.span(), wrong), reason
                break
        text = lines[block.line].rstrip()
        if text.endswith(')') and code.strip():
            yield 'comment-unclosed', put(block, (len(text) - 1, len(text)), ''), reason
