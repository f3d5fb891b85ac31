"""What was found and what was missed, as JSON for programs and as Markdown for people."""
import json
from collections import Counter, defaultdict

from . import dinplus_kinds, sinumerik_kinds
from .plants import ERROR, KINDS, WARNING
from .runs import SHOWN_BY_RUNS

BARS = {ERROR: 0.995, WARNING: 0.95}
STATE, STATE_BAR = 'saved state', 0.9  # a group of classes with a bar of its own, beside those of the severities
POOR = 0.95  # classes with a bar of their own that are listed
MOST_LEFT_OUT = 0.25  # of a class, without what the runs show to be the same
JUDGED = ('found', 'only a note', 'missed')
HOLD = 'hold'


def share(results):
    judged = [verdict for _, verdict, _ in results if verdict in JUDGED]
    return judged.count('found') / len(judged) if judged else 1.0


def counted(results):
    """Those of the half that nobody has tuned on, where there are any."""
    return [result for result in results if result[0].half == HOLD] or results


def by_severity(results, severity):
    return [result for result in results if KINDS[result[0].kind].severity == severity and not KINDS[result[0].kind].own_bar]


def of_kind(results, name):
    return [result for result in results if result[0].kind == name]


def of_state(results):
    return [result for result in results if KINDS[result[0].kind].group == STATE]


def percent(results):
    return f'{100 * share(results):.1f} %' if any(verdict in JUDGED for _, verdict, _ in results) else '-'


def bars(results):
    """(what is counted, results, bar) of the half that counts."""
    chosen = counted(results)
    yield from ((f'{severity}s', by_severity(chosen, severity), bar) for severity, bar in BARS.items())
    yield STATE, of_state(chosen), STATE_BAR


def class_bars(results):
    """The same for each class that has a bar of its own: of all programs, because a half has only a few places of a class."""
    for name, kind in KINDS.items():
        chosen = of_kind(results, name)
        if kind.own_bar and any(verdict in JUDGED for _, verdict, _ in chosen):
            yield name, chosen, bar_of(name, kind)


def bar_of(name, kind):
    if kind.group.startswith('SINUMERIK'):
        return sinumerik_kinds.BARS.get(name, sinumerik_kinds.SHARES[kind.severity])
    return dinplus_kinds.BARS.get(name, BARS[kind.severity])


def summary(results):
    halves = {result[0].half for result in counted(results)}
    text = '; '.join(f'{name}: {percent(chosen)} of {sum(v in JUDGED for _, v, _ in chosen)} places found (bar: {100 * bar:g} %)'
                     for name, chosen, bar in bars(results))
    text = f'Half {", ".join(sorted(halves))}: {text}' if halves and halves != {''} else text
    own = [result for result in results if KINDS[result[0].kind].own_bar]
    return text + (f'; classes with bars of their own: {percent(own)} of {sum(v in JUDGED for _, v, _ in own)} places, '
                   f'{len(below(results))} below their bars{": " if below(results) else ""}{", ".join(below(results))}' if own else '')


def below(results):
    """The classes that miss their own bars, where both halves were looked at."""
    if len({plant.half for plant, _, _ in results}) < 2:
        return []
    return [name for name, chosen, bar in class_bars(results) if share(chosen) < bar]


def passes(results):
    return all(share(chosen) >= bar for _, chosen, bar in bars(results)) and not below(results)


def left_out_share(results, harmless):
    """By class how much of it is left out for another reason than that the runs do the same."""
    other = Counter(plant.kind for plant in harmless if plant.harmless not in SHOWN_BY_RUNS)
    kept = Counter(plant.kind for plant, _, _ in results)
    return {kind: count / (count + kept[kind]) for kind, count in other.items()}


def cause_of(plant, verdict, codes):
    """Misses with one cause are alike in these."""
    others = sorted({code.rsplit(' line', 1)[0] for code in codes})
    return plant.kind, verdict, ', '.join(others) or 'nothing'


def markdown(results, harmless, examples, seed, seconds):
    lines = ['# Planted defects', '', f'Seed {seed}, {seconds:.0f} s. {summary(results)}.', '',
             '| class | severity | places | found | a note only | missed | share | tune | hold | the same | left out | rules |',
             '|---|---|---|---|---|---|---|---|---|---|---|---|']
    same = Counter(plant.kind for plant in harmless if plant.harmless in SHOWN_BY_RUNS)
    other = Counter(plant.kind for plant in harmless) - same
    for name, kind in KINDS.items():
        own = [result for result in results if result[0].kind == name]
        counts = Counter(verdict for _, verdict, _ in own)
        if own or same[name] or other[name]:
            halves = [percent([result for result in own if result[0].half == half]) for half in ('tune', HOLD)]
            cells = [name, kind.severity, sum(counts[v] for v in JUDGED), *(counts[v] for v in JUDGED), percent(own), *halves,
                     same[name], other[name], ' '.join(kind.rules)]
            lines.append(f'| {" | ".join(map(str, cells))} |')
    for group in (*BARS, STATE):
        chosen = of_state(results) if group == STATE else by_severity(results, group)
        lines.append(f'| all: {group} | | {sum(v in JUDGED for _, v, _ in chosen)} | | | | {percent(chosen)} | '
                     f'{percent([r for r in chosen if r[0].half == "tune"])} | {percent([r for r in chosen if r[0].half == HOLD])} | | | |')
    lines += rules_table(results)
    poor = [(name, chosen) for name, chosen, _ in class_bars(results) if share(chosen) < POOR]
    lines += ['', f'## Classes of which less than {100 * POOR:g} % is found', ''] if poor else []
    lines += [f'- {name}: {percent(chosen)} of {sum(v in JUDGED for _, v, _ in chosen)}: {KINDS[name].what}' for name, chosen in poor]
    shares = {kind: part for kind, part in left_out_share(results, harmless).items() if part > MOST_LEFT_OUT}
    lines += ['', '## Left out', ''] + [f'More than a quarter of {kind}: {100 * part:.0f} %.' for kind, part in sorted(shares.items())] + ['']
    reasons = Counter((plant.kind, plant.harmless) for plant in harmless)
    lines += [f'- {kind}: {count} × {reason}' for (kind, reason), count in sorted(reasons.items())]
    other = Counter(verdict for _, verdict, _ in results if verdict not in JUDGED)
    lines += [f'- {count} × {verdict}' for verdict, count in sorted(other.items())]
    lines += misses(results, examples)
    return '\n'.join(lines) + '\n'


def rules_table(results):
    """How many of the places that a rule ought to notice it noticed."""
    lines = ['', '| rule | places of its classes | found by it |', '|---|---|---|']
    places, found = Counter(), Counter()
    for plant, verdict, codes in results:
        if verdict in JUDGED:
            for rule in KINDS[plant.kind].rules[:1]:
                places[rule] += 1
            for rule in {code.split()[0] for code in codes} & set(KINDS[plant.kind].rules):
                found[rule] += 1
    return lines + [f'| {rule} | {places[rule]} | {found[rule]} |' for rule in sorted(set(places) | set(found))]


def miss_groups(results):
    groups = defaultdict(list)
    for plant, verdict, codes in results:
        if verdict in ('missed', 'only a note'):
            groups[cause_of(plant, verdict, codes)].append((plant, codes))
    return groups


def misses(results, examples):
    groups = miss_groups(results)
    lines = ['', '## Misses', '']
    for (kind, verdict, said), group in sorted(groups.items(), key=lambda item: (-len(item[1]), item[0])):
        lines += [f'### {kind}: {len(group)} {verdict}; new findings: {said}', '', f'Expected: {" or ".join(KINDS[kind].rules)}.', '']
        if (kind, verdict, said) in examples:
            example, difference = examples[kind, verdict, said]
            lines += ['```', *example, '```', '', 'with `' + '` `'.join(difference) + '`:', '']
        for plant, codes in group:
            lines += [f'- {plant.path}:{plant.line} `' + '` `'.join(plant.difference()) + '`' + (f' ({"; ".join(codes)})' if codes else '')]
        lines.append('')
    return lines


def as_json(results, harmless, seed):
    def row(plant, verdict, codes):
        return {'class': plant.kind, 'half': plant.half, 'file': str(plant.path), 'line': plant.line, 'change': plant.difference(),
                'expected': list(KINDS[plant.kind].rules), 'verdict': verdict, 'new': codes, 'runs': plant.shown}

    return json.dumps({'seed': seed, 'shares': {severity: share(by_severity(results, severity)) for severity in BARS},
                       'bars': BARS, 'plants': [row(*result) for result in results],
                       'harmless': [row(plant, 'harmless', []) | {'reason': plant.harmless} for plant in harmless]}, indent=1) + '\n'
