"""Calls and returns of Fanuc programs."""
import re

from .edit import drop, put
from .fanuc import ALARM, CALL, NUMBER_CALLED, RETURN

MODAL = re.compile(r'G\s*66(?:\.1)?(?![\d.])')
CANCEL = re.compile(r'G\s*67(?![\d.])')


def plants(program, numbers):
    """`numbers`: programs that are there, of all files that are read together."""
    for index, block in enumerate(program.blocks):
        reason = '' if index in program.reachable else 'no path leads to this block'
        call, number = CALL.search(block.code), NUMBER_CALLED.search(block.code)
        if call and number:
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
    yield from returns_removed(program)


def missing(number, numbers):
    text = str(number)
    swapped = [text[:at] + text[at + 1] + text[at] + text[at + 2:] for at in range(len(text) - 1)]
    typed = [text[:-1] + digit for digit in '9876543210'] + [text[:-2] + str(n) for n in range(10, 100)] + [f'{n}' for n in range(9999, 7000, -1)]
    return next(int(new) for new in swapped + typed if new and new[0] != '0' and int(new) not in numbers)


def returns_removed(program):
    """The M99 after which nothing comes that the control would run on into."""
    for index, block in enumerate(program.blocks):
        back = RETURN.search(block.code)
        if not back or block.conditional or block.skipped:
            continue
        reason = '' if index in program.reachable else 'no path leads to this block'
        follows = program.reach([index + 1]) if index + 1 < len(program.blocks) else set()
        ends = [at for at in follows if not program.successors[at]]
        if follows and all(RETURN.search(program.blocks[at].code) for at in ends):
            reason = reason or 'the control runs on into another M99'
        elif follows and any(ALARM.search(program.blocks[at].code) for at in ends):
            reason = reason or 'the control runs on into an alarm'
        yield 'return-removed', put(block, back.span(), '') if block.code.strip() != back.group() else drop(block), reason
