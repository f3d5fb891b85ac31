"""What must be the same, held against two reports."""
import random
from collections import defaultdict
from dataclasses import dataclass

from .changes import CHANGES, LANGUAGES, blocks, code_end, pieces, takes_comment
from .compare import Match
from .exempt import is_exempt
from .text import apply, insert


@dataclass
class Difference:
    """A program of which something else is said after a change."""
    change: str
    program: object
    edits: list
    lost: list
    new: list


def edits_of(change, program, seed):
    edits = change.edits(program, random.Random(f'{seed} {change.name} {program.path}'))
    return edits if edits and apply(program.text, edits) != program.text else None


def held(match, before, after):
    """The findings that are lost and new, those of exempt rules left out."""
    change, path = match.change, str(match.program.path)
    lost, new = match.compare(before.findings[path], after.findings[path])
    lost, new = ([finding for finding in found if not is_exempt(change.name, finding['code'])] for found in (lost, new))
    if not lost and not new and [n['code'] for n in before.notices[path]] != [n['code'] for n in after.notices[path]]:
        return before.notices[path], after.notices[path]
    return lost, new


def try_change(maclint, change, programs, seed):
    """The differences, and of how many programs."""
    changed = {program.path: (program, edits) for program in programs if program.language in change.languages
               for edits in [edits_of(change, program, seed)] if edits}
    if not changed:
        return [], 0
    # The same programs on both sides: one that could not be changed must not answer for those that call it.
    before = maclint.check(f'{change.name}/before', {path: program.text for path, (program, _) in changed.items()})
    after = maclint.check(f'{change.name}/after', {path: apply(program.text, edits) for path, (program, edits) in changed.items()})
    matches = [Match(change, program, edits) for program, edits in changed.values()]
    lines = defaultdict(set)
    for match in matches:
        lines[match.program.path.parts[0]] |= match.lines
    found = []
    for match in matches:
        match.other_lines = lines[match.program.path.parts[0]]
        lost, new = held(match, before, after)
        if lost or new:
            found.append(Difference(change.name, match.program, match.edits, lost, new))
    return found, len(changed)


# A comment that allows a finding

NOT_ALLOWED = {
    'MAC001': 'speaks of such comments', 'MAC002': 'speaks of such comments',
    'MAC003': 'speaks of a file that is no program', 'MAC004': 'speaks of a file', 'MAC005': 'takes the place of all other findings',
    'MAC102': 'the comment that allows it would be in the open one'}


def allow(program, findings, rng):
    """(a finding, the edit that allows it), or None."""
    candidates = [finding for finding in findings if finding['code'] not in NOT_ALLOWED and ' more place' not in finding['message']]
    rng.shuffle(candidates)
    opening, closing = LANGUAGES[program.language].COMMENT.split('K')
    for finding in candidates:
        at = finding['range']['bytes'][0]
        for block in blocks(pieces(program)):
            if block[0].begin <= at < block[-1].end or at == block[-1].end == len(program.text):
                if block[-1].kind != 'end' or not takes_comment(block) or any(piece.kind == 'fixed' and '"' not in piece.text[:1] for piece in block):
                    break
                return finding, insert(code_end(block), f" {opening}MACLINT ALLOW {finding['code']} - K{closing}")
    return None


def try_allow(maclint, programs, seed):
    base = maclint.check('allow/before', {program.path: program.text for program in programs})
    chosen = {}
    for program in programs:
        found = allow(program, base.findings[str(program.path)], random.Random(f'{seed} allow {program.path}'))
        if found:
            chosen[program.path] = (program, *found)
    if not chosen:
        return [], 0
    after = maclint.check('allow/after', {program.path: apply(program.text, [chosen[program.path][2]]) if program.path in chosen else
                                          program.text for program in programs})
    found = []
    for path, (program, allowed, edit) in chosen.items():
        lost, new = Match(CHANGES['comment-at-end'], program, [edit]).compare(base.findings[str(path)], after.findings[str(path)])
        known = [finding['range']['bytes'] for finding in base.suppressed[str(path)]]
        gone = [finding for finding in lost if finding['code'] == allowed['code'] and same_block(program, finding, allowed)]
        others = [finding for finding in lost if finding not in gone]
        if not gone:
            new = new + [dict(allowed, message=f"is not allowed by its comment: {allowed['message']}")]
        if len(after.suppressed[str(path)]) != len(known) + len(gone):
            new = new + [dict(allowed, message='the report counts other findings as allowed')]
        if others or new:
            found.append(Difference('allow', program, [edit], others, new))
    return found, len(chosen)


def same_block(program, one, other):
    for block in blocks(pieces(program)):
        if all(block[0].begin <= finding['range']['bytes'][0] <= block[-1].end for finding in (one, other)):
            return True
    return False


# The command line

def try_order(maclint, programs, seed):
    """Another order of the files, and other threads: the same bytes."""
    texts = {program.path: program.text for program in programs}
    home = maclint.lay_out('order', texts)
    paths = [str(path) for path in texts]
    expected = maclint.run(home, ['--jobs', '1', '--', *paths])
    random.Random(f'{seed} order').shuffle(paths)
    found = []
    for options in (['--jobs', '1'], ['--jobs', '2'], ['--jobs', '8']):
        if maclint.run(home, [*options, '--', *paths]) != expected:
            found.append(f"files in another order with {' '.join(options)}: another report; {home}")
    return found, len(programs)


def try_stdin(maclint, programs, seed):
    """A file by its path, and the same bytes on standard input: the same bytes."""
    found = []
    for program in programs:
        home = maclint.lay_out('stdin', {program.path: program.text})
        path, text = str(program.path), program.text.encode('latin-1')
        if maclint.run(home, ['--', path]) != maclint.run(home, ['--stdin-filename', path, '-'], text):
            found.append(f'{path}: another report of the same bytes on standard input')
    return found, len(programs)
