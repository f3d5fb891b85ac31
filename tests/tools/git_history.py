"""Reads the commits of a repository that may be a stranger's.

As maclint itself does (cli/gate/git_call.cpp): git is asked only for commits, lists of files and their texts, which reads
no index, no attributes and no working file. So no hook, filter, textconv, external diff, pager, alias or file system
monitor that the repository's settings name is run; nothing is fetched, and nothing is written into it.
"""
import contextlib
import datetime
import os
import pathlib
import re
import subprocess
import tempfile
import threading

MEGABYTE = 1 << 20
LARGEST_TEXT = 64 * MEGABYTE
LARGEST_FOLDER = 4096 * MEGABYTE
LONGEST_ANSWER = 256 * MEGABYTE  # some three million files; a few trees that hold each other can have more
LONGEST_CALL = 600  # seconds

# Files whose lines git reads, and so may quote (gitrepository-layout): none may lead out of .git.
READ_BY_GIT = """HEAD ORIG_HEAD FETCH_HEAD MERGE_HEAD CHERRY_PICK_HEAD REVERT_HEAD BISECT_HEAD REBASE_HEAD AUTO_MERGE config
config.worktree commondir gitdir packed-refs shallow index info/refs info/grafts info/exclude info/attributes
info/sparse-checkout logs/HEAD objects/info/packs objects/info/alternates objects/info/http-alternates
objects/info/commit-graph objects/info/commit-graphs/commit-graph-chain objects/pack/multi-pack-index
reftable/tables.list""".split()

SETTINGS = ["core.fsmonitor=false", "core.hooksPath=/dev/null", "protocol.allow=never"]
USERS_OWN = ["GIT_CONFIG_GLOBAL", "GIT_CONFIG_SYSTEM", "HOME", "XDG_CONFIG_HOME"]


class BadRepository(Exception):
    """What the user is told."""


def lies_below(path, folder):
    return pathlib.Path(path) == folder or folder in pathlib.Path(path).parents


def git_outside_of(root):
    """The first git of the PATH that neither lies in the repository nor is reached through it."""
    for folder in os.environ.get("PATH", os.defpath).split(os.pathsep):
        program = os.path.join(folder, "git")
        if os.path.isabs(folder) and os.access(program, os.X_OK) and os.path.isfile(program):
            if not any(lies_below(each, root) for each in (os.path.abspath(program), os.path.realpath(program))):
                return program
    raise BadRepository("no git is found in a folder of the PATH outside of the repository")


def line_of(file):
    with open(file, encoding="utf-8", errors="surrogateescape") as lines:
        return lines.readline(4096).rstrip("\r\n")


def folders_of(root):
    """Its own .git, and the one that it shares with other working trees."""
    own = root / ".git"
    if own.is_file():
        own = root / line_of(own).removeprefix("gitdir: ")
    shared = own / line_of(own / "commondir") if (own / "commondir").is_file() else own
    if not own.is_dir():
        raise BadRepository(f"'{root}' holds no .git: name the folder of a repository that does")
    return own, shared


def refuse_special_files(root):
    folders = folders_of(root)
    ends = [pathlib.Path(os.path.realpath(folder)) for folder in folders]
    for folder in folders:
        for name in READ_BY_GIT:
            file = folder / name
            if not any(lies_below(os.path.realpath(file), end) for end in ends):
                raise BadRepository(f"'{file}' is a link that leads out of the repository's .git")
            if file.exists() and not file.is_file():
                raise BadRepository(f"'{file}' is no file: mend the repository")


def environment(root):
    """The user's own settings stay, absolute; all else that git takes from there goes."""
    kept = {key: value for key, value in os.environ.items() if not key.startswith("GIT_") or key == "GIT_CONFIG_NOSYSTEM"}
    kept.update({key: os.path.abspath(os.environ[key]) for key in USERS_OWN if os.environ.get(key)})
    return kept | {
        "GIT_OPTIONAL_LOCKS": "0",
        "GIT_ALLOW_PROTOCOL": "no_protocol",  # no protocol has that name: nothing is fetched
        "GIT_NO_LAZY_FETCH": "1",
        "GIT_TERMINAL_PROMPT": "0",
        "GIT_CEILING_DIRECTORIES": str(root.parent),
        "LC_ALL": "C",
    }


def seconds_of(day):
    try:
        return int(datetime.datetime.fromisoformat(day).replace(tzinfo=datetime.timezone.utc).timestamp())
    except ValueError:
        raise BadRepository(f"there is no day '{day}'") from None


class Commit:
    """What is told of one: its day, the first line of its message, the tree that it holds."""

    def __init__(self, name, text):
        head, _, message = text.partition(b"\n\n")
        lines = head.decode(errors="replace").split("\n")
        times = [re.search(r" (-?\d{1,11}) [+-]\d{4}$", line) for line in lines if line.startswith("committer ")]
        self.name = name
        self.tree = next((line[5:] for line in lines if line.startswith("tree ")), "")
        self.seconds = int(times[0].group(1)) if times and times[0] else 0
        self.subject = message.strip().decode(errors="replace").split("\n")[0].strip()


class History:
    def __init__(self, root):
        self.root = pathlib.Path(os.path.realpath(root))
        refuse_special_files(self.root)
        settings = [word for setting in SETTINGS for word in ("-c", setting)]
        self.git = [git_outside_of(self.root), "--no-pager", "-C", str(self.root), *settings]
        self.environment = environment(self.root)

    def asked(self, *words, given=b""):
        with tempfile.TemporaryFile() as question, tempfile.TemporaryFile() as errors:
            question.write(given)
            question.seek(0)
            with subprocess.Popen([*self.git, *words], stdin=question, stdout=subprocess.PIPE, stderr=errors,
                                  env=self.environment) as process:
                watch = threading.Timer(LONGEST_CALL, process.kill)
                watch.start()
                answer = process.stdout.read(LONGEST_ANSWER + 1)
                if len(answer) > LONGEST_ANSWER:
                    process.kill()
                process.wait()
                watch.cancel()
            errors.seek(0)
            said = errors.read(4096).decode(errors="replace").split("\n")[0]
        if len(answer) > LONGEST_ANSWER:
            raise BadRepository("git says more than can be held: the repository has too many files")
        if process.returncode != 0:
            raise BadRepository(f"git {words[0]} ended with status {process.returncode}: {said or 'it says nothing'}")
        return answer

    def pairs(self, since):
        """(commit, parent), newest first, without merges; since: a day, or a revision, whose commits are left out."""
        words = ["rev-list", "--parents", "--no-merges", "HEAD"]
        if since and re.fullmatch(r"\d{4}-\d\d-\d\d", since):
            words.insert(1, f"--max-age={seconds_of(since)}")
        elif since:
            left_out = self.asked("rev-parse", "--verify", "--end-of-options", f"{since}^{{commit}}").decode().strip()
            words.append(f"^{left_out}")
        rows = [row.split() for row in self.asked(*words, "--").decode().splitlines()]
        return [tuple(row) for row in rows if len(row) == 2]

    def commits(self, names):
        return {name: Commit(name, text) for name, text in self.texts(names, b"commit").items() if text is not None}

    def files(self, commit):
        """By path, as bytes: the text's name. Links and submodules are left out, and names that lead out of a folder."""
        files = {}
        for row in self.asked("ls-tree", "-r", "-z", "--full-tree", commit).split(b"\0"):
            what, _, path = row.partition(b"\t")
            if what.startswith(b"100") and all(part not in (b"", b".", b"..") and part.lower() != b".git" for part in path.split(b"/")):
                files[path] = what.split()[2].decode()
        return files

    def texts(self, names, kind=b"blob"):
        """By name; None where a text is missing, larger than LARGEST_TEXT or of another kind."""
        names = list(dict.fromkeys(names))
        texts = dict.fromkeys(names)
        chunk, size = [], 0
        sizes = self.asked("cat-file", "--batch-check", given="".join(f"{name}\n" for name in names).encode()) if names else b""
        for name, row in zip(names, sizes.splitlines()):
            words = row.split()
            if len(words) != 3 or words[1] != kind or int(words[2]) > LARGEST_TEXT:
                continue
            if size + int(words[2]) > LARGEST_TEXT:
                texts.update(self.chunk(chunk))
                chunk, size = [], 0
            chunk.append(name)
            size += int(words[2])
        texts.update(self.chunk(chunk))
        return texts

    def chunk(self, names):
        answer = self.asked("cat-file", "--batch", given="".join(f"{name}\n" for name in names).encode()) if names else b""
        texts, at = {}, 0
        for name in names:
            begin = answer.index(b"\n", at) + 1
            at = begin + int(answer[at:begin].split()[2]) + 1
            texts[name] = answer[begin:at - 1]
        return texts


class Folder:
    """A folder of our own that holds the files of one commit, and then those of another."""

    def __init__(self, history, path):
        self.history, self.path, self.held = history, os.fsencode(path), {}
        # maclint takes it for a repository, as the folder is for its owner, and so minds its .gitignore.
        os.makedirs(os.path.join(self.path, b".git"))

    def become(self, files):
        for path in [path for path, name in self.held.items() if files.get(path) != name]:
            place = os.path.join(self.path, path)
            os.unlink(place)
            with contextlib.suppress(OSError):  # not empty
                os.removedirs(os.path.dirname(place))
            del self.held[path]
        missing = {path: name for path, name in files.items() if path not in self.held}
        names = list(dict.fromkeys(missing.values()))
        written = 0
        for at in range(0, len(names), 500):
            texts = self.history.texts(names[at:at + 500])
            for path in [path for path, name in missing.items() if name in texts]:
                text = texts[missing[path]]
                written += len(text or b"")
                if written > LARGEST_FOLDER:
                    raise BadRepository("the files of a commit are larger than 4 GB together")
                if text is not None and self.write(path, text):
                    self.held[path] = missing[path]

    def write(self, path, text):
        """False where a tree holds what no disk does: a name too long, a file that is a folder, too."""
        place = os.path.join(self.path, path)
        try:
            os.makedirs(os.path.dirname(place), exist_ok=True)
            with open(place, "xb") as file:
                file.write(text)
        except (OSError, ValueError):
            return False
        return True
