"""Text files of any encoding, decoded by the same code as scenes and surveys (scene/text_file.h)."""
from drill_rig_sim import _sim
from drill_rig_sim.field.table import RecordError
from drill_rig_sim.lockstep import Refused


def read_text(file):
    """The text, and a remark on its encoding or "". RecordError with one line where it cannot be read."""
    try:
        return _sim.read_text(file)
    except Refused as refusal:
        raise RecordError(str(refusal).splitlines()[0])
