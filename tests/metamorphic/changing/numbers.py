"""Sequence numbers one higher, together with all that names them."""
import re

from .text import Edit

MOST = {'fanuc': 9999, 'dinplus': 9999}
FANUC_HEAD = re.compile(r'(?:^|(?<=[\r\n;%]))[ \t]*(?:/[1-9]?[ \t]*)*N[ \t]*(\d+)', re.IGNORECASE)
COMPUTED = {
    'fanuc': re.compile(r'GO[ \t]*TO[ \t]*[^\d \t]|M[ \t]*9[79][^;\r\n]*P[ \t]*[#\[]|N[ \t]*[#\[]|#[ \t]*4[01234]14', re.IGNORECASE),
    'dinplus': re.compile(r'N[SE]?[ \t]*[#(_]|N[SE][^"\r\n]*\+'),
}
NAMES = {
    # GOTO n; M97, M99 P n; M98 P Q n; (G70-G73 are looked at apart: on a mill they have other words)
    'fanuc': re.compile(r'GO[ \t]*TO[ \t]*(\d+)|M[ \t]*9[79](?!\d)[^;\r\n(]*?P[ \t]*(\d+)|M[ \t]*98(?!\d)[^;\r\n(]*?Q[ \t]*(\d+)', re.IGNORECASE),
    'dinplus': re.compile(r'(?<![A-Z])N[SE][ \t]*(\d+)'),
}
CONTOUR = re.compile(r'G[ \t]*7[0-3](?![\d.])[^;\r\n(]*?P[ \t]*(\d+)(?![\d.])[^;\r\n(]*?Q[ \t]*(\d+)(?![\d.])', re.IGNORECASE)
DINPLUS_HEAD = re.compile(r'(?:^|(?<=[\r\n]))[ \t]*(?:[$/]\d*[ \t]*)*N[ \t]*(\d+)')


def code_of(text, language):
    """Comments and texts as blanks: nothing in them is a number of a block."""
    hidden = re.compile(r'\([^)\r\n]*\)?|(?:DPRNT|BPRNT)[^\r\n;]*' if language == 'fanuc' else r'\[[^\]]*\]?|"[^"\r\n]*"?|(?:;|//)[^\r\n]*')
    return hidden.sub(lambda match: ' ' * len(match.group()), text)


def places(text, language):
    """(begin, end) of each number of a block, and of each that names one; None where some are calculated."""
    code = code_of(text, language)
    if COMPUTED[language].search(code):
        return None
    heads = [match.span(1) for match in (FANUC_HEAD if language == 'fanuc' else DINPLUS_HEAD).finditer(code)]
    labels = {int(text[begin:end]) for begin, end in heads}
    named = [match.span(group) for match in NAMES[language].finditer(code) for group in range(1, NAMES[language].groups + 1)
             if match.group(group)]
    if language == 'fanuc':
        for match in CONTOUR.finditer(code):
            if {int(match.group(1)), int(match.group(2))} <= labels:
                named += [match.span(1), match.span(2)]
    return sorted(set(heads) | set(named))


def renumber(program, rng):
    found = places(program.text, program.language)
    if not found:
        return None
    numbers = [program.text[begin:end] for begin, end in found]
    if any(int(number) >= MOST[program.language] or int(number) == 0 for number in numbers):
        return None
    return [Edit(begin, end, str(int(number) + 1).zfill(len(number))) for (begin, end), number in zip(found, numbers)]
