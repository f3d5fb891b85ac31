#!/usr/bin/env python3
"""Changes programs in ways that must not matter, and demands the same findings: ./dev metamorphic.

README.md beside this file says how.
"""
import argparse
import os
import sys
import time
from pathlib import Path

from changing import corpus, verdicts
from changing.changes import CHANGES
from changing.runs import Failed, Maclint
from changing.smallest import smallest
from changing.text import apply

ROOT = Path(__file__).resolve().parents[2]
OTHERS = {'allow': verdicts.try_allow, 'order': verdicts.try_order, 'standard-input': verdicts.try_stdin}
MOST_SHOWN, MOST_LINES = 3, 4


def shown_place(text, finding):
    at = finding.get('range', {}).get('bytes', [0])[0]
    line = text.count('\n', 0, at) + 1 if '\n' in text else text.count('\r', 0, at) + 1
    return f"line {line} {finding['code']} {finding.get('severity', '')} {finding['message']}"


def shown(difference, seed):
    """A few lines: what is said before and after, the places that were changed, how to see it again."""
    program = difference.program
    changed = apply(program.text, difference.edits)
    lines = [f'{program.path}: {difference.change}']
    lines += [f'  - {shown_place(program.text, finding)}' for finding in difference.lost[:MOST_LINES]]
    lines += [f'  + {shown_place(changed, finding)}' for finding in difference.new[:MOST_LINES]]
    for edit in difference.edits[:2]:
        begin = max(program.text.rfind('\n', 0, edit.begin), program.text.rfind('\r', 0, edit.begin)) + 1
        end = min((at for at in (program.text.find(c, edit.end) for c in '\r\n') if at >= 0), default=len(program.text))
        line = program.text[begin:end][:80]
        new = (program.text[begin:edit.begin] + edit.text + program.text[edit.end:end])[:80]
        lines.append(f'    {line!r} -> {new!r}')
    if len(difference.edits) > 2:
        lines.append(f'    and {len(difference.edits) - 2} more places')
    lines.append(f'  again: ./dev metamorphic 0 {seed} --change {difference.change} --program {program.path}')
    return '\n'.join(lines)


def main():
    parser = argparse.ArgumentParser(prog='./dev metamorphic', description=__doc__.splitlines()[0])
    parser.add_argument('programs', nargs='?', type=int, default=200, help='how many are drawn, half of each language (default: 200); 0: all')
    parser.add_argument('seed', nargs='?', type=int, default=1, help='of the draw and of the changes (default: 1)')
    parser.add_argument('--change', action='append', choices=[*CHANGES, *OTHERS], metavar='CHANGE', help='only this one; may stand more than once')
    parser.add_argument('--program', action='append', metavar='PATH', help='only programs with this in their path')
    parser.add_argument('--all-shown', action='store_true', help=f'show all differences of a change, not the first {MOST_SHOWN}')
    parser.add_argument('--maclint', type=Path, default=ROOT / 'build' / 'maclint', help='the executable (default: build/maclint)')
    parser.add_argument('--shared', type=Path, default=Path(os.environ.get('MACLINT_SHARED', ROOT.parent / 'shared')),
                        help='the folder with programs of others')
    parser.add_argument('--folder', type=Path, default=ROOT / 'build' / 'metamorphic', help='where programs are laid out')
    options = parser.parse_args()

    maclint = Maclint(options.maclint.resolve(), options.folder.resolve())
    programs = corpus.programs_of(ROOT, options.shared, maclint.languages)
    if options.program:
        programs = [program for program in programs if any(part in str(program.path) for part in options.program)]
    if options.programs:
        programs = corpus.drawn(programs, options.programs, options.seed)
    languages = [sum(program.language == language for program in programs) for language in ('fanuc', 'dinplus')]
    print(f'{languages[0]} Fanuc programs, {languages[1]} in DIN PLUS, seed {options.seed}', flush=True)
    failed = 0
    for name in options.change or [*CHANGES, *OTHERS]:
        began = time.monotonic()
        try:
            if name in CHANGES:
                found, count = verdicts.try_change(maclint, CHANGES[name], programs, options.seed)
            else:
                found, count = OTHERS[name](maclint, programs, options.seed)
        except Failed as failure:
            found, count = [str(failure)], len(programs)
        failed += len(found)
        print(f'{name}: {len(found)} of {count} programs differ, {time.monotonic() - began:.1f} s', flush=True)
        for difference in found if options.all_shown else found[:MOST_SHOWN]:
            if isinstance(difference, str):
                print(difference)
                continue
            if name in CHANGES and not CHANGES[name].whole:
                difference = smallest(maclint, CHANGES[name], difference)
            print(shown(difference, options.seed), flush=True)
    print(f'{failed} differences' if failed else 'the same findings throughout')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
