"""Which lines of a program show a defect: those that are changed, and those that name what they name."""
import re

from .fanuc import CALL, PROGRAM_END, RETURN, VARIABLE, code_of

LABEL = re.compile(r'^\s*/?\s*N\s*0*(\d+)|GOTO\s*0*(\d+)')
LOOP = re.compile(r'(?:DO|END)\s*(\d+)')
PROGRAM = re.compile(r'P\s*0*(\d+)(?![\d.])|^\s*(?:O|:)\s*0*(\d+)')
CODE = re.compile(r'G\s*0*(\d+(?:\.\d)?)(?![\d.])')
COPIED = re.compile(r'(?<![A-Z])[GFS]\s*[#\[]')
LETTER = {'A': 1, 'B': 2, 'C': 3, 'D': 7, 'E': 8, 'F': 9, 'H': 11, 'I': 4, 'J': 5, 'K': 6, 'M': 13, 'Q': 17, 'R': 18, 'S': 19, 'T': 20,
          'U': 21, 'V': 22, 'W': 23, 'X': 24, 'Y': 25, 'Z': 26}
GROUPS = [{'0', '1', '2', '3', '33', '80', '81', '82', '83', '84', '85', '86', '87', '88', '89', '73', '74', '76'}, {'17', '18', '19'},
          {'90', '91'}, {'93', '94', '95'}, {'20', '21'}, {'40', '41', '42'}, {'43', '44', '49'}, {'98', '99'}, {'50', '51'},
          {'50.1', '51.1'}, {'66', '67'}, {'96', '97'}, {'68', '69'}, {'15', '16'}, {'61', '62', '63', '64'}]
MODAL = ('modal', 'saved state')


def names_in(code):
    """What a line names, each with its kind."""
    found = {('#', int(number)) for number in VARIABLE.findall(code)} - {('#', 0)}
    found |= {('N', int(a or b)) for a, b in LABEL.findall(code)}
    found |= {('DO', number) for number in LOOP.findall(code)}
    found |= {('O', int(a or b)) for a, b in PROGRAM.findall(code)}
    for number in CODE.findall(code):
        found |= {('G', index) for index, group in enumerate(GROUPS) if number in group}
    if CALL.search(code):
        found |= {('#', LETTER[letter]) for letter in re.findall(r'(?<![A-Z])([A-Z])\s*-?[#\[\d.]', code) if letter in LETTER}
    found |= {('word', letter) for letter in re.findall(r'(?<![A-Z])([FS])\s*-?[#\[\d.]', code)}
    return found


def lines_that_show(lines, changes, group):
    """From 1 on. Of modal state the exits and what puts copies back show it, too, and of a program that runs on its last line."""
    codes = [code_of(line) for line in lines]
    named = set().union(*(names_in(codes[line]) | names_in(code_of(new)) for line, new in changes.items()))
    shown = {line + 1 for line in changes}
    for line, code in enumerate(codes):
        leaves = RETURN.search(code) or PROGRAM_END.search(code)
        if names_in(code) & named or (group in MODAL and (leaves or COPIED.search(code))) or (group == 'calls' and leaves):
            shown.add(line + 1)
    if group == 'calls':
        shown |= {line + 1 for line in last_lines(codes, changes)}
    return shown


def last_lines(codes, changes):
    """The last block of each program without what is changed: there the control runs off."""
    last, found = None, set()
    for line, code in enumerate([*codes, 'O0']):
        code = code_of(changes.get(line, code)) if line < len(codes) else code
        if re.match(r'\s*[O:]\s*\d', code) and last is not None:
            found.add(last)
        if code.replace('%', '').strip():
            last = line
    return found


def is_shown_elsewhere(line, group):
    """Whether a line of another program shows it: a call, or in the classes of calls each line."""
    return group == 'calls' or CALL.search(code_of(line)) is not None
