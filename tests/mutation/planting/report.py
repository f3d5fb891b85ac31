"""What was found and what was missed, as JSON for programs and as Markdown for people."""
import json
from collections import Counter, defaultdict

from .plants import ERROR, KINDS, WARNING

BARS = {ERROR: 0.995, WARNING: 0.95}
JUDGED = ('found', 'only a note', 'missed')


def share(results):
    judged = [verdict for _, verdict, _ in results if verdict in JUDGED]
    return judged.count('found') / len(judged) if judged else 1.0


def by_severity(results, severity):
    return [result for result in results if KINDS[result[0].kind].severity == severity]


def percent(results):
    return f'{100 * share(results):.1f} %' if results else '-'


def summary(results):
    return '; '.join(f'{severity}s: {percent(chosen)} of {sum(v in JUDGED for _, v, _ in chosen)} places found (bar: {100 * bar:g} %)'
                     for severity, bar in BARS.items() for chosen in [by_severity(results, severity)])


def passes(results):
    return all(share(by_severity(results, severity)) >= bar for severity, bar in BARS.items())


def cause_of(plant, verdict, codes):
    """Misses with one cause are alike in these."""
    others = sorted({code.rsplit(' line', 1)[0] for code in codes})
    return plant.kind, verdict, ', '.join(others) or 'nothing'


def markdown(results, harmless, examples, seed, seconds):
    lines = ['# Planted defects', '', f'Seed {seed}, {seconds:.0f} s. {summary(results)}.', '',
             '| class | severity | places | found | a note only | missed | share | harmless | rules |',
             '|---|---|---|---|---|---|---|---|---|']
    left_out = Counter(plant.kind for plant in harmless)
    for name, kind in KINDS.items():
        own = [result for result in results if result[0].kind == name]
        counts = Counter(verdict for _, verdict, _ in own)
        if own or left_out[name]:
            cells = [name, kind.severity, sum(counts[v] for v in JUDGED), *(counts[v] for v in JUDGED), percent(own), left_out[name],
                     ' '.join(kind.rules)]
            lines.append(f'| {" | ".join(map(str, cells))} |')
    lines += rules_table(results)
    lines += ['', '## Left out as harmless', '']
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
        return {'class': plant.kind, 'file': str(plant.path), 'line': plant.line, 'change': plant.difference(),
                'expected': list(KINDS[plant.kind].rules), 'verdict': verdict, 'new': codes, 'runs': plant.shown}

    return json.dumps({'seed': seed, 'shares': {severity: share(by_severity(results, severity)) for severity in BARS},
                       'bars': BARS, 'plants': [row(*result) for result in results],
                       'harmless': [row(plant, 'harmless', []) | {'reason': plant.harmless} for plant in harmless]}, indent=1) + '\n'
