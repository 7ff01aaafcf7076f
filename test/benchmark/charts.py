# SPDX-License-Identifier: BSD-3-Clause
"""Draws one chart per scene: cost against error, every point, the Pareto front, the default and level auto."""
import os

import matplotlib

matplotlib.use('Agg')
matplotlib.rcParams['svg.hashsalt'] = 'drill_rig_sim'  # equal data, equal file
import matplotlib.lines as lines  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402

import drill  # noqa: E402
import points as points_of  # noqa: E402
import verdict  # noqa: E402

COLORS = dict(zip(drill.METHODS, ('#1f77b4', '#8c564b', '#c49c94', '#2ca02c', '#ff7f0e', '#bcbd22', '#17becf', '#7f7f7f')))
# of lines over variable steps and of levels of guided pipe, which outweigh those of the methods
LEVELS = {points_of.BEAM: '#08306b', points_of.HYBRID: '#d6279b', points_of.AXIAL: '#6a3d9a'}
AUTO = '#d62728'
MARKERS = ('o', 's', '^', 'v', 'D')
DASHES = dict(zip(drill.ELEMENTS, ('-', '--', ':')))
# of what competes, and with meshes and levels that do not (points.mark_coarse())
FRONTS = {False: {'color': 'black', 'linewidth': 3.5, 'alpha': 0.2}, True: {'color': 'black', 'linewidth': 1.2, 'alpha': 0.3, 'linestyle': '--'}}
FAR = 10.0  # over the default's: errors beyond are drawn at the edge, a run that far off is off, no matter how far


def groups(points):
    """Points that worked, by what a line joins: (level, variable, method, element, length, Newton tolerance, reference tolerance) -> points by step
    or, of variable steps, by tolerance."""
    out = {}
    for p in points:
        if p.errors and p.level != points_of.AUTO:
            variable = p.step == points_of.VARIABLE
            out.setdefault((p.level, variable, p.method, p.element, p.length, p.newton, None if variable else p.tolerance), []).append(p)
    return {key: sorted(group, key=lambda p: (p.step, p.tolerance or 0.0)) for key, group in out.items()}


def style_of(key, lengths):
    level, variable, method, element, length, newton, tolerance = key
    own = variable or level != points_of.BEAM
    return {'color': LEVELS[level] if own else COLORS[method], 'marker': MARKERS[lengths.index(length) % len(MARKERS)],
            'markersize': 4.5 if own else 3, 'fillstyle': 'none' if newton or tolerance or own and not variable else 'full',
            'linestyle': (0, (1, 1)) if newton or own and not variable else DASHES[element], 'linewidth': 1.8 if variable else 0.8,
            'alpha': 0.95 if own else 0.5, 'zorder': 3 if own else 2}


def edge(points):
    """The largest error that is drawn where it is."""
    default = next(p for p in points if p.default)
    return FAR * default.error if default.errors else max([p.error for p in points if p.errors], default=1.0)


def draw_auto(axes, points, cost, far):
    """Stars by tolerance, joined."""
    stars = sorted((p for p in points if p.errors and p.level == points_of.AUTO), key=lambda p: p.tolerance)
    axes.plot([min(p.error, far) for p in stars], [getattr(p, cost) for p in stars], color=AUTO, linewidth=1.2, marker='*', markersize=12,
              markeredgecolor='white', markeredgewidth=0.6, zorder=6)
    for p in stars:
        axes.annotate(points_of.percent(p.tolerance), (min(p.error, far), getattr(p, cost)), xytext=(6, 5), textcoords='offset points', color=AUTO, fontsize=9,
                      fontweight='bold', zorder=7, bbox={'facecolor': 'white', 'edgecolor': 'none', 'alpha': 0.7, 'pad': 0.5})


def draw_cost(axes, points, cost, lengths, own_error):
    far = edge(points)
    for key, group in groups(points).items():
        axes.plot([min(p.error, far) for p in group], [getattr(p, cost) for p in group], **style_of(key, lengths))
    draw_auto(axes, points, cost, far)
    for any_mesh in (True, False):
        best = verdict.front([(p.error, getattr(p, cost)) for p in points if p.errors and (p.counted or cost == 'cpu') and (any_mesh or not p.coarse)])
        axes.plot([min(e, far) for e, _ in best], [c for _, c in best], zorder=0, solid_capstyle='round', **FRONTS[any_mesh])
    for p in points:
        if p.default and p.errors:
            axes.plot(min(p.error, far), getattr(p, cost), marker='*', color='black', markersize=14, fillstyle='none', markeredgewidth=1.5, zorder=5)
    axes.set_xscale('log')
    axes.set_yscale('log')
    if own_error > 0.0:
        left = axes.get_xlim()[0]
        axes.axvspan(min(left, own_error), own_error, color='0.9', zorder=-1)
        axes.set_xlim(left=left)
    axes.grid(True, which='major', linewidth=0.4)
    axes.set_xlabel('relative error of the outputs; beyond %.2g at the edge' % far)


def legend(points, lengths, own_error):
    seen = groups(points)
    fixed = {key[2] for key in seen if key[0] == points_of.BEAM and not key[1]}
    handles = [lines.Line2D([], [], color=COLORS[m], alpha=0.7, label=m) for m in drill.METHODS if m in fixed]
    handles += [lines.Line2D([], [], color=color, linewidth=1.8, label=level + ', variable steps') for level, color in LEVELS.items() if any(key[:2] == (level, True) for key in seen)]
    handles += [lines.Line2D([], [], color=color, linewidth=0.8, linestyle=(0, (1, 1)), marker='o', fillstyle='none', markersize=4.5, label=level + ', fixed steps')
                for level, color in LEVELS.items() if level != points_of.BEAM and any(key[:2] == (level, False) for key in seen)]
    handles += [lines.Line2D([], [], color='0.3', linestyle='', marker=MARKERS[k % len(MARKERS)], markersize=5, label='elements: ' + points_of.mesh(length))
                for k, length in enumerate(lengths)]
    handles += [lines.Line2D([], [], color='0.3', linestyle=DASHES[e], label=e) for e in drill.ELEMENTS[1:] if any(key[3] == e for key in seen)]
    if any(p.newton and p.errors for p in points):
        handles.append(lines.Line2D([], [], color='0.3', linestyle=(0, (1, 1)), marker='o', fillstyle='none', markersize=4, label='other Newton tolerance'))
    handles.append(lines.Line2D([], [], color='black', linestyle='', marker='*', markersize=11, fillstyle='none', label='the default'))
    if any(p.errors and p.level == points_of.AUTO for p in points):
        handles.append(lines.Line2D([], [], color=AUTO, linewidth=1.2, marker='*', markersize=10, label='auto, at its tolerances'))
    handles += [lines.Line2D([], [], label='Pareto front' + (', any mesh and level' if any_mesh else ''), **style) for any_mesh, style in FRONTS.items()]
    if own_error > 0.0:
        handles.append(lines.Line2D([], [], color='0.9', linewidth=6, label="below the reference's own error"))
    return handles


def draw(scene, points, note, own_error, folder):
    """Writes SCENE.svg and SCENE.png; returns their names."""
    lengths = sorted({p.length for p in points}, reverse=True)
    figure, (left, right) = plt.subplots(1, 2, figsize=(12.0, 5.2))
    draw_cost(left, points, 'cpu', lengths, own_error)
    left.set_ylabel('CPU seconds per simulated second')
    draw_cost(right, points, 'work', lengths, own_error)
    right.set_ylabel('counted work: instructions per simulated second')
    recipe = note['recipe']
    figure.suptitle('%s (%s), %g s; reference: %s, %g ms, %g m' % (scene.title, scene.name, scene.duration, recipe['integrator'],
                                                                   1e3 * recipe['step'], recipe['element_length']), fontsize=11)
    figure.legend(handles=legend(points, lengths, own_error), loc='center right', fontsize=8, frameon=False)
    figure.tight_layout(rect=(0.0, 0.0, 0.81, 1.0))
    names = []
    for end, options in (('svg', {'metadata': {'Date': None}}), ('png', {'dpi': 90, 'metadata': {'Software': None}})):
        names.append(scene.name + '.' + end)
        figure.savefig(os.path.join(folder, names[-1]), **options)
    plt.close(figure)
    return names
