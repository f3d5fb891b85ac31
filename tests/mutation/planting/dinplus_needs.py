"""What a code of DIN PLUS needs before it is gone: a tool, the spindle, a feed, the C axis."""
import re

from .dinplus_reader import emptied, put, without

MOVES = ('G1', 'G2', 'G3')
CYCLES = ('G810', 'G820', 'G830', 'G840', 'G845', 'G846', 'G860', 'G869', 'G870', 'G890', 'G71', 'G72', 'G73', 'G74', 'G31', 'G32')
ON_C = ('G100', 'G101', 'G102', 'G103', 'G110', 'G111', 'G112', 'G113')
MILLED_Y = ('G841', 'G842', 'G843', 'G844', 'G800', 'G803', 'G804', 'G806')
STARTS = ('M3', 'M4', 'M103', 'M104', 'M203', 'M204', 'M303', 'M304')
STOPS = ('M5', 'M105', 'M205', 'M305')

# (class, codes that give it, what needs it, with the lines of the manual)
NEEDS = [
    ('din-c-axis-gone', ('M14', 'M214', 'M314'), ON_C),  # 20044, 16297
    ('din-limit-gone', ('G26',), ('G96',)),  # 10369, 12461, 12641
    ('din-lateral-diameter-gone', ('G120',), r'\bG11[0-3]\b.*\bCYi?[-\d#_]'),  # 16288
    ('din-probe-start-gone', ('G910',), ('G911',)),  # 22275-22346
    ('din-measured-value-gone', ('G787',), ('G788',)),  # 22195
]


def plants(program):
    run = program.run()
    if any(block.text.startswith('L"') for block in run):
        return  # a subprogram may do it
    for slide in sorted({digit for block in run for digit in re.findall(r'\d', block.slides)} or {''}):
        yield from of_slide([block for block in run if slide in block.slides] if slide else run)
    yield from pairs(program, run)


def first(run, wanted):
    return next((at for at, block in enumerate(run) if wanted(block)), None)


def works(block):
    return block.has(*MOVES, *CYCLES)


def of_slide(run):
    """What stands before the first work of a slide, once."""
    work = first(run, works)
    if work is None:
        return
    before = run[:work]
    tools = [block for block in before if block.codes('T')]
    if len(tools) == 1:
        word = next(word for word in tools[0].words if word.letter == 'T')
        yield 'din-tool-gone', without(tools[0], word), ''
    spindle = [block for block in before if block.has(*STARTS, *STOPS)]
    if spindle and spindle[-1].has(*STARTS) and not any(block.has(*STARTS) for block in spindle[:-1]):
        spindle = spindle[-1:]
        word = next(word for word in spindle[0].words if word.letter == 'M' and f'M{word.value}' in STARTS)
        yield 'din-spindle-gone', without(spindle[0], word), ''
        yield 'din-spindle-stopped', put(spindle[0], word, '5'), ''
    feeds = [block for block in before if block.get('F') and block.has('G95', 'G94', 'G195', 'G193', 'G295', 'G395')]
    if len(feeds) == 1 and not run[work].get('F'):
        yield 'din-feed-gone', feeds_gone(feeds[0]), ''
    speeds = [block for block in before if block.get('S') and block.has('G96', 'G97', 'G196', 'G197', 'G296', 'G396')]
    if len(speeds) == 1:
        yield 'din-speed-gone', without(speeds[0], speeds[0].get('S')), ''


def feeds_gone(block):
    """The feed with its code, so that none is left without its word."""
    code = next(word for word in block.words if f'G{word.value}' in ('G95', 'G94', 'G195', 'G193', 'G295', 'G395'))
    return without(block, code) + without(block, block.get('F'))


def pairs(program, run):
    """A code that another one needs, once before it."""
    for kind, need, users in NEEDS:
        places = [at for at, block in enumerate(run) if block.has(*need)]
        using = first(run, lambda block: uses(block, users))
        if places and using is not None and places[0] < using and (kind != 'din-limit-gone' or len(places) == 1):
            place = run[places[0]]
            later = [at for at in places[1:] if at < using]
            harmless = 'it stands twice before it is needed' if later else ''
            if kind == 'din-limit-gone' and not faces(program, run):
                harmless = 'no cycle faces to the axis, and the speed does not rise without end'
            word = next(word for word in place.words if f'{word.letter}{word.value}' in need)
            alone = len(place.codes()) + len(place.codes('M')) + len(place.codes('T')) == 1
            yield kind, emptied(place) if alone else without(place, word), harmless
    for at, block in enumerate(run):
        if block.has('G14') and block.get('D') and block.get('D').value in ('1', '2'):
            points = [other for other in run[:at] if other.has('G140') and other.get('D') and other.get('D').value == block.get('D').value]
            if len(points) == 1:
                yield 'din-change-point-gone', emptied(points[0]), ''
                break
    for plane in range(len(run)):
        block = run[plane]
        if block.text in ('G17', 'G19'):
            end = next((at for at in range(plane + 1, len(run)) if run[at].has('G18', 'G17', 'G19')), len(run))
            if any(other.has(*MILLED_Y) for other in run[plane:end]):
                yield 'din-plane-gone', emptied(block), ''


def faces(program, run):
    """Whether a facing cycle goes to the axis: it names the line of a finished part that begins at X0 (12598)."""
    finished = [block for block in program.blocks if block.section == 'FINISHED']
    axis = {second.number for first, second in zip(finished, finished[1:])
            if first.has('G0') and first.get('X') and first.get('X').number == 0}
    return any(block.has('G820') and block.get('NS') and block.get('NS').number in axis for block in run)


def uses(block, users):
    return block.has(*users) if isinstance(users, tuple) else re.search(users, block.code) is not None
