"""Whether two reports say the same of a program, before and after a change."""
import bisect
import re
from collections import defaultdict

from . import dinplus, fanuc
from .exempt import TELLS_A_PIECE
from .text import Places, apply

MARKS = re.compile(rf'{re.escape(fanuc.COMMENT)}|{re.escape(dinplus.COMMENT)}')

WITHHELD = re.compile(r'it gives \d+ findings?, ')
# A long quotation is cut off, at a place that blanks and comments in it move.
CUT_OFF = re.compile(r"'([^']{0,20})[^']*(?:…|\.\.\.)(?:'|$)")


class Match:
    """Findings of a program before and after the edits of a change."""

    def __init__(self, change, program, edits):
        self.change, self.program, self.edits = change, program, edits
        self.places = Places(program.text, edits)
        self.changed = apply(program.text, edits)
        before, after = (line_starts(text) for text in (program.text, self.changed))
        starts = defaultdict(set)  # lines that begin at a place now: an empty one, too
        for number, begin in enumerate(after, 1):
            starts[self.places.of_new(begin)].add(number)
        # (a line of the program as it is, where it may be now); messages name lines of the programs beside it, too
        self.lines = {(number, now) for number, begin in enumerate(before, 1) for now in starts[self.places.of_old(begin)]}
        self.other_lines = set()

    def compare(self, before, after):
        """(findings that are lost, findings that are new)."""
        if self.change.same == 'blanks':
            before, after = (by_line(findings, text) for findings, text in ((before, self.program.text), (after, self.changed)))
        open_places = defaultdict(list)
        for finding in after:
            open_places[self.key(finding, self.places.of_new)].append(finding)
        lost = []
        for finding in before:
            there = open_places[self.key(finding, self.places.of_old)]
            match = next((other for other in there if self.same_words(finding['message'], other['message'])), None)
            if match is None:
                lost.append(finding)
            else:
                there.remove(match)
        return lost, [finding for left in open_places.values() for finding in left]

    def key(self, finding, kept):
        begin, end = finding['range']['bytes']
        return finding['code'], finding['severity'], kept(begin), kept(end)

    def same_words(self, before, after):
        before, after = (re.split(r'(\d+)', self.plain(text)) for text in (before, after))
        if len(before) != len(after):
            return False
        return all(self.same_number(old, new) if index % 2 else old == new for index, (old, new) in enumerate(zip(before, after)))

    def plain(self, message):
        message = MARKS.sub('', message)
        if self.change.same == 'case':
            # MAC104 tells of small letters, and is counted among the findings that MAC005 holds back.
            message = WITHHELD.sub('', message).upper()
        # Where a comment, a blank or a semicolon stands beside a quoted block, the quotation may have it.
        return CUT_OFF.sub(r"'\1…'", re.sub(r'[\s;]', '', message))

    def same_number(self, before, after):
        old, new = int(before), int(after)
        return old == new or (old, new) in self.lines or (old, new) in self.other_lines or self.change.same == 'numbers' and new == old + 1


def by_line(findings, text):
    """Findings that tell a piece of a block: one for each line, wherever the piece begins."""
    starts = line_starts(text)
    kept, lines = [], {}
    for finding in findings:
        if finding['code'] not in TELLS_A_PIECE:
            kept.append(finding)
            continue
        for place in [finding, *finding['related']]:
            line = bisect.bisect_right(starts, place['range']['bytes'][0]) - 1
            lines[finding['code'], line] = dict(finding, message='', range={'bytes': [starts[line]] * 2})
    return kept + list(lines.values())


def line_starts(text):
    return [0, *(match.end() for match in re.finditer(r'\r\n|\r|\n', text))]
