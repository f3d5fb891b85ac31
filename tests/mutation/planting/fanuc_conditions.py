"""Conditions of Fanuc programs that ask something else than was meant."""
import re

from .edit import put
from .fanuc import ARGUMENTS, NUMBER_CALLED, OTHER_LOCALS
from .flow import certainly_stores, tests_vacancy, unreached, uses, variables_in

VACANT = re.compile(r'\[\s*#\s*(\d+)\s*(EQ|NE)\s*(#\s*0)\s*\]')
ANY_TEST = re.compile(r'(#\s*0+)\s*(?:EQ|NE)\s*#\s*(\d+)(?![\d.])|#\s*(\d+)\s*(?:EQ|NE)\s*(#\s*0+)(?![\d.])')
ZERO = re.compile(r'\[\s*#\s*(\d+)\s*(EQ|NE)\s*(0\.?0*)\s*\]')
COMPARED = re.compile(r'(?<![A-Z])(EQ|NE|GT|LT|GE|LE)(?![A-Z])')
SYMBOLS = {'EQ': '=', 'NE': '<>', 'GT': '>', 'LT': '<', 'GE': '>=', 'LE': '<='}
GUARD = re.compile(r'IF\s*(\[\s*#\s*(\d+)\s*(\w\w)\s*(#?\s*\d+\.?\d*)\s*\])\s*(GOTO|THEN\s*#\s*3000)')
DISTANCE = re.compile(r'\[\s*ABS\s*\[[^\[\]]*-[^\[\]]*\]\s*(LT|LE|GT|GE)\s*(\.\d+|0\.\d+)\s*\]')


def plants(program, numbers):
    """`numbers`: programs that are there."""
    yield from vacancy_tests(program, numbers)
    yield from zero_tests(program)
    yield from repeated_guards(program)
    yield from doubled_parts(program)
    yield from doubled_cases(program)
    yield from symbols(program)
    yield from distances(program)


def not_vacant(program, index, variable):
    """Why the variable holds a number at this test, or does not matter; '' when it may be vacant."""
    if variable >= 1000:
        return 'a system variable'
    if variable >= 34:
        return 'a common variable, of which the program does not say that it can be vacant'
    if variable in OTHER_LOCALS or not program.is_macro:
        return 'no argument, so nothing says that it can be vacant'
    if variable not in ARGUMENTS:
        return 'no argument'
    before = program.reach([0], lambda at: at == index or variable in program.blocks[at].stores)
    if index not in before:
        return 'it is set before'
    return ''


def unknown_frame(program, index, numbers):
    """An M98 on the way there of a program that is not there, which may set the caller's locals."""
    for at, block in enumerate(program.blocks):
        called = NUMBER_CALLED.search(block.code)
        missing = block.uses_frame_of_caller and (called is None or int(called.group(1)) not in numbers)
        if missing and at in program.reachable and index in program.reach(program.successors[at]):
            return 'a program that is not there and shares the locals is called before'
    return ''


def tested_elsewhere(program, index, variable):
    """Another block looks whether the variable is vacant, so that this test may be passed at leisure."""
    return any(at != index and tests_vacancy(block, variable) for at, block in enumerate(program.blocks))


def vacancy_tests(program, numbers):
    for index, block in enumerate(program.blocks):
        for test in ANY_TEST.finditer(block.code):
            null, variable = (test.span(1), int(test.group(2))) if test.group(1) else (test.span(4), int(test.group(3)))
            yield 'vacancy-as-zero', put(block, null, '0'), says_not_vacant(program, index, variable)
        test = VACANT.search(block.code)
        if not test:
            continue
        variable = int(test.group(1))
        if test.group(2) == 'EQ' and block.jumps and block.conditional:
            reason = unreached(program, index) or not_vacant(program, index, variable) or unknown_frame(program, index, numbers)
            reason = reason or ('the variable is tested elsewhere, too' if tested_elsewhere(program, index, variable) else '')
            target = program.target_of(index, block.target) if block.target is not None else None
            after = program.reach([index + 1], lambda at: certainly_stores(program.blocks[at], variable)) \
                if index + 1 < len(program.blocks) else set()
            matters = any(uses(program.blocks[at], variable) for at in after)
            yield ('guard-inverted', put(block, test.span(2), 'NE'),
                   reason or ('' if matters and target is not None else 'nothing uses the vacant variable after the test'))
        yield 'vacancy-of-result', put(block, (test.start(1) - 1, test.end(1)), f'[#{variable}*1]'), unreached(program, index)


def says_not_vacant(program, index, variable):
    """Why nothing but this test says that the variable can be vacant; '' for locals, which are vacant until something sets them."""
    others = any(at != index and (tests_vacancy(block, variable) or re.search(rf'#\s*0*{variable}\s*=\s*#\s*0+\s*$', block.code))
                 for at, block in enumerate(program.blocks))
    return '' if variable < 34 or others else 'no local variable, and nothing but this test says that it can be vacant'


def zero_tests(program):
    for index, block in enumerate(program.blocks):
        test = ZERO.search(block.code)
        if not test:
            continue
        variable = int(test.group(1))
        reason = unreached(program, index)
        if not reason and not is_set(program, index, variable):
            reason = 'the variable may be vacant there, so that the test makes sense'
        yield 'zero-as-vacancy', put(block, test.span(3), '#0'), reason


def is_set(program, index, variable):
    """Every path to the block sets the variable to something that is not a plain copy."""
    called = any(block.is_call for block in program.blocks)
    unknown = any(block.uses_frame_of_caller or block.stores_anywhere for block in program.blocks)
    if 0 < variable < (0 if unknown else 34 if called else 1000):
        def sets(at):
            block = program.blocks[at]
            return certainly_stores(block, variable) and not re.search(rf'#\s*0*{variable}\s*=\s*#\s*\d+\s*$', block.code.rstrip())

        return index not in program.reach([0], lambda at: at != index and sets(at)) and \
            not any(variable in b.stores and re.search(rf'#\s*0*{variable}\s*=\s*#\s*(\d+|\[.*\])\s*$', b.code.rstrip())
                    for b in program.blocks)
    return False


def repeated_guards(program):
    """IF[#25EQ#0]GOTO901 after IF[#24EQ#0]GOTO901: the second tests #24, too."""
    for index in range(1, len(program.blocks)):
        first, second = (GUARD.search(program.blocks[at].code) for at in (index - 1, index))
        if not first or not second or program.blocks[index].label is not None:
            continue
        same = re.sub(r'\s', '', first.group(3) + first.group(4)) == re.sub(r'\s', '', second.group(3) + second.group(4))
        variable = int(first.group(2))
        if same and variable != int(second.group(2)) and int(second.group(2)) in variables_in(second.group(1)):
            reason = unreached(program, index) or ('a system variable may change in between' if variable >= 1000 else '')
            yield 'guard-repeated', put(program.blocks[index], second.span(2), first.group(2)), reason


PARTS = re.compile(r'(\[[^\[\]]*\])\s*(?:AND|OR)\s*(\[[^\[\]]*\])')
CASE = re.compile(r'IF\s*\[\s*(#\s*\d+)\s*EQ\s*(\d+\.?\d*)\s*\]\s*THEN\s*#\s*(\d+)\s*=([^=]*)$')


def doubled_parts(program):
    """IF[[#1EQ0]OR[#2EQ0]]: the second part is the first one again."""
    for index, block in enumerate(program.blocks):
        parts = PARTS.search(block.code) if block.conditional or block.loop_condition else None
        if not parts or not COMPARED.search(parts.group(1)) or parts.group(1) == parts.group(2):
            continue
        if variables_in(parts.group(1)) != variables_in(parts.group(2)):  # [[#1LT8]OR[#1GT6]] is always true already
            yield 'part-doubled', put(block, parts.span(2), parts.group(1)), unreached(program, index)


def doubled_cases(program):
    """IF[#1EQ2]THEN#33=5 after IF[#1EQ1]THEN#33=4: the second asks for the case of the first."""
    for index in range(1, len(program.blocks)):
        first, second = (CASE.search(program.blocks[at].code.rstrip()) for at in (index - 1, index))
        if not first or not second or program.blocks[index - 1].skipped or program.blocks[index].skipped:
            continue
        same = [first.group(part) == second.group(part) for part in (1, 2, 3)]
        read = variables_in(first.group(1) + first.group(4) + second.group(4))
        if same == [True, False, True] and int(first.group(3)) not in read:
            yield 'case-doubled', put(program.blocks[index], second.span(2), first.group(2)), unreached(program, index)


def symbols(program):
    for index, block in enumerate(program.blocks):
        word = COMPARED.search(block.code) if block.conditional or block.loop_condition else None
        if word:
            yield 'comparison-symbol', put(block, word.span(), SYMBOLS[word.group()]), unreached(program, index)


def distances(program):
    for index, block in enumerate(program.blocks):
        test = DISTANCE.search(block.code)
        if test:
            relation = 'EQ' if test.group(1) in ('LT', 'LE') else 'NE'
            yield ('distance-equal', put(block, test.span(1), relation) + put(block, test.span(2), '0'),
                   unreached(program, index))
