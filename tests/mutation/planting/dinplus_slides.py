"""Slides of a lathe that wait for each other."""
import re

from .dinplus_reader import emptied, put


def plants(program):
    slides = next((set(re.findall(r'\$(\d)', code)) for code in program.codes if code.strip().startswith(('#SLIDE', '#SCHLITTEN'))), set())
    if len(slides) < 2:
        return
    unknown = next(str(n) for n in range(1, 10) if str(n) not in slides)
    marks = {block.get('H').value for block in program.run() if block.has('G62', 'G162') and block.get('H')}
    free = next(str(n) for n in range(1, 16) if str(n) not in marks)
    for block in program.run():
        own = re.findall(r'\d', block.slides)
        if not own:
            continue
        at = block.code.index('$') + 1
        yield 'din-slide-unknown', [(block.line, (at, at + 1), unknown)], ''
        if block.has('M97') and len(own) == 2:  # three slides may as well be two that meet
            for begin in (at - 1, block.code.index('$', at)):
                yield 'din-m97-one-slide', [(block.line, (begin, begin + 2), '')], ''
        mark = block.get('H')
        if block.has('G162') and mark:
            waiting = [other for other in program.run() if other.has('G62') and other.get('H') and other.get('H').value == mark.value]
            setting = [other for other in program.run() if other.has('G162') and other.get('H') and other.get('H').value == mark.value]
            harmless = '' if waiting and len(setting) == 1 else 'nobody waits for this mark alone'
            yield 'din-mark-mistyped', put(block, mark, free), harmless
            yield 'din-mark-gone', emptied(block), harmless
        if block.has('G62') and mark:
            yield 'din-mark-mistyped', put(block, mark, free), ''
        if re.match(r'(#g\d+)\s*=.*\1(?!\d)', block.text) and len(own) == 1:  # each slide has its own #l
            yield 'din-slide-gone', [(block.line, (at - 1, at + 1), '')], ''
