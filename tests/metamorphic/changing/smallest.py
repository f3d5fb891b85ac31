"""The fewest edits of a change that still make a difference."""
from .compare import Match
from .text import apply
from .verdicts import held

MOST_RUNS = 40


def smallest(maclint, change, difference):
    """Edits of the difference, as few as were found; all of them where it needs the programs beside it."""
    program, runs = difference.program, 0

    def differs(edits):
        nonlocal runs
        runs += 1
        before = maclint.check('smallest/before', {program.path: program.text})
        after = maclint.check('smallest/after', {program.path: apply(program.text, edits)})
        lost, new = held(Match(change, program, edits), before, after)
        return (lost, new) if lost or new else None

    edits, found = difference.edits, differs(difference.edits)
    if not found:
        return difference
    parts = 2
    while len(edits) > 1 and runs < MOST_RUNS:
        size = -(-len(edits) // parts)
        chunks = [edits[at:at + size] for at in range(0, len(edits), size)]
        for candidate in chunks + [[e for e in edits if e not in chunk] for chunk in chunks if len(chunks) > 2]:
            result = differs(candidate) if runs < MOST_RUNS else None
            if result:
                edits, found, parts = candidate, result, 2
                break
        else:
            if size == 1:
                break
            parts = min(parts * 2, len(edits))
    return difference.__class__(difference.change, program, edits, *found)
