"""Conditions of Fanuc programs that ask something else than was meant."""
import re

from .edit import put
from .fanuc import ALARM, ARGUMENTS, NUMBER_CALLED, OTHER_LOCALS
from .flow import certainly_stores, live_uses, tests_vacancy, unreached, uses, variables_in

VACANT = re.compile(r'\[\s*#\s*(\d+)\s*(EQ|NE)\s*(#\s*0)\s*\]')
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
        test = VACANT.search(block.code)
        if not test:
            continue
        variable = int(test.group(1))
        reason = unreached(program, index) or not_vacant(program, index, variable) or unknown_frame(program, index, numbers)
        reason = reason or ('the variable is tested elsewhere, too' if tested_elsewhere(program, index, variable) else '')
        used = [at for at in live_uses(program, index, variable) if calculates_with(program.blocks[at], variable)]
        useless = '' if used else 'nothing calculates with the variable after the test'
        useless = useless or ('another test sends what is vacant out of the program' if zero_is_refused(program, index, variable) else '')
        yield 'vacancy-as-zero', put(block, test.span(3), '0'), reason or useless
        if test.group(2) == 'EQ' and block.jumps and block.conditional:
            target = program.target_of(index, block.target) if block.target is not None else None
            after = program.reach([index + 1], lambda at: certainly_stores(program.blocks[at], variable)) \
                if index + 1 < len(program.blocks) else set()
            matters = any(uses(program.blocks[at], variable) for at in after)
            yield ('guard-inverted', put(block, test.span(2), 'NE'),
                   reason or ('' if matters and target is not None else 'nothing uses the vacant variable after the test'))
        yield 'vacancy-of-result', put(block, (test.start(1) - 1, test.end(1)), f'[#{variable}*1]'), unreached(program, index)


def zero_is_refused(program, index, variable):
    """Whether what is vacant, which now passes the test or jumps by it, leaves by a test after it, IF[#24LT10]GOTO8, before
    anything calculates with it: it counts as 0 there. A jump to an alarm refuses it, too."""
    block = program.blocks[index]
    jumps = bool(block.jumps and VACANT.search(block.code).group(2) == 'NE')
    if jumps and leads_to_alarm(program, index):
        return True
    at = program.target_of(index, block.target) if jumps and block.target is not None else index + 1
    seen = {index}
    while at is not None and at < len(program.blocks) and at not in seen:
        seen.add(at)
        block = program.blocks[at]
        test = GUARD.search(block.code)
        if test and int(test.group(2)) == variable and refuses_zero(test) and \
                (leads_to_alarm(program, at) or block.target == program.blocks[index].target):
            return True
        if block.loop is not None or variable in block.stores or calculates_with(block, variable) or \
                (not block.conditional and len(program.successors[at]) != 1):
            return False
        at = program.successors[at][0] if not block.conditional else at + 1
    return False


def calculates_with(block, variable):
    """Not in a comparison, where vacant is as good as 0 or told from it, nor in a line that is printed."""
    if not uses(block, variable) or 'DPRNT' in block.code:
        return False
    compared = re.compile(rf'\[\s*#\s*0*{variable}\s*(?:EQ|NE|GT|LT|GE|LE)[^\[\]]*\]|(?:EQ|NE|GT|LT|GE|LE)\s*#\s*0*{variable}\s*\]')
    return variable in variables_in(compared.sub('', block.code))


def refuses_zero(test):
    """0 is on the side that leaves; EQ and NE tell vacant from 0."""
    limit = 0.0 if '#' in test.group(4) else float(test.group(4))
    return {'LT': 0 < limit, 'LE': 0 <= limit, 'GT': 0 > limit, 'GE': 0 >= limit}.get(test.group(3), False)


def same_way_out(program, first, second):
    """Both jump to one block, or both lead to an alarm."""
    targets = [program.blocks[at].target for at in (first, second)]
    return (targets[0] is not None and targets[0] == targets[1]) or all(leads_to_alarm(program, at) for at in (first, second))


def leads_to_alarm(program, index):
    """Whether the test at the index leaves by an alarm, without another decision on the way there."""
    if ALARM.search(program.blocks[index].code):
        return True
    if program.blocks[index].target is None:
        return False
    at = program.target_of(index, program.blocks[index].target)
    while at is not None and not ALARM.search(program.blocks[at].code):
        following = program.successors[at]
        at = following[0] if len(following) == 1 and following[0] > at else None
    return at is not None


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
