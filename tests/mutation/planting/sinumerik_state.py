"""Slips in what a SINUMERIK program switches on and has to switch off, saves and puts back."""
import re

from .sinumerik_reader import ENDS, added_behind, cut, emptied, gone, put

FRAME = r'(?<![\w$])(A?)(?:TRANS|ROT|SCALE|MIRROR)(?!\w)'
TOOL = r'(?<![\w$])(?:T\d|T=|M6(?!\w)|D\d)'
CYCLE = r'(?<![\w$])(?:CYCLE8[1-9]|HOLES[12])\b'
COUPLED = {'TRAFOOF': ('TRANSMIT', 'TRACYL', 'TRAORI'), 'COUPOF': ('COUPON',)}
PAIRS = [('G90', 'G91'), ('G17', 'G18'), ('G94', 'G95'), ('G40', 'G41'), ('G0', 'G1'), ('DIAMON', 'DIAMOF')]


def plants(program, libraries):
    for block in program.blocks:
        yield from codes(block)
        yield from compensation(program, block)
        yield from cancels(program, block)
        yield from saved(program, block)
        yield from lathe(program, block)
        yield from actions(program, block)
    yield from distances(program, libraries)
    yield from frames(program)


def codes(block):
    for one, other in PAIRS:
        if block.has(one) and not block.has(other) and not block.definition and 'MEAS' not in block.text:
            code = block.find(rf'(?<![\w$]){one}(?![\w\[])')
            yield 'sin-two-codes', put(block, (code.end(), code.end()), f' {other}'), ''
            break


def arc(block):
    return block is not None and block.has('G2', 'G3', 'CIP')


def compensation(program, block):
    code = block.find(r'(?<!\w)G4[12]\s')
    after = program.at(block)
    if code and arc(after) and not arc(block) and not after.label:
        begin = after.head
        yield 'sin-compensation-on-arc', cut(block, code) + [(after.line, (begin, begin), code.group().strip() + ' ')], ''
    straight = after is not None and (after.has('G1', 'G0') or re.match(r'[XY]', after.text)) and not after.word and not after.label
    if code and straight and not arc(after) and not after.has('G40', 'G41', 'G42') and re.search(r'[XYZ]', after.text):
        begin = after.head
        yield 'sin-side-switched', put(after, (begin, begin), ('G42 ' if 'G41' in code.group() else 'G41 ')), ''
    off = block.find(r'(?<!\w)G40\s?')
    if not off or not any(found.has('G41', 'G42') for found in program.before(block)):
        return
    before = program.at(block, -1)
    if arc(before) and not block.label:
        yield 'sin-compensation-off-arc', cut(block, off) + [(before.line, (before.head, before.head), 'G40 ')], ''
    later = next((found for found in program.after(block) if found.find(TOOL) or found.find(CYCLE) or found.has('G40', 'G41', 'G42')
                  or found.jump or found.word in ('ELSE', 'ENDIF') or ENDS.search(found.text)), None)
    if later is None or later.has('G40', 'G41', 'G42') or later.jump or later.word:
        return
    if later.find(TOOL):
        yield 'sin-compensation-at-tool', cut(block, off), ''
    elif later.find(CYCLE):
        yield 'sin-compensation-at-cycle', cut(block, off), ''
    elif not program.save:
        yield 'sin-compensation-left', cut(block, off), ''


def cancels(program, block):
    for off, on in COUPLED.items():
        stop = block.find(rf'(?<!\w){off}\b')
        if stop and any(found.has(*on) for found in program.before(block)):
            later = any(found.has(off) for found in program.after(block))
            anew = any(found.has(*on) for found in program.after(block))
            reason = 'another one follows' if anew else 'it is switched off later, too' if later else ''
            yield 'sin-coupling-left', emptied(block), reason
    rounding = block.find(r'(?<!\w)RNDM=0(?![\w.])')
    if rounding and any(found.find(r'RNDM=(?!0\b)') for found in program.before(block)):
        yield 'sin-rounding-left', cut(block, rounding), ''
    position = block.find(r'(?<!\w)SPOS=\S+')
    after = program.at(block)
    if position and after is not None and after.has('G331'):
        others = any(found is not block and found.find(r'(?<!\w)SPOS=') for found in program.blocks)
        yield 'sin-tap-without-position', emptied(block), 'another block positions the spindle' if others else ''


def saved(program, block):
    """A group is read with $P_GG and put back with G[ ]=."""
    back = block.find(r'(?<!\w)G\[(\d+)\]=([A-Z_]{2}\w*)')
    if back:
        others = [found for found in program.blocks if found.find(r'\w+=\$P_GG\[\d+\]') and not found.text.startswith(back.group(2) + '=')]
        yield 'sin-restore-gone', emptied(block), ''
        if others:
            wrong = re.match(r'\w+', others[0].text).group()
            yield 'sin-restore-crossed', cut(block, back, 2, wrong), ''
    kept = re.match(r'(\w+)=\$P_GG\[(\d+)\]$', block.text)
    members = {'14': ('G90', 'G91'), '6': ('G17', 'G18', 'G19'), '15': ('G94', 'G95')}.get(kept.group(2)) if kept else None
    changed = next((found for found in program.after(block) if members and found.has(*members)), None)
    if changed is not None:
        yield 'sin-saved-late', gone(block) + added_behind(changed, block.code.strip()), ''


def lathe(program, block):
    limit = block.find(r'(?<!\w)LIMS=\S+')
    if limit and any(found.has('G96') for found in program.after(block)) and not any(found.find('LIMS=') for found in program.before(block)):
        again = any(found.find(r'(?<!\w)LIMS=') for found in program.after(block))
        yield 'sin-speed-without-limit', emptied(block), 'another limit follows' if again else ''


def actions(program, block):
    own = block.find(r'(?:ID|IDS)=(\d+)\s')
    if block.action and own:
        yield 'sin-action-number', cut(block, own, 1, '300'), ''
        other = next((found for found in program.before(block) if found.action and found.find(r'ID=(\d+)\s')), None)
        if other:
            yield 'sin-action-number-twice', cut(block, own, 1, other.find(r'ID=(\d+)\s').group(1)), ''
    if block.action:
        does = block.bare.index('DO')
        stored = re.compile(r'\$R\[(\d+)\](?==)').search(block.bare, does) or re.compile(r'\$AC_MARKER\[(\d+)\](?==)').search(block.bare, does)
        if stored:
            yield 'sin-action-variable', cut(block, stored, 0, f'R{stored.group(1)}'), ''
    if block.text.startswith('CANCEL(') and not program.main:
        yield 'sin-action-left', emptied(block), ''


def distances(program, libraries):
    """A program that works by distances gives its caller G91."""
    if program.main or not any(program.name in other.named for name, other in libraries.items() if name != program.name):
        return
    last = next((block for block in reversed(program.blocks) if block.has('G90', 'G91')), None)
    if program.save and last is not None and last.has('G91') and not last.inside:
        yield 'sin-save-gone', cut(program.proc, program.proc.find(r'\s*\bSAVE\b')), ''
    restored = any(block.find(r'(?<!\w)G\[14\]=') for block in program.blocks)
    moves = [block for block in program.blocks if block.words() and block.find(r'(?<![\w$])[XYZ][-=\d]')
             and not block.inside and not block.label]
    if not program.save and not restored and moves and not moves[-1].has('G90', 'SUPA', 'G53'):
        yield 'sin-distance-left', put(moves[-1], (moves[-1].head, moves[-1].head), 'G91 '), ''


def frames(program):
    commands = [(block, block.find(FRAME)) for block in program.blocks if block.find(FRAME) and not block.definition]
    for place, (block, found) in enumerate(commands):
        bare = block.end == found.end()
        follow = commands[place + 1][0] if place + 1 < len(commands) else None
        if follow is program.at(block) and follow is not None and not bare:
            add = follow.find(r'(?<!\w)A(?=TRANS|ROT|SCALE|MIRROR)')
            if add:
                yield 'sin-frame-lost', cut(follow, add), ''
        if bare and not found.group(1) and not program.save:
            later = program.after(block)
            on = any(other.end != match.end() for other, match in commands[:place])
            off = any(other.end == match.end() for other, match in commands[place + 1:])
            if on and not off and follow is None:
                computed = any(other.text.startswith(('CALL', 'PCALL')) for other in program.blocks if other.line > commands[0][0].line)
                reason = 'a computed call may cancel it' if computed else ''
                yield 'sin-frame-left', emptied(block), reason
