"""Each fix that a rule offers for a bad example of its page or a defect of corpus/, applied by --fix: the finding goes, and
nothing comes in its place."""
import collections
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = sorted((ROOT / "docs/rules").glob("[A-Z]*[0-9].md"))
BAD = re.compile(r"## Bad \((\w+)[^)\n]*\)\n\n```\n(.*?)```", re.DOTALL)
# The rule that was meant has nothing to allow in the example.
UNCOVERS = {("MAC002", "MAC001")}


def examples():
    """Code of the rule, language and text of each bad example."""
    for page in PAGES:
        for language, text in BAD.findall(page.read_text(encoding="utf-8")):
            yield page.stem, language, text


def defects():
    """Language and text of each program of the corpus with a defect."""
    for file in sorted(path for path in (ROOT / "corpus").glob("*/defects/*") if path.is_file()):
        yield file.parts[-3], file.read_bytes().decode("latin-1")


def maclint(*arguments):
    return subprocess.run([os.environ["MACLINT"], "check", "--isolated", *map(str, arguments)], capture_output=True, text=True)


def findings(file, language, *options):
    return json.loads(maclint("--dialect", language, "--format", "json", *options, file).stdout)["findings"]


def codes(found):
    return collections.Counter(finding["code"] for finding in found)


def differing_lines(before, after):
    """How many lines of the longer text are not in the other."""
    return max((collections.Counter(one.splitlines()) - collections.Counter(other.splitlines())).total()
               for one, other in ((before, after), (after, before)))


def offering(folder):
    """The examples whose rule offers a fix; found in a run for each language, which is quicker than one for each example."""
    all_examples = list(examples())
    for number, (code, language, text) in enumerate(all_examples):
        file = folder / language / str(number) / f"{code}.nc"
        file.parent.mkdir(parents=True)
        file.write_text(text, encoding="utf-8")
    numbers = set()
    for language in {language for _, language, _ in all_examples}:
        for finding in findings(folder / language, language, "--select", "ALL", "--max-findings", "all"):
            file = pathlib.Path(finding["file"])
            if finding["fix"] and finding["code"] == file.stem:
                numbers.add(int(file.parent.name))
    return [all_examples[number] for number in sorted(numbers)]


class FixesTest(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        if not os.environ.get("MACLINT"):
            self.skipTest("MACLINT does not name an executable")

    def problems(self, code, language, text, folder):
        file = folder / f"{code}.nc"
        file.write_text(text, encoding="utf-8")
        offered = [finding for finding in findings(file, language, "--select", code) if finding["fix"]]
        before = codes(findings(file, language))
        left = codes(findings(file, language, "--select", code))[code]
        maclint("--dialect", language, "--select", code, "--fix", "--unsafe-fixes", file)
        fixed = file.read_text(encoding="utf-8")
        places = sum(len(finding["fix"]) for finding in offered)
        found = []
        if codes(findings(file, language, "--select", code))[code] > left - len(offered):
            found.append(f"{code}: still found in\n{fixed}")
        come = [other for other in codes(findings(file, language)) - before if (code, other) not in UNCOVERS]
        if come:
            found.append(f"{code}: its fix brings {', '.join(come)} into\n{fixed}")
        if differing_lines(text, fixed) > 2 * places:  # a block that is put in front of another takes over its number
            found.append(f"{code}: more lines than its {places} edits have changed in\n{fixed}")
        return found

    def fixed(self, folder, language, code, text, line_end):
        file = folder / "ends.nc"
        file.write_bytes(text.replace("\n", line_end).encode())
        maclint("--dialect", language, "--select", code, "--fix", "--unsafe-fixes", file)
        return file.read_bytes().decode().replace(line_end, "\n")

    def test_does_the_same_whatever_ends_the_lines_and_as_its_difference_says(self):
        with tempfile.TemporaryDirectory() as held:
            folder = pathlib.Path(held)
            for code, language, text in offering(folder):
                with self.subTest(code=code, text=text):
                    fixed = self.fixed(folder, language, code, text, "\n")
                    self.assertEqual(self.fixed(folder, language, code, text, "\r\n"), fixed)
                    self.assertEqual(self.fixed(folder, language, code, text, "\r"), fixed)
                    for end in ("\n", ""):
                        (folder / "ends.nc").write_text(text.rstrip("\n") + end, encoding="utf-8")
                        difference = subprocess.run(
                            [os.environ["MACLINT"], "check", "--isolated", "--dialect", language, "--select", code, "--diff",
                             "--unsafe-fixes", "ends.nc"], cwd=folder, capture_output=True, check=False).stdout
                        subprocess.run(["git", "apply"], cwd=folder, input=difference, check=True)
                        applied = (folder / "ends.nc").read_text(encoding="utf-8")
                        (folder / "ends.nc").write_text(text.rstrip("\n") + end, encoding="utf-8")
                        maclint("--dialect", language, "--select", code, "--fix", "--unsafe-fixes", folder / "ends.nc")
                        self.assertEqual(applied, (folder / "ends.nc").read_text(encoding="utf-8"))

    def test_mends_the_defects_of_the_corpus_and_brings_nothing(self):
        found = []
        places = 0
        with tempfile.TemporaryDirectory() as held:
            file = pathlib.Path(held) / "all.nc"
            for language, text in defects():
                file.write_text(text, encoding="utf-8")
                for code in sorted({finding["code"] for finding in findings(file, language) if finding["fix"]}):
                    places += 1
                    found += self.problems(code, language, text, pathlib.Path(held))
        self.assertEqual(found, [])
        self.assertGreater(places, 10)

    def test_mends_what_is_found_and_brings_nothing(self):
        fixing = set()
        found = []
        with tempfile.TemporaryDirectory() as held:
            folder = pathlib.Path(held)
            for code, language, text in offering(folder):
                fixing.add(code)
                found += self.problems(code, language, text, folder)
        self.assertEqual(found, [])
        self.assertGreaterEqual(len(fixing), 30, sorted(fixing))


if __name__ == "__main__":
    unittest.main()
