"""Editors are run without a screen on programs of our own: they must come to the file, line and column of each finding.

What is not installed is skipped: apt-get install neovim vim-nox emacs-nox elpa-flycheck nodejs.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
VIM = ROOT / "editors/vim"
EMACS = ROOT / "editors/emacs/maclint.el"
TASKS = (ROOT / "editors/vscode/tasks.json").read_text()
MACLINT = os.environ.get("MACLINT")

LOOP = """%
O9100
(\u00dc) IF[#100EQ1]GOTO20
WHILE[#1LT5]DO1
N10 G91 G1 X1. F100
WHILE[#2LT5]DO2
#2=#2+1
END2
N20 G0 X#1
#1=#1+1
END1
M99
%
"""
SHAFT = """%shaft.nc
PROGRAM HEAD
#UNIT METRIC
MACHINING
N10 L"CHAMFER" LA40
N20 M30
SUBPROGRAM "CHAMFER"
N1 G1 X#__la Z#__lb
RETURN
END
"""
COVER = """%_N_COVER_MPF
N10 G0 X5
FOR R1=1 TO 3
N20 G1 Z=-R1 F100
IF R1==2 GOTOF NEXT
NEXT:
ENDFOR
N30 M30
"""
# O9100.nc stands in letters: \u00dc is one, and two bytes.
FINDINGS = [("O9100.nc", 3, 16, "error", "MAC303", "Jump into a loop: 'GOTO20' enters the loop"),
            ("O9100.nc", 5, 1, "warning", "MAC501", "Distance mode G91 is left to the caller."),
            ("lathe/shaft.nc", 8, 15, "warning", "DIN330", "Transfer value left out: #__lb is used here"),
            ("O9101", 3, 1, "error", "MAC301", "Missing sequence number: 'GOTO99' finds no N99")]
TYPES = {"O9100.nc": "fanuc", "O9101": "fanuc", "O9102_TORUS": "fanuc", "a.tap": "fanuc", "a.cnc": "fanuc", "a.min": "fanuc", "a.NCD": "fanuc",
         "a.eia": "fanuc", "empty.nc": "fanuc", "empty.ncs": "dinplus", "cover.nc": "sinumerik",
         "a.mpf": "sinumerik", "a.SPF": "sinumerik", "a.arc": "sinumerik", "a.cpf": "sinumerik", "a.def": "sinumerik", "lathe/shaft.nc": "dinplus"}


class EditorTest(unittest.TestCase):
    def setUp(self):
        if not MACLINT:
            self.skipTest("MACLINT names no executable")
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        base = pathlib.Path(held.name).resolve()
        self.folder = base / "programs with blanks"
        for name in TYPES:
            text = SHAFT if name == "lathe/shaft.nc" else "" if "empty" in name else COVER if TYPES[name] == "sinumerik" else LOOP
            path = self.folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("%\nO9101\nGOTO99\nM30\n%\n" if name == "O9101" else text, encoding="utf-8")
        (base / "bin").mkdir()
        (base / "bin/maclint").symlink_to(MACLINT)
        self.base = base
        self.environment = {"PATH": f"{base / 'bin'}:{os.environ['PATH']}", "HOME": str(base), "XDG_CONFIG_HOME": str(base), "LC_ALL": "C.UTF-8",
                            "TERM": "xterm"}

    def run_editor(self, *words):
        done = subprocess.run(words, cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def assert_shown(self, rows, findings):
        """rows: file, line, column, message."""
        self.assertEqual([tuple(row[:3]) for row in rows], [finding[:3] for finding in findings])
        for row, finding in zip(rows, findings):
            self.assertIn(finding[5], row[3])


class VimRunner(EditorTest):
    def told_by(self, editor, script):
        """What the script puts into the list `out`."""
        lines = ["set nocompatible encoding=utf-8", f"set runtimepath^={VIM}", "filetype plugin on", "let out = []", *script,
                 f"call writefile([json_encode(out)], '{self.base}/out')", "qall!"]
        (self.base / "run.vim").write_text("\n".join(lines) + "\n")
        quiet = ["--headless"] if editor == "nvim" else ["-e", "-s", "-N"]
        self.run_editor(editor, *quiet, "-u", "NONE", "-i", "NONE", "-S", str(self.base / "run.vim"))
        return json.loads((self.base / "out").read_text())


class VimTest(VimRunner):
    """Vim and Neovim, whichever is there."""

    def editors(self):
        found = [name for name in ("nvim", "vim") if shutil.which(name)]
        if not found:
            self.skipTest("neither Neovim nor Vim is installed (neovim, vim-nox)")
        return found

    # Where :cc leads, in letters.
    LIST = ["for i in range(len(getqflist()))", "  silent execute 'cc' (i + 1)",
            "  call add(out, [fnamemodify(bufname('%'), ':.'), line('.'), strchars(strpart(getline('.'), 0, col('.') - 1)) + 1,"
            " getqflist()[i].type, getqflist()[i].text])", "endfor"]

    def rows(self, told):
        return [(*row[:3], row[4]) for row in told]

    def test_make_fills_the_quickfix_list(self):
        for editor in self.editors():
            with self.subTest(editor):
                told = self.told_by(editor, ["edit O9100.nc", "silent make %", *self.LIST])
                self.assert_shown(self.rows(told), FINDINGS[:2])
                self.assertEqual([row[3] for row in told], ["e", "w"])
                self.assertTrue(told[0][4].startswith("[MAC303] "))

    def test_make_without_a_name_checks_the_folder(self):
        for name in set(TYPES) - {"O9100.nc", "O9101", "lathe/shaft.nc"}:
            (self.folder / name).unlink()
        for editor in self.editors():
            with self.subTest(editor):
                told = self.told_by(editor, ["edit lathe/shaft.nc", "silent make", *self.LIST])
                self.assert_shown(self.rows(told), [*FINDINGS[:2], FINDINGS[3], FINDINGS[2]])

    def test_what_goes_wrong_stays_to_be_read(self):
        for editor in self.editors():
            with self.subTest(editor):
                told = self.told_by(editor, ["edit O9100.nc", "silent make --control none %", "let out = map(getqflist(), 'v:val.text')"])
                self.assertTrue(any("none" in line for line in told), told)

    def test_programs_have_their_file_type(self):
        for editor in self.editors():
            with self.subTest(editor):
                told = self.told_by(editor, [f"edit {name}\ncall add(out, ['{name}', &filetype])" for name in TYPES])
                self.assertEqual(dict(told), TYPES)
                other = self.told_by(editor, ["edit O12.txt", "call add(out, &filetype)", "edit OLD", "call add(out, &filetype)"])
                self.assertFalse({"fanuc", "dinplus", "sinumerik"} & set(other))

    def test_a_linker_s_definitions_are_no_program(self):
        (self.folder / "dll.def").write_text("; of a library\nLIBRARY SHAFT\nEXPORTS\n")
        for editor in self.editors():
            with self.subTest(editor):
                self.assertNotIn("sinumerik", self.told_by(editor, ["edit dll.def", "call add(out, &filetype)"]))

    def test_the_programs_of_the_corpus_have_theirs(self):
        programs = {str(path): path.relative_to(ROOT / "corpus").parts[0] for path in (ROOT / "corpus").rglob("*.nc*")}
        self.assertGreater(len(programs), 100)
        for editor in self.editors():
            with self.subTest(editor):
                told = self.told_by(editor, [f"edit {path}\ncall add(out, ['{path}', &filetype])" for path in programs])
                self.assertEqual(dict(told), programs)

    def test_loops_and_sections_fold(self):
        levels, ends = (f"let out = map(range(1, line('$')), '{name}(v:val)')" for name in ("foldlevel", "foldclosedend"))
        for editor in self.editors():
            with self.subTest(editor):
                self.assertEqual(self.told_by(editor, ["edit O9100.nc", levels]), [0, 0, 0, 1, 1, 2, 2, 2, 1, 1, 1, 0, 0])
                self.assertEqual(self.told_by(editor, ["edit cover.nc", levels]), [0, 0, 1, 1, 1, 1, 1, 0])
                self.assertEqual(self.told_by(editor, ["edit lathe/shaft.nc", ends]), [-1] * 10, "all is open at first")
                self.assertEqual(self.told_by(editor, ["edit lathe/shaft.nc", "set foldlevel=0", ends]), [-1, 3, 3, 6, 6, 6, 9, 9, 9, -1])


class TreesInNeovimTest(VimRunner):
    """Parse trees and queries as docs/editors.md has them installed; colours by themselves from 0.9 on."""

    def test_queries_are_taken(self):
        if not shutil.which("nvim") or not shutil.which("cc"):
            self.skipTest("there is no Neovim, or no C compiler for the parsers")
        for language in ("fanuc", "dinplus", "sinumerik"):
            source = ROOT / "grammar" / language
            (self.base / "nvim/parser").mkdir(parents=True, exist_ok=True)
            subprocess.run(["cc", "-shared", "-fPIC", "-O0", "-I", str(source / "src"), str(source / "src/parser.c"), "-o",
                            str(self.base / f"nvim/parser/{language}.so")], check=True)
            shutil.copytree(source / "queries", self.base / f"nvim/queries/{language}")
        lua = """
function Counted()
  local language, counted = vim.bo.filetype, {}
  for _, kind in ipairs({'highlights', 'folds', 'locals', 'tags'}) do
    local query = (vim.treesitter.query.get or vim.treesitter.get_query)(language, kind)
    local root = vim.treesitter.get_parser(0, language):parse()[1]:root()
    for id, node in query:iter_captures(root, 0, 0, -1) do
      local name = query.captures[id]
      counted[name] = (counted[name] or 0) + 1
    end
  end
  counted.colours = vim.fn.has('nvim-0.9') == 1 and vim.treesitter.highlighter.active[vim.api.nvim_get_current_buf()] ~= nil and 1 or 0
  return counted
end"""
        (self.base / "counted.lua").write_text(lua)
        script = [f"luafile {self.base}/counted.lua", "for name in ['O9100.nc', 'lathe/shaft.nc', 'cover.nc']", "  execute 'edit' name",
                  "  call add(out, luaeval('Counted()'))", "endfor", "call add(out, has('nvim-0.9'))"]
        fanuc, dinplus, sinumerik, has_colours = self.told_by("nvim", [f"set runtimepath^={self.base}/nvim", *script])
        self.assertEqual((fanuc["keyword.repeat"], fanuc["label"], fanuc["local.definition"], fanuc["fold"]), (6, 2, 2, 1))
        self.assertEqual((dinplus["keyword.directive"], dinplus["label"], dinplus["reference.call"]), (4, 3, 1))
        self.assertEqual((sinumerik["keyword.repeat"], sinumerik["label"]), (3, 5))
        self.assertEqual((fanuc["colours"], dinplus["colours"], sinumerik["colours"]), (has_colours, has_colours, has_colours))


class EmacsTest(EditorTest):
    WAIT = """
(setq compilation-ask-about-save nil)
(defun wait-until (done) (let ((n 0)) (while (and (not (funcall done)) (< n 1000)) (accept-process-output nil 0.05) (setq n (1+ n)))))
(let ((default-directory "/usr/share/emacs/site-lisp/elpa/"))
  (when (file-directory-p default-directory) (normal-top-level-add-subdirs-to-load-path)))
(defun tell (&rest things) (princ (concat (mapconcat (lambda (each) (format "%s" each)) things "\\t") "\\n")))
"""

    def told(self, script):
        if not shutil.which("emacs"):
            self.skipTest("Emacs is not installed (emacs-nox)")
        (self.base / "run.el").write_text(self.WAIT + script)
        out = self.run_editor("emacs", "-Q", "--batch", "-l", str(EMACS), "-l", str(self.base / "run.el"))
        return [row.split("\t") for row in out.splitlines()]

    # Goes from finding to finding, as M-g n does.
    COMPILED = """
(with-current-buffer "%s"
  (wait-until (lambda () (not (get-buffer-process (current-buffer)))))
  (goto-char (point-min)))
(dotimes (_ 2)
  (next-error)
  (let ((line (with-current-buffer next-error-last-buffer
                (list (buffer-substring-no-properties (line-beginning-position) (line-end-position))
                      (compilation--message->type (get-text-property (point) 'compilation-message))))))
    (with-current-buffer (window-buffer)
      (apply #'tell (file-name-nondirectory buffer-file-name) (line-number-at-pos) (1+ (current-column)) line))))
"""

    def rows(self, told):
        return [(row[0], int(row[1]), int(row[2]), row[3]) for row in told]

    def test_the_compilation_buffer_leads_to_the_findings(self):
        told = self.told('(find-file "O9100.nc") (maclint)' + self.COMPILED % "*maclint*")
        self.assert_shown(self.rows(told), FINDINGS[:2])
        self.assertEqual([row[4] for row in told], ["2", "1"], "an error and a warning")

    def test_so_does_that_of_m_x_compile(self):
        command = "maclint --format concise --quiet --color never O9100.nc"
        told = self.told(f'(find-file "O9100.nc") (compile "{command}")' + self.COMPILED % "*compilation*")
        self.assert_shown(self.rows(told), FINDINGS[:2])

    def test_programs_have_their_mode(self):
        told = self.told("".join(f'(find-file "{name}") (tell "{name}" major-mode)\n' for name in TYPES))
        self.assertEqual(dict(told), {name: f"maclint-{kind}-mode" for name, kind in TYPES.items()})

    def test_the_programs_of_the_corpus_have_theirs(self):
        programs = {str(path): path.relative_to(ROOT / "corpus").parts[0] for path in (ROOT / "corpus").rglob("*.nc*")}
        told = self.told("".join(f'(find-file "{path}") (font-lock-ensure) (tell "{path}" major-mode)\n' for path in programs))
        self.assertEqual(dict(told), {path: f"maclint-{kind}-mode" for path, kind in programs.items()})

    def test_flycheck_shows_them(self):
        script = """
(if (not (require 'flycheck nil t)) (tell "none")
  (setq flycheck-check-syntax-automatically nil)
  (dolist (name '("O9100.nc" "lathe/shaft.nc" "O9101"))
    (find-file (expand-file-name name "%s/"))
    (flycheck-mode) (flycheck-buffer) (wait-until (lambda () (not (flycheck-running-p))))
    (dolist (each flycheck-current-errors)
      (tell name (flycheck-error-line each) (flycheck-error-column each) (flycheck-error-message each) (flycheck-error-level each)
            (flycheck-error-id each)))))
""" % self.folder
        told = self.told(script)
        if told == [["none"]]:
            self.skipTest("flycheck is not installed (elpa-flycheck)")
        self.assert_shown(self.rows(told), FINDINGS)
        self.assertEqual([tuple(row[4:]) for row in told], [finding[3:5] for finding in FINDINGS])


def without_comments(text):
    return re.sub(r"^\s*//.*$", "", text, flags=re.M)


class TasksOfCodeTest(EditorTest):
    """What can be tried without VS Code: its tasks are run, and their expression is tried on what they print."""

    def tasks(self):
        return {task["label"]: task for task in json.loads(without_comments(TASKS))["tasks"]}

    def output_of(self, task):
        words = [task["command"], *(word.replace("${relativeFile}", "O9100.nc") for word in task["args"])]
        done = subprocess.run(words, cwd=self.folder, env=self.environment, capture_output=True, text=True, encoding="utf-8", check=False)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return done.stdout

    def test_the_expression_takes_findings_apart(self):
        task = self.tasks()["maclint: this program"]
        pattern = task["problemMatcher"]["pattern"]
        matches = [re.search(pattern["regexp"], line) for line in self.output_of(task).splitlines()]
        rows = [[match.group(pattern[part]) for part in ("file", "line", "column", "severity", "code", "message")] for match in matches]
        self.assert_shown([(row[0], int(row[1]), int(row[2]), row[5]) for row in rows], FINDINGS[:2])
        self.assertEqual([tuple(row[3:5]) for row in rows], [finding[3:5] for finding in FINDINGS[:2]])
        match = re.search(pattern["regexp"], r"C:\nc\O1.nc:7:2: note[MAC523/G83.Q] A word is missing.")
        self.assertEqual(match.groups(), (r"C:\nc\O1.nc", "7", "2", "note", "MAC523/G83.Q", "A word is missing."))

    def test_javascript_takes_the_expression_alike(self):
        if not shutil.which("node"):
            self.skipTest("node is not installed (nodejs)")
        task = self.tasks()["maclint: all programs"]
        line = self.output_of(task).splitlines()[0]
        pattern = task["problemMatcher"]["pattern"]["regexp"]
        self.assertEqual(pattern, self.tasks()["maclint: this program"]["problemMatcher"]["pattern"]["regexp"])
        done = subprocess.run(["node", "-e", "console.log(JSON.stringify(new RegExp(process.argv[1]).exec(process.argv[2])))", pattern, line],
                              capture_output=True, text=True, check=True)
        self.assertEqual(json.loads(done.stdout)[1:6], [str(each) for each in FINDINGS[0][:5]])

    def test_the_report_for_the_viewer_is_written(self):
        self.output_of(self.tasks()["maclint: SARIF report"])
        report = json.loads((self.folder / "maclint.sarif").read_text(encoding="utf-8"))
        self.assertEqual(report["version"], "2.1.0")
        self.assertTrue(report["runs"][0]["results"])


if __name__ == "__main__":
    unittest.main()
