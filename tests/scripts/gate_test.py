"""The steps of .ci/run: what hangs has failed, what the hour has no room for is skipped, and with what a change is compared."""
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def in_steps(script, folder=ROOT, **variables):
    """Output of a script that knows the functions of .ci/steps.sh."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("MACLINT_BASE", "GIT_"))}
    done = subprocess.run(["bash", "-c", f". '{ROOT}/.ci/steps.sh'\n{script}"], cwd=folder, capture_output=True, text=True,
                          env={**environment, **variables})
    return done.stdout + done.stderr


class WithinTest(unittest.TestCase):
    def verdict(self, hour, call):
        return in_steps(f'hour={hour}; f() {{ within {call}; }}; step name f').splitlines()[-1]

    def test_what_hangs_fails(self):
        self.assertRegex(self.verdict(3400, "1 1 sleep 60"), r"FAILED \(status 124\)")

    def test_what_the_hour_ends_is_skipped(self):
        self.assertIn("skipped: it did not end within the hour", self.verdict(1, "1 9 sleep 60"))

    def test_what_no_longer_fits_is_skipped_at_once(self):
        self.assertIn("skipped: only 0 minutes are left", self.verdict(0, "1 9 true"))

    def test_any_other_status_is_that_of_the_command(self):
        self.assertIn("passed", self.verdict(3400, "1 9 true"))
        self.assertIn("FAILED (status 3)", self.verdict(3400, "1 9 sh -c 'exit 3'"))


class BaseTest(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = pathlib.Path(held.name)

    def git(self, *words):
        command = ["git", "-c", "user.name=x", "-c", "user.email=x@x.invalid", *words]
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=True).stdout.strip()

    def base(self, name=""):
        return in_steps('f() { find_base && echo "base $base"; }; step name f', self.folder, MACLINT_BASE=name,
                        GIT_CEILING_DIRECTORIES=str(self.folder.parent))

    def test_is_the_commit_that_was_named_and_nothing_else(self):
        self.git("init", "--quiet")
        for message in ("one", "two", "three"):
            self.git("commit", "--quiet", "--allow-empty", "--message", message)
        self.assertIn("base " + self.git("rev-parse", "HEAD~1"), self.base("HEAD~1"))
        self.assertIn("base " + self.git("rev-parse", "HEAD~2"), self.base())
        wrong = self.base("no-such-branch")
        self.assertIn("MACLINT_BASE names no commit that is here: 'no-such-branch'", wrong)
        self.assertIn("FAILED", wrong)

    def test_is_not_asked_for_outside_of_a_checkout(self):
        self.assertIn("skipped: this is not a git checkout", self.base("HEAD"))


if __name__ == "__main__":
    unittest.main()
