"""How the assembly's drift depends on side cutting and stabiliser: short runs of the main job's scene with one thing changed."""
import os
import subprocess

from job import Job

DEPTH = 740.0  # [m]
VARIANTS = [
    ('as in the scene', []),
    ('no side cutting', ['string[0].side_cutting=0']),
    ('side cutting 0.3', ['string[0].side_cutting=0.3']),
    ('no stabiliser blades', ['string[3].blade_diameter=0.2032']),
    ('stabiliser 0.3112 m, full gauge', ['string[3].blade_diameter=0.3112']),
    ('straight motor', ['string[1].bend_deg=0']),
]


def report(drill, scene, folder):
    """Writes drift.md: turn of the corrected path per 30 m for each variant."""
    lines = ['| variant | inclination [deg/30 m] | azimuth [deg/30 m] |', '| --- | --- | --- |']
    for name, settings in VARIANTS:
        place = os.path.join(folder, 'drift', name.replace(' ', '_').replace(',', ''))
        os.makedirs(place, exist_ok=True)
        command = [drill, 'run', scene, '--until-depth', str(DEPTH), '--csv', os.path.join(place, 'series.csv'),
                   '--json', os.path.join(place, 'summary.json'), '--path', os.path.join(place, 'path.csv'),
                   '--raw-path', os.path.join(place, 'raw_path.csv')]
        for setting in settings:
            command += ['--set', setting]
        if subprocess.call(command, stdout=subprocess.DEVNULL) != 0:
            lines.append('| %s | the run failed | |' % name)
            continue
        rates = Job(scene, place).drift_rates()
        lines.append('| %s | %+.2f | %+.2f |' % (name, rates[0], rates[1]))
    with open(os.path.join(folder, 'drift.md'), 'w') as out:
        out.write('\n'.join(lines) + '\n')
    print('\n'.join(lines))
