"""How many times each law of the core stands in the sources, by an expression that no other text needs."""
import re

# law: (an expression of its formula, how many places are allowed, its text)
LAWS = {
    'Stribeck curve': (r'\(static_ratio - ', 1, 'contact/friction_text.h'),
    'sticking bristle of wall and pipe': (r'time / \(time \+ law\.damping / law\.stiffness\)', 1, 'contact/friction_text.h'),
    'Hertz with Hunt-Crossley damping': (r'exponent \* slope \* factor', 1, 'contact/normal_text.h'),
    "tangent of the wall's contact": (r'mul_sub\(share, dot\(', 1, 'contact/wall_text.h'),
    'bending stiffness under tension (corotational beam)': (r'= 4\.0 / 30\.0', 2, 'string/beam_element.h'),
    'load on the wall of guided pipe': (r'mul_add\(smooth, smooth, dot\(push', 1, 'model/forces/guided_text.h'),
}


def places(texts):
    """{law: [file:line]} of the sources of include/ and src/."""
    found = {law: [] for law in LAWS}
    for file, text in sorted(texts.items()):
        if file.split('/')[0] not in ('include', 'src'):
            continue
        for number, line in enumerate(text.splitlines(), 1):
            for law, (expression, _, _) in LAWS.items():
                if re.search(expression, line):
                    found[law].append('%s:%d' % (file, number))
    return found


def table(texts):
    lines = ['| law | places | text |', '| --- | --- | --- |']
    return lines + ['| %s | %d | [%s](%s) |' % (law, len(found), LAWS[law][2], LAWS[law][2]) for law, found in places(texts).items()]


def faults(texts):
    """One line for each law that stands more often than is allowed, or nowhere."""
    lines = []
    for law, found in places(texts).items():
        allowed = LAWS[law][1]
        if len(found) > allowed:
            lines.append('%s stands %d times, allowed: %d (%s)' % (law, len(found), allowed, ', '.join(found)))
        if not found:
            lines.append('%s stands nowhere: test/house/laws.py has another expression for it' % law)
    return lines
