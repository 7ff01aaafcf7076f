# SPDX-License-Identifier: BSD-3-Clause
"""Text files as the simulator reads them: UTF-8, UTF-16 with a byte order mark, else latin-1, which is reported. Needs no ROS."""
import logging
import os

from drill_rig_sim.refusal import Refusal

LONGEST = 2**24  # bytes of a scene, a survey or a plan
_reported = set()
_stands_for = {}  # files that remarks name, by the path of a file that was written in their place


class TextError(Refusal):
    """Why a text file cannot be read, in one line with its name."""


def stands_for(path, file):
    """Remarks on the file at `path`, which was written in the place of another one, name that one. The path."""
    _stands_for[path] = file
    return path


def report(remarks):
    """Logs what readers remark of a file, each once in a process: on stderr, where no log is set up."""
    for remark in remarks:
        for path, file in _stands_for.items():
            remark = remark.replace(path, file)
        if remark not in _reported:
            _reported.add(remark)
            logging.getLogger("drill_rig_sim").warning("%s", remark)


def plain_utf8(file, longest):
    """The text of a file where the Python module sim is not built, as after only ./launch/demo: the package's own files are UTF-8."""
    try:
        with open(file, "rb") as source:
            text = source.read(longest + 1).decode("utf-8-sig")
    except OSError as error:
        raise TextError("%s: %s" % (file, error.strerror))
    except UnicodeDecodeError:
        raise TextError("%s: is not UTF-8; other encodings are read by the Python module sim, which is not built (it needs pybind11-dev)" % file)
    if len(text) > longest or "\0" in text:
        raise TextError("%s: is not text, or longer than %d bytes" % (file, longest))
    return text


def decoded(file, longest=LONGEST):
    """The text of a file of at most `longest` bytes, and what is to be reported of its encoding: one line, or "". TextError where it is none."""
    try:
        from drill_rig_sim import _sim  # pylint: disable=import-outside-toplevel
        from drill_rig_sim.lockstep import Refused  # pylint: disable=import-outside-toplevel
    except ImportError:
        return plain_utf8(file, longest), ""
    try:
        return _sim.read_text(os.fspath(file), longest)
    except Refused as refusal:
        raise TextError(str(refusal).splitlines()[0])


def read_text(file):
    """The text of a file; its encoding is reported. TextError where it is none."""
    text, remark = decoded(file)
    report([remark] if remark else [])
    return text
