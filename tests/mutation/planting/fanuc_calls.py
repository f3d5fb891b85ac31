"""Calls and returns of Fanuc programs."""
import re

from .edit import drop, put
from .fanuc import ALARM, CALL, NUMBER_CALLED, PROGRAM_END, RETURN, closing
from .flow import reads_arguments, unreached, variables_in

WITHIN = re.compile(r'M\s*0*97')  # P is a block of the program itself
MODAL = re.compile(r'G\s*66(?:\.1)?(?![\d.])')
CANCEL = re.compile(r'G\s*67(?![\d.])')


LETTERS = {'A': 1, 'B': 2, 'C': 3, 'D': 7, 'E': 8, 'F': 9, 'H': 11, 'M': 13, 'Q': 17, 'R': 18, 'S': 19, 'T': 20,
           'U': 21, 'V': 22, 'W': 23, 'X': 24, 'Y': 25, 'Z': 26}
ARGUMENT = re.compile(r'(?<![A-Z])([A-FHMQ-Z])\s*-?\s*(?:[\d.]+|#\s*\d+|(?=\[))')


def plants(program, numbers, callers):
    """`numbers`: programs that are there, of all files that are read together."""
    yield from left_out_letters(program, callers)
    yield from alarms_removed(program)
    yield from returns_that_end(program, callers)
    for index, block in enumerate(program.blocks):
        reason = unreached(program, index)
        call, number = CALL.search(block.code), NUMBER_CALLED.search(block.code)
        if call and number and not WITHIN.match(call.group()):
            called = int(number.group(1))
            if called in numbers:
                yield 'program-missing', put(block, number.span(1), str(missing(called, numbers))), reason
            if program.number:
                yield 'recursion', put(block, number.span(1), str(program.number)), reason
            yield 'call-without-number', put(block, number.span(), ''), reason
        cancel = CANCEL.search(block.code)
        if cancel and any(MODAL.search(other.code) for other in program.blocks[:index]):
            later = any(CANCEL.search(other.code) for other in program.blocks[index + 1:])
            yield 'modal-call-left', put(block, cancel.span(), ''), reason or ('a later block has G67' if later else '')
    yield from returns_removed(program, callers)


MOVE = re.compile(r'(?<![A-Z])[XYZ]\s*-?\s*[#\[\d.]')


def chains(program, numbers):
    """A call in front of a move, the first one of the program, of programs that call one another."""
    for index, block in enumerate(program.blocks):
        if index in program.reachable and MOVE.search(block.code) and not (block.conditional or block.is_call or block.skipped):
            head = re.match(r'\s*(?:N\s*\d+)?', block.code)
            for kind, call, levels in (('too-deep-macros', 'G65P', 5), ('too-deep-subprograms', 'M98P', 11)):
                first = next(number for number in range(8801, 9999) if not numbers & set(range(number, number + levels)))
                texts = [f'O{at}\nG4X.1\n{call}{at + 1}\nM99\n' for at in range(first, first + levels - 1)]
                texts.append(f'O{first + levels - 1}\nG4X.1\nM99\n')
                call = put(block, head.span(), f'{head.group().strip()}{call}{first}\n')
                last = program.blocks[-1]
                if block.line % 3 == 0 and last is not block:  # in the program's own file, after it
                    yield kind, call + put(last, (len(last.code), len(last.code)), '\n' + ''.join(texts).rstrip()), ''
                elif block.line % 3 == 1:
                    yield kind, call, '', {f'O{first}.nc': '%\n' + ''.join(texts) + '%\n'}
                else:
                    yield kind, call, '', {f'O{first + at}.nc': f'%\n{text}%\n' for at, text in enumerate(texts)}
            return


def missing(number, numbers):
    text = str(number)
    swapped = [text[:at] + text[at + 1] + text[at] + text[at + 2:] for at in range(len(text) - 1)]
    typed = [text[:-1] + digit for digit in '9876543210'] + [str(other) for other in range(9999, 7000, -1)]
    return next(int(new) for new in swapped + typed if new and new[0] != '0' and int(new) not in numbers)


def returns_removed(program, callers):
    """The M99 after which nothing comes that the control would run on into."""
    for index, block in enumerate(program.blocks):
        back = RETURN.search(block.code)
        if not back or block.conditional or block.skipped:
            continue
        reason = unreached(program, index)
        follows = program.reach([index + 1]) if index + 1 < len(program.blocks) else set()
        ends = [at for at in follows if not program.successors[at]]
        if follows and all(RETURN.search(program.blocks[at].code) for at in ends):
            reason = reason or 'the control runs on into another M99'
        elif follows and any(ALARM.search(program.blocks[at].code) for at in ends):
            reason = reason or 'the control runs on into an alarm'
        elif follows and all(RETURN.search(program.blocks[at].code) or PROGRAM_END.search(program.blocks[at].code) for at in ends):
            reason = reason or 'the control runs on into the end of the part'
        elif not is_meant_to_return(program, index, callers):
            reason = reason or 'nothing else says that the program is called: it has no caller of its control, no argument, no other end'
        yield 'return-removed', put(block, back.span(), '') if block.code.strip() != back.group() else drop(block), reason


def is_meant_to_return(program, index, callers):
    """Whether a reader sees without the M99 at the index that the program must not run over its end."""
    ends = any(at != index and at in program.reachable and (RETURN.search(block.code) or PROGRAM_END.search(block.code))
               for at, block in enumerate(program.blocks))
    return ends or any(True for _ in callers.of_one_control(program)) or reads_arguments(program)


def returns_that_end(program, callers):
    """M30 for the only M99 of a program that others call."""
    known = list(callers.of(program.number)) if program.number else []
    returns = [block for block in program.blocks if RETURN.search(block.code)]
    if not known or len(returns) != 1 or re.search(r'M\s*0*99\s*P', returns[0].code):
        return
    ends = re.compile(RETURN.pattern + '|' + PROGRAM_END.pattern)
    goes_on = any(not ends.search(caller.blocks[after].code) for caller, at in known for after in caller.successors[at])
    reason = '' if goes_on else 'nothing follows the call'
    if program.blocks[-1] is not returns[0]:
        reason = reason or 'blocks after it may return, too'
    if not any(True for _ in callers.of_one_control(program)):
        reason = reason or 'another program has its number, or its callers stand in a folder beside it: nobody can tell'
    yield 'return-ends', put(returns[0], RETURN.search(returns[0].code).span(), 'M30'), reason


def alarms_removed(program):
    """The alarm in the last block: the control runs on over the end of the program."""
    last = program.blocks[-1]
    alarm = ALARM.search(last.code)
    if alarm and not last.conditional and not last.skipped:
        reason = '' if len(program.blocks) - 1 in program.reachable else 'no path leads to this block'
        yield 'alarm-removed', put(last, (alarm.start(), len(last.code.rstrip())), ''), reason


def left_out_letters(program, callers):
    """The only call of a program leaves out a letter that it reckons with and never tests."""
    for index, block in enumerate(program.blocks):
        call, number = re.search(r'G\s*65(?!\d)', block.code), NUMBER_CALLED.search(block.code)
        callee = callers.by_number.get(int(number.group(1))) if call and number else None
        if callee is None or len(list(callers.of(callee.number))) != 1 or index not in program.reachable:
            continue
        for letter in ARGUMENT.finditer(block.code, call.end()):
            end = letter.end()
            if block.code[end:end + 1] == '[':
                end = closing(block.code, end) + 1
            if reckons_with(callee, LETTERS[letter.group(1)]):
                yield 'letter-left-out', put(block, (letter.start(), end), ''), ''
                break


def reckons_with(program, variable):
    """Whether it adds or multiplies what it neither tests nor sets."""
    named = [block for block in program.blocks if variable in variables_in(block.code)]
    if any('IF' in block.code or 'WHILE' in block.code or variable in block.stores or block.is_call for block in named):
        return False
    sums = re.compile(rf'[-+*/]\s*#\s*0*{variable}(?!\d)|#\s*0*{variable}\s*[-+*/]')
    return any(sums.search(block.code) and program.blocks.index(block) in program.reachable for block in named)
