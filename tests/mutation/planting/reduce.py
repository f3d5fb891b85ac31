"""Makes a program in which a plant was missed as small as it can be while the plant is still missed."""
import json
import subprocess
from pathlib import Path

from .plants import ERROR, KINDS, RANK
from .workspace import Corpus, File

ATTEMPTS = 150  # runs of maclint for one miss


class Reducer:
    """Every attempt is one run of maclint on one small program."""

    def __init__(self, maclint, folder):
        self.maclint, self.folder = maclint, folder
        folder.mkdir(parents=True, exist_ok=True)

    def smallest(self, corpus, plant):
        """Lines of the unchanged program, and the line that the plant changes in it; the program alone, without its neighbours."""
        path = Path(*plant.path.parts[1:])
        lines = [text.rstrip('\r') for text in corpus.files[path].lines]
        wanted = lines[plant.line - 1]
        self.left = ATTEMPTS
        if not self.is_missed(corpus, plant, path, lines, wanted):
            return None
        size = len(lines) // 2
        while size:
            at = 0
            while at < len(lines):
                fewer = lines[:at] + lines[at + size:]
                if wanted in fewer and fewer[:1] == lines[:1] and self.is_missed(corpus, plant, path, fewer, wanted):
                    lines = fewer
                else:
                    at += size
            size //= 2
        return lines

    def is_missed(self, corpus, plant, path, lines, wanted):
        """Whether the same kind of plant in that line is no harmless one here, and maclint does not find it."""
        self.left -= 1
        if self.left < 0:
            return False
        alone = Corpus(corpus.name, corpus.language, [File(path, '\n'.join(lines))])
        for other in alone.plants(path):
            if other.kind == plant.kind and not other.harmless and lines[other.line - 1] == wanted \
                    and other.difference() == plant.difference():
                changed = list(lines)
                for line, text in other.changes.items():
                    changed[line] = text
                before, after = (self.findings(path.suffix, text) for text in (lines, changed))
                sound = not any(finding['severity'] == ERROR for finding in before)
                return sound and not any(finding['code'] in KINDS[plant.kind].rules and RANK[finding['severity']] >= RANK[plant.least]
                                         for finding in before + after)
        return False

    def findings(self, suffix, lines):
        file = self.folder / f'program{suffix or ".nc"}'
        file.write_bytes('\n'.join(lines).encode('latin-1'))
        options = ['--isolated', '--jobs', '1', '--format', 'json', '--no-timestamps']
        done = subprocess.run([str(self.maclint), 'check', *options, file.name], cwd=self.folder, capture_output=True)
        return json.loads(done.stdout)['findings']
