"""Slips in the calls of SINUMERIK programs, and in what they declare."""
import re

from .sinumerik_reader import DEFINED, PROC, added_before, cut, put, slip

NUMBERS = ('INT', 'REAL')
OTHER_TYPE = {'INT': 'REAL', 'REAL': 'INT', 'BOOL': 'REAL'}


def plants(program, libraries):
    """`libraries`: the programs that may be called, by name."""
    declared = set()
    for block in program.blocks:
        for name, given in block.calls(libraries):
            if name == program.name:
                continue
            callee = libraries[name]
            begin = block.bare.index(name, block.head)
            yield 'sin-program-missing', put(block, (begin, begin + len(name)), slip(name)), ''
            if callee.parameters and given:
                yield from call(program, block, callee, given)
                if name not in declared:
                    declared.add(name)
                    yield from external(program, callee)
            elif given is None and not callee.proc:
                yield 'sin-arguments-without-proc', put(block, (begin + len(name), begin + len(name)), '(5)'), ''
        alone = block.text.strip() == 'MCALL'
        after = program.at(block)
        if alone and after is not None and not after.text.startswith('MCALL'):
            yield 'sin-modal-call-left', put(block, (block.head, block.end), ''), ''
    yield from declarations(program, libraries)


def call(program, block, callee, given):
    if len(given) == len(callee.parameters):
        end = given[-1][1]
        yield 'sin-argument-added', put(block, (end, end), ',1'), ''
    for own, (begin, end) in zip(callee.parameters, given):
        text = block.bare[begin:end].strip()
        if own.reference and text:
            last = own.parameter == len(given)
            yield 'sin-reference-left-out', put(block, (begin - 1, end) if last and own.parameter > 1 else (begin, end), ''), ''
            yield 'sin-reference-number', put(block, (begin, end), '0'), ''
            passed = program.variables.get(text)
            if passed and not passed.parameter and own.type in OTHER_TYPE:
                yield 'sin-reference-type', retyped(program, text, OTHER_TYPE[own.type]), ''
        elif own.type in NUMBERS and text:
            yield 'sin-argument-text', put(block, (begin, end), '"A"'), ''


def retyped(program, name, kind):
    """The definition of a variable with another type; the others of its line keep theirs."""
    own = program.variables[name]
    block = next(block for block in program.blocks if block.line == own.line)
    defined = DEFINED.match(block.text)
    begin = block.head
    others = [other for other in program.variables.values() if other.line == own.line]
    if len(others) == 1:
        return put(block, (begin + defined.start(1), begin + defined.end(1)), kind)
    last = max(other.whole[1] for other in others) == own.whole[1]
    span = (own.whole[0] - 1, own.whole[1]) if last else (own.whole[0], own.whole[1] + 1)
    return put(block, span, '') + added_before(block, f'DEF {kind} {name}{block.bare[own.span[1]:own.whole[1]].partition("=")[0]}')


def external(program, callee):
    """A declaration whose types are not those of the program."""
    types = [f'{"VAR " if own.reference else ""}{own.type}{"[32]" if own.type == "STRING" else ""}' for own in callee.parameters]
    at = next((place for place, own in enumerate(callee.parameters) if own.type in NUMBERS), None)
    if at is None or any(own.sizes for own in callee.parameters):
        return
    types[at] = types[at].replace(callee.parameters[at].type, OTHER_TYPE[callee.parameters[at].type])
    first = program.first()
    declared = next((block for block in program.blocks if re.match(rf'EXTERN\s+{callee.name}\b', block.text)), None)
    if declared:
        opened = declared.bare.index('(')
        yield 'sin-extern-differs', put(declared, (opened, declared.end), f'({",".join(types)})'), ''
    elif first is not None:
        yield 'sin-extern-differs', added_before(first, f'EXTERN {callee.name}({",".join(types)})'), ''


def declarations(program, libraries):
    block = program.proc
    if block is None:
        return
    named = PROC.match(block.text)
    if named.group(1) == program.name:
        begin = block.head
        yield 'sin-proc-name', put(block, (begin + named.start(1), begin + named.end(1)), f'{program.name[:20]}_OLD'), ''
    callers = [other for name, other in libraries.items() if name != program.name]
    called = any(given for other in callers for line in other.blocks for _, given in line.calls({program.name}))
    listed = block.find(r'\(.*\)')
    if called and listed and program.parameters:
        yield 'sin-arguments-without-proc', cut(block, listed), ''
