"""State that Fanuc programs save and put back: returns that go round it, restores left out, the wrong thing saved."""
import re

from .edit import drop, put
from .fanuc import RETURN

SAVE = re.compile(r'#\s*(\d+)\s*=\s*#\s*(4\d\d\d)\s*$')
LETTERS = {'4107': 'D', '4109': 'F', '4111': 'H', '4113': 'M', '4119': 'S', '4120': 'T'}
WORD = re.compile(r'(?<![A-Z])([GFS])\s*(?:#\s*(\d+)|\[\s*#\s*(\d+)\s*\])(?!\s*[-+*/\]\d.])')
# The codes of a group that shops take for granted, by the number of its system variable.
CUSTOMARY = {'4002': {'17'}, '4003': {'90'}, '4005': {'94', '98'}, '4006': {'21', '71'}, '4007': {'40'}, '4008': {'49'}, '4009': {'80'},
             '4010': {'98'}, '4011': {'50'}, '4013': {'97'}, '4015': {'64'}, '4016': {'69'}, '4017': {'15'}}
OTHERS = {'4002': {'18', '19'}, '4003': {'91'}, '4005': {'93', '95', '99'}, '4006': {'20', '70'}, '4007': {'41', '42'},
          '4008': {'43', '44'}, '4010': {'99'}, '4011': {'51'}, '4013': {'96'}, '4015': {'61', '62', '63'}, '4016': {'68'}, '4017': {'16'}}
# Variables that are easily taken for one another.
EXCHANGED = {'4109': ['4119', '4001'], '4119': ['4109', '4003'], '4001': ['4003', '4109'], '4003': ['4001', '4109'],
             '4002': ['4003', '4012'], '4005': ['4006', '4003'], '4006': ['4005', '4003'], '4007': ['4008', '4001'], '4008': ['4007', '4003']}


def plants(program):
    saved = saved_groups(program)
    for index, sources in restores(program, saved):
        block = program.blocks[index]
        if program.returns:
            yield from early_returns(block)
            yield from restores_removed(program, block, sources)
    yield from wrong_saves(program, saved)


def saved_groups(program):
    """By variable: (block, number of the system variable) of each plain save."""
    found = {}
    for index, block in enumerate(program.blocks):
        save = SAVE.search(block.code)
        if save and letter_of(save.group(2)):
            found.setdefault(int(save.group(1)), []).append((index, save.group(2)))
    return found


def letter_of(source):
    """The address whose word puts the value back; '' where it is no modal state that a program puts back."""
    return 'G' if 4001 <= int(source) <= 4030 else {'F': 'F', 'S': 'S'}.get(LETTERS.get(source), '')


def restores(program, saved):
    """(block, numbers of the system variables) of each block that puts saved state back."""
    for index, block in enumerate(program.blocks):
        sources = [source for word in WORD.finditer(block.code) for at, source in saved.get(int(word.group(2) or word.group(3)), [])
                   if letter_of(source) == word.group(1) and index in program.reach(program.successors[at])]
        if sources and index in program.reachable and not (RETURN.search(block.code) and block.conditional):
            yield index, sorted(set(sources))


def early_returns(block):
    """An M99 of its own in front of the block that puts back: always, or where the block is not skipped. A jump to the block
    takes it, too."""
    number = re.match(r'\s*(N\s*\d+)?', block.code)
    head, text = number.span(), number.group().strip()
    if not block.skipped:
        yield 'return-early', put(block, head, f'{text}M99\n'), ''
        yield 'return-skipped', put(block, head, f'/{text}M99\n'), ''


def restores_removed(program, block, sources):
    """The block, where it holds nothing but words that put back; with M99 these words alone."""
    rest = RETURN.sub('', re.sub(r'^\s*/?\s*(?:N\s*\d+)?', '', WORD.sub('', block.code))).strip()
    if rest or block.conditional:
        return
    kind = 'restore-removed-customary' if all(only_customary(program, source) for source in sources) else 'restore-removed'
    words = list(WORD.finditer(block.code))
    yield kind, [(block.line, (words[0].start(), words[-1].end()), '')] if RETURN.search(block.code) else drop(block), ''


def only_customary(program, source):
    """Whether the program sets the group to its customary code and to no other by a literal word."""
    codes = {code.lstrip('0') for block in program.blocks for code in re.findall(r'G\s*(\d+)(?![\d.])', block.code)}
    return bool(codes & CUSTOMARY.get(source, set())) and not codes & OTHERS.get(source, set())


def wrong_saves(program, saved):
    """Each saving variable exchanged for others."""
    for variable, places in saved.items():
        letters = {word.group(1) for block in program.blocks for word in WORD.finditer(block.code)
                   if int(word.group(2) or word.group(3)) == variable}
        for index, source in places:
            if letter_of(source) not in letters or index not in program.reachable:
                continue
            block = program.blocks[index]
            at = block.code.rindex(source)
            for other in EXCHANGED.get(source, ['4003', '4109']):
                kind = 'saved-wrong' if letter_of(other) != letter_of(source) else 'saved-other-group'
                yield kind, put(block, (at, at + 4), other), ''

