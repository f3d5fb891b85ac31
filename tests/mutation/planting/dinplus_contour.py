"""Contours of DIN PLUS that cannot be, or lie where they cannot be turned."""
import math

from .dinplus_reader import RUN, TURNED, emptied, plain, put

OUTLINES = {'G101', 'G102', 'G103', 'G111', 'G112', 'G113', 'G171', 'G172', 'G173', 'G181', 'G182', 'G183'}
POCKETS = ('G845', 'G846')


def plants(program):
    for at, block in enumerate(program.blocks):
        if block.section in (*TURNED, *RUN) and block.has('G1', 'G2', 'G3'):
            before = position(program.blocks[:at], block.part)
            if before:
                yield from element(program, block, before)
    yield from outside(program)
    yield from opened(program)


def position(blocks, part):
    """(X, Z) in front of a block, where it can be told from the blocks before it: G0 and G1 to G3 with numbers."""
    x = z = None
    for block in reversed(blocks):
        turned = any(word.name in ('Xi', 'Zi', 'AN', 'A', 'W') for word in block.words)
        if block.part != part or not block.has('G0', 'G1', 'G2', 'G3') or turned:
            return None
        for name in ('X', 'Z'):
            word = block.get(name)
            if word and word.number is None:
                return None
            if name == 'X' and word and x is None:
                x = word.number
            if name == 'Z' and word and z is None:
                z = word.number
        if x is not None and z is not None:
            return x, z
    return None


def element(program, block, before):
    if any(word.name in ('Xi', 'Zi', 'Y', 'J', 'AN', 'A', 'Ii', 'Ki') for word in block.words):
        return
    ends = [block.get(name) for name in ('X', 'Z')]
    if any(word and word.number is None for word in ends):
        return
    x, z = (word.number if word else old for word, old in zip(ends, before))
    chord = math.hypot((x - before[0]) / 2, z - before[1])
    contour = block.section in TURNED
    if block.has('G2', 'G3') and chord:
        radius = block.get('R')
        if radius and radius.number:
            yield 'din-arc-radius', put(block, radius, plain(0.4 * chord)), ''
        centre = block.get('K' if x == before[0] else 'I')
        if centre and centre.number is not None:
            yield 'din-arc-centre', put(block, centre, plain(centre.number + 4)), ''
        far = block.get('X')
        if far and block.get('I') and block.get('K'):
            yield 'din-arc-end', put(block, far, plain(far.number + 7)), ''
        if contour and ends[0] and ends[1]:
            yield 'din-arc-closed', put(block, ends[0], plain(before[0])) + put(block, ends[1], plain(before[1])), ''
    if contour and block.has('G1') and block.section != 'BLANK':
        chamfer = block.get('BR')
        if chamfer and chamfer.number and chamfer.number < 0:
            yield 'din-chamfer-long', put(block, chamfer, plain(-chord - 5)), ''
        if ends[0] and x > 0:
            yield 'din-across-axis', put(block, ends[0], f'-{ends[0].value}'), ''


def outside(program):
    """The bar is thinner or shorter than the part that is turned from it."""
    bars = [block for block in program.blocks if block.section == 'BLANK' and block.has('G20')]
    if len(bars) != 1 or sum(name == 'FINISHED' for name, _ in program.heads) != 1:
        return
    part = [block for block in program.blocks if block.section == 'FINISHED' and block.has('G0', 'G1', 'G2', 'G3')]
    xs, zs = ([block.get(name).number for block in part if block.get(name) and block.get(name).number is not None] for name in ('X', 'Z'))
    x, z = bars[0].get('X'), bars[0].get('Z')
    if xs and x and x.number and max(xs) > 0:
        yield 'din-outside-blank', put(bars[0], x, plain(0.6 * max(xs))), ''
    if zs and z and z.number and max(zs) - min(zs) > 1:
        yield 'din-outside-blank', put(bars[0], z, plain(0.5 * (max(zs) - min(zs)))), ''


def opened(program):
    """A pocket whose last element is gone, so that its outline no longer closes."""
    named = {word.value for block in program.run() if block.has(*POCKETS) for word in block.words if word.letter == 'ID'}
    numbers = {int(word.number) for block in program.run() if block.has(*POCKETS) for word in block.words
               if word.letter == 'NS' and word.number is not None}
    begin = None
    for at, block in enumerate(program.blocks):
        if block.has('G308'):
            begin = at
        if block.has('G309') and begin is not None:
            inside, name = program.blocks[begin + 1:at], program.blocks[begin].get('ID')
            outline = [element for element in inside if OUTLINES & {f'G{number}' for number in element.codes()}]
            used = (name and name.value in named) or any(element.number in numbers for element in inside)
            if used and len(outline) >= 3 and len(outline) == len(inside) - 1:
                yield 'din-pocket-opened', emptied(outline[-1]), ''
            begin = None
