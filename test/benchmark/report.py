# SPDX-License-Identifier: BSD-3-Clause
"""The verdict in words: for the terminal and for test/benchmark/README.md."""
import os

import reference
import verdict

ADVICE = 1.2  # another setting is named as better when it takes this much less work at no more error, in geometric mean


def better_settings(chosen_scenes, by_scene):
    """Settings (level, method, element, step, length, tolerances) that worked in every scene and beat the default there in geometric mean at no more error in
    geometric mean: (label, ratio of work, ratio of error), best first."""
    ratios = {}  # by setting: its point, and of each scene that it worked in work and error over the default's
    for scene in chosen_scenes:
        points = [p for p in by_scene[scene.name] if p.competes]
        default = next((p for p in points if p.default), None)
        if default is None:
            return []
        for p in points:
            if p.default:
                continue
            _, work, error = ratios.setdefault((p.method, p.element, p.step, p.length, p.newton, p.tolerance, p.level), (p, [], []))
            work.append(p.work / default.work)
            error.append(max(p.error, 1e-12) / max(default.error, 1e-12))
    means = [(p.label(), verdict.geometric_mean(work), verdict.geometric_mean(error)) for p, work, error in ratios.values() if len(work) == len(chosen_scenes)]
    return sorted((m for m in means if m[1] * ADVICE < 1.0 and m[2] <= 1.0), key=lambda m: m[1])


def allowed(scene):
    """The default's largest error in this scene, and why."""
    return '%g: %s' % (scene.largest_error, scene.why_so_large) if scene.largest_error else '-'


def rows(chosen_scenes, by_scene, notes, judged):
    judged_scenes = {s.name: s for s in judged.scenes}
    for scene in chosen_scenes:
        points = by_scene[scene.name]
        default = next(p for p in points if p.default)
        note = notes[scene.name]
        recipe = note['recipe']
        by = '%s, %g ms, %g m' % (recipe['integrator'], 1e3 * recipe['step'], recipe['element_length'])
        if scene.name not in judged_scenes:
            yield scene, default, None, None, by, reference.own_error(note)
            continue
        # the cheapest point that is as accurate: a name to the front
        s = judged_scenes[scene.name]
        rival = min((p for p in points if p.competes and p.error <= s.error), key=lambda p: p.work)
        yield scene, default, s, rival, by, reference.own_error(note)


def closing(chosen_scenes, by_scene, judged):
    lines = ['geometric mean of the ratios: %.2f (at most 1.5); with meshes coarser than the default\'s and cheaper levels: %.2f' % (judged.mean, judged.mean_on_any_mesh)]
    for label, work, error in better_settings(chosen_scenes, by_scene)[:3]:
        lines.append('better than the default over all scenes: %s: %.2f of its work at %.2f of its error' % (label, work, error))
    return lines + judged.complaints


def text(chosen_scenes, by_scene, notes, judged):
    lines = ['scene, error of the default, work / best at this error, cheapest as accurate, CPU s per simulated s, reference (its own error)']
    for scene, default, s, rival, by, own in rows(chosen_scenes, by_scene, notes, judged):
        if s is None:
            lines.append('%s, failed: %s' % (scene.name, default.failure))
            continue
        lines.append('%s, %.2e, %.2f, %s, %.4f, %s (%.1e)' % (scene.name, default.error, s.ratio, rival.label(), default.cpu, by, own))
    failures = [p for points in by_scene.values() for p in points if p.failure]
    lines.append('%d of %d points failed; points.csv says why' % (len(failures), sum(len(points) for points in by_scene.values())))
    return '\n'.join(lines + closing(chosen_scenes, by_scene, judged))


def write(chosen_scenes, by_scene, notes, judged, about, folder):
    """verdict.md; returns its name."""
    with open(os.path.join(folder, 'verdict.md'), 'w') as out:
        out.write('| scene | error of the default | allowed | the run warns | its work / the best\'s at this error | on any mesh or level | cheapest as accurate | '
                  'CPU s per simulated s | reference | its own error |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n')
        for scene, default, s, rival, by, own in rows(chosen_scenes, by_scene, notes, judged):
            if s is None:
                out.write('| %s | failed: %s | | | | | | | %s | %.1e |\n' % (scene.title, default.failure, by, own))
            else:
                out.write('| %s | %.1e | %s | %s | %.2f | %.2f | %s | %.4f | %s | %.1e |\n' % (
                    scene.title, default.error, allowed(scene), 'yes' if default.warned else 'no', s.ratio, s.ratio_on_any_mesh, rival.label(), default.cpu, by, own))
        out.write('\n%s.\n\n%s, %d cores, %s, %s; load %.1f; %s.\n' % ('; '.join(closing(chosen_scenes, by_scene, judged)), about['cpu'], about['cores'],
                                                                     about['compiler'], about['flags'], about['load'][0], about['date']))
    return ['verdict.md']
