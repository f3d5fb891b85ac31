"""What a DIN PLUS program switches on and no longer switches off."""
import re

from .dinplus_reader import TURNED, emptied, without

# (class, what switches on, what switches off, with the lines of the manual). The last block that switches off is emptied.
LEFT = [
    ('din-coupling-left', r'\bG720\b.*\bH[1-9]', r'\bG720(?!.*\bH[1-9])'),  # 20215
    ('din-eccentric-left', r'\bG(725|726|727)\b.*\bH1', r'\bG(725|726|727)\b.*\bH0'),  # 18626-18628, 18695
    ('din-override-left', r'\bG(919)\b.*\bH1', r'\bG(919)\b.*\bH0'),  # 18152
    ('din-override-left', r'\bG908\b.*\bH1|\bG908\s+H1', r'\bG908\b.*\bH2|\bG908\s+H2'),  # 18131
    ('din-tcpm-left', r'\bG928\b.*\bH1', r'\bG928\b.*\bH0'),  # 25519-25525
    ('din-zone-left', r'\bG995\s+H\d', r'\bG995\s*$'),  # 18403
    ('din-zone-off-left', r'\bG60\s+Q1', r'\bG60\s+Q0'),  # 18061-18069
    ('din-interrupted-feed-left', r'\bG64\s+E', r'\bG64\s*$'),  # 12506
    ('din-probe-left', r'\bG910\b', r'\bG913\b'),  # 22342
]
TURNING = re.compile(r'\bM0?[34]\b|\bG96\b')


def plants(program):
    run = program.run()
    if not any(block.text.startswith('L"') for block in run):
        for kind, on, off in LEFT:
            yield from left(run, kind, re.compile(on), re.compile(off))
        yield from c_axis(run)
    yield from attributes(program)


def left(run, kind, on, off):
    offs = [(at, code_kind(off.search(block.code))) for at, block in enumerate(run) if off.search(block.code)]
    for at, name in offs:
        before = [block for block in run[:at] if on.search(block.code) and code_kind(on.search(block.code)) == name]
        again = any(other > at and other_name == name for other, other_name in offs)
        if before and not again:
            alone = len(run[at].codes()) == 1 and not run[at].codes('M')
            if alone:
                yield kind, emptied(run[at]), ''


def code_kind(match):
    return match.group(1) if match.re.groups else ''


def c_axis(run):
    """M15 is gone, and the spindle turns again: the C axis still holds it (20044-20045)."""
    for at, block in enumerate(run):
        if not block.has('M15'):
            continue
        after = run[at + 1:]
        again = next((other for other in after if TURNING.search(other.code)), None)
        anew = next((other for other in after if other.has('M14', 'M15')), None)
        if again and (anew is None or after.index(again) < after.index(anew)):
            word = next(word for word in block.words if word.letter == 'M' and word.value == '15')
            yield 'din-c-axis-left', without(block, word) if len(block.words) > 1 else emptied(block), ''


def attributes(program):
    """Attributes of a contour (G10, G38, G52) that end within their section; G149 may as well end with it (11376-11386)."""
    for at, block in enumerate(program.blocks):
        if block.section not in TURNED:
            continue
        for code in ('G10', 'G38', 'G52'):
            if block.text == code and any(other.part == block.part and other.has(code) and len(other.words) > 1
                                          for other in program.blocks[:at]):
                anew = (code, 'G95') if code == 'G10' else (code,)  # a feed ends the roughness (11251)
                later = any(other.part == block.part and other.has(*anew) for other in program.blocks[at + 1:])
                yield 'din-attribute-left', emptied(block), 'another one follows' if later else ''
