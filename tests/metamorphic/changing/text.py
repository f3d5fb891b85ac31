"""A program as text that is changed, and where each byte of it is found again.

Bytes are read as Latin-1, so that a character is a byte; nobody here looks at letters beyond ASCII.
"""
import bisect
import itertools
from dataclasses import dataclass, field
from pathlib import Path


@dataclass(frozen=True)
class Edit:
    begin: int
    end: int
    text: str


def insert(at, text):
    return Edit(at, at, text)


def apply(text, edits):
    """The text with all edits made; of edits that overlap the first one counts."""
    parts, at = [], 0
    for edit in sorted(edits, key=lambda edit: (edit.begin, edit.end)):
        if edit.begin < at:
            continue
        parts += [text[at:edit.begin], edit.text]
        at = edit.end
    return ''.join(parts) + text[at:]


class Places:
    """Places before and after the edits, both counted in characters that stayed: what was put in or taken out there
    has no width."""

    def __init__(self, text, edits):
        self.before, self.after = [], []  # (begin, end, kept up to its begin) of each stretch that stayed
        old = new = kept = 0
        for edit in [*sorted(edits, key=lambda edit: (edit.begin, edit.end)), Edit(len(text), len(text), '')]:
            if edit.begin < old:
                continue
            stays = edit.begin - old
            self.before.append((old, old + stays, kept))
            self.after.append((new, new + stays, kept))
            kept += stays
            old, new = edit.end, new + stays + len(edit.text)

    @staticmethod
    def kept(stretches, at):
        begin, end, kept = stretches[max(bisect.bisect_right(stretches, at, key=lambda stretch: stretch[0]) - 1, 0)]
        return kept + min(max(at - begin, 0), end - begin)

    def of_old(self, at):
        return self.kept(self.before, at)

    def of_new(self, at):
        return self.kept(self.after, at)


@dataclass
class Program:
    """A file of a corpus."""
    path: Path  # below the folder that maclint is run in
    language: str  # 'fanuc' or 'dinplus'
    text: str
    pieces: list = field(default=None, repr=False)  # in the order of the text, without gaps

    def lines(self):
        """(begin, end) of each line, without its end."""
        at = 0
        for line in self.text.splitlines(keepends=True) if '\n' in self.text or '\r' in self.text else [self.text]:
            yield at, at + len(line.rstrip('\r\n'))
            at += len(line)


@dataclass(frozen=True)
class Piece:
    kind: str  # 'letters', 'number', 'sign', 'blank', 'end', 'comment', or 'fixed': what no change touches
    begin: int
    end: int
    text: str


def pieces_of(text, token, kind_of, code=None):
    """Cuts the text by the expression `token`; `kind_of(match)` names the kind. What the expression passes over is fixed, and so is
    what stands outside of `code`, (begin, end)."""
    begin, stop = code or (0, len(text))
    at, pieces = 0, []

    def pass_to(end):
        if end > at:
            pieces.append(Piece('fixed', at, end, text[at:end]))

    for match in token.finditer(text, begin, stop):
        pass_to(match.start())
        if match.end() > match.start():
            pieces.append(Piece(kind_of(match), match.start(), match.end(), match.group()))
        at = match.end()
    pass_to(len(text))
    return pieces


def blocks(pieces):
    """The pieces of each block, with the end of it last."""
    block = []
    for piece in pieces:
        block.append(piece)
        if piece.kind == 'end':
            yield block
            block = []
    if block:
        yield block


def neighbours(pieces):
    return itertools.pairwise(pieces)
