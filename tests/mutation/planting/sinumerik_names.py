"""Slips in the definitions and names of a SINUMERIK program."""
import re

from .sinumerik_reader import DEFINED, NAME, added_behind, closing, cut, emptied, gone, put, slip, split

NUMBERS = ('INT', 'REAL')


def plants(program, shared):
    """`shared`: the names that definition files beside the program define."""
    for block in program.blocks:
        yield from definitions(program, block)
        yield from system_variables(block)
        yield from indices(program, block)
        yield from types(program, block)
    yield from labels(program)
    yield from misspelt(program, shared)
    yield from loops(program)


def definitions(program, block):
    first = program.first()
    if re.match(r'(?:DEF|EXTERN)\b', block.text) and first is not None and first.line > block.line:
        yield 'sin-late-definition', gone(block) + added_behind(first, block.code.strip()), ''
    if block is program.proc and program.parameters:
        own = program.parameters[0]
        name = block.bare[slice(*own.span)]
        yield 'sin-name-twice', added_behind(block, f'DEF {own.type}{"[10]" if own.type == "STRING" else ""} {name}'), ''
    defined = DEFINED.match(block.text)
    if not defined:
        return
    yield 'sin-name-twice', added_behind(block, block.code.strip()), ''
    names = [name for name, variable in program.variables.items() if variable.line == block.line and not variable.parameter]
    for name in names[:1]:
        wrong = f'{name[0]}1_{name[1:]}'
        yield 'sin-name-form', everywhere(program, name, wrong), ''
        yield 'sin-name-long', everywhere(program, name, f'{name}_OF_THE_FIRST_SIDE_AND_OF_THE_SECOND'), ''
        word = 'SPOS' if 'SPOS' not in program.named else 'OFFN'
        yield 'sin-name-of-a-word', everywhere(program, name, word), ''
        if used(program, name):
            yield 'sin-undefined', without(program, name, block), ''
    values = block.find(r'(\w+)\[(\d+)(?:,(\d+))?\]=(?:SET)?\(')
    if values:
        end = closing(block.bare, values.end() - 1)
        places = int(values.group(2)) * int(values.group(3) or 1)
        given = split(block.bare, values.end(), end)
        if len(given) == places:
            last = block.code[slice(*given[-1])]
            yield 'sin-values-too-many', put(block, (end, end), f',{last}'), ''


def without(program, name, block):
    """The definition without the name: a line with others keeps them."""
    others = [own for own in program.variables.values() if own.line == block.line]
    if len(others) == 1:
        return emptied(block)
    own = program.variables[name]
    begin, end = own.whole
    last = max(other.whole[1] for other in others) == end
    return put(block, (begin - 1, end) if last else (begin, end + 1), '')


def everywhere(program, name, other):
    edits = []
    for block in program.blocks:
        edits += [(block.line, found.span(), other) for found in NAME.finditer(block.bare) if found.group() == name]
    return edits


def used(program, name):
    own = program.variables[name].line
    return any(name in NAME.findall(block.bare) for block in program.blocks if block.line != own)


def system_variables(block):
    found = block.find(r'\$\$?A[A-Z]?_[A-Z]+|\$P_[A-Z]+')
    if found:
        yield 'sin-system-variable', put(block, (found.end(), found.end()), 'Q'), ''


def indices(program, block):
    if block.definition:
        return
    for found in block.each(r'(?<![\w$])([A-Z_]{2}\w*)\[([^\[\]]+)\]'):
        own = program.variables.get(found.group(1))
        if own is None or not own.sizes or own.parameter or own.type == 'STRING':
            continue  # of a text the last index is a character
        given = [part.strip() for part in found.group(2).split(',')]
        if given[0].isdigit():
            begin = found.start(2)
            yield 'sin-index-beyond', put(block, (begin, begin + len(given[0])), str(own.sizes[0])), ''
        wrong = f'{found.group(2)},0' if len(given) == 1 else given[0]
        yield 'sin-dimensions', cut(block, found, 2, wrong), ''
        break
    for found in block.each(r'(?<![\w$])([A-Z_]{2}\w*)(?![\w\[(=])'):
        own = program.variables.get(found.group(1))
        if own and not own.sizes and own.type in NUMBERS and not own.parameter and block.depth(found.start()) == 0 and not block.jump:
            yield 'sin-dimensions', put(block, (found.end(), found.end()), '[0]'), ''
            break


def types(program, block):
    stored = re.match(r'([A-Z_]{2}\w*)=(?!=)(\S+)', block.text)
    own = program.variables.get(stored.group(1)) if stored else None
    if own and own.type in NUMBERS and not own.sizes and '"' not in stored.group(2):
        value = (block.head + stored.start(2), block.head + stored.end(2))
        yield 'sin-text-for-number', put(block, value, '"10"'), ''
        if own.type == 'INT' and stored.group(2).isdigit():
            yield 'sin-fraction', put(block, value, f'{stored.group(2)}.5'), ''
            yield 'sin-integer-large', put(block, value, '3000000000'), ''


def labels(program):
    """A label has the name of a variable, and its jumps follow."""
    name = next((name for name, own in program.variables.items() if len(name) > 1 and not own.parameter), None)
    for block in program.blocks:
        jumps = any(found.jump and found.jump.group(2) == block.label for found in program.blocks)
        if name and block.label and jumps:
            yield 'sin-label-of-a-variable', everywhere(program, block.label, name), ''


def loops(program):
    """FOR I=0 TO 7 runs over an array of eight: one more is too many."""
    for block in program.blocks:
        loop = re.match(r'FOR\s+(\w+)=\d+\s+TO\s+(\d+)$', block.text)
        if not loop:
            continue
        sizes = {program.variables[found.group(1)].sizes[0] for inner in program.body(block)
                 for found in inner.each(rf'(?<![\w$])([A-Z_]{{2}}\w*)\[{loop.group(1)}\b') if found.group(1) in program.variables
                 and program.variables[found.group(1)].sizes and not program.variables[found.group(1)].parameter}
        if sizes and min(sizes) == int(loop.group(2)) + 1:
            begin = block.head + loop.start(2)
            yield 'sin-loop-beyond', put(block, (begin, begin + len(loop.group(2))), str(min(sizes))), ''


def misspelt(program, shared):
    """One reading of a variable of the program has two letters exchanged."""
    taken = set(program.variables) | shared
    done = set()
    for block in program.blocks:
        if block.definition or block.action:
            continue
        for found in NAME.finditer(block.bare, block.head):
            name = found.group()
            written = re.match(r'(?:\[[^\]]*\])?=(?!=)', block.bare[found.end():])
            own = program.variables.get(name)
            if own and len(name) > 4 and name not in done and slip(name) not in taken and not written:
                done.add(name)
                yield 'sin-variable-misspelt', cut(block, found, 0, slip(name)), ''
                break
