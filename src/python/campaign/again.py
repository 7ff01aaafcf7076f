# SPDX-License-Identifier: BSD-3-Clause
"""A run of a campaign once more: played in this process, or as files for a node and rviz."""
import os
import shlex
from xml.sax.saxutils import escape, quoteattr

from drill_rig_sim.campaign.blueprint import SEED, Blueprint
from drill_rig_sim.campaign.results import ResultsError
from drill_rig_sim.campaign.runner import GOOD, outcome
from drill_rig_sim.campaign.scene_text import written
from drill_rig_sim.score_runs import write_series

COMMAND = "rosrun drill_rig_sim drill_campaign"
LAUNCH = """<!-- Run {number} of the campaign {name}: its scene, controller, parameters and seed. drill score judges all of it, the campaign what came after {begin:g} s. -->
<launch>
  <arg name="headless" default="false" doc="true: in lockstep, as fast as possible, no window; ends with the score. False: in real time, by topics"/>
  <arg name="rviz" default="false" doc="show the rig in rviz"/>
  <arg name="csv" default="" doc="headless: file for the truth, as drill run --csv writes it"/>
  <!-- within an include, $(dirname) is the folder of the included file on Debian 11 -->
  <arg name="folder" value="$(dirname)"/>

  <include file="$(find drill_rig_sim)/launch/rig.launch">
    <arg name="scene" value={scene}/>
    <arg name="rate" value="{rate:g}"/>
    <arg name="seed" value="{seed}"/>
    <arg name="clock" value="$(eval 'lockstep' if headless else 'realtime')"/>
    <arg name="headless" value="$(arg headless)"/>
    <arg name="rviz" value="$(arg rviz)"/>
  </include>
  <node ns="rig" pkg="drill_rig_sim" type="controller.py" name="controller" output="screen" required="true">
    <param name="law" value={law}/>
    <param name="lockstep" value="$(arg headless)"/>
    <param name="timeout" value="{duration!r}"/>
    <param if="$(eval csv != '')" name="csv" value="$(arg csv)"/>
    <rosparam>
      settings: {settings}
      score: {score}
    </rosparam>
  </node>
</launch>
"""


def run_of(results, number):
    """A run's row and the blueprint of its campaign."""
    about = results.about()
    if "blueprint" not in about:
        raise ResultsError("%s: holds no campaign" % results.file)
    for row in results.rows():
        if row["number"] == number:
            return row, Blueprint.of_parts(about["blueprint"])
    raise ResultsError("%s: has no run %d" % (results.file, number))


# --- in this process


def play(results, number, csv=None):
    """Whether it ended as it did in the campaign, and well; and what to say of it, in lines."""
    row, blueprint = run_of(results, number)
    status, reason, outputs, over = outcome(blueprint, row["values"])
    lines = ["run %d: %s%s" % (number, status, ": " + reason if reason else "")]
    lines += ["%-30s %s" % (name, "none" if value is None else repr(value)) for name, value in outputs.items()]
    if csv is not None:
        if over is None:
            lines.append("%s is not written: the run did not go to its end" % csv)
        else:
            write_series(over.whole, csv)
            lines.append(csv)
    same = (status, reason, outputs) == (row["status"], row["reason"], row["outputs"])
    lines.append("as in %s, to the last bit" % results.file if same else "not as in %s: %s" % (results.file, there(row, results.about()["identity"])))
    return same and status == GOOD, lines


def there(row, identity):
    """How it ended in the campaign, and by which build."""
    ended = "%s %s" % (row["status"], row["reason"] or ", ".join("%s %r" % pair for pair in row["outputs"].items()))
    return "%s; build and kernel there: %s %s" % (ended, identity[0][:8], identity[1])


# --- for a node


def write_files(results, number, file):
    """The scene's file of a run, beside it its survey where it has one, and where it has a controller that and a launch file. What to say of it, in lines."""
    row, blueprint = run_of(results, number)
    written_files = {file: blueprint.scene_of(row["values"], os.path.basename(file) + ".survey.csv")}
    if blueprint.survey is not None:
        written_files[file + ".survey.csv"] = blueprint.survey
    if blueprint.controller is not None:
        base = os.path.splitext(file)[0]
        if blueprint.controller.text is not None:
            written_files[base + ".law.py"] = blueprint.controller.text
        written_files[base + ".launch"] = launch_file(blueprint, row, os.path.basename(file), os.path.basename(base) + ".law.py")
    for name, text in written_files.items():
        with open(name, "w", encoding="utf-8") as out:
            out.write(text)
    return list(written_files) + ["shown by: " + show_command(blueprint, row["values"], os.path.abspath(file)),
                                  "its numbers again: " + play_command(results.file, number)]


def launch_file(blueprint, row, scene, law):
    """Of a rig with the controller, beside scene and law."""
    controller, values = blueprint.controller, row["values"]
    where = controller.where if controller.text is None else "$(dirname)/%s:%s" % (law, controller.name)
    score = {name: value for name, value in blueprint.judge.items() if name != "plan"}
    return LAUNCH.format(number=row["number"], name=blueprint.name.replace("--", "-"), begin=blueprint.begin, scene=quoteattr("$(arg folder)/" + scene), rate=blueprint.rate,
                         seed=blueprint.seed_of(values), law=quoteattr(where), duration=float(blueprint.duration),
                         settings=escape(written(blueprint.parameters_of(values))), score=escape(written(score)))


def commands(blueprint, row, results_file):
    """What shows a run and plays it, a command a line."""
    file = "run_%d.yaml" % row["number"]
    return [scene_command(results_file, row["number"]) + " --out " + file, show_command(blueprint, row["values"], "$PWD/" + file),
            play_command(results_file, row["number"]) + " --csv run_%d.csv" % row["number"]]


def scene_command(results_file, number):
    return "%s scene %s --run %d" % (COMMAND, shlex.quote(results_file), number)


def play_command(results_file, number):
    return "%s play %s --run %d" % (COMMAND, shlex.quote(results_file), number)


def show_command(blueprint, values, scene):
    """By rig.launch with the scene's program, its seed where one counts; with a controller by the launch file beside the scene."""
    path = scene if scene.startswith("$PWD/") else shlex.quote(scene)
    if blueprint.controller is not None:
        return "roslaunch %s rviz:=true    # headless:=true: in lockstep, as in the campaign" % (os.path.splitext(path)[0] + ".launch")
    seed = blueprint.seed_of(values)
    seeded = " seed:=%d" % seed if seed or SEED in blueprint.values_by_key(values) else ""
    rate = " rate:=%g" % blueprint.rate if blueprint.rate != 100.0 else ""
    return "roslaunch drill_rig_sim rig.launch scene:=%s play_program:=true%s%s rviz:=true" % (path, seeded, rate)
