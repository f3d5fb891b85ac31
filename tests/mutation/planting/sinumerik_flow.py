"""Slips in what decides where a SINUMERIK program goes on."""
import re

from .sinumerik_reader import CLOSERS, ENDS, JUMP, LOOPS, NAME, NUMBER, added_before, added_behind, cut, emptied, gone, put, slip

OTHER_END = {'ENDFOR': 'ENDWHILE', 'ENDWHILE': 'ENDFOR', 'ENDLOOP': 'ENDWHILE', 'ENDIF': 'ENDFOR'}


def plants(program, libraries):
    for block in program.blocks:
        yield from jumps(program, block)
        yield from structures(program, block)
        yield from cases(block)
    yield from labels(program)
    yield from steps(program, libraries)
    yield from exits(program, libraries)
    yield from ends(program, libraries)


def jumps(program, block):
    jump = block.jump
    if not jump:
        return
    word, target = jump.groups()
    begin = block.head
    known = program.labels(target)
    if word != 'GOTOC' and known and not program.labels(slip(target)):
        yield 'sin-jump-misspelt', put(block, (begin + jump.start(2), begin + jump.end(2)), slip(target)), ''
    behind = {found.line > block.line for found in known}
    if word in ('GOTOF', 'GOTOB') and len(behind) == 1:
        yield 'sin-direction', put(block, (begin + jump.start(1), begin + jump.end(1)), 'GOTOB' if word == 'GOTOF' else 'GOTOF'), ''
    if word == 'GOTO' and len(known) == 1 and known[0].line > block.line:
        plain = [found for found in program.before(block) if not (found.definition or found.label or found.inside or found.word)]
        other = next(iter(plain), None)
        if other and block.label != target:
            yield 'sin-label-twice', put(other, (other.head, other.head), f'{target}: '), ''


def labels(program):
    for block in program.blocks:
        named = [found for found in program.blocks if found.jump and found.jump.group(2) == block.label and found.jump.group(1) != 'GOTOC']
        cased = any(re.search(rf'GOTO[FB]?\s+{block.label}\b', found.text) for found in program.blocks if found.text.startswith('CASE'))
        if block.label and (named or cased) and len(program.labels(block.label)) == 1:
            yield 'sin-label-renamed', put(block, block.label_span, slip(block.label)), ''
        if block.text.startswith('REPEAT') and block.word == '':
            first = re.match(r'REPEATB?\s+([A-Z_]{2}\w*)', block.text)
            if first and not program.labels(slip(first.group(1))):
                begin = block.head
                yield 'sin-repeat-misspelt', put(block, (begin + first.start(1), begin + first.end(1)), slip(first.group(1))), ''
        loop = next((outer for outer in block.inside if outer.word in LOOPS), None)
        if block.label and loop:
            yield 'sin-into-loop', added_before(loop, f'IF R99==1 GOTOF {block.label}'), ''


def structures(program, block):
    word = block.word
    if word in CLOSERS.values():
        yield 'sin-end-gone', emptied(block), ''
        if word in OTHER_END:
            yield 'sin-end-other', put(block, (block.head, block.end), OTHER_END[word]), ''
    if word in CLOSERS:
        yield 'sin-begin-gone', emptied(block), ''
        end = program.closer(block)
        loop = block.inside[-1] if block.inside else None
        outer = program.closer(loop) if loop else None
        closed = end is not None and end.word == 'ENDIF' and outer is not None and outer.word == CLOSERS[loop.word]
        if word == 'IF' and closed and loop.word != 'IF':
            yield 'sin-ends-crossed', gone(end) + added_behind(outer, 'ENDIF'), ''
    if word == 'ELSE':
        yield 'sin-else-twice', added_behind(block, 'ELSE'), ''
    counted = re.match(rf'FOR\s+\w+=({NUMBER})\s+TO\s+({NUMBER})$', block.text)
    if counted and float(counted.group(1)) < float(counted.group(2)):
        begin = block.head
        yield 'sin-for-down', [(block.line, (begin + counted.start(1), begin + counted.end(1)), counted.group(2)),
                               (block.line, (begin + counted.start(2), begin + counted.end(2)), counted.group(1))], ''


def cases(block):
    values = list(block.each(r'\s(-?\d+)\s+GOTO')) if block.text.startswith('CASE') else []
    if len(values) > 1:
        yield 'sin-case-twice', cut(block, values[1], 1, values[0].group(1)), ''


def names_of(text):
    return set(NAME.findall(text)) | set(re.findall(r'(?<![\w$])R\d+', text))


def stores(block):
    """The variables that a block sets by its text."""
    return set(re.findall(r'(?<![\w$\[])(R\d+|[A-Z_]{2}\w*)=(?!=)', block.text))


def steps(program, libraries):
    """What changes the condition of WHILE is lost, or goes the other way."""
    for loop in program.blocks:
        if loop.word != 'WHILE':
            continue
        asked = names_of(loop.text[5:])
        body = program.body(loop)
        inside = [block for block in body if stores(block) & asked]
        other = any('GOTO' in block.text or ENDS.search(block.text) or block.text.startswith('CALL') or list(block.calls(libraries))
                    for block in body)
        step = re.match(r'(\w+)=\1([+-])([^+-]+)$', inside[0].text) if len(inside) == 1 else None
        relation = re.match(r'WHILE\s+(\w+)\s*([<>])=?\s*[^<>=]+$', loop.text)
        alone = step and relation and relation.group(1) == step.group(1)
        if not alone or other or '$' in loop.text:
            continue
        block = inside[0]
        yield 'sin-step-lost', emptied(block), ''
        rising = relation.group(2) == '<'
        if (step.group(2) == '+') == rising and re.fullmatch(NUMBER, step.group(3)):
            begin = block.head + step.start(2)
            yield 'sin-step-turned', put(block, (begin, begin + 1), '-' if rising else '+'), ''


def exits(program, libraries):
    """The only way out of a loop, or of a circle of jumps, is lost."""
    for loop in program.blocks:
        body = program.body(loop) if loop.word == 'LOOP' else []
        out = [block for block in body if 'GOTO' in block.text or ENDS.search(block.text)]
        if len(out) == 1 and out[0].jump:
            yield 'sin-exit-lost', emptied(out[0]), ''
    for block in program.blocks:
        jump = block.jump
        start = next((found for found in program.before(block) if jump and found.label == jump.group(2)), None)
        if start is None or jump.group(1) not in ('GOTOB', 'GOTO') or len(JUMP.findall(block.text)) != 1:
            continue
        circle = program.before(block)[program.blocks.index(start):]
        own = {found.label for found in circle if found.label}
        out = [found for found in circle if ENDS.search(found.text) or 'CASE' in found.text
               or any(name not in own for _, name in JUMP.findall(found.text))]
        waits = any(found.has('G4', 'STOPRE', 'M0') or '$A' in found.text or found.text.startswith('CALL') for found in circle + [block])
        if block.text.startswith('IF') and not out:
            edits = put(block, (block.head, block.head + jump.start(1)), '')
            yield 'sin-endless-jump', edits, 'it may wait on purpose' if waits else ''
        elif jump.start() == 0 and len(out) == 1 and out[0].text.startswith('IF') and out[0].jump and not out[0].inside:
            yield 'sin-endless-jump', emptied(out[0]), 'it may wait on purpose' if waits else ''


def ends(program, libraries):
    last = program.blocks[-1]
    end = ENDS.search(last.text)
    called = any(program.name in found.named for name, found in libraries.items() if name != program.name)
    targets = {name for block in program.blocks for _, name in JUMP.findall(block.bare)}
    if end and last.label not in targets:
        reason = '' if called and not program.main else 'no source says what the control does then' if program.main else 'nobody calls it'
        yield 'sin-end-of-program-gone', emptied(last), reason
    if end and not program.main and called and last.text in ('RET', 'M17'):
        other = any(re.search(r'(?<!\w)(?:RET|M17)(?!\w)', block.text) for block in program.blocks[:-1])
        yield 'sin-job-end', put(last, (last.head, last.end), 'M30'), 'another path returns' if other else ''
        arguments = ','.join(program.proc.bare[slice(*own.span)] for own in program.parameters) if program.proc else ''
        yield 'sin-recursion', added_before(last, program.name + (f'({arguments})' if arguments else '')), ''
