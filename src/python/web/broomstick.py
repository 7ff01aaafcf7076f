# SPDX-License-Identifier: BSD-3-Clause
"""The broomstick chart: hook load over the depth of the bit, picked up, slacked off and rotating, for several frictions; worked out as `drill static`
does, in a process of its own at low priority. Run as a module, it is that process: a scene's text by standard input, a JSON line for each point by
standard output. Where the run has shown weights, the string moves through the mud as it did then."""
import asyncio
import json
import os
import re
import statistics
import sys
import tempfile

import yaml

FACTORS = (1.0, 0.5, 1.5)   # of the scene's friction, the scene's own first
SHARES = (1.0, 0.85, 0.7, 0.55, 0.4, 0.25, 0.15)  # of the depth of the hole at which the bit stands
OFF_BOTTOM = 1.0            # [m]
MOST_FRICTION = 5.0         # that a scene may have


def scene_at(scene, bit_depth, factor):
    """A scene whose bit hangs at a depth, with other friction. A hole that became deeper than its stations goes on straight."""
    well = dict(scene["well"])
    if "sections" in well:
        well["sections"] = [{**section, "friction": min(factor * section.get("friction", 0.0), MOST_FRICTION)} for section in well["sections"]]
    deepest = bit_depth + OFF_BOTTOM
    if well.get("stations") and well["stations"][-1][0] < deepest:
        well["stations"] = [*well["stations"], [deepest, *well["stations"][-1][1:]]]
    if well.get("hole_depth", deepest) < deepest:
        well["hole_depth"] = deepest
    if well.get("sections") and well["sections"][-1].get("to", deepest) < deepest:
        well["sections"][-1]["to"] = deepest
    start = {**scene.get("start", {}), "bit_depth": bit_depth, "weight_on_bit": 0.0, "torque_on_bit": 0.0}
    return {**scene, "well": well, "start": start}


def assembly_length(scene):
    """Of the parts below the pipe that reaches to the surface [m]."""
    parts = [part for part in scene.get("string", []) if part.get("joints") != "fill"]
    return sum(part["length"] if "length" in part else part.get("joints", 1) * part.get("joint_length", 0.0) for part in parts)


def cases(scene, depth):
    """Factor, depth and motion of each point, none with the assembly above the table; what rotates has the same weight with any friction."""
    depths = [share * (depth - OFF_BOTTOM) for share in SHARES if share == SHARES[0] or share * (depth - OFF_BOTTOM) > assembly_length(scene)]
    return [(factor, bit_depth, motion) for factor in FACTORS for bit_depth in depths
            for motion in (("up", "down", "rotate") if factor == 1.0 else ("up", "down"))]


def ways_of(weights):
    """How the string was moved in the weights of a run, by motion: medians of speed [m/s], rotation [rad/s] and flow [m3/s]. A motion that the run has
    not shown is left out."""
    ways = {}
    for motion in sorted({weight["motion"] for weight in weights}):
        own = {name: statistics.median(weight[name] for weight in weights if weight["motion"] == motion) for name in ("speed", "rotation", "flow")}
        ways[motion] = {**own, "speed": 0.0} if motion == "rotate" else {**own, "rotation": 0.0}
    return ways


def points(scene, depth, ways=()):
    """Dicts of factor, motion, depth [m] and load, as the gauge shows it [N]; load is None and `why` says it where there is no equilibrium. `ways`: as
    ways_of() has them; a motion without one has no drag of the mud."""
    from drill_rig_sim.lockstep import Refused
    from drill_rig_sim.sim import static
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "broomstick.yaml")
        for factor, bit_depth, motion in cases(scene, depth):
            with open(file, "w", encoding="utf-8") as out:
                yaml.safe_dump(scene_at(scene, bit_depth, factor), out)
            point = {"factor": factor, "motion": motion, "depth": bit_depth}
            try:
                loads = static(file, **ways[motion]) if motion in ways else static(file, motion)
                yield {**point, "load": loads["hook_load_gauge"]}
            except (Refused, ValueError) as refusal:
                yield {**point, "load": None, "why": re.sub(r"^\S*broomstick.yaml:(\d+: )?", "", str(refusal).splitlines()[0])}


def main():
    os.nice(10)
    order = json.load(sys.stdin)
    for point in points(yaml.safe_load(order["scene"]), order["depth"], order["ways"]):
        print(json.dumps(point), flush=True)


class Broomstick:
    """What a page is sent of it: `message`. One is worked out at a time."""

    def __init__(self):
        self.message = {"type": "broomstick", "points": [], "ways": {}, "done": False, "running": False, "problem": ""}
        self.revision, self._task = 0, None

    def begin(self, scene, depth, ways):
        """`scene`: text of a scene; `ways`: as points() has them. Why it cannot be, or ""."""
        if self.message["running"]:
            return "the broomstick is already being computed"
        self.message = {**self.message, "points": [], "ways": ways, "done": False, "running": True, "problem": "", "count": len(cases(yaml.safe_load(scene), depth))}
        self._task = asyncio.ensure_future(self._work({"scene": scene, "depth": depth, "ways": ways}))
        return ""

    async def _work(self, order):
        child = await asyncio.create_subprocess_exec(sys.executable, "-m", "drill_rig_sim.web.broomstick", stdin=asyncio.subprocess.PIPE,
                                                     stdout=asyncio.subprocess.PIPE, stderr=asyncio.subprocess.PIPE)
        try:
            child.stdin.write(json.dumps(order).encode())
            child.stdin.close()
            async for line in child.stdout:
                self.message["points"].append(json.loads(line))
                self.revision += 1
            errors = (await child.stderr.read()).decode().strip().splitlines()
            if await child.wait() != 0:
                self.message["problem"] = errors[-1] if errors else "ended with status %d" % child.returncode
        finally:
            if child.returncode is None:
                child.kill()
            self.message.update(running=False, done=not self.message["problem"])
            self.revision += 1


if __name__ == "__main__":
    main()
