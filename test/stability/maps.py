# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of the stability map: largest stable step along each axis, a curve a method."""
import os

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as pyplot  # noqa: E402 (the backend comes first)

from tables import AXES, unique, who  # noqa: E402

COLOURS = ['#1f5fa8', '#c0392b', '#2e8b57', '#d9822b', '#7d3c98', '#16a0a0', '#8a6d3b', '#444444', '#e377c2', '#999999']
MARKS = 'osv^D<>Pphx'
LOWEST = 7e-6  # where `none` is drawn [s]
pyplot.rcParams.update({'font.size': 9, 'axes.grid': True, 'grid.alpha': 0.3, 'savefig.bbox': 'tight', 'svg.hashsalt': 'drill_rig_sim'})


def draw_axis(axes, rows, axis, names, default_step):
    mine = [row for row in rows if row['case'] == axis]
    for k, name in enumerate(names):
        points = [(float(row['value']), float(row['figure']) or LOWEST) for row in mine if who(row) == name]
        if not points:
            continue
        # side by side where they meet, the default where it is
        shift = 1.0 + 0.03 * k
        axes.plot([p[0] for p in points], [p[1] * shift for p in points], marker=MARKS[k % len(MARKS)], markersize=4, linewidth=2.2 if k == 0 else 1.0,
                  color=COLOURS[k % len(COLOURS)], label=name + (' (default)' if k == 0 else ''), zorder=9 if k == 0 else 3)
    if any(float(row['value']) == 0.0 for row in mine):
        axes.set_xscale('symlog', linthresh=1.0)
    else:
        axes.set_xscale('log')
    axes.set_yscale('log')
    axes.set_ylim(5e-6, 0.2)
    axes.set_xlabel(AXES[axis])
    axes.axhline(default_step, color='black', linewidth=0.8, linestyle=':')


def draw(rows, folder):
    """Draws into `folder`; returns the files' names."""
    corners = [row for row in rows if row['group'] == 'corners']  # run at the default's step
    rows = [row for row in rows if row['group'] == 'map' and row['method'] != 'reference']
    if not rows or not corners:
        return []
    default_step = float(corners[0]['figure'])
    names = unique(who(row) for row in rows)
    figure, grid = pyplot.subplots(2, 3, sharey=True, figsize=(11.0, 6.5))
    panels = grid.flatten()
    for panel, axis in zip(panels, AXES):
        draw_axis(panel, rows, axis, names, default_step)
    for panel in grid[:, 0]:
        panel.set_ylabel('largest stable step [s]')
    panels[5].axis('off')
    handles = {}
    for panel in panels[:5]:
        for handle, label in zip(*panel.get_legend_handles_labels()):
            handles.setdefault(label, handle)
    panels[5].legend(handles.values(), handles.keys(), loc='center', title='dotted: the default step, %g ms;\nat the lower edge: none, or too slow to tell' % (1e3 * default_step))
    figure.suptitle('Largest step that passes without halving; pipe lowered and turned in an inclined hole')
    figure.tight_layout()
    for ending in ('svg', 'png'):
        figure.savefig(os.path.join(folder, 'map.' + ending), dpi=110)
    pyplot.close(figure)
    return ['map.svg', 'map.png']
