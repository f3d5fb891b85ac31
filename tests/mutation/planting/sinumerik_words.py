"""Slips in the words of a SINUMERIK block, and in its numbers."""
import math
import re

from .sinumerik_reader import cut, more

PLANES = {'G17': ('XY', 'IJ'), 'G18': ('ZX', 'KI'), 'G19': ('YZ', 'JK')}


def plants(program):
    for block in program.blocks:
        yield from twice(block)
        yield from divisions(block)
        yield from positions(block)
        yield from numbers(block)
        yield from functions(block)
    yield from arcs(program)


def twice(block):
    axes = [word for word in block.words() if word.group(1) in 'XYZ']
    if axes:
        word = axes[-1]
        yield 'sin-address-twice', more(block, f'{word.group(1)}{float(word.group(2)) + 1.5:g}'), ''


def divisions(block):
    if block.definition or block.action:
        return
    for divisor in block.each(r'(?:/|\bDIV\b|\bMOD\b)\s*(\d+\.?\d*)(?![\w.])'):
        yield 'sin-division-by-zero', cut(block, divisor, 1, '0'), ''
        break


def numbers(block):
    """What a cycle and an alarm are called with."""
    depth = block.find(r'(?<!\w)CYCLE8[1-6]\(\d+,0,\d+,(-)\d')
    if depth:
        yield 'sin-cycle-depth', cut(block, depth, 1), ''
    alarm = block.find(r'(?<!\w)SETAL\((6)\d{4}\b')
    if alarm:
        yield 'sin-alarm-number', cut(block, alarm, 1), ''


def functions(block):
    """SQRT(R1) with an argument more, ATAN2(R1,R2) with one less; CYCEL81 for CYCLE81."""
    one = block.find(r'(?<![\w$])(?:SQRT|SIN|COS|TAN|ABS|TRUNC|ROUND|POT)\([^(),"]+()\)')
    if one:
        yield 'sin-function-arguments', cut(block, one, 1, ',2'), ''
    two = block.find(r'(?<![\w$])ATAN2\([\w.]+(,[\w.]+)\)')
    if two:
        yield 'sin-function-arguments', cut(block, two, 1), ''
    cycle = block.find(r'(?<![\w$])CYC(LE)\d+\(')
    if cycle:
        yield 'sin-cycle-misspelt', cut(block, cycle, 1, 'EL'), ''


def positions(block):
    """X=$P_EP[X]+5 goes to a place, X=IC($P_EP[X]+5) by it."""
    read = block.find(r'(?<![\w$])[XYZ]=(\$P_EP\[[XYZ]\][^\s]*)')
    if read and not block.has('G91'):
        yield 'sin-position-as-distance', cut(block, read, 1, f'IC({read.group(1)})'), ''


def arcs(program):
    """Arcs whose start, end and radius or centre are plain numbers."""
    plane, place, absolute = 'G17', {}, program.main
    diameter = False
    for block in program.blocks:
        if block.word or block.label or block.has('G91', 'TRANSMIT', 'TRACYL', 'CIP') or re.match(r'A?(?:TRANS|ROT|SCALE|MIRROR)\b', block.text):
            place = {}
        absolute = absolute or block.has('G90')
        plane = next((code for code in PLANES if block.has(code)), plane)
        diameter = (diameter or block.has('DIAMON')) and not block.has('DIAMOF')
        axes, centres = PLANES[plane]
        words = {word.group(1): word for word in block.words()}
        if block.has('G2', 'G3') and all(axis in place for axis in axes) and not diameter:
            yield from arc(block, words, axes, centres, place)
        if re.match(r'(?:CALL|REPEAT|[A-Z_]{2}\w*\(|[A-Z_]{2}\w*$)', block.text) and not re.match(r'MSG|STOPRE', block.text):
            place = {}
            continue
        for axis in 'XYZ':
            if axis in words and absolute:
                place[axis] = float(words[axis].group(2))
            elif re.search(rf'(?<![\w$]){axis}=', block.text):
                place.pop(axis, None)


def arc(block, words, axes, centres, place):
    if any(re.search(rf'(?<![\w$]){axis}=', block.text) for axis in axes):
        return
    start = [place[axis] for axis in axes]
    end = [float(words[axis].group(2)) if axis in words else place[axis] for axis in axes]
    chord = math.dist(start, end)
    radius = block.find(r'(?<!\w)CR=(\d+\.?\d*)')
    if radius and chord > 1:
        yield 'sin-radius-short', cut(block, radius, 1, f'{chord / 2 * 0.8:.3f}'), ''
        given = [words[axis] for axis in axes if axis in words]
        if given:
            edits = [(block.line, words[axis].span(2), f'{place[axis]:g}') for axis in axes if axis in words]
            yield 'sin-radius-closed', edits, ''
    centre = [words.get(letter) for letter in centres]
    if not radius and all(centre) and chord > 1:
        along = max((0, 1), key=lambda axis: abs(end[axis] - start[axis]))  # beside the chord both ends stay as far from it
        shift = max(2.0, chord)
        yield 'sin-centre-beside', cut(block, centre[along], 2, f'{float(centre[along].group(2)) + shift:g}'), ''
