# SPDX-License-Identifier: BSD-3-Clause
"""Makes an FMU of a folder's files, for `drill fmu`: python3 -m drill_rig_sim.fmu_archive FOLDER FILE. Exit status 0 done, 2 it cannot be written."""
import os
import sys
import zipfile

OLDEST = (1980, 1, 1, 0, 0, 0)  # one time for all files: the same rig gives the same archive


def archive(folder, file):
    """Writes the file whole, or leaves what was there."""
    names = sorted(os.path.relpath(os.path.join(place, name), folder) for place, _, names in os.walk(folder) for name in names)
    unfinished = file + ".part"
    try:
        with zipfile.ZipFile(unfinished, "w", zipfile.ZIP_DEFLATED) as out:
            for name in names:
                with open(os.path.join(folder, name), "rb") as content:
                    out.writestr(zipfile.ZipInfo(name, OLDEST), content.read(), zipfile.ZIP_DEFLATED)
        os.replace(unfinished, file)
    except OSError:
        if os.path.exists(unfinished):
            os.remove(unfinished)
        raise


if __name__ == "__main__":
    try:
        archive(*sys.argv[1:])
    except OSError:
        sys.exit(2)  # the caller names the file
