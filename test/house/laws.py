# SPDX-License-Identifier: BSD-3-Clause
"""How many times each law of the core stands in the sources, by an expression that no other text needs."""
import re

# law: (an expression of its formula, how many places are allowed, its text)
LAWS = {
    'Stribeck curve': (r'\(static_ratio - ', 1, 'contact/friction_text.h'),
    'sticking bristle of wall and pipe': (r'time / \(time \+ damping / stiffness\)', 1, 'contact/friction_text.h'),
    'Hertz with Hunt-Crossley damping': (r'exponent \* slope \* factor', 1, 'contact/normal_text.h'),
    "tangent of the wall's contact": (r'mul_sub\(share, dot\(', 1, 'contact/wall_text.h'),
    'bending stiffness under tension (corotational beam)': (r'= 4\.0 / 30\.0', 1, 'string/beam_text.h'),
    'inertia of a section': (r'body\.added_mass \* dot\(', 1, 'rig/rigid_body_text.h'),
    "mud's drag across and along the string": (r'by_speed \* sideways\)', 1, 'string/mud_text.h'),
    'closest point of the hole': (r'all\(0\.1\) \* speed2', 1, 'well/locate_text.h'),
    'inertia of a guided node': (r'mass \* acceleration\.x', 1, 'model/forces/guided_text.h'),
    'tension of a guided element': (r'axial \* \(\w+\.?stretch \+', 1, 'model/forces/guided_text.h'),
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
