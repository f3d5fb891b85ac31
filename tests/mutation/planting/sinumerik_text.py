"""Slips in the characters of a SINUMERIK block: what the control cannot read."""
import re

from .sinumerik_reader import DEFINED, STRUCTURE, code_of, cut, gone, more, put, split, closing

WIDE_COLON = '\u00ef\u00bc\u009a'  # the bytes of the full-width colon, as Latin-1
OPEN_QUOTE, CLOSE_QUOTE = '\u00e2\u0080\u009c', '\u00e2\u0080\u009d'
CARON = '\u00c5\u00bd'
COMPARISONS = {'==': 'EQ', '<>': 'NE', '>': 'GT', '<': 'LT', '>=': 'GE', '<=': 'LE'}
SIGNS = {'<>': '!=', '<=': '=<', '>=': '=>'}
FOREIGN_ENDS = {'ENDWHILE': 'WEND', 'ENDFOR': 'NEXT', 'ELSE': 'ELSEIF R1==2'}
KEYWORDS = {'WHILE': 'WHLIE', 'ENDWHILE': 'ENDWHIEL', 'ENDIF': 'ENDFI', 'ELSE': 'ESLE', 'FOR': 'FRO', 'ENDFOR': 'ENDFRO', 'LOOP': 'LOPO',
            'ENDLOOP': 'ENDLOPO', 'REPEAT': 'REPAET', 'UNTIL': 'UNTLI', 'GOTOF': 'GOTFO', 'GOTOB': 'GOTBO', 'CASE': 'CSAE',
            'DEFAULT': 'DEFUALT', 'DEF': 'DFE', 'PROC': 'PORC'}
COMMANDS = {'STOPRE': 'STOPPRE', 'TRANS': 'TRNAS', 'ATRANS': 'ATRNAS', 'AROT': 'ARTO', 'MCALL': 'MCLAL', 'TRAFOOF': 'TRAFOF', 'DIAMON': 'DAIMON',
            'CANCEL': 'CANCLE', 'SETAL': 'SETLA', 'EXTERN': 'EXTREN'}
ADDRESS = r'(?<![\w$])(?:CR|RP|AP|SPOS|LIMS|RND|RNDM|RPL|AR|OFFN|ADIS|TURN)(=)\d'


def plants(program):
    for block in program.blocks:
        yield from conditions(block)
        yield from assignments(program, block)
        yield from brackets(block)
        yield from numbers(block)
        yield from keywords(block)
        yield from forms(block)
        yield from joined(program, block)
    yield from remarks(program)


def conditions(block):
    if not re.match(r'(?:IF|WHILE|UNTIL)\b', block.text):
        return
    equal = block.find(r'==')
    if equal:
        yield 'sin-equals-in-condition', cut(block, equal, 0, '='), ''
    sign = block.find(r'==|<>|>=|<=|>|<')
    if sign and block.bare[sign.start():sign.start() + 2] != '<<':
        yield 'sin-comparison-word', cut(block, sign, 0, f' {COMPARISONS[sign.group()]} '), ''
        if sign.group() in SIGNS:
            yield 'sin-comparison-sign', cut(block, sign, 0, SIGNS[sign.group()]), ''
    if block.word == 'IF':
        yield 'sin-then', more(block, 'THEN'), ''
    joined_ = block.find(r'\(([^()]*[<>=][^()]*)\)(\s*(?:AND|OR)\s*)\(([^()]*[<>=][^()]*)\)')
    if joined_:
        yield 'sin-logic-open', cut(block, joined_, 0, joined_.group(1) + joined_.group(2) + joined_.group(3)), ''


def assignments(program, block):
    stored = block.find(r'(R\d+|[A-Z_]{2}\w*)(?:\[[^\]]*\])?(=)(?!=)')
    known = stored and (stored.group(1) in program.variables or re.match(r'R\d', stored.group(1)))
    if known and stored.start() == block.head and not block.definition:
        yield 'sin-double-equals', cut(block, stored, 2, '=='), ''
    if block.definition or block.action:
        return
    for word in [*block.each(r'(?<![\w$])[XYZFTSIJK](=)(-?)(?=["A-Z_(])'), *block.each(ADDRESS)]:
        if block.depth(word.start()) == 0:
            sign = block.bare[word.end(1)]
            yield 'sin-equals-gone', cut(block, word, 1, '' if sign in '-"' else ' '), ''
            break


def brackets(block):
    for kind, opener, closer in (('sin-bracket', '(', ')'), ('sin-index-bracket', '[', ']')):
        if closer in block.text and block.bare.count(opener) == block.bare.count(closer):
            at = block.bare.rindex(closer)
            yield kind, put(block, (at, at + 1), ''), ''
            at = block.bare.index(opener)
            yield kind, put(block, (at, at + 1), ''), ''
    texts = list(block.each(r'"[^"]*"'))
    if texts:
        end = texts[-1].end()
        yield 'sin-quote-gone', put(block, (end - 1, end), ''), ''
        begin, end = texts[0].span()
        edits = put(block, (begin, begin + 1), OPEN_QUOTE) + put(block, (end - 1, end), CLOSE_QUOTE)
        yield 'sin-quotes-typographic', edits, ''


def numbers(block):
    words = block.words()
    fraction = next((word for word in words if '.' in word.group(2) and word.group(2)[-1] != '.'), None)
    if fraction:
        yield 'sin-decimal-comma', cut(block, fraction, 2, fraction.group(2).replace('.', ',')), ''
    minus = next((word for word in words if word.group(2)[0] == '-'), None)
    if minus:
        yield 'sin-sign-twice', cut(block, minus, 2, '-' + minus.group(2)), ''
    for wanted in ('GM', 'XYZSF'):
        zero = next((word for word in words if word.group(1) in wanted and word.group(2)[-1] == '0'), None)
        if zero:
            yield 'sin-letter-o', put(block, (zero.end() - 1, zero.end()), 'O'), ''


def keywords(block):
    found = re.match(r'[A-Z]+', block.text)
    for table, kind in ((KEYWORDS, 'sin-keyword'), (COMMANDS, 'sin-command')):
        if found and found.group() in table:
            yield kind, put(block, (block.head, block.head + found.end()), table[found.group()]), ''
    for later in block.each(r'\b(?:GOTOF|GOTOB|DEFAULT)\b'):
        if later.start() > block.head:
            yield 'sin-keyword', cut(block, later, 0, KEYWORDS[later.group()]), ''
            break
    if found and found.group() in FOREIGN_ENDS:
        yield 'sin-foreign-word', put(block, (block.head, block.end), FOREIGN_ENDS[found.group()]), ''


def forms(block):
    if block.label:
        colon = block.bare.index(':', block.label_span[1])
        yield 'sin-wide-colon', put(block, (colon, colon + 1), WIDE_COLON), ''
    if block.jump:
        end = block.head + block.jump.end(2)
        yield 'sin-jump-colon', put(block, (end, end), ':'), ''
    if block.number is not None and block.text:
        yield 'sin-stray-letter', put(block, (0, 0), CARON), ''
    if block.word in ('IF', 'FOR', 'WHILE', 'LOOP') and not block.label:
        yield 'sin-head-at-structure', put(block, (block.head, block.head), 'START_OF: '), ''
    elif block.word:
        yield 'sin-head-at-structure', put(block, (0, 0), '/'), ''
    default = block.find(r'\bDEFAULT\s+(GOTO[FB]?\s+)')
    if default and block.text.startswith('CASE'):
        yield 'sin-case-default', cut(block, default, 1), ''
        yield 'sin-case-default', cut(block, default, 0, f'{default.group(1)}DEFAULT '), ''
    arms = list(block.each(r'\bGOTO[FB]?\s+\w+\s+(?=-?\d)')) if block.text.startswith('CASE') else []
    if arms:
        yield 'sin-case-of', put(block, (arms[0].end(), arms[0].end()), 'OF '), ''
    if re.match(r'(?:PROC|EXTERN)\b.*,|DEF\b.*,', block.text):
        defined = DEFINED.match(block.text)
        opened = block.bare.find('(')
        begin, end = (block.head + defined.end(), block.end) if defined else (opened + 1, closing(block.bare, opened))
        parts = split(block.bare, begin, end)
        if len(parts) > 1:
            yield 'sin-split-definition', put(block, (parts[0][1] + 1, parts[0][1] + 1), '\n'), ''
    text = block.find(r'MSG\("([^"]+)"')
    if text:
        yield 'sin-text-long', put(block, (text.start(1), text.start(1)), 'mind the clamp ' * 14), ''


def joined(program, block):
    """Two lines become one."""
    after = program.at(block)
    if after is None or after.line != block.line + 1 or after.definition or block.definition:
        return
    if block.end != len(program.lines[block.line].rstrip()):
        return  # what follows a remark is part of it
    if STRUCTURE.match(after.text) or after.label or not after.text or block.action:
        return
    if block.word and after.text[0] in 'GXYZTSM':
        yield 'sin-not-alone', more(block, after.code[after.head:after.end]) + gone(after), ''
    elif block.number is not None and after.number is not None and block.words() and after.words():
        yield 'sin-two-blocks', more(block, after.code[:after.end].strip()) + gone(after), ''


def remarks(program):
    for line, text in enumerate(program.lines):
        code = code_of(text)
        begin = len(code.rstrip()) if code.strip() else 0
        remark = text[begin:].strip()
        if not remark.startswith(';'):
            continue
        words = remark[1:].strip()
        at = text.index(';', begin)
        if len(re.findall(r'[A-Za-z]+', words)) > 2:
            yield 'sin-remark-open', [(line, (at, at + 1), '')], '' if ',' in words.partition(';')[0] else 'its words may be macros'
        if words and '(' not in words:
            yield 'sin-remark-bracket', [(line, (at, len(text)), f'({words})')], ''
    for block in program.blocks:
        words = block.words()
        if words and words[-1].end() == block.end and len(program.lines[block.line].rstrip()) == block.end and block.has('G0', 'G1'):
            yield 'sin-remark-bracket', more(block, '(FINISH)'), ''
