"""Jumps of Fanuc programs that lead elsewhere."""
from .edit import put
from .fanuc import GOTO
from .flow import is_trap, unreached


def plants(program):
    yield from wrong_targets(program)
    yield from removed_labels(program)
    yield from doubled_labels(program)
    yield from jumps_into_loops(program)
    yield from endless_jumps(program)
    yield from copied_branches(program)


def literal_jumps(program):
    for index, block in enumerate(program.blocks):
        if block.target is not None and program.target_of(index, block.target) is not None:
            yield index, block


def wrong_targets(program):
    for index, block in literal_jumps(program):
        number = GOTO.search(block.code)
        text = number.group(1)
        swapped = [text[:at] + text[at + 1] + text[at] + text[at + 2:] for at in range(len(text) - 1)]
        typed = [text[:-1] + str((int(text[-1]) + step) % 10) for step in range(1, 10)] + [text + str(more) for more in range(1, 100)]
        wrong = next(new for new in swapped + typed if int(new) and int(new) not in program.labels)
        yield 'goto-nowhere', put(block, number.span(1), wrong), unreached(program, index)


def removed_labels(program):
    wanted = {block.target: index for index, block in literal_jumps(program) if index in program.reachable}
    for label in sorted(wanted):
        if len(program.labels[label]) == 1:
            block = program.blocks[program.labels[label][0]]
            at = block.code.index('N')
            digits = block.code.index(str(label), at) + len(str(label))
            yield 'label-removed', put(block, (at, digits), ''), ''


def doubled_labels(program):
    """Only where some jump now takes the new block, and that block is not what the old one is."""
    targets = sorted({block.target for _, block in literal_jumps(program)})
    for label, places in sorted(program.labels.items()):
        if label in targets or len(places) > 1:
            continue
        near = min(targets, key=lambda target: (abs(target - label), target), default=None)
        if near is None or len(program.labels[near]) > 1:
            continue
        block, place, old = program.blocks[places[0]], places[0], program.labels[near][0]
        at = block.code.index('N')
        end = block.code.index(str(label), at) + len(str(label))
        yield 'label-doubled', put(block, (at, end), f'N{near}'), no_jump_is_misled(program, near, place, old)


def no_jump_is_misled(program, label, new, old):
    for index, block in literal_jumps(program):
        if block.target == label and index in program.reachable:
            after = [place for place in sorted((new, old)) if place > index]
            if (after[0] if after else min(new, old)) == new:
                return ''
    return 'every jump takes the block that was meant'


def jumps_into_loops(program):
    inside = [(start, index) for start, end in program.loops() for index in range(start + 1, end)
              if program.blocks[index].label is not None and len(program.labels[program.blocks[index].label]) == 1]
    for index, block in literal_jumps(program):
        for start, place in inside:
            if not start < index < program.end_of[start]:
                number = GOTO.search(block.code)
                yield ('jump-into-loop', put(block, number.span(1), str(program.blocks[place].label)),
                       unreached(program, index))
                break


def endless_jumps(program):
    """IF [...] GOTO 10 that leads back becomes GOTO 10."""
    for index, block in literal_jumps(program):
        place = program.target_of(index, block.target)
        if not block.conditional or place > index or index not in program.reachable:
            continue

        def successors(at, jump=index, to=place):
            return [to] if at == jump else program.successors[at]

        at = block.code.index('IF')
        harmless = '' if is_trap(program, successors, place) else 'another block of the cycle leads out of it, or stops'
        yield 'endless-jump', put(block, (at, GOTO.search(block.code).start()), ''), harmless


def copied_branches(program):
    """IF..GOTO4 / a / GOTO5 / N4 b / N5: a is b, too."""
    for index, block in enumerate(program.blocks[:-4]):
        one, leave, other, after = program.blocks[index + 1:index + 5]
        plain = all(part.code.strip() and not (part.jumps or part.conditional or part.loop or part.end or part.leaves or part.skipped)
                    for part in (one, other))
        if not block.conditional or block.target is None or not plain or one.label is not None or leave.conditional:
            continue
        if program.target_of(index, block.target) != index + 3 or leave.target is None or \
                program.target_of(index + 2, leave.target) != index + 4 or leave.label is not None:
            continue
        body = other.code.rstrip()
        body = body[body.index(str(other.label), body.index('N')) + len(str(other.label)):]
        entered = sum(index + 3 in following for following in program.successors) > 1
        reason = 'another jump leads into one of the branches' if entered else unreached(program, index)
        if body.strip() and body.strip() != one.code.strip():
            yield 'branch-copied', put(one, (0, len(one.code.rstrip())), body), reason
