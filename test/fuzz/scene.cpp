// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: bytes as a scene file. Either one line a problem comes back, or a rig that can be built, or one line why not; a
// rig that was built takes 50 frames of wild commands with everything it reports finite, and a snapshot brings back the same
// bits.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "counters.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/sim/simulator.h"
#include "random.h"
#include "shown.h"

namespace drill_rig_sim
{
namespace fuzz
{
namespace
{
constexpr int frames = 50;
constexpr double most_elements = 60.0;
constexpr std::size_t most_stations = 200;

/// The scene, or nothing if it is refused.
std::optional<Scene> read(const std::string& text)
{
  try
  {
    return parse_scene(text, "/nonexistent/scene.yaml");
  }
  catch (const SceneError& error)
  {
    check(!error.problems().empty(), "refused without a problem");
    for (const std::string& problem : error.problems()) check_refusal(problem);
    return std::nullopt;
  }
}

/// Would take so long that other inputs are of more use.
bool too_large(const Scene& scene)
{
  const double longest = element_lengths(scene).lower;
  double elements = 0.0;
  for (const PartSpec& part : scene.string)
  {
    const double length = part.joints == 0 ? scene.start.bit_depth + scene.start.block_height : part.length;
    const double joints = std::max(1.0, length / part.joint_length);
    elements += joints * std::max(1.0, std::ceil(part.joint_length / longest));
  }
  return !(elements <= most_elements) || scene.well.survey.size() > most_stations;
}

/// The rig, or nothing if there is a line that says why it cannot be built.
std::optional<Simulator> build(const Scene& scene, std::uint64_t seed)
{
  try
  {
    return Simulator(scene, seed);
  }
  catch (const std::runtime_error& error)
  {
    check_refusal(error.what());
    return std::nullopt;
  }
}

void command_wildly(Simulator& rig, Random& random)
{
  if (random.one_in(4)) rig.command(WinchSetpoint{random.wild(1.0), random.one_in(4)});
  if (random.one_in(4))
  {
    const auto mode = static_cast<TopDriveMode>(random.one_in(8) ? random.below(5) : random.below(2));
    rig.command(TopDriveSetpoint{mode, random.wild(20.0), random.wild(3e4), random.wild(10.0),
                                 random.one_in(2) ? 0.0 : random.wild(3e4)});
  }
  if (random.one_in(4)) rig.command(PumpSetpoint{random.wild(0.05)});
  if (random.one_in(20)) rig.tare();
  if (random.one_in(40)) rig.stick_pipe(random.wild(100.0));
  if (random.one_in(20)) rig.free_pipe();
}

/// Frames `first` to `last` under commands drawn from `random`; false if one of them could not be solved.
bool ride(Simulator& rig, int first, int last, Random random)
{
  const double step = rig.scene().numerics.step, frame = step > 0.0 ? step : default_step;
  for (int k = first; k < last; ++k)
  {
    command_wildly(rig, random);
    const FrameStatus status = rig.frame(frame * static_cast<double>(1 + random.below(2)));
    check_signals(rig);
    check(std::isfinite(rig.energy().residual()), "the energy balance is not finite");
    if (k % 10 == 0 || status == FrameStatus::failed) check_reports(rig);
    check((status == FrameStatus::failed) == (rig.failure()[0] != '\0'), "a frame's status and the failure's text disagree");
    if (status == FrameStatus::failed) return false;
  }
  return true;
}

/// The whole ride, with a snapshot on the way that is gone back to. The reference's memory is no part of a snapshot: it comes
/// back within its tolerance only, and so does whether a frame can be solved.
bool ride_with_snapshot(Simulator& rig, Random random)
{
  if (random.one_in(4)) rig.balance_energy();
  if (random.one_in(4)) rig.set_command_timeout(random.between(0.0, 0.1));
  const int middle = static_cast<int>(frames - 1 - random.below(12));
  if (!ride(rig, 0, middle, random)) return false;
  const auto snapshot = rig.save();
  const Random rest(random.next());
  const bool solved = ride(rig, middle, frames, rest);
  const std::vector<double> end = everything(rig);
  rig.restore(*snapshot);
  const bool solved_again = ride(rig, middle, frames, rest);
  if (rig.statistics().is_reference) return solved;
  check(solved_again == solved, "after a restored snapshot a frame fails that did not, or the other way round");
  check(bit_identical(everything(rig), end), "a restored snapshot does not lead to the same bits");
  return solved;
}

void take(const std::string& text)
{
  ++counters().inputs;
  const std::optional<Scene> scene = read(text);
  if (!scene)
  {
    ++counters().refused;
    return;
  }
  if (too_large(*scene))
  {
    ++counters().too_large;
    return;
  }
  const std::uint64_t seed = seed_of(text);
  std::optional<Simulator> rig = build(*scene, seed);
  if (!rig)
  {
    ++counters().unbuildable;
    return;
  }
  check_signals(*rig);
  check_reports(*rig);
  const bool solved = ride_with_snapshot(*rig, Random(seed));
  ++counters().accepted;
  if (!solved) ++counters().failed;
}
}  // namespace
}  // namespace fuzz
}  // namespace drill_rig_sim

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  drill_rig_sim::fuzz::take(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
