"""The programs that defects are planted in, with those that they call or are called by."""
import hashlib
import re
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

from . import (dinplus, edit, fanuc, fanuc_calls, fanuc_conditions, fanuc_forms, fanuc_jumps, fanuc_loops, fanuc_modal,
               fanuc_numbers, fanuc_saved, fanuc_variables, sinumerik, sinumerik_kinds, spelling)
from .callers import NEEDS, Callers
from .plants import KINDS, NOTE, WARNING, Plant
from .shows import lines_that_show

USUAL = {'.nc', '.ncs', '.cnc', '.tap', '.ncc', '.txt', '.gcode', '.ncf', '.mpf', '.spf', '.def', ''}
LARGEST = 200_000  # bytes; what is larger is moves
CALLED_BY_NAME = re.compile(r'L\s*"([^"]+)"')


@dataclass
class File:
    path: Path  # from the corpus' folder
    text: str  # Latin-1, so that every byte stays as it is

    @property
    def lines(self):
        return self.text.split('\n')


class Corpus:
    """A folder of programs: each of its folders is read alone, as maclint does with a repository."""

    def __init__(self, name, language, files):
        self.name, self.language = name, language
        self.files = {file.path: file for file in files}
        self.neighbours = self.connect()

    @classmethod
    def read(cls, root, name, language):
        paths = sorted(path for path in root.rglob('*')
                       if path.is_file() and path.suffix.lower() in USUAL and path.stat().st_size <= LARGEST)
        return cls(name, language, [File(path.relative_to(root), path.read_bytes().decode('latin-1')) for path in paths])

    def connect(self):
        """For each file those that it calls and those that call it, directly or through others."""
        homes = defaultdict(list)
        for path, file in self.files.items():
            for name in self.names(file):
                homes[self.repository(path), name].append(path)
        called, callers = defaultdict(set), defaultdict(set)
        for path, file in self.files.items():
            for name in self.called(file):
                for home in homes[self.repository(path), name]:
                    called[path].add(home)
                    callers[home].add(path)
        return {path: sorted(reached(path, called) | reached(path, callers)) for path in self.files}

    def half(self, path):
        """'tune' or 'hold', by the author: the folder is named OWNER__REPOSITORY. Of unknown authors, and of us, each program
        is taken for one."""
        owner = path.parts[0].partition('__')[0].lower() if len(path.parts) > 1 else 'unknown'
        name = path.name if owner == 'unknown' else owner
        return ('hold', 'tune')[hashlib.sha256(name.encode()).digest()[0] & 1]

    def repository(self, path):
        return path.parts[0] if len(path.parts) > 1 else ''

    def names(self, file):
        if self.language == 'dinplus':
            return {file.path.stem.upper()}
        if self.language == 'sinumerik':
            return sinumerik.names_of(file.path, file.lines)
        named = re.match(r'[Oo]?0*(\d+)$', file.path.stem)
        own = {program.number for program in fanuc.programs_of(file.lines) if program.number is not None}
        return own | ({int(named.group(1))} if named else set())

    def called(self, file):
        if self.language == 'dinplus':
            return {name.upper() for name in CALLED_BY_NAME.findall(file.text)}
        if self.language == 'sinumerik':
            return sinumerik.named_in(file.path, file.lines) - sinumerik.names_of(file.path, file.lines)
        return fanuc.calls_of(file.lines)

    def plants(self, path):
        """All plants of a file."""
        file = self.files[path]
        if self.language == 'dinplus':
            libraries = {name: dinplus.code_of(self.files[other].lines) for other in self.neighbours[path]
                         for name in self.names(self.files[other])}
            for kind, edits, harmless in dinplus.plants(file.lines, libraries, self.name.startswith('own')):
                yield self.planted(kind, path, file.lines, edits, harmless)
            return
        if self.language == 'sinumerik':
            yield from self.sinumerik_plants(path)
            return
        lines = file.lines
        numbers = {name for other in self.neighbours[path] for name in self.names(self.files[other])}
        callers = Callers([program for other in self.neighbours[path] for program in fanuc.programs_of(self.files[other].lines, other.parent)])
        for program in fanuc.programs_of(lines, path.parent):
            found = [*fanuc_jumps.plants(program), *fanuc_loops.plants(program, numbers, callers.by_number),
                     *fanuc_conditions.plants(program, numbers), *fanuc_variables.plants(program), *fanuc_numbers.plants(program),
                     *fanuc_modal.plants(program, lines), *fanuc_saved.plants(program), *fanuc_calls.plants(program, numbers, callers),
                     *fanuc_calls.chains(program, numbers),
                     *spelling.plants(program, lines), *fanuc_forms.plants(program, lines)]
            for kind, edits, harmless, *added in found:
                if kind in NEEDS and not harmless and callers.none_is_hurt(kind, program.number):
                    harmless = 'its callers say the mode anew before they need it'
                yield self.planted(kind, path, lines, edits, harmless, *added)

    def sinumerik_plants(self, path):
        if path.suffix.lower() not in sinumerik.WHOLE:
            return
        files = [self.files[other] for other in self.neighbours[path]]
        libraries = {program.name: program for file in files if file.path.suffix.lower() in sinumerik.WHOLE
                     for program in [sinumerik.program_of(file.path, file.lines)]}
        shared = {name for file in files for name in self.names(file)}
        for kind, edits, harmless in sinumerik.plants(sinumerik.program_of(path, self.files[path].lines), libraries, shared):
            yield self.planted(kind, path, self.files[path].lines, edits, harmless)

    def planted(self, kind, path, lines, edits, harmless, added=None):
        changes = edit.apply(lines, edits)
        if all(changes[line] == lines[line] for line in changes):
            harmless = 'nothing changes'
        least = NOTE if kind in ('label-doubled', 'zero-as-vacancy', 'feed-left', 'speed-left', *sinumerik_kinds.NOTES) else WARNING
        added = {path.parent / name: text for name, text in (added or {}).items()}
        return Plant(kind, Path(self.name) / path, changes, harmless, least, kind.endswith('program-missing') or kind == 'sin-undefined',
                     [lines[line] for line in sorted(changes)], self.half(path), added=added)

    def shown(self, plant):
        """Lines of the plant's program that show the defect, from 1 on; nothing: each of them."""
        if self.language != 'fanuc':
            return None
        return lines_that_show(self.files[Path(*plant.path.parts[1:])].lines, plant.changes, KINDS[plant.kind].group)


def reached(start, links):
    found, waiting = {start}, [start]
    while waiting:
        new = links[waiting.pop()] - found
        found |= new
        waiting += new
    return found
