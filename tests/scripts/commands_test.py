"""Every command of maclint that the pages show is run, in a folder with what it names; it must be accepted."""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", ROOT / "action.yml", ROOT / ".pre-commit-hooks.yaml",
         *(ROOT / "docs" / name for name in ("use.md", "baseline.md", "editors.md", "install.md", "json.md", "packaging.md")), *ROOT.glob("docs/ci/*")]
JUMP = "%\nO9100\nGOTO 99\nM30\n%\n"
# What stands for something of the reader's.
MEANT = {"[check]": "check", "[PATH...]": ".", "PATH...": ".", "PATH…": ".", "PATH": ".", "[COMMAND]": "check", "[FOLDER]": "--print .", "[NAME]": "haas", "RULE": "MAC303",
         "SHELL": "bash", "FILE": "baseline.json", "REV": "HEAD", "$OPTIONS": "", "$PATHS": ".", "$(FULL_CURRENT_PATH)": "O9100.nc", '"sarif:$REPORT"': "sarif:a.sarif"}
NAMES = ["O9100.nc", "O9010.nc", "programs/O9100.nc", "D:\\NC programs\\O9010.nc", "\\\\server\\shop\\lathe", "C:\\programs"]


def shown_in(text, is_page):
    """Commands that begin a line of a block or a step of a recipe, and those in code spans; without what is said of them."""
    blocks = re.findall(r"^ *```\w*\n(.*?)^ *```", text, re.S | re.M) if is_page else [text]
    rows = re.findall(r"^ *(?:- )?(?:run: |script: |sh 'PATH=[^;]*; )?(?:build/)?(maclint(?: .*)?)$", "\n".join(blocks), re.M)
    return [re.split(r" {2,}|'$", row)[0] for row in rows] + re.findall(r"`(maclint [^`\n]+)`", text)


def commands_of(page):
    return shown_in(page.read_text(encoding="utf-8"), page.suffix == ".md")


def runnable(command):
    for name, meant in MEANT.items():
        command = re.sub(rf"(?<![\w./-]){re.escape(name)}(?![\w./-])", meant, command)
    # A shell of Linux takes backslashes outside of quotes for its own.
    return re.sub(r'(?<= )(\\\\\w\S*|\w:\\\S+)', r"'\1'", command)


class CommandsTest(unittest.TestCase):
    def setUp(self):
        program = os.environ.get("MACLINT")
        if not program or not shutil.which("git"):
            self.skipTest("there is no git, or MACLINT does not name an executable")
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = pathlib.Path(held.name)
        (self.folder / "bin").mkdir()
        (self.folder / "bin/maclint").symlink_to(program)
        self.work = self.folder / "work"
        for name in NAMES:
            path = self.work / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(JUMP)
        for name in (".local/share/bash-completion/completions", ".zfunc", ".config/fish/completions"):
            (self.folder / name).mkdir(parents=True)
        self.run_shell("git init -q && git add O9100.nc && git -c user.name=x -c user.email=x@x.invalid commit -qm x && "
                       "git update-ref refs/remotes/origin/main HEAD && maclint --quiet --write-baseline baseline.json . >log; rm log")

    def run_shell(self, command):
        return subprocess.run(["bash", "-c", command], cwd=self.work, capture_output=True, text=True, stdin=subprocess.DEVNULL,
                              env={"HOME": str(self.folder), "PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}", "LC_ALL": "C.UTF-8"})

    def test_are_accepted(self):
        seen = 0
        for page in PAGES:
            for command in commands_of(page):
                with self.subTest(page.name, command=command):
                    done = self.run_shell(runnable(command))
                    self.assertIn(done.returncode, (0, 1), f"{runnable(command)}\n{done.stderr}")
                    self.assertNotIn("error:", done.stderr)
                seen += 1
        self.assertGreater(seen, 40)

    def test_have_options_that_maclint_knows(self):
        known = set(re.findall(r"--[a-z][a-z-]+", self.run_shell("maclint --help; maclint rules --help; maclint init --help; maclint renumber --help").stdout)) | {"--write-docs"}
        self.assertIn("--since", known)
        for page in PAGES:
            for span in re.findall(r"`(--[^`\n]+)`", page.read_text(encoding="utf-8")):
                self.assertIn(re.match(r"--[a-z-]+", span).group(), known, page.name)


class FoundCommandsTest(unittest.TestCase):
    def test_are_those_of_blocks_recipes_and_spans(self):
        text = ("```\nmaclint --select A .     # why\nmaclint [check] [PATH...]    '-' reads\n  - maclint a\nmaclintx\n```\n\n`maclint b`\nor `x` maclint c\n"
                "    script: maclint d\n  sh 'PATH=\"x\"; maclint e'\n")
        page = ["maclint --select A .", "maclint [check] [PATH...]", "maclint a"]
        self.assertEqual(shown_in(text, True), [*page, "maclint b"])
        self.assertEqual(shown_in(text, False), [*page, "maclint d", "maclint e", "maclint b"])

    def test_are_run_with_things_for_placeholders(self):
        self.assertEqual(runnable("maclint --since REV [PATH...]"), "maclint --since HEAD .")
        self.assertEqual(runnable('maclint "D:\\NC programs\\O.nc" \\\\server\\x C:\\y'),
                         'maclint "D:\\NC programs\\O.nc" \'\\\\server\\x\' \'C:\\y\'')


if __name__ == "__main__":
    unittest.main()
