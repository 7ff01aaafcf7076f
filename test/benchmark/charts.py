"""Draws one chart per scene: cost against error, every point, the Pareto front and the default."""
import os

import matplotlib

matplotlib.use('Agg')
matplotlib.rcParams['svg.hashsalt'] = 'drill_rig_sim'  # equal data, equal file
import matplotlib.lines as lines  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402

import drill  # noqa: E402
import points as points_of  # noqa: E402
import verdict  # noqa: E402

COLORS = dict(zip(drill.METHODS, ('#1f77b4', '#9467bd', '#8c564b', '#2ca02c', '#ff7f0e', '#d62728', '#17becf', '#7f7f7f')))
MARKERS = ('o', 's', '^', 'v', 'D')
DASHES = dict(zip(drill.ELEMENTS, ('-', '--', ':')))
# of meshes that compete, and with those that are too coarse to (points.mark_coarse())
FRONTS = {False: {'color': 'black', 'linewidth': 3.5, 'alpha': 0.2}, True: {'color': 'black', 'linewidth': 1.2, 'alpha': 0.3, 'linestyle': '--'}}
FAR = 2.0  # errors beyond are drawn at the edge: a run that far off is off, no matter how far


def groups(points):
    """Points that worked, by what a line joins: (method, element, length, Newton tolerance, reference tolerance) -> points by step."""
    out = {}
    for p in points:
        if p.errors:
            out.setdefault((p.method, p.element, p.length, p.newton, p.tolerance), []).append(p)
    return {key: sorted(group, key=lambda p: p.step) for key, group in out.items()}


def draw_cost(axes, points, cost, lengths, own_error):
    for (method, element, length, newton, tolerance), group in groups(points).items():
        axes.plot([min(p.error, FAR) for p in group], [getattr(p, cost) for p in group], linestyle=(0, (1, 1)) if newton else DASHES[element],
                  marker=MARKERS[lengths.index(length) % len(MARKERS)], color=COLORS[method], markersize=4, fillstyle='none' if newton or tolerance else 'full', linewidth=0.9, alpha=0.85)
    for any_mesh in (True, False):
        best = verdict.front([(p.error, getattr(p, cost)) for p in points if p.errors and (p.counted or cost == 'cpu') and (any_mesh or not p.coarse)])
        axes.plot([min(e, FAR) for e, _ in best], [c for _, c in best], zorder=0, solid_capstyle='round', **FRONTS[any_mesh])
    for p in points:
        if p.default and p.errors:
            axes.plot(min(p.error, FAR), getattr(p, cost), marker='*', color='black', markersize=14, fillstyle='none', markeredgewidth=1.5, zorder=5)
    axes.set_xscale('log')
    axes.set_yscale('log')
    if own_error > 0.0:
        left = axes.get_xlim()[0]
        axes.axvspan(min(left, own_error), own_error, color='0.9', zorder=-1)
        axes.set_xlim(left=left)
    axes.grid(True, which='major', linewidth=0.4)
    axes.set_xlabel('relative error of the outputs')


def legend(points, lengths, own_error):
    seen = groups(points)
    handles = [lines.Line2D([], [], color=COLORS[m], label=m) for m in drill.METHODS if any(key[0] == m for key in seen)]
    handles += [lines.Line2D([], [], color='0.3', linestyle='', marker=MARKERS[k % len(MARKERS)], markersize=5, label='elements: ' + points_of.mesh(length))
                for k, length in enumerate(lengths)]
    handles += [lines.Line2D([], [], color='0.3', linestyle=DASHES[e], label=e) for e in drill.ELEMENTS[1:] if any(key[1] == e for key in seen)]
    loose = sorted({p.newton for p in points if p.newton and p.errors})
    handles += [lines.Line2D([], [], color='0.3', linestyle=(0, (1, 1)), marker='o', fillstyle='none', markersize=5, label='Newton to %g' % n) for n in loose]
    handles.append(lines.Line2D([], [], color='black', linestyle='', marker='*', markersize=11, fillstyle='none', label='the default'))
    handles += [lines.Line2D([], [], label='Pareto front' + (', coarser meshes too' if any_mesh else ''), **style) for any_mesh, style in FRONTS.items()]
    if own_error > 0.0:
        handles.append(lines.Line2D([], [], color='0.9', linewidth=6, label="below the reference's own error"))
    return handles


def draw(scene, points, note, own_error, folder):
    """Writes SCENE.svg and SCENE.png; returns their names."""
    lengths = sorted({p.length for p in points}, reverse=True)
    figure, (left, right) = plt.subplots(1, 2, figsize=(12.0, 4.6))
    draw_cost(left, points, 'cpu', lengths, own_error)
    left.set_ylabel('CPU seconds per simulated second')
    draw_cost(right, points, 'work', lengths, own_error)
    right.set_ylabel('counted work: instructions per simulated second')
    recipe = note['recipe']
    figure.suptitle('%s (%s), %g s; reference: %s, %g ms, %g m' % (scene.title, scene.name, scene.duration, recipe['integrator'],
                                                                   1e3 * recipe['step'], recipe['element_length']), fontsize=11)
    figure.legend(handles=legend(points, lengths, own_error), loc='center right', fontsize=8, frameon=False)
    figure.tight_layout(rect=(0.0, 0.0, 0.82, 1.0))
    names = []
    for end, options in (('svg', {'metadata': {'Date': None}}), ('png', {'dpi': 90, 'metadata': {'Software': None}})):
        names.append(scene.name + '.' + end)
        figure.savefig(os.path.join(folder, names[-1]), **options)
    plt.close(figure)
    return names
