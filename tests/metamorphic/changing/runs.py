"""Runs of maclint over many programs at once."""
import json
import re
import shutil
import subprocess
from collections import defaultdict


class Failed(Exception):
    """maclint ended in a way that is no verdict on a program."""


class Maclint:
    """Programs lie in folders that look like a repository, so that nothing beside them is read."""

    def __init__(self, executable, folder):
        self.executable, self.folder = str(executable), folder
        shutil.rmtree(folder, ignore_errors=True)

    def lay_out(self, name, texts):
        """The folder NAME with these texts, by path."""
        home = self.folder / name
        shutil.rmtree(home, ignore_errors=True)
        (home / '.git').mkdir(parents=True)
        for path, text in texts.items():
            (home / path).parent.mkdir(parents=True, exist_ok=True)
            (home / path).write_bytes(text.encode('latin-1'))
        return home

    def run(self, home, arguments, stdin=None):
        """Standard output of a check in that folder."""
        done = subprocess.run([self.executable, 'check', '--isolated', '--vendor', '--select', 'ALL', '--format', 'json', '--no-timestamps', *arguments], cwd=home,
                              input=stdin, capture_output=True, check=False)
        if done.returncode not in (0, 1) or not done.stdout:
            raise Failed(f'maclint ended with status {done.returncode} in {home}:\n{done.stderr.decode(errors="replace")[-2000:]}')
        return done.stdout

    def languages(self, texts):
        """The language that maclint takes each of these programs for."""
        home = self.lay_out('languages', texts)
        done = subprocess.run([self.executable, 'check', '--isolated', '--show-config', *map(str, texts)], cwd=home, capture_output=True,
                              check=False)
        if done.returncode:
            raise Failed(f'maclint does not say what it takes programs for:\n{done.stderr.decode(errors="replace")[-2000:]}')
        found = re.findall(r'^(\S[^\n]*)\n(?:  [^\n]*\n)*?  dialect +(\w+)', done.stdout.decode(errors='replace'), re.MULTILINE)
        dialects = dict(found)
        return {path: {'nct': 'fanuc'}.get(dialects.get(str(path)), dialects.get(str(path))) for path in texts}

    def check(self, name, texts, options=()):
        """What is found in these programs: {path: findings}, those that comments allow, and {path: notices}."""
        home = self.lay_out(name, texts)
        report = json.loads(self.run(home, [*options, '--', *map(str, texts)]))
        return Report(report)


class Report:
    def __init__(self, report):
        self.findings, self.suppressed, self.notices = defaultdict(list), defaultdict(list), defaultdict(list)
        for finding in report['findings']:
            self.findings[finding['file']].append(finding)
        for finding in report['suppressed']:
            self.suppressed[finding['file']].append(finding)
        for notice in report['notices']:
            self.notices[notice.get('file') or ''].append({'code': notice['severity'], 'message': notice['message']})
