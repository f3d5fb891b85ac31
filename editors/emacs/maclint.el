;;; maclint.el --- NC programs: modes, maclint in the compilation buffer, flycheck  -*- lexical-binding: t; -*-

;; Package-Requires: ((emacs "26.1"))
;; License: MIT

;;; Commentary:

;; (load "/path/to/editors/emacs/maclint") opens .nc, .tap, .cnc, .min, .ncs, .ncd, .eia, O1234, and .mpf, .spf, .arc,
;; .cpf and .def of SINUMERIK, as NC programs.  M-x eglot starts the language server.
;; M-x maclint checks the program of the buffer together with those around it, C-u M-x maclint the whole folder;
;; M-g n goes to the next finding.  Where flycheck is installed, M-x flycheck-mode shows findings as you type.

;;; Code:

(require 'compile)

(defgroup maclint nil "Findings in NC programs." :group 'tools)

(defcustom maclint-program "maclint"
  "The executable."
  :type 'string)

(defcustom maclint-options nil
  "Further options, such as (\"--control\" \"fanuc-16i\")."
  :type '(repeat string))

;; The buffer is a terminal to maclint, which gets colours and no more than 100 findings.
(defconst maclint-report '("--format" "concise" "--quiet" "--color" "never" "--max-findings" "all")
  "Options of the report that is read here.")

;; O9100.nc:3:12: error[MAC303] Jump into a loop: ...
(defconst maclint-line
  "^\\(.+?\\):\\([0-9]+\\):\\([0-9]+\\): \\(?:error\\|\\(warning\\)\\|\\(note\\)\\)\\[[^]]+\\] "
  "A finding of the concise report.  Columns count from 1.")

(define-compilation-mode maclint-compilation-mode "maclint"
  "Findings of maclint, and nothing that looks like those of a compiler."
  (setq-local compilation-error-regexp-alist '(maclint))
  (setq-local compilation-error-regexp-alist-alist `((maclint ,maclint-line 1 2 3 (4 . 5))))
  (setq-local compilation-first-column 1)
  ;; Letters, not the width that a tab has on the screen.
  (setq-local compilation-error-screen-columns nil))

;; M-x compile understands maclint as well, as a step of a Makefile.
(add-to-list 'compilation-error-regexp-alist-alist `(maclint ,maclint-line 1 2 3 (4 . 5)))
(add-to-list 'compilation-error-regexp-alist 'maclint)

;;;###autoload
(defun maclint (&optional whole-folder)
  "Check the program of this buffer, with WHOLE-FOLDER all programs of its folder."
  (interactive "P")
  (save-some-buffers (not compilation-ask-about-save))
  (compilation-start
   (mapconcat #'shell-quote-argument
              `(,maclint-program ,@maclint-report ,@maclint-options "--"
                ,(if (or whole-folder (not buffer-file-name)) "." (file-relative-name buffer-file-name)))
              " ")
   'maclint-compilation-mode (lambda (_) "*maclint*")))

;;; Modes

(defconst maclint-fanuc-keywords
  '(("\\<\\(IF\\|THEN\\|GOTO\\|WHILE\\|DO\\|END\\|POPEN\\|PCLOS\\|DPRNT\\|BPRNT\\|SETVN\\)\\(?:\\>\\|[0-9#]\\)" 1 font-lock-keyword-face)
    ("^[ \t/0-9]*\\([:O][ \t]*[0-9]+\\)" 1 font-lock-function-name-face)
    ("^[ \t/0-9]*\\(N[ \t]*[0-9]+\\)" 1 font-lock-constant-face)
    ("#[ \t]*\\(?:[0-9]+\\|_[A-Z0-9_]+\\|<[^>\n]*>\\)" 0 font-lock-variable-name-face)))

;;;###autoload
(define-derived-mode maclint-fanuc-mode prog-mode "Fanuc"
  "Fanuc macro code."
  (modify-syntax-entry ?\( "<")
  (modify-syntax-entry ?\) ">")
  (modify-syntax-entry ?\n ">")
  (setq-local comment-start "(" comment-end ")" comment-start-skip "([ \t]*")
  (setq-local font-lock-defaults '(maclint-fanuc-keywords nil t)))

(defconst maclint-dinplus-keywords
  '(("\\<\\(IF\\|THEN\\|ELSE\\|ENDIF\\|WHILE\\|ENDWHILE\\|SWITCH\\|CASE\\|DEFAULT\\|BREAK\\|ENDSWITCH\\|RETURN\\|PRINT\\|INPUT\\|WINDOW\\|UNIT\\|END_OF_UNIT\\)\\>"
     1 font-lock-keyword-face)
    ("^[ \t]*\\(\\(?:[[:upper:]]\\{3,\\}[ _]?\\)+\\)" 1 font-lock-function-name-face)
    ("^[ \t$/0-9]*\\(N[ \t]*[0-9]+\\)" 1 font-lock-constant-face)
    ("#[ \t]*_*[a-z0-9_]+" 0 font-lock-variable-name-face)))

;;;###autoload
(define-derived-mode maclint-dinplus-mode prog-mode "DIN PLUS"
  "HEIDENHAIN DIN PLUS."
  (modify-syntax-entry ?\[ "<")
  (modify-syntax-entry ?\] ">")
  (setq-local comment-start "[" comment-end "]" comment-start-skip "\\[[ \t]*")
  (setq-local case-fold-search nil)
  (setq-local font-lock-defaults '(maclint-dinplus-keywords nil nil)))

(defconst maclint-sinumerik-keywords
  '(("\\<\\(IF\\|ELSE\\|ENDIF\\|CASE\\|OF\\|DEFAULT\\|GOTO[FBCS]?\\|FOR\\|TO\\|ENDFOR\\|LOOP\\|ENDLOOP\\|WHILE\\|ENDWHILE\\|REPEATB?\\|UNTIL\\|PROC\\|EXTERN\\|MCALL\\|P?CALL\\|DEF\\|REDEF\\|DEFINE\\|AS\\|VAR\\|WHEN\\|WHENEVER\\|EVERY\\|FROM\\|DO\\|RET\\)\\>"
     1 font-lock-keyword-face)
    ("^%_N_.*" 0 font-lock-function-name-face)
    ("\\<PROC[ \t]+\\([A-Z_][A-Z0-9_]*\\)" 1 font-lock-function-name-face)
    ("\\<\\(INT\\|REAL\\|BOOL\\|CHAR\\|STRING\\|AXIS\\|FRAME\\)\\>" 1 font-lock-type-face)
    ("^[ \t/0-9]*\\(N[ \t]*[0-9]+\\|[A-Z_][A-Z_][A-Z0-9_]*:\\)" 1 font-lock-constant-face)
    ("\\(?:\\$\\$?[A-Z_][A-Z0-9_]*\\|\\<R[0-9]+\\>\\)" 0 font-lock-variable-name-face)))

;;;###autoload
(define-derived-mode maclint-sinumerik-mode prog-mode "SINUMERIK"
  "SIEMENS SINUMERIK."
  (modify-syntax-entry ?\; "<")
  (modify-syntax-entry ?\n ">")
  (modify-syntax-entry ?_ "w")
  (setq-local comment-start ";" comment-end "" comment-start-skip ";+[ \t]*")
  (setq-local font-lock-defaults '(maclint-sinumerik-keywords nil t)))

;; Only DIN PLUS has header entries (#UNIT METRIC), comments in brackets, and sections: capital words without a number.
(defconst maclint-dinplus-line
  "^[ \t]*\\(?:#[[:upper:]]\\{2,\\}\\|\\[[/ ]*[[:alpha:]]\\|\\([[:upper:]]\\{4,\\}\\)\\(?:[[ _\"]\\|\r?$\\)\\)")

(defun maclint--is-dinplus ()
  "Whether one of the first hundred lines, or the name, tells DIN PLUS."
  (let ((case-fold-search nil) (found nil))
    (save-excursion
      (goto-char (point-min))
      (while (and (not found) (re-search-forward maclint-dinplus-line (line-end-position 100) t))
        (setq found (not (member (match-string 1) '("GOTO" "WHILE" "POPEN" "PCLOS" "DPRNT" "BPRNT" "SETVN"))))))
    (or found (and buffer-file-name (string-match-p "\\.[nN][cC][sS]\\'" buffer-file-name)))))

(defun maclint--is-sinumerik ()
  "Whether the name, or a head that the control has written, tells SINUMERIK."
  (or (and buffer-file-name (string-match-p "\\.\\(?:mpf\\|spf\\|arc\\|cpf\\|def\\)\\'" (downcase buffer-file-name)))
      (save-excursion
        (goto-char (point-min))
        (re-search-forward "^[ \t]*\\(?:%_N_\\|;\\$PATH=\\)" (line-end-position 100) t))))

;;;###autoload
(defun maclint-mode ()
  "The mode of an NC program: its name tells little, so the first lines decide."
  (interactive)
  (cond ((maclint--is-sinumerik) (maclint-sinumerik-mode))
        ((maclint--is-dinplus) (maclint-dinplus-mode))
        (t (maclint-fanuc-mode))))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.\\(?:[nN][cC]\\|[tT][aA][pP]\\|[cC][nN][cC]\\|[mM][iI][nN]\\|[nN][cC][sS]\\|[nN][cC][dD]\\|[eE][iI][aA]\\|[mM][pP][fF]\\|[sS][pP][fF]\\|[aA][rR][cC]\\|[cC][pP][fF]\\|[dD][eE][fF]\\)\\'" . maclint-mode))
;;;###autoload
(add-to-list 'auto-mode-alist '("/[oO][0-9]+\\(?:[_ (-][^./]*\\)?\\'" . maclint-mode))

;;; Language server

;; M-x eglot. The server knows languages by the ids below.
(defvar eglot-server-programs)
(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs
               `((maclint-fanuc-mode maclint-dinplus-mode maclint-sinumerik-mode) . (,maclint-program "lsp"))))
(put 'maclint-fanuc-mode 'eglot-language-id "fanuc")
(put 'maclint-dinplus-mode 'eglot-language-id "dinplus")
(put 'maclint-sinumerik-mode 'eglot-language-id "sinumerik")

(declare-function eglot-current-server "eglot")
(declare-function jsonrpc-request "jsonrpc")
(declare-function eglot--apply-workspace-edit "eglot")

(defun maclint--ask (command &rest arguments)
  "What the server answers to COMMAND with ARGUMENTS."
  (jsonrpc-request (or (eglot-current-server) (user-error "No server reads this buffer: M-x eglot"))
                   :workspace/executeCommand `(:command ,command :arguments ,(vconcat arguments))))

(defun maclint--show-page (page)
  "Show PAGE, which the server has answered."
  (with-current-buffer (get-buffer-create "*maclint page*")
    (let ((inhibit-read-only t))
      (erase-buffer)
      (insert (plist-get page :markdown)))
    (goto-char (point-min))
    (special-mode)
    (display-buffer (current-buffer))))

(defun maclint-explain (code)
  "Show the page of the rule CODE, such as MAC303."
  (interactive "sRule: ")
  (maclint--show-page (maclint--ask "maclint.explain" code)))

(defun maclint-renumber ()
  "Renumber the blocks of this program, with all that jumps to them."
  (interactive)
  (let ((edit (maclint--ask "maclint.renumber" (plist-get (eglot--TextDocumentIdentifier) :uri))))
    (when edit (eglot--apply-workspace-edit edit))))

(declare-function eglot--TextDocumentIdentifier "eglot")
(with-eval-after-load 'eglot
  ;; "Explain MAC303" among the code actions is a command whose answer eglot would not show.
  (eval
   '(cl-defmethod eglot-execute-command (_server (_command (eql maclint.explain)) arguments)
      (maclint-explain (elt arguments 0)))
   t))

;;; Flycheck

(with-eval-after-load 'flycheck
  (eval
   '(progn
      ;; The text of the buffer goes to standard input under the file's name, so that programs around it are read and
      ;; nothing is written.
      (flycheck-define-checker maclint
        "Findings of maclint in an NC program."
        :command ("maclint" "--format" "concise" "--quiet" (eval maclint-options)
                  "--stdin-filename" source-original "-")
        :standard-input t
        :error-patterns
        ((error line-start (file-name) ":" line ":" column ": error[" (id (+ (not (any "]")))) "] " (message) line-end)
         (warning line-start (file-name) ":" line ":" column ": warning[" (id (+ (not (any "]")))) "] " (message) line-end)
         (info line-start (file-name) ":" line ":" column ": note[" (id (+ (not (any "]")))) "] " (message) line-end))
        :predicate (lambda () buffer-file-name)
        :modes (maclint-fanuc-mode maclint-dinplus-mode maclint-sinumerik-mode))
      (add-to-list 'flycheck-checkers 'maclint))
   t))

(provide 'maclint)
;;; maclint.el ends here
