"""Blocks and sections of a DIN PLUS program in the wrong order."""
import re

from .dinplus_reader import RUN, SURFACES, TURNED, emptied, exchanged

MOVES = re.compile(r'\bG(?:0|1|2|3|7\d|8\d\d?|14|701|12|13|10\d|11\d|3[1-9])\b')
LEAVES = re.compile(r'\bG(?:0|14|701)\b')
PATTERNS = ('G401', 'G402', 'G411', 'G412', 'G471', 'G472', 'G481', 'G482')
# Codes that the manual wants in this order (l.12300, 13643, 22275-22346, 22195).
IN_ORDER = [('G740', 'G860'), ('G741', 'G860'), ('G910', 'G911'), ('G914', 'G912'), ('G787', 'G788')]


def plants(program):
    yield from sections(program)
    yield from contours(program)
    run = [block for block in program.blocks if block.section in RUN]
    for block in run:
        if block.text == 'G80':
            yield 'din-g80-removed', emptied(block), ''
    for first, second in zip(run, run[1:]):
        if first.part != second.part or first.slides != second.slides:
            continue
        if first.has('G14') and second.codes('T') and len(second.words) == 1 and not first.has('M5', 'M30'):
            yield 'din-tool-before-retract', exchanged(first, second), away(run[:run.index(first)])
        if any(first.has(before) and second.has(after) for before, after in IN_ORDER):
            yield 'din-codes-exchanged', exchanged(first, second), ''


def away(before):
    """Why the slide is not at the work any more."""
    last = next((block for block in reversed(before) if MOVES.search(block.code)), None)
    if last is None:
        return 'nothing has moved before'
    return 'the slide may have left the work before' if LEAVES.search(last.code) else ''


def sections(program):
    """The word of a section, with what stands beside it, is gone or stands where that of another belongs."""
    heads = {name: line for name, line in program.heads}
    count = [name for name, _ in program.heads]
    for first, second in (('BLANK', 'FINISHED'), ('FINISHED', 'MACHINING'), ('TURRET', 'BLANK')):
        if count.count(first) == 1 == count.count(second) and first in heads and second in heads:
            lines = [(heads[name], program.codes[heads[name]].rstrip()) for name in (first, second)]
            edits = [(line, (0, len(text)), other) for (line, text), (_, other) in zip(lines, lines[::-1])]
            yield 'din-sections-exchanged', edits, ''
    for name, line in program.heads:
        inside = [block for block in program.blocks if block.part == program.heads.index((name, line))]
        if name in ('FINISHED', 'AUXIL', *SURFACES) and any(block.words for block in inside):
            before = [other for other, at in program.heads if at < line][-1:]
            harmless = 'the section before it is of its kind' if before == [name] else ''
            yield 'din-section-gone', [(line, (0, len(program.codes[line].rstrip())), '')], harmless


def contours(program):
    for at, block in enumerate(program.blocks):
        after = program.blocks[at + 1] if at + 1 < len(program.blocks) else None
        same = after is not None and after.part == block.part
        if block.place == 'c' and same and block.has(*PATTERNS):
            yield 'din-pattern-behind-figure', exchanged(block, after), ''
        if block.place == 'c' and block.has('G308'):
            yield 'din-pocket-not-begun', emptied(block), ''
        if block.place == 'c' and block.has('G309'):
            yield 'din-pocket-not-ended', emptied(block), ''
        if block.section in TURNED and block.has('G0') and same and after.has('G1', 'G2', 'G3'):
            yield 'din-contour-without-start', emptied(block), ''
