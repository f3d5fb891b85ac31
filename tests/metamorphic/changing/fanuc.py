"""Fanuc programs in pieces: what a change may touch, and what not."""
import re

from .text import pieces_of

KEYWORDS = ('WHILE', 'GOTO', 'THEN', 'END', 'IF', 'DO', 'EQ', 'NE', 'GT', 'GE', 'LT', 'LE', 'AND', 'XOR', 'OR', 'MOD', 'NOT')
FOREIGN = ('ENDIF', 'ELSEIF', 'FOR', 'ENDFOR', 'LTE', 'GTE', 'NEQ', 'ORG')  # words of other languages that begin or end like keywords
COMMENT = '(K)'

# Texts that are no code: what DPRNT prints, names of programs and variables, folder marks and data of a memory dump.
TOKEN = re.compile(r'''
    (?P<fixed>&[A-Za-z]=[^\r\n;]*
      | (?:DPRNT|BPRNT|SETVN)[^\r\n;]*
      | [<>=!]=|=[<>]|<>
      | <[^>\r\n;(\#\[]*> | \#[ \t]*<[^>\r\n]*> | \#[ \t]*[A-Za-z_]\w*
      | [A-Za-z]*_\w*\[? | [\000%\x1a] | [^\x00-\x7f]+ | &[A-Za-z]?)
  | (?P<comment>\([^)\r\n]*\)?)
  | (?P<end>;|\r\n|\n\r*|\r)
  | (?P<blank>[ \t]+)
  | (?P<letters>[A-Za-z]+)
  | (?P<number>[0-9.]+)
  | (?P<sign>.)''', re.VERBOSE | re.IGNORECASE)


def pieces(text):
    """Text before the first tape mark and after the last is none of the control's business."""
    return pieces_of(text, TOKEN, lambda match: match.lastgroup, code_of(text))


def code_of(text):
    """(begin, end) of what stands between the line of the first tape mark and the line of the last."""
    marks = [match.start() for match in re.finditer(r'^[ \t\ufeff\000]*%', text, re.MULTILINE)]
    if not marks:
        return 0, len(text)
    first = re.match(r'[^\r\n;]*', text[marks[0]:]).end() + marks[0]
    before = text[:marks[0]].strip(' \t\r\n\0\xef\xbb\xbf')
    begin = 0 if before else first
    end = marks[-1] if len(marks) > 1 or before else len(text)
    return min(begin, end), end


def keywords_in(letters):
    """Letters in a row as keywords and addresses: THENGOTO is two words, GOTO one; what is neither stays one."""
    words, at = [], 0
    capitals = letters.upper()
    while at < len(letters):
        words.append(next((word for word in KEYWORDS if capitals.startswith(word, at)), capitals[at]))
        at += len(words[-1])
    plain = sum(len(word) == 1 for word in words)
    return [capitals] if capitals in FOREIGN or plain > 1 or plain and len(words[-1]) > 1 else words
