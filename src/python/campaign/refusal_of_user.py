# SPDX-License-Identifier: BSD-3-Clause
"""Refusals of a scene that was written with other values, by the files that its user wrote."""
import re

from drill_rig_sim.campaign.runner import one_line
from drill_rig_sim.campaign.scene_text import survey_file

SCENE, SURVEY = re.compile(r"(^|; )scene\.yaml(?::(\d+))?: "), re.compile(r"(^|; )survey\.csv(?=:)")


def line_of_user(refusal, blueprint, row, file):
    """A refusal of a blueprint's scene of a row of values in one line, with the user's scene file, the line in it where the user wrote that one, and the user's survey."""
    values = blueprint.values_with_survey(row)

    def place(match):
        line = blueprint.template.line_of(int(match[2]), values) if match[2] else None
        return "%s%s%s: " % (match[1], file, ":%d" % line if line else "")
    survey = survey_file(blueprint.scene, file)
    text = SCENE.sub(place, one_line(refusal, blueprint))
    return SURVEY.sub(lambda match: match[1] + survey, text) if survey else text
