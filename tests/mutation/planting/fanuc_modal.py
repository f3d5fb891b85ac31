"""Modal state of Fanuc programs that is left changed, or put back wrongly."""
import re

from .edit import put
from .fanuc import CALL, PROGRAM_END, RETURN
from .flow import unreached

SAVE = re.compile(r'^\s*(?:N\s*\d+\s*)?#\s*(\d+)\s*=\s*#\s*(4[01]\d\d)\s*$')
PLAIN_STORE = re.compile(r'^\s*#\s*(\d+)\s*=')
LATHE = re.compile(r'G\s*96(?!\d)|G\s*50\s*S|G\s*7[012](?!\d)|(?<![A-Z])[UW]\s*-?\s*[\d.]+')
# The group's system variable, its codes, and the one that shops take for granted.
MODES = [('4003', ('90', '91'), '90'), ('4002', ('17', '18', '19'), '17')]
# What cancels what. A motion code cancels a canned cycle, too.
CANCELS = [('40', '4[12]', ''), ('69', '68', ''), ('15', '16', ''), ('50.1', '51.1', ''), ('80', '8[1-9]', '0?[0-3]')]


def word(letter, value):
    return re.compile(rf'{letter}\s*0*(?:{value})(?![\d.])')


def plants(program, lines):
    taken = set()
    for saved in saves(program):
        index, _, source, back = saved
        yield from saved_late(program, lines, index, source, back)
        yield from saved_lost(program, saved, taken)
    yield from incremental(program)
    for variable, codes, customary in MODES:
        yield from modes_left(program, variable, codes, customary)
        yield from conflicts(program, codes)
    yield from words_left(program, 'F', '4109', 'feed-left')
    yield from words_left(program, 'S', '4119', 'speed-left')
    yield from cancels_removed(program)
    yield from single_block(program)
    yield from doubled_addresses(program)


def is_lathe(program):
    return any(LATHE.search(block.code) for block in program.blocks)


def states(program, change, start):
    """What may hold before each block and at the ends (M99 and M30), as sets."""
    before = {0: {start}}
    waiting, ends = [0], set()
    while waiting:
        index = waiting.pop()
        after = change(index, before[index])
        block = program.blocks[index]
        returns = RETURN.search(block.code) or PROGRAM_END.search(block.code)
        if returns:
            ends |= after
        for following in program.successors[index]:
            known = before.setdefault(following, set())
            if not after <= known or following not in before:
                known |= after
                waiting.append(following)
    return before, ends


def saves(program):
    """(index, variable, system variable, index of the block that puts it back)"""
    for index, block in enumerate(program.blocks):
        save = SAVE.match(block.code)
        if not save or index not in program.reachable:
            continue
        variable, source = int(save.group(1)), save.group(2)
        letter = {'4109': 'F', '4119': 'S'}.get(source, 'G')
        if letter == 'G' and int(source) > 4021:
            continue
        back = [at for at, other in enumerate(program.blocks) if re.search(rf'{letter}\s*#\s*0*{variable}(?!\d)', other.code)]
        stores = [at for at, other in enumerate(program.blocks) if variable in other.stores]
        if back and len(stores) == 1 and back[-1] in program.reach(program.successors[index]):
            yield index, variable, source, back[-1]


def incremental(program):
    """G91 in front of a move, from which a path leads to an exit where nothing says G90 or puts back what was saved."""
    anew = re.compile(r'G\s*(?:9[01](?![\d.])|\[|#)')
    moves = re.compile(r'(?<![A-Z])[XYZ]\s*(?:-?\s*[\d.]+|[-#\[])')
    if not program.is_macro or is_lathe(program):
        return
    for index, block in enumerate(program.blocks):
        if index not in program.reachable or block.is_call or block.conditional or block.stores or anew.search(block.code) or \
                not moves.search(block.code) or re.search(r'G\s*0*(?:4|10|28|30|5[0-9]|92|65|66|68|8\d)(?![\d])', block.code):
            continue
        following = program.reach([index], lambda at: anew.search(program.blocks[at].code) or program.blocks[at].is_call)
        if any(RETURN.search(program.blocks[at].code) and not anew.search(program.blocks[at].code) for at in following):
            head = re.match(r'\s*/?\s*(?:N\s*\d+)?\s*', block.code).end()
            yield 'incremental-left', put(block, (head, head), 'G91'), ''


def saved_lost(program, saved, taken):
    """The first assignment after the save, one for each saved value, goes to the variable that keeps it."""
    index, variable, _, back = saved
    for later in range(index + 1, back):
        other = program.blocks[later]
        store = PLAIN_STORE.match(other.code)
        if store and later in program.reachable and not SAVE.match(other.code) and int(store.group(1)) < 34:
            only = other.stores == [int(store.group(1))]
            reached = back in program.reach(program.successors[later])
            if only and reached and not other.skipped and later not in taken:
                taken.add(later)
                yield 'saved-lost', put(other, store.span(1), str(variable)), ''
                return


def changes_of(source):
    if source == '4109':
        return re.compile(r'F\s*[#\[\d.]')
    if source == '4119':
        return re.compile(r'(?<![A-Z])S\s*[#\[\d.]')
    codes = next((codes for number, codes, _ in MODES if number == source), None)
    return word('G', '|'.join(codes)) if codes else None


def saved_late(program, lines, index, source, back):
    """The block that saves changes places with the next one that changes what it saves."""
    changing = changes_of(source)
    for later in range(index + 1, back):
        block = program.blocks[later]
        if block.label is not None or block.jumps or block.loop is not None or block.end is not None or block.is_call:
            return
        if changing and changing.search(block.code):
            first, second = program.blocks[index].line, block.line
            yield ('saved-late', [(first, (0, len(lines[first].rstrip('\r'))), lines[second].rstrip('\r')),
                                  (second, (0, len(lines[second].rstrip('\r'))), lines[first].rstrip('\r'))], '')
            return


def modes_left(program, variable, codes, customary):
    """Each word that puts the group back: G90, or G#3 with #3 a copy of #4003."""
    if not program.is_macro or is_lathe(program):
        return
    copies = {copy for _, copy, source, _ in saves(program) if source == variable}
    literal = re.compile(rf'G\s*({"|".join(codes)})(?![\d.])')
    copied = re.compile(rf'G\s*#\s*({"|".join(map(str, sorted(copies))) or "0"})(?!\d)')

    def change(without):
        def after(index, held):
            block = program.blocks[index]
            found = [(m.start(), m.group(1)) for m in literal.finditer(block.code) if (index, m.start()) != without]
            found += [(m.start(), 'caller') for m in copied.finditer(block.code) if (index, m.start()) != without]
            if block.may_call:
                return {'unknown'}
            new = {max(found)[1]} if found else held
            return new | held if block.conditional else new
        return after

    bad = set(codes) - {customary}
    _, ends = states(program, change(None), 'caller')
    for index, block in enumerate(program.blocks):
        if index not in program.reachable:
            continue
        words = [m for m in literal.finditer(block.code) if m.group(1) == customary] + list(copied.finditer(block.code))
        for match in words:
            _, left = states(program, change((index, match.start())), 'caller')
            if left & bad:
                reason = 'it was left before' if ends & bad else ''
                yield 'mode-left', put(block, match.span(), ''), reason
            elif copied.match(block.code, match.start()):
                yield 'mode-left', put(block, match.span(), ''), 'what is left is the customary code, or unknown'


def words_left(program, letter, source, kind):
    """F#33 or S#33 that puts back what was saved."""
    copies = {variable for _, variable, saved, _ in saves(program) if saved == source}
    if not copies or not program.is_macro:
        return
    restored = re.compile(rf'{letter}\s*#\s*({"|".join(map(str, sorted(copies)))})(?!\d)')
    any_word = re.compile(rf'(?<![A-Z]){letter}\s*[#\[\d.]')

    def change(without):
        def after(index, held):
            block = program.blocks[index]
            back = restored.search(block.code)
            if back and index != without:
                return {'caller'}
            if block.may_call:
                return {'unknown'}
            changed = any_word.search(block.code) and not back and not CALL.search(block.code)
            return {'own'} | (held if block.conditional else set()) if changed else held
        return after

    _, ends = states(program, change(None), 'caller')
    for index, block in enumerate(program.blocks):
        back = restored.search(block.code)
        if back and index in program.reachable:
            _, left = states(program, change(index), 'caller')
            reason = '' if 'own' in left else 'the program changes it on no path'
            reason = reason or ('it was left before' if 'own' in ends else '')
            yield kind, put(block, back.span(), ''), reason


def motion_put_back(program):
    """The G word with a copy of the caller's motion code, which ends a canned cycle as any code of its group does."""
    copies = {str(variable) for _, variable, source, _ in saves(program) if source == '4001'}
    return rf'G\s*#\s*0*(?:{"|".join(sorted(copies)) or "0"})(?!\d)'


def cancels_removed(program):
    for cancel, start, also in CANCELS:
        if cancel in ('80', '69') and is_lathe(program):
            continue
        off, on = word('G', re.escape(cancel)), word('G', start.replace('.', r'\.'))
        motion = re.compile(f'{word("G", also).pattern}|{motion_put_back(program)}') if also else None

        def change(without, off=off, on=on, motion=motion):
            def after(index, held):
                block = program.blocks[index]
                if block.may_call:
                    return {'unknown'}
                if on.search(block.code):
                    return {'on'} | (held if block.conditional else set())
                cancelled = (off.search(block.code) and index != without) or (motion and motion.search(block.code))
                return {'off'} | (held if block.conditional else set()) if cancelled else held
            return after

        _, ends = states(program, change(None), 'off')
        for index, block in enumerate(program.blocks):
            match = off.search(block.code)
            if match and index in program.reachable and not on.search(block.code):
                _, left = states(program, change(index), 'off')
                if 'on' in left and 'on' not in ends:
                    yield 'cancel-removed', put(block, match.span(), ''), ''


def single_block(program):
    for variable in ('3003', '3004'):
        store = re.compile(rf'#\s*0*{variable}\s*=\s*(\d+)\s*$')

        def change(without, store=store):
            def after(index, held):
                if program.blocks[index].may_call:
                    return {'unknown'}
                match = store.search(program.blocks[index].code.rstrip())
                if not match or index == without:
                    return held
                new = {'on' if int(match.group(1)) else 'off'}
                return new | held if program.blocks[index].conditional else new
            return after

        _, ends = states(program, change(None), 'off')
        for index, block in enumerate(program.blocks):
            match = store.search(block.code.rstrip())
            if match and not int(match.group(1)) and index in program.reachable:
                _, left = states(program, change(index), 'off')
                reason = '' if 'on' in left else 'no path leaves it set'
                yield 'single-block-left', put(block, match.span(), ''), reason or ('it was left before' if 'on' in ends else '')


def conflicts(program, codes):
    if is_lathe(program):
        return
    for index, block in enumerate(program.blocks):
        match = word('G', codes[0]).search(block.code)
        if match and not CALL.search(block.code):
            reason = unreached(program, index)
            yield 'group-conflict', put(block, (match.end(), match.end()), f'G{codes[1]}'), reason


def doubled_addresses(program):
    for index, block in enumerate(program.blocks):
        match = re.search(r'X\s*[-#\[\d.].*?(Y)\s*[-#\[\d.]', block.code)
        if match and not CALL.search(block.code) and '=' not in block.code and not block.conditional:
            reason = unreached(program, index)
            yield 'address-twice', put(block, match.span(1), 'X'), reason
