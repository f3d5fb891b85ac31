"""What a DIN PLUS program names: blocks of contours, contours, tools, constants, subprograms."""
import re

from .dinplus_reader import RUN, SURFACES, put

STARTS = ('G0', 'G100', 'G110', 'G170', 'G180')
MILLED = ('G840', 'G845', 'G846', 'G847', 'G848')  # NS names an element, not the start point (17190, 17256, 17465)
CONTOUR_CYCLES = ('G810', 'G820', 'G830', 'G860', 'G869', 'G890', 'G895', 'G870', 'G31', 'G809')


def plants(program):
    numbers = program.numbered()
    contours = {number: block for number, block in numbers.items() if block.place == 'c'}
    for block in program.blocks:
        if block.section in RUN:
            yield from contour_blocks(program, block, numbers, contours)
            yield from names(program, block)
            yield from tools(program, block)
    yield from turret(program)
    yield from doubled_names(program)
    yield from constants(program)


def contour_blocks(program, block, numbers, contours):
    for letter in ('NS', 'NE'):
        word = block.get(letter)
        if not word or word.number is None or int(word.number) not in contours or not block.codes():
            continue
        target = contours[int(word.number)]
        yield 'din-reference-nowhere', put(block, word, str(program.free_number())), ''
        if block.number is not None:
            yield 'din-reference-to-machining', put(block, word, str(block.number)), ''
        if letter == 'NS' and block.has(*MILLED):
            start = next((other for other in program.blocks if other.part == target.part and other.number is not None
                          and other.has(*STARTS[1:]) and other.number < target.number
                          and not any(between.has('G308') for between in program.blocks
                                      if between.part == target.part and other.line < between.line < target.line)), None)
            if start and start.number == target.number - 1:
                yield 'din-reference-to-start', put(block, word, str(start.number)), ''
        if letter == 'NE' and block.has(*CONTOUR_CYCLES):
            other = next((other for other in contours.values() if other.section in SURFACES and other.codes()), None)
            if other:
                yield 'din-reference-to-other-section', put(block, word, str(other.number)), ''
        if block.has('G870') or block.has('G71', 'G72', 'G73', 'G74'):
            wanted = ('G22',) if block.has('G870') else ('G300', 'G310', 'G370', 'G380')
            other = next((other for other in contours.values() if other.has('G1', 'G101', 'G111')), None)
            if other and target.has(*wanted):
                yield 'din-reference-to-other-kind', put(block, word, str(other.number)), ''


def names(program, block):
    known = {name for name, _, _ in program.names_of_contours()}
    name = block.get('ID')
    if name and block.codes() and name.value.strip('"') in known:
        text = name.value.strip('"')
        yield 'din-contour-name', put(block, name, f'"{text[:-1] if len(text) > 3 and text[:-1] not in known else text + "X"}"'), ''
    mark = block.get('NF')
    if mark and mark.number is not None and not block.get('A') and block.has('G71', 'G72', 'G840', 'G845'):
        others = {other.get('NF').value for other in program.blocks if other.get('NF')}
        yield 'din-position-mark', put(block, mark, next(str(n) for n in range(1, 127) if str(n) not in others)), ''


def pockets(program):
    """(tool, line, columns, text, line of the turret's word) of the lists of tools."""
    for name, line in program.heads:
        if name == 'TURRET':
            end = next((other for _, other in program.heads if other > line), len(program.codes))
            for at in range(line + 1, end):
                found = re.match(r'\s*T(\d+)(?:\.\d)?\s', program.codes[at])
                if found:
                    yield int(found.group(1)), at, found.span(1), found.group(0), line


def tools(program, block):
    known = {tool for tool, *_ in pockets(program)}
    word = block.get('T')
    if known and word and word.number is not None and int(word.number) in known and len(known) > 1:
        yield 'din-tool-not-in-turret', put(block, word, str(next(n for n in range(max(known) + 1, 200)))), ''
        yield 'din-tool-edge', put(block, word, f'{int(word.number)}.12'), ''


def turret(program):
    found = list(pockets(program))
    for (tool, *_, first), (other, line, columns, text, second) in zip(found, found[1:]):
        if tool != other and '.' not in text and first == second:
            yield 'din-pocket-twice', [(line, columns, str(tool))], ''


def doubled_names(program):
    """Two contours of one name that a cycle asks for: which of them it takes, nobody can tell."""
    found = list(program.names_of_contours())
    asked = {word.value.strip('"') for block in program.blocks if block.section in RUN for word in block.words if word.letter == 'ID'}
    for (name, *_), (other, line, columns) in zip(found, found[1:]):
        if name != other and name in asked:
            yield 'din-contour-name-twice', [(line, columns, name)], ''


def constants(program):
    """A letter of a constant's or variable's name exchanged where it is used."""
    declared = set()
    for block in program.blocks:
        if block.section in ('CONST', 'VAR'):
            declared |= {found.lower() for found in re.findall(r'^#?(_[a-z]\w*)', block.text)}
    for block in program.blocks:
        if block.section in ('CONST', 'VAR'):
            continue
        for used in re.finditer(r'(?<![a-z0-9_"])#?(_[a-z]\w*)', block.code):
            name = used.group(1)
            wrong = name[:-1] + ('z' if name[-1] != 'z' else 'y')
            if name in declared and wrong not in declared and '"' not in block.code[:used.start()]:
                yield 'din-name-mistyped', [(block.line, used.span(1), wrong)], ''
                break
