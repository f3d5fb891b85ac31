"""Editors as clients of `maclint lsp`, without a screen: they show the findings, apply a fix, rename a label.

What is not installed is skipped: apt-get install neovim emacs-nox elpa-eglot.
"""
import functools
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
VIM = ROOT / "editors/vim"
EMACS = ROOT / "editors/emacs/maclint.el"
MACLINT = os.environ.get("MACLINT")

# XO. has the letter O for a zero; the loop is entered by no jump from outside but GOTO20.
PROGRAM = """%
O9100
IF[#100EQ1]GOTO20
(\u00dc) G1 XO. F100
N20 G0 X0
M99
%
"""
FIXED = PROGRAM.replace("XO.", "X0.")
RENAMED = FIXED.replace("20", "30")
LETTER = ("MAC106", 4, 8)  # the finding of XO.: code, line, column in letters


@functools.cache
def capabilities():
    """What the server offers; None where MACLINT names no program that serves editors."""
    if not MACLINT:
        return None
    body = json.dumps({"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {"processId": None, "rootUri": None, "capabilities": {}}})
    done = subprocess.run([MACLINT, "lsp"], input=f"Content-Length: {len(body)}\r\n\r\n{body}".encode(), capture_output=True, timeout=60, check=False)
    _, separator, answer = done.stdout.partition(b"\r\n\r\n")
    return json.JSONDecoder().raw_decode(answer.decode())[0]["result"]["capabilities"] if separator else None


class ClientTest(unittest.TestCase):
    """A folder of programs, and an editor that finds `maclint` on the PATH."""

    def setUp(self):
        if capabilities() is None:
            self.skipTest("MACLINT names no maclint that knows 'lsp'")
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.base = pathlib.Path(held.name).resolve()
        self.folder = self.base / "programs with blanks"
        self.folder.mkdir()
        (self.folder / ".maclint.json").write_text("{}\n")
        (self.folder / "O9100.nc").write_text(PROGRAM, encoding="utf-8")
        (self.base / "bin").mkdir()
        (self.base / "bin/maclint").symlink_to(MACLINT)
        self.environment = {"PATH": f"{self.base / 'bin'}:{os.environ['PATH']}", "HOME": str(self.base), "XDG_CONFIG_HOME": str(self.base),
                            "LC_ALL": "C.UTF-8", "TERM": "xterm"}

    def need(self, *providers):
        for provider in providers:
            if not capabilities().get(provider):
                self.skipTest(f"this maclint has no {provider}")

    def told(self, *words):
        """What the editor writes into the file `out`, a JSON value."""
        done = subprocess.run(words, cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertTrue((self.base / "out").exists(), done.stdout + done.stderr)
        return json.loads((self.base / "out").read_text(encoding="utf-8"))


class NeovimTest(ClientTest):
    START = """
vim.opt.runtimepath:prepend('%(vim)s')
vim.cmd('filetype plugin on')
require('maclint').setup()
local function lines() return table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), '\\n') .. '\\n' end
local function settled(run) return vim.wait(30000, run, 50) end
local function shown() return settled(function() return #vim.diagnostic.get(0) > 0 end) end
local function choose(title) vim.ui.select = function(items, options, chosen)
  for index, item in ipairs(items) do
    if options.format_item(item):find(title, 1, true) then return chosen(item, index) end
  end
end end
local function go(line, column) vim.api.nvim_win_set_cursor(0, { line, column }) end
local function run()
  vim.cmd('edit O9100.nc')
  shown()
  %(script)s
end
local ok, out = pcall(run)
vim.fn.writefile({ vim.json and vim.json.encode(out) or vim.fn.json_encode(out) }, '%(base)s/out')
vim.cmd('qall!')
"""

    def told_by_neovim(self, script):
        if not shutil.which("nvim"):
            self.skipTest("Neovim is not installed (neovim)")
        path = self.base / "run.lua"
        path.write_text(self.START % {"vim": VIM, "base": self.base, "script": script})
        return self.told("nvim", "--headless", "-u", "NONE", "-i", "NONE", "-c", f"luafile {path}")

    def test_findings_are_shown(self):
        told = self.told_by_neovim("""
  local found = {}
  for _, each in ipairs(vim.diagnostic.get(0)) do
    local letters = vim.fn.strchars(vim.fn.getline(each.lnum + 1):sub(1, each.col))
    table.insert(found, { each.code or each.user_data.lsp.code, each.lnum + 1, letters + 1 })
  end
  return found""")
        self.assertIn(list(LETTER), told)

    def test_a_fix_is_applied(self):
        self.need("codeActionProvider")
        told = self.told_by_neovim("""
  go(4, 8)
  choose('0')
  vim.lsp.buf.code_action()
  settled(function() return lines():find('X0.', 1, true) ~= nil end)
  return lines()""")
        self.assertEqual(told, FIXED)

    def test_so_are_all_that_are_safe(self):
        self.need("codeActionProvider")
        self.assertEqual(self.told_by_neovim("vim.cmd('MaclintFixAll') return lines()"), FIXED)

    def test_a_label_is_renamed(self):
        self.need("renameProvider")
        (self.folder / "O9100.nc").write_text(FIXED, encoding="utf-8")
        told = self.told_by_neovim("""
  settled(function() return #(vim.lsp.get_clients or vim.lsp.get_active_clients)() > 0 end)
  go(5, 1)
  vim.lsp.buf.rename('N30')
  settled(function() return lines():find('N30', 1, true) ~= nil end)
  return lines()""".replace("shown()", ""))
        self.assertEqual(told, RENAMED)

    def test_hover_tells_what_a_variable_is(self):
        self.need("hoverProvider")
        told = self.told_by_neovim("""
  go(3, 4)
  local answers = vim.lsp.buf_request_sync(0, 'textDocument/hover', vim.lsp.util.make_position_params(0, 'utf-16'), 30000)
  for _, each in pairs(answers or {}) do if each.result then return each.result.contents.value end end""")
        self.assertIn("**#100**", told)
        self.assertIn("common variable", told)

    def test_definition_leads_to_the_block(self):
        self.need("definitionProvider")
        told = self.told_by_neovim("""
  go(3, 16)
  vim.lsp.buf.definition()
  settled(function() return vim.api.nvim_win_get_cursor(0)[1] == 5 end)
  return vim.api.nvim_win_get_cursor(0)""")
        self.assertEqual(told, [5, 1])

    def test_a_rule_is_explained(self):
        self.need("executeCommandProvider")
        told = self.told_by_neovim(f"vim.cmd('MaclintExplain {LETTER[0]}') return {{ vim.bo.filetype, lines() }}")
        self.assertEqual(told[0], "markdown")
        self.assertIn(LETTER[0], told[1])

    def test_what_the_server_refuses_is_said_in_its_words(self):
        self.need("executeCommandProvider")
        told = self.told_by_neovim("vim.cmd('MaclintExplain MAC99999')")
        self.assertIn("MAC99999", told)


class EmacsTest(ClientTest):
    START = """;; -*- lexical-binding: t -*-
(let ((default-directory "/usr/share/emacs/site-lisp/elpa/"))
  (when (file-directory-p default-directory) (normal-top-level-add-subdirs-to-load-path)))
(unless (require 'eglot nil t) (kill-emacs 77))
(require 'json)
(load "%(emacs)s")
(setq make-backup-files nil last-nonmenu-event ?x eglot-sync-connect 30 eglot-confirm-server-initiated-edits nil)
(defun settled (done) (let ((n 0)) (while (and (not (funcall done)) (< n 600)) (accept-process-output nil 0.05) (setq n (1+ n)))))
(defun text () (buffer-substring-no-properties (point-min) (point-max)))
(defun go (line column) (goto-char (point-min)) (forward-line (1- line)) (forward-char (1- column)))
(defun choose (title) (fset 'completing-read
  (lambda (_prompt collection &rest _)
    (seq-find (lambda (each) (string-match-p (regexp-quote title) each)) (all-completions "" collection)))))
(find-file "O9100.nc")
(apply #'eglot (eglot--guess-contact))
(settled (lambda () (flymake-diagnostics)))
(let ((out (condition-case problem (progn %(script)s) (error (error-message-string problem)))))
  (with-temp-file "%(base)s/out" (insert (json-encode out))))
"""

    def told_by_emacs(self, script):
        if not shutil.which("emacs"):
            self.skipTest("Emacs is not installed (emacs-nox)")
        path = self.base / "run.el"
        path.write_text(self.START % {"emacs": EMACS, "base": self.base, "script": script})
        done = subprocess.run(["emacs", "-Q", "--batch", "--eval", '(progn (let ((default-directory "/usr/share/emacs/site-lisp/elpa/")) (when '
                               '(file-directory-p default-directory) (normal-top-level-add-subdirs-to-load-path))) (kill-emacs (if (require '
                               "'eglot nil t) 0 77)))"], capture_output=True, check=False)
        if done.returncode == 77:
            self.skipTest("eglot is not installed (elpa-eglot, or Emacs 29)")
        return self.told("emacs", "-Q", "--batch", "-l", str(path))

    def test_findings_are_shown(self):
        told = self.told_by_emacs("""
  (mapcar (lambda (each)
            (save-excursion (goto-char (flymake-diagnostic-beg each))
                            (vector (flymake-diagnostic-text each) (line-number-at-pos) (1+ (current-column)))))
          (flymake-diagnostics))""")
        self.assertTrue([row for row in told if LETTER[0] in row[0] and tuple(row[1:]) == LETTER[1:]], told)

    def test_a_fix_is_applied(self):
        self.need("codeActionProvider")
        self.assertEqual(self.told_by_emacs("""(go 4 9) (choose "0") (eglot-code-actions (point) (point) nil t)
  (settled (lambda () (string-match-p "X0\\\\." (text)))) (text)"""), FIXED)

    def test_a_label_is_renamed(self):
        self.need("renameProvider")
        # eglot tells of a change when Emacs has been idle for a moment, which it never is here.
        told = self.told_by_emacs('(go 4 9) (choose "0") (eglot-code-actions (point) (point) nil t) '
                                  '(eglot--signal-textDocument/didChange) (go 5 2) (eglot-rename "N30") (text)')
        self.assertEqual(told, RENAMED)

    def test_hover_tells_what_a_variable_is(self):
        self.need("hoverProvider")
        told = self.told_by_emacs("""(go 3 5)
  (plist-get (plist-get (jsonrpc-request (eglot--current-server-or-lose) :textDocument/hover (eglot--TextDocumentPositionParams))
                        :contents) :value)""")
        self.assertIn("**#100**", told)
        self.assertIn("common variable", told)

    def test_definition_leads_to_the_block(self):
        self.need("definitionProvider")
        told = self.told_by_emacs("""(go 3 17) (xref-find-definitions "LSP identifier at point.")
  (vector (line-number-at-pos) (current-column))""")
        self.assertEqual(told, [5, 1])

    def test_a_rule_is_explained(self):
        self.need("executeCommandProvider")
        told = self.told_by_emacs(f'(maclint-explain "{LETTER[0]}") (with-current-buffer "*maclint page*" (text))')
        self.assertIn(LETTER[0], told)


if __name__ == "__main__":
    unittest.main()
