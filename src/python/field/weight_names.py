# SPDX-License-Identifier: BSD-3-Clause
"""What the trade calls the columns of a table of weights."""
from drill_rig_sim.field.motions import MOTIONS
from drill_rig_sim.field.signals import word
from drill_rig_sim.field.table import bare

# the torque, of which a few numbers say little, has to be named
NAMES = {
    "depth": "md bit_depth measured_depth bit_md depth_md teufe tiefe profundidad profondeur profundidade dybde glubina",
    "pick_up": "pu pickup_weight pick_up_weight pu_weight pu_wt pickup_wt pick_up_wt up_weight upweight hook_load_up hookload_up hook_load_pick_up hookload_pick_up puw up "
               "subiendo levantando montee subindo opp ves_pri_podeme hakenlast_aufwarts hakenlast_aufwaerts aufwarts aufwaerts",
    "slack_off": "so slackoff_weight slack_off_weight so_weight so_wt slackoff_wt slack_off_wt down_weight downweight hook_load_down hookload_down hook_load_slack_off "
                 "hookload_slack_off sow down bajando descente descendo ned ves_pri_spuske hakenlast_abwarts hakenlast_abwaerts abwarts abwaerts",
    "rotating": "rot rotating_weight rot_weight rot_wt rotating_wt rotating_off_bottom free_rotating free_rotating_weight rob hook_load_rotating hookload_rotating rotw "
                "rotando ves_pri_vrashchenii hakenlast_drehend drehend",
}
BY_WORD = {word(name): what for what, names in NAMES.items() for name in names.split()}
EXACT = {word(what): what for what in ("depth", *MOTIONS) if what != "torque"}


def called(name):
    """depth or one of MOTIONS by the name of a column; None where it is none of them."""
    what = bare(name)
    return what if what in MOTIONS else EXACT.get(word(what)) or BY_WORD.get(word(what))
