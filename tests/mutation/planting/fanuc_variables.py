"""Variables of Fanuc programs that nothing sets any more."""
import re

from .edit import put
from .fanuc import ARGUMENTS, OTHER_LOCALS, STORE, VARIABLE
from .flow import SHARED, live_uses, may_share_locals, tests_vacancy, unreached, uses, vacant_uses, variables_in


def plants(program):
    yield from removed_assignments(program)
    yield from wrong_variables(program)
    yield from crossed_axes(program)
    yield from stores_into_one(program)
    for block in program.blocks:
        store = STORE.search(block.code)
        if store and int(store.group(1)) < 34:
            yield 'null-assigned', put(block, store.span(1), '0'), ''


def locals_that_start_vacant(program):
    """In a macro those that no letter passes; in a program that nobody calls every local."""
    return OTHER_LOCALS if program.returns else OTHER_LOCALS | ARGUMENTS


def removed_assignments(program):
    """Only blocks that hold nothing but the assignment."""
    for index, block in enumerate(program.blocks):
        match = STORE.search(block.code)
        if not match or len(block.stores) != 1 or block.jumps or block.loop is not None:
            continue
        variable = block.stores[0]
        if not 0 < variable < 34:
            continue
        stores = [at for at, other in enumerate(program.blocks) if variable in other.stores]
        kind = 'assignment-removed' if len(stores) == 1 else 'case-removed'
        reason = why_it_is_not_missed(program, index, variable)
        if kind == 'case-removed' and reason == ONE_OF_MANY:
            continue
        begin = match.start()
        then = re.search(r'IF\b.*THEN', block.code)
        begin = then.start() if then else begin
        yield kind, put(block, (begin, len(block.code.rstrip())), ''), reason


ONE_OF_MANY = 'another assignment comes before every use'


def why_it_is_not_missed(program, index, variable):
    block = program.blocks[index]
    if index not in program.reachable:
        return 'no path leads to this block'
    if variable not in locals_that_start_vacant(program):
        return 'an argument may have set it'
    if not live_uses(program, index, variable):
        return 'nothing uses the variable afterwards'
    if any(tests_vacancy(other, variable) for other in program.blocks):
        return 'the program looks whether it is vacant'
    if re.search(r'=\s*#\s*0\s*$', block.code.rstrip()):
        return 'it is set to vacant'
    if re.search(r'=\s*0+\.?0*\s*$', block.code.rstrip()) and counts_as_zero(program, index, variable):
        return 'it is set to 0, and vacant counts as 0 in every use'
    before = vacant_uses(program, variable)
    after = vacant_uses(program, variable, without=index)
    reached = program.reach(program.successors[index])
    if not {use for use in after - before if use in reached}:
        return ONE_OF_MANY if after == before and not before else 'its uses may have been vacant before, or another assignment comes first'
    if any(other.loop is not None and other.stores for other in program.blocks):
        return 'a block holds a loop and an assignment, which the planter does not read'
    if loop_sets_it_before(program, index, variable):
        return 'an earlier loop has set it, unless it makes no pass'
    if block.conditional and 'THEN' in block.code:
        return 'it is set only under a condition'
    if re.search(r'#\s*\[', ''.join(b.code for b in program.blocks)) and reads_through_index(program):
        return 'the program reads variables through an index'
    return SHARED if may_share_locals(program) else ''


def loop_sets_it_before(program, index, variable):
    return any(end < index and any(variable in program.blocks[at].stores for at in program.body(start))
               for start, end in program.loops())


def counts_as_zero(program, index, variable):
    """Whether every use of what is set there is arithmetic or a comparison other than EQ and NE."""
    word = re.compile(rf'[A-Z]\s*-?\s*#\s*0*{variable}(?!\d)|#\s*0*{variable}\s*(?:EQ|NE)|(?:EQ|NE)\s*#\s*0*{variable}(?!\d)')
    relation = re.compile(r'(?:LT|LE|GT|GE|MOD|AND|OR|XOR)\s*$')
    for at in live_uses(program, index, variable):
        code = program.blocks[at].code
        for match in word.finditer(code):
            if not relation.search(code[:match.start() + 1]) or 'EQ' in match.group() or 'NE' in match.group():
                return False
    return True


def reads_through_index(program):
    """A local may be read by number: #[#1] with a small #1."""
    for block in program.blocks:
        for match in re.finditer(r'#\s*\[([^\]]*)\]', block.code):
            numbers = [int(n) for n in re.findall(r'(?<![#\d.])(\d{3,})', match.group(1))]
            commons = [v for v in variables_in(match.group(1)) if v >= 100]
            if not numbers and not commons:
                return True
    return False


def wrong_variables(program):
    """The first word of a block that reads a variable reads one that nothing sets: X#31 becomes X#13."""
    stored = {v for block in program.blocks for v in block.stores}
    if any(block.uses_frame_of_caller or block.stores_anywhere for block in program.blocks):
        return  # a local may come from elsewhere
    shared = SHARED if may_share_locals(program) else ''
    mentioned = {v for block in program.blocks for v in variables_in(block.code)}
    free = locals_that_start_vacant(program) - stored - mentioned
    if not free:
        return
    for index, block in enumerate(program.blocks):
        read = next((m for m in VARIABLE.finditer(block.code) if 0 < int(m.group(1)) < 1000
                     and not re.match(r'\s*=', block.code[m.end():]) and uses(block, int(m.group(1)))), None)
        if not read or tests_vacancy(block, int(read.group(1))):
            continue
        if re.match(r'.*=\s*#\s*\d+\s*$', block.code.rstrip()):
            continue
        wrong = typing_error(int(read.group(1)), free)
        reason = unreached(program, index) or shared
        yield 'wrong-variable', put(block, read.span(1), str(wrong)), reason


def typing_error(number, free):
    """A free number that looks like this one: digits exchanged, one digit more or wrong."""
    text = str(number)
    alike = [text[::-1], text + '0', *(text[:-1] + digit for digit in '0123456789')]
    return next((int(new) for new in alike if int(new) in free), max(free))


NUMBER = re.compile(r'\d+(?:\.\d*)?')


def crossed_axes(program):
    """`#25=#5002+#25` after `#24=#5001+#24` takes #24."""
    for first, second in zip(program.blocks, program.blocks[1:]):
        numbers = [NUMBER.findall(block.code) for block in (first, second)]
        alike = NUMBER.sub('0', first.code).strip() == NUMBER.sub('0', second.code).strip()
        if not alike or not second.stores or not re.match(r'\s*#\s*\d+\s*=', second.code) or len(numbers[0]) < 3:
            continue
        pairs = [(float(a), float(b)) for a, b in zip(*numbers)]
        own = [match for match in VARIABLE.finditer(second.code) if int(match.group(1)) == second.stores[0]][1:]
        follows = all(b - a in (0, 1) for a, b in pairs) and any(a > 5000 and b - a == 1 for a, b in pairs)
        if follows and pairs[0][1] - pairs[0][0] == 1 and len(own) == 1 and all(a != pairs[0][1] for a, b in pairs):
            yield 'axes-crossed', put(second, own[0].span(1), str(second.stores[0] - 1)), ''


LOCAL_RESULT = re.compile(r'\s*(?:N\s*\d+\s*)?#\s*(\d+)(\s*=)(?=[^=]*(?:[-+*/\]]))([^=]*)$')


def stores_into_one(program):
    """Two blocks in a row calculate two locals: the second sets the variable of the first."""
    for index in range(1, len(program.blocks)):
        first, second = program.blocks[index - 1], program.blocks[index]
        results = [LOCAL_RESULT.match(block.code.rstrip()) for block in (first, second)]
        if not all(results) or second.label is not None or first.skipped or second.skipped:
            continue
        variable, other = (int(result.group(1)) for result in results)
        plain = re.sub(r'\s', '', results[0].group(3)) == re.sub(r'\s', '', results[1].group(3))
        if not 0 < variable < 34 or not 0 < other < 34 or variable == other or plain:
            continue
        if not variables_in(results[0].group(3)) or reads_through_index(program):
            continue
        reason = unreached(program, index)
        if variable in variables_in(results[0].group(3)):
            reason = reason or 'the first only changes the variable'
        if variable in variables_in(results[1].group(3)) or re.search(r'#\s*\[', results[1].group(3)):
            reason = reason or 'the second reads, or may read, what the first has set'
        yield 'stores-into-one', put(second, results[1].span(1), str(variable)), reason
