"""Loops of Fanuc programs that do not pair, or do not end."""
import re

from .edit import drop, put
from .fanuc import ALARM, DO, END, NUMBER_CALLED, OTHER_LOCALS, PROGRAM_END, STOP, WHILE
from .flow import SHARED, may_share_locals, variables_in

STEP = re.compile(r'#\s*(\d+)\s*=\s*(?:#\s*\1\s*(?P<sign>[+-])\s*(?P<by>#\s*\d+|\d+\.?\d*|\.\d+)|'
                  r'(?P<front>#\s*\d+|\d+\.?\d*)\s*\+\s*#\s*\1)\s*$')
RELATION = re.compile(r'^\[\s*#\s*(\d+)\s*(LT|LE|GT|GE|NE)\s*(.*)\]$')
UNREADABLE = re.compile(r'(?:ABS|SIN|COS|TAN|SQRT|FIX|FUP|ROUND)(?!\s*\[)')  # what a ( follows is blank here
LEVELS = {1, 2, 3}
UP, DOWN = {'LT', 'LE'}, {'GT', 'GE'}
FRACTIONS = ('0.1', '0.2', '.05')


def plants(program, numbers, callees=None):
    """`numbers`: programs that are there; `callees`: those that can be read, by number."""
    for start, end in program.loops():
        yield from unpaired(program, start, end)
        if program.blocks[start].loop_condition:
            yield from endless(program, start, numbers, callees or {})
            yield from first_values(program, start)
    yield from fractions(program)


def fractions(program):
    """Steps by a number of what a loop compares with LT, LE, GT or GE; it may go round by IF and GOTO."""
    for index, block in enumerate(program.blocks):
        step = STEP.search(block.code)
        by = step and (step['by'] or step['front'])
        if not step or by.startswith('#') or block.conditional or block.skipped or block.stores != [int(step.group(1))]:
            continue
        compares = re.compile(rf'#\s*0*{step.group(1)}\s*(?:LT|LE|GT|GE)(?![A-Z])|(?:LT|LE|GT|GE)\s*#\s*0*{step.group(1)}(?![\d.])')
        if any(compares.search(condition) for condition in conditions_around(program, index)):
            group = 'by' if step['by'] else 'front'
            yield 'step-fraction', put(block, step.span(group), FRACTIONS[block.line % len(FRACTIONS)]), ''


def conditions_around(program, index):
    """The conditions by which the loops around a block go round."""
    for start, end in program.loops():
        if start < index < end:
            yield program.blocks[start].loop_condition
    for at in range(index, len(program.blocks)):
        block = program.blocks[at]
        target = program.target_of(at, block.target) if block.conditional and block.target is not None else None
        if target is not None and target <= index:
            yield block.code


def first_values(program, start):
    """The last assignment before the loop of what its condition compares, where nothing else has set that."""
    relation = RELATION.match(program.blocks[start].loop_condition.strip())
    if not relation:
        return
    counter = int(relation.group(1))
    if counter not in (OTHER_LOCALS if program.returns else range(1, 34)) or \
            not any(counter in program.blocks[index].stores for index in program.body(start)):
        return
    for index in range(start - 1, -1, -1):
        block = program.blocks[index]
        if block.jumps or block.loop is not None or block.end is not None or block.is_call:
            return
        if counter in block.stores:
            if len(block.stores) == 1 and not block.conditional and not block.skipped:
                yield 'first-value-removed', drop(block), SHARED if may_share_locals(program) else ''
            return


def unpaired(program, start, end):
    first, last = program.blocks[start], program.blocks[end]
    number, do = END.search(last.code), DO.search(first.code)
    other = str(first.loop % 3 + 1)
    refused = '' if first.loop in LEVELS else 'the control stops at the DO before it'
    yield 'end-wrong', put(last, number.span(1), other), refused
    yield 'end-removed', put(last, number.span(), ''), refused
    yield 'loop-number', put(first, do.span(1), '4') + put(last, number.span(1), '4'), refused
    if first.loop_condition:
        yield 'do-removed', put(first, do.span(), ''), refused
        yield 'while-removed', drop(first), refused


def step_of(program, start):
    """The only block of the loop that changes what its condition compares, with the match of STEP; else None."""
    relation = RELATION.match(program.blocks[start].loop_condition.strip())
    if not relation:
        return None
    counter = int(relation.group(1))
    found = [program.blocks[index] for index in program.body(start) if counter in program.blocks[index].stores]
    if len(found) != 1 or found[0].conditional or found[0].skipped:
        return None
    step = STEP.search(found[0].code)
    return (found[0], step, relation) if step and int(step.group(1)) == counter else None


def why_it_still_ends(program, start, counter, numbers, callees):
    """Something else than the step may end the loop; '' when nothing does."""
    condition = program.blocks[start].loop_condition
    watched = variables_in(condition)
    if start not in program.reachable:
        return 'no path leads to the loop'
    if '#[' in condition.replace(' ', '') or any(1000 <= variable for variable in watched):
        return 'the machine changes what the condition reads'
    if all(v >= 100 for v in watched) and sum(bool(program.blocks[index].code.strip()) for index in program.body(start)) < 2:
        return 'without its step the loop only waits for a common variable'
    for index in program.body(start):
        block = program.blocks[index]
        if program.has_exit(index) and not block.is_call:
            return 'the loop stops or leaves by another block'
        if any(not start < after <= program.end_of[start] and after != start for after in program.successors[index]) \
                and index not in program.end_of:
            return 'the loop leaves by another jump'
        if block.stores_anywhere:
            return 'a store through a variable may reach the counter'
        called = NUMBER_CALLED.search(block.code)
        if block.may_call and (called is None or int(called.group(1)) not in numbers):
            return 'a called program that is not there may stop'
        if block.is_call and may_stop_by_the_machine(callees.get(int(called.group(1)))):
            return 'a called program may stop, and reads the machine or waits'
        if UNREADABLE.search(block.code):
            return 'a block of the loop cannot be read'
        if block.is_call and (block.uses_frame_of_caller or any(33 < variable < 1000 for variable in watched)):
            return 'a called program may change what the condition reads'
        if any(variable in block.stores for variable in watched - {counter}):
            return 'the loop changes the limit, too'
    return ''


def may_stop_by_the_machine(program):
    """Whether a called program stops for the operator, calls others, or raises an alarm and reads what may change without
    its caller: a position, an offset, an input."""
    if program is None:
        return False
    if any(STOP.search(block.code) or PROGRAM_END.search(block.code) or block.is_call for block in program.blocks):
        return True
    reads_machine = any(variable >= 1000 and not 4001 <= variable <= 4130 for block in program.blocks for variable, _ in block.reads) or \
        any(re.search(r'#\s*\[', block.code) for block in program.blocks)
    return reads_machine and any(ALARM.search(block.code) for block in program.blocks)


def ends_by_alarm(program, start, callees):
    """Why a loop ends whose counter runs away: what it passes to a called program does, too, and that raises an alarm."""
    for index in program.body(start):
        block = program.blocks[index]
        called = NUMBER_CALLED.search(block.code) if block.is_call else None
        callee = callees.get(int(called.group(1))) if called else None
        if callee and any(ALARM.search(other.code) for other in callee.blocks):
            return 'a called program raises an alarm for some numbers'
    return ''


def endless(program, start, numbers, callees):
    found = step_of(program, start)
    if not found:
        return
    block, step, relation = found
    counter = int(relation.group(1))
    reason = why_it_still_ends(program, start, counter, numbers, callees)
    yield 'step-removed', put(block, step.span(), ''), reason
    unused = unused_local(program)
    if unused:
        name = step.group(0).index(step.group(1))
        span = (step.start() + name, step.start() + name + len(step.group(1)))
        yield 'step-elsewhere', put(block, span, str(unused)), reason
        yield from other_condition(program, start, counter, unused, reason or ends_by_alarm(program, start, callees))
    by = step['by'] or step['front']
    if not by.startswith('#'):
        yield from literal_steps(block, step, relation, float(by), reason, ends_by_alarm(program, start, callees))
    else:
        yield from unguarded_step(program, int(by.strip('# ')), start, reason)


def unused_local(program):
    taken = {variable for block in program.blocks for variable in variables_in(block.code)}
    return max(OTHER_LOCALS - taken, default=None)


def other_condition(program, start, counter, unused, reason):
    block = program.blocks[start]
    at = WHILE.search(block.code).end() - 1
    name = re.compile(rf'#\s*0*({counter})(?!\d)').search(block.code, at)
    others = [v for b in program.blocks[:start] for v in b.stores if v != counter and 0 < v < 34]
    inside = {v for index in program.body(start) for v in program.blocks[index].stores}
    literal = {v for b in program.blocks for v in b.stores if re.search(r'=\s*-?[\d.]+\s*$', b.code.rstrip())}
    free = [v for v in others if v not in inside | variables_in(block.loop_condition) | literal]  # a setting may say anything
    yield 'condition-elsewhere', put(block, name.span(1), str(free[-1] if free else unused)), reason


def literal_steps(block, step, relation, by, reason, alarm):
    kind, limit = relation.group(2), relation.group(3).strip()
    sign = step['sign'] or '+'
    right = {'+': UP, '-': DOWN}[sign]
    if step['sign']:
        turned = '-' if sign == '+' else '+'
        doubt = reason or alarm or ('' if kind in right else 'the sign was not that of the relation')
        yield 'step-sign', put(block, step.span('sign'), turned), doubt
    digits = step.span('by') if step['by'] else step.span('front')
    yield 'step-zero', put(block, digits, '0'), reason


def unguarded_step(program, variable, start, reason):
    """The block IF[#17LE0]GOTO91 or IF[#17EQ#0]GOTO91 before the loop is gone, and no other tests the step."""
    guard = re.compile(rf'IF\s*\[\s*#\s*0*{variable}\s*(LE|LT|EQ)\s*(#\s*0|\d+\.?\d*|\.\d+)\s*\]')
    tests = [b for b in program.blocks if 'IF' in b.code and re.search(rf'#\s*0*{variable}(?!\d)', b.code)]
    stores = [b for b in program.blocks if variable in b.stores]
    if len(tests) != 1 or stores or not guard.search(tests[0].code) or program.blocks.index(tests[0]) > start:
        return
    if variable < 34:
        yield 'step-guard-removed', drop(tests[0]), reason
