"""Defects of DIN PLUS programs, told line by line; sections and keywords in English and German."""
import re
from dataclasses import dataclass

from . import (dinplus_contour, dinplus_flow, dinplus_left, dinplus_needs, dinplus_order, dinplus_references, dinplus_slides,
               dinplus_words)
from .dinplus_reader import HEAD, Program

MACHINING = re.compile(r'(?:MACHINING|BEARBEITUNG)\s*$')
SUBPROGRAM = re.compile(r'(?:SUBPROGRAM|UNTERPROGRAMM)\s*"([^"]+)"')
RETURN = re.compile(r'(?:RETURN)\b')
END = re.compile(r'(?:END|ENDE)\s*$')
VARIABLE = re.compile(r'#(l\d+|_[a-z]\w*)', re.I)
BEFORE = r'^\s*(?:\$\d\s*)*(?:N\s*\d+\s+)?'  # slides and number of a block
STORE = re.compile(BEFORE + r'#(l\d+|_[a-z]\w*)\s*=(?!=)\s*(.*)$', re.I)
STEP = re.compile(BEFORE + r'#(l\d+|_[a-z]\w*)\s*=\s*#\1\s*([+-])\s*(\d+\.?\d*)\s*$', re.I)
WHILE = re.compile(r'WHILE\s+#(l\d+|_[a-z]\w*)\s*(<=?|>=?)\s*(.+?)\s*$', re.I)
CALL = re.compile(r'L\s*"([^"]+)"(.*)$')
WHOLE = (dinplus_words, dinplus_order, dinplus_needs, dinplus_left, dinplus_references, dinplus_slides, dinplus_contour, dinplus_flow)
TRANSFERRED = re.compile(r'#__(\w+)')


def code_of(lines):
    """The lines with blanks where comments are; a comment may go on over several lines."""
    out, inside = [], False
    for text in lines:
        code = []
        for char in text.rstrip('\r'):
            inside = inside or char == '['
            code.append(' ' if inside else char)
            inside = inside and char != ']'
        out.append(''.join(code))
    return out


@dataclass
class Routine:
    """The blocks of the main program's machining part, or of a subprogram."""
    first: int
    last: int
    name: str  # '' for the main program


def routines_of(codes):
    found, start, name = [], None, ''
    for line, code in enumerate(codes):
        named = SUBPROGRAM.search(code)
        if named or MACHINING.match(code.strip()):
            if start is not None:
                found.append(Routine(start, line, name))
            start, name = line + 1, named.group(1) if named else ''
        elif start is not None and (END.match(code.strip()) or RETURN.match(code.strip())):
            found.append(Routine(start, line + 1, name))
            start = None
    return found + ([Routine(start, len(codes), name)] if start is not None else [])


def head_of(code):
    return HEAD.match(code).end()


def drop(line, code):
    return [(line, (head_of(code), len(code)), '')]


def cut(line, match, group=0, text=''):
    return [(line, match.span(group), text)]


def plants(lines, libraries, clean=True):
    """(class, edits, why it is harmless). `libraries`: codes of the programs that are read together, by name. `clean`: the
    program is known to have no defect of its own, so that the slips in whole programs are planted, too."""
    codes = code_of(lines)
    machining = next((line for line, code in enumerate(codes) if MACHINING.match(code.strip())), None)
    yield from sections(codes)
    program = Program(codes)
    if clean and program.whole:
        for module in WHOLE:
            yield from module.plants(program)
    if machining is None:
        return
    for line in range(machining + 1, len(codes)):
        yield from structure(line, codes)
        yield from words(line, codes)
    for routine in routines_of(codes):
        yield from variables(routine, codes)
        yield from loops(routine, codes)
        yield from cancels(routine, codes)
    yield from calls(codes, machining, libraries)


def sections(codes):
    for line, code in enumerate(codes):
        text = code.strip()
        main = any(END.match(other.strip()) for other in codes)
        if MACHINING.match(text) and main:
            yield 'din-section-removed', drop(line, code), ''
        elif END.match(text):
            yield 'din-end-removed', drop(line, code), ''
        elif RETURN.match(text):
            yield 'din-return-removed', drop(line, code), ''


KEYWORDS = [('din-if-open', 'ENDIF'), ('din-then-removed', 'THEN'), ('din-while-open', 'ENDWHILE'), ('din-switch-open', 'ENDSWITCH'),
            ('din-unit-open', 'END_OF_UNIT'), ('din-if-gone', 'IF'), ('din-while-gone', 'WHILE'), ('din-break-removed', 'BREAK')]


def structure(line, codes):
    code = codes[line]
    word = re.match(r'[A-Z_]+', code[head_of(code):])
    for kind, keyword in KEYWORDS:
        if word and word.group() == keyword:
            harmless = ''
            if kind == 'din-break-removed':
                following = next((other[head_of(other):] for other in codes[line + 1:] if other.strip()), '')
                harmless = 'the last branch' if following.startswith('ENDSWITCH') else ''
            yield kind, drop(line, code), harmless
    if word and word.group() == 'IF':
        after = line + 1
        if after < len(codes) and codes[after][head_of(codes[after]):].strip() == 'THEN':
            yield 'din-joined', [(line, (len(code.rstrip()), len(code)), ' THEN'), *drop(after, codes[after])], ''


def numbers_in(codes):
    return {int(number) for number in (HEAD.match(code).group(2) for code in codes) if number}


def words(line, codes):
    code = codes[line]
    condition = re.search(r'\b(?:IF|WHILE)\b.*?(==)', code)
    if condition:
        yield 'din-assigned', cut(line, condition, 1, '='), ''
    store = STORE.match(code)
    if store:
        yield 'din-compared', [(line, (code.index('='), code.index('=') + 1), '==')], ''
    defined = re.search(r'N?DEF\((?=_)', code)
    if defined:
        yield 'din-def-hash', [(line, (defined.end(), defined.end()), '#')], ''
    contour = re.search(r'\bG8\d\d?\b.*?\bN[SE](\d+)', code)
    if contour:
        numbers = numbers_in(codes)
        yield 'din-contour-nowhere', cut(line, contour, 1, str(max(numbers) + 7)), ''
    restart = re.search(r'\bM99\s+NS(\d+)', code)
    if restart:
        numbers = numbers_in(codes)
        yield 'din-restart-nowhere', cut(line, restart, 1, str(max(numbers) + 7)), ''
    if '(' in code and '"' not in code and code.count('(') == code.count(')'):
        yield 'din-bracket-unclosed', [(line, (code.rindex(')'), code.rindex(')') + 1), '')], ''
        yield 'din-bracket-unopened', [(line, (code.index('('), code.index('(') + 1), '')], ''


def reads(variable, code):
    store = STORE.match(code)
    text = store.group(2) if store else code
    if re.search(rf'INPUT\(.*#{variable}\)', text, re.I) or re.search(rf'N?DEF\(#?{variable}\)', text, re.I):
        return False
    return re.search(rf'#{variable}(?!\w)', text, re.I) is not None


def stores(variable, code):
    store = STORE.match(code)
    return bool(store and store.group(1).lower() == variable) or re.search(rf'INPUT\(.*#{variable}\)', code, re.I) is not None


def variables(routine, codes):
    """The only assignment, or that of one side of IF … ELSE, of a variable that is read afterwards."""
    text = '\n'.join(codes)
    for line in range(routine.first, routine.last):
        store = STORE.match(codes[line])
        if not store or STEP.match(codes[line]):
            continue
        variable = store.group(1).lower()
        own = [at for at in range(routine.first, routine.last) if stores(variable, codes[at])]
        aliased = re.search(rf'^#{variable}=#l\d+\(', text, re.I | re.M)
        free = variable.startswith('l') or re.search(rf'^#{variable}=#l\d+\s*$', text, re.I | re.M)
        if aliased or not free:
            continue
        first = next((at for at in range(line + 1, routine.last) if reads(variable, codes[at])), None)
        harmless = '' if first is not None else 'nothing reads the variable afterwards'
        if re.search(rf'N?DEF\(#?{variable}\)', text, re.I):
            harmless = harmless or 'the program looks whether it is defined'
        if harmless == '' and len(own) == 1:
            yield 'din-assignment-removed', drop(line, codes[line]), ''
        elif harmless == '' and len(own) == 2 and sides(codes, own) and first > own[1]:
            yield 'din-case-removed', drop(line, codes[line]), ''
        elif harmless:
            yield 'din-assignment-removed', drop(line, codes[line]), harmless


def sides(codes, lines):
    """Whether the two lines are the two sides of one IF, with no other IF in between."""
    between = [codes[at][head_of(codes[at]):].strip() for at in range(lines[0] + 1, lines[1])]
    return between.count('ELSE') == 1 and not any(text.startswith(('IF', 'ENDIF', 'CASE', 'DEFAULT', 'WHILE')) for text in between)


def loops(routine, codes):
    for line in range(routine.first, routine.last):
        loop = WHILE.search(codes[line])
        if not loop:
            continue
        end = closing(codes, line, routine.last)
        counter = loop.group(1).lower()
        inside = [at for at in range(line + 1, end) if stores(counter, codes[at])]
        step = STEP.match(codes[inside[0]]) if len(inside) == 1 else None
        if not step:
            continue
        limit = {name.lower() for name in VARIABLE.findall(loop.group(3))}
        leaves = any(re.search(r'\bM0*(?:0|1|30|99)\b|RETURN', codes[at]) for at in range(line + 1, end))
        changed = any(stores(name, codes[at]) for name in limit for at in range(line + 1, end))
        harmless = 'the loop may stop or leave otherwise' if leaves or changed else ''
        rising = loop.group(2).startswith('<')
        yield 'din-step-removed', drop(inside[0], codes[inside[0]]), harmless
        yield 'din-step-zero', cut(inside[0], step, 3, '0'), harmless
        wrong = harmless or ('' if (step.group(2) == '+') == rising else 'the sign was not that of the relation')
        yield 'din-step-sign', cut(inside[0], step, 2, '-' if step.group(2) == '+' else '+'), wrong


def closing(codes, start, last):
    depth = 0
    for line in range(start, last):
        text = codes[line][head_of(codes[line]):]
        depth += text.startswith('WHILE') - text.startswith('ENDWHILE')
        if depth == 0:
            return line
    return last


CANCELS = [('din-compensation-left', r'\bG4[12]\b', r'\bG40\b'), ('din-plane-left', r'\bG16\s+B', r'\bG16\s*$'),
           ('din-shift-left', r'\bG92[01]\b', r'\bG98[01]\b'), ('din-conversion-left', r'\bG30\s+H[1-9]', r'\bG30\s+H0')]


def cancels(routine, codes):
    for kind, start, stop in CANCELS:
        active = False
        for line in range(routine.first, routine.last):
            active = active or re.search(start, codes[line]) is not None
            off = re.search(stop, codes[line])
            if off and active:
                later = any(re.search(stop, codes[at]) for at in range(line + 1, routine.last))
                yield kind, cut(line, off), 'it is cancelled later, too' if later and kind != 'din-compensation-left' else ''
                active = False


def calls(codes, machining, libraries):
    """What callers pass and callees read."""
    for line in range(machining + 1, len(codes)):
        call = CALL.search(codes[line])
        if call and call.group(1).upper() in libraries:
            yield 'din-program-missing', cut(line, call, 1, call.group(1) + 'X'), ''
            callee = libraries[call.group(1).upper()]
            for letter in re.finditer(r'\bL([A-KO-Z])(?=[-\d#.])', call.group(2)):
                at = call.start(2) + letter.start()
                end = re.compile(r'\s|$').search(codes[line], at).start()
                yield 'din-letter-removed', [(line, (at, end), '')], unread(callee, 'l' + letter.group(1).lower())
        read = TRANSFERRED.search(codes[line])
        if read:
            yield 'din-letter-unknown', cut(line, read, 1, 'lg'), ''


def unread(callee, name):
    guarded = any(re.search(rf'N?DEF\(__{name}\)', code) for code in callee)
    used = any(re.search(rf'#__{name}(?!\w)', code) for code in callee)
    return 'the callee looks whether it is passed' if guarded else '' if used else 'the callee does not read it'
