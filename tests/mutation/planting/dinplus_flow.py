"""Slips in what decides where a DIN PLUS program goes on."""
import re

from .dinplus_reader import RUN, exchanged

CONDITION = re.compile(r'(?:IF|WHILE)\s+(.*)')
COUNTED = re.compile(r'WHILE\s+#(l\d+)\s*(<=?|>=?)\s*-?\d')


def plants(program):
    blocks = [block for block in program.blocks if block.section in RUN]
    for at, block in enumerate(blocks):
        after = blocks[at + 1] if at + 1 < len(blocks) and blocks[at + 1].part == block.part else None
        word = re.match(r'[A-Z_]*', block.text).group()
        if after and {word, after.text} in ({'ENDIF', 'ENDWHILE'}, {'ENDIF', 'ENDSWITCH'}, {'ENDWHILE', 'ENDSWITCH'}):
            yield 'din-ends-crossed', exchanged(block, after), ''
        if word in ('ELSE', 'DEFAULT'):
            yield 'din-branch-twice', [(block.line, (block.end, block.end), f'\n{block.text}')], ''
        if word == 'IF' or word == 'WHILE':
            condition = CONDITION.match(block.text)
            joined = len(re.findall(r'\b(?:AND|OR)\b', block.text))
            if condition and joined == 1 and '"' not in block.text:
                yield 'din-three-conditions', [(block.line, (block.end, block.end), ' AND (#l1>0)')], ''
        if after and not block.slides and block.section == 'MACHINING' and after.codes('T') and depth(blocks[:at + 1], block.part) == 0:
            yield 'din-end-early', [(block.line, (block.end, block.end), '\nM30')], ''
    yield from cases(blocks)
    yield from never(blocks)
    yield from renamed_once(program, blocks)
    yield from recursion(program)


def depth(blocks, part):
    own = [block.text for block in blocks if block.part == part]
    return sum(text.startswith(('IF', 'WHILE', 'SWITCH')) - text.startswith(('ENDIF', 'ENDWHILE', 'ENDSWITCH')) for text in own) \
        + sum(text.startswith('UNIT') - text.startswith('END_OF_UNIT') for text in own)


def cases(blocks):
    """Two branches of one SWITCH ask for the same."""
    seen = []
    for block in blocks:
        if block.text.startswith('SWITCH'):
            seen = []
        case = re.match(r'CASE\s+(\S+)', block.text)
        if case and seen:
            begin = block.head + case.start(1)
            yield 'din-case-twice', [(block.line, (begin, begin + len(case.group(1))), seen[0])], ''
        if case:
            seen.append(case.group(1))


def never(blocks):
    """The relation of a counted loop the other way round: with its first value it is never true."""
    for at, block in enumerate(blocks):
        loop = COUNTED.match(block.text)
        if not loop:
            continue
        firsts = [re.match(rf'#{loop.group(1)}\s*=\s*(-?\d+\.?\d*)$', other.text) for other in blocks[max(0, at - 3):at]]
        first = next((found for found in reversed(firsts) if found), None)
        limit = re.match(r'WHILE\s+#l\d+\s*[<>]=?\s*(-?\d+\.?\d*)$', block.text)
        if first and limit and float(first.group(1)) != float(limit.group(1)):
            begin = block.head + loop.start(2)
            yield 'din-loop-never', [(block.line, (begin, begin + 1), '>' if loop.group(2)[0] == '<' else '<')], ''


def renamed_once(program, blocks):
    """One reading of a local variable gets a number that nothing sets."""
    used = set(re.findall(r'#(l\d+)', '\n'.join(program.codes)))
    free = next(f'l{number}' for number in range(90, 9, -1) if f'l{number}' not in used)
    for block in blocks:
        if 'DEF(' in block.text or 'INPUT(' in block.text:
            continue
        begin = block.code.index('=') if re.match(r'#\w+\s*=[^=]', block.text) else block.head
        read = re.search(r'#(l\d+)(?!\()', block.code[begin:])
        if read:
            at = begin + read.start(1)
            yield 'din-variable-renamed', [(block.line, (at, at + len(read.group(1))), free)], ''


def recursion(program):
    """A subprogram calls itself where it ought to return."""
    for index, (name, line) in enumerate(program.heads):
        named = re.search(r'"([^"]+)"', program.codes[line])
        own = [block for block in program.blocks if block.part == index]
        if name == 'SUBPROGRAM' and named and own and own[-1].text.startswith('RETURN'):
            yield 'din-recursion', [(own[-1].line, (own[-1].head, own[-1].head), f'L"{named.group(1)}"\n')], ''
