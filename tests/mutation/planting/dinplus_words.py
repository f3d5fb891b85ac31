"""Slips in the words of a DIN PLUS block: one is gone, has a value that its code does not take, is none of the code, stands twice."""
from .dinplus_facts import WORDS
from .dinplus_reader import NUMBER, put, with_more, without

KEPT = {'X', 'Y', 'Z', 'XK', 'YK', 'C'}  # left out, they keep their last value (l.10293)
TAKEN_ANEW = {'G20', 'G120', 'G152'}  # codes that have nothing to keep
STRANGE = ('KC', 'HC', 'EW', 'NF', 'WB', 'SP', 'UE')  # words of other cycles
# Words that exclude each other (l.10803, 11302, 11953, 15658, 15789, 15887, 16382-16667).
POLAR = [('X', 'XK'), ('X', 'YK'), ('C', 'XK'), ('C', 'YK')]
DRILLED = [('XS', 'ZS'), ('ID', 'XS'), ('ID', 'ZS'), ('NS', 'XS'), ('NS', 'ZS')]
EXCLUDED = {
    ('G22', 'c'): [('X', 'Z')], ('G110', 'c'): [('C', 'CY')], ('G71', 'm'): DRILLED, ('G73', 'm'): DRILLED, ('G74', 'm'): DRILLED,
    ('G100', 'm'): POLAR, ('G101', 'm'): POLAR, ('G102', 'm'): [*POLAR, ('R', 'I'), ('R', 'J')],
    ('G103', 'm'): [*POLAR, ('R', 'I'), ('R', 'J')], ('G110', 'm'): [('C', 'CY')], ('G111', 'm'): [('C', 'CY')],
    ('G112', 'm'): [('C', 'CY'), ('R', 'K')], ('G113', 'm'): [('C', 'CY'), ('R', 'K')],
    ('G743', 'm'): POLAR, ('G745', 'm'): POLAR,
}


def plants(program):
    for block in program.blocks:
        codes = [f'G{number}' for number in block.codes()]
        lists = [WORDS.get((code, block.place)) for code in codes]
        both = lists if block.section != 'SUBPROGRAM' else lists + [WORDS.get((code, 'c'), {}) for code in codes]  # it may be a contour
        numbers = [word for word in block.words if word.letter not in ('G', 'M', 'T') and NUMBER.match(word.value)]
        if not codes or None in lists:
            continue
        for code, words in zip(codes, lists):
            yield from of_code(block, code, words, [other for other in lists if other is not words])
        strange = next((name for name in STRANGE if not any(name in words for words in both) and not block.get(name)), None)
        if strange and any(lists) and block.text.count(' '):
            yield 'din-word-unknown', with_more(block, f'{strange}1'), ''
        if numbers:
            word = numbers[-1]
            yield 'din-word-twice', with_more(block, f'{word.name}{word.value}5'), ''
        fraction = next((word for word in numbers if '.' in word.value), None)
        if fraction:
            yield 'din-decimal-comma', put(block, fraction, fraction.value.replace('.', ',')), ''


def of_code(block, code, words, others):
    for word in block.words:
        listed = words.get(word.name)
        if listed is None or any(word.name in other for other in others):
            continue
        if listed.required and (word.name not in KEPT or code in TAKEN_ANEW):
            yield 'din-word-missing', without(block, word), ''
        if listed.values is not None and word.number in listed.values:
            yield 'din-word-value', put(block, word, str(max(listed.values) + 1)), ''
    names = {word.letter for word in block.words}
    for pair in EXCLUDED.get((code, block.place), ()):
        for there, more in (pair, pair[::-1]):
            if there in names and not names & {more} and more not in ('ID', 'NS') and not any(more in other for other in others):
                yield 'din-words-exclude', with_more(block, f'{more}5'), ''
