#ifndef DRILL_RIG_SIM_SRC_PYTHON_IN_PROCESS_RIG_H
#define DRILL_RIG_SIM_SRC_PYTHON_IN_PROCESS_RIG_H

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drill_rig_sim/scene/new_well.h"
#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/sim/player.h"
#include "drill_rig_sim/sim/simulator.h"

/// A rig that the caller steps, without ROS; by the same steps as the node in lockstep. What is refused is std::runtime_error with one line, and nothing has changed.
namespace drill_rig_sim
{
/// The signals by the names of RigState.msg; those that are constant in a process (header, run_state) or stamps are not there.
struct Signals
{
  RigSignals signals;
  int operation_number = 0;
  double operation_progress = 0.0;
  OperationKind operation_kind = OperationKind::wait;

  std::string current_operation() const;

  template <class V>
  void visit(V& v)
  {
    ByMessage<V> by_message{v};
    signals.visit(by_message);
    v("operation_number", operation_number);
    v("operation_progress", operation_progress);
  }

private:
  /// Set points are flat in the message, and the crew's task is a word: current_operation().
  template <class V>
  struct ByMessage
  {
    V& v;
    template <class T>
    void operator()(const char* name, T& field)
    {
      v(name, field);
    }
    void operator()(const char*, CrewTask&) {}
    void operator()(const char*, Setpoints& s)
    {
      v("winch", s.winch);
      v("top_drive", s.top_drive);
      v("mud_pump", s.pump);
      v("steering", s.steering);
      v("magnetic_steering", s.magnetic_steering);
    }
  };
};

/// A place in the frame of the rig floor [m].
struct Place
{
  double x = 0.0, y = 0.0, z = 0.0;

  template <class V>
  void visit(V& v)
  {
    v("x", x);
    v("y", y);
    v("z", z);
  }
};

/// By the names of BitTruth.msg.
struct Bit
{
  Place position;
  double wob = 0.0, torque = 0.0, speed = 0.0, inclination = 0.0, azimuth = 0.0, toolface = 0.0;

  template <class V>
  void visit(V& v)
  {
    v("position", position);
    v("wob", wob);
    v("torque", torque);
    v("speed", speed);
    v("inclination", inclination);
    v("azimuth", azimuth);
    v("toolface", toolface);
  }
};

/// What one frame tells.
struct Frame
{
  Signals readings, truth;
  Bit bit;
};

/// Of many frames, a row each.
struct Recording
{
  std::vector<Signals> readings, truth;
  std::vector<Bit> bit;
};

/// A state to go back to.
struct SavedRig
{
  std::shared_ptr<const SimulatorState> state;
  ScenePlayer player;
  bool playing;
};

class InProcessRig
{
public:
  /// The rig of a scene's file at its start. `rate`: frames a second. `play`: the scene's program and operations give the set points until a command does.
  InProcessRig(const std::string& scene_file, double rate, std::uint64_t seed, bool play);

  /// Set points from the next frame on; all of them are taken, or none.
  void command(const std::optional<WinchSetpoint>& winch, const std::optional<TopDriveSetpoint>& top_drive, const std::optional<PumpSetpoint>& pump,
               const std::optional<SteeringSetpoint>& steering);
  void advance(std::size_t frames);
  /// The state after the last frame.
  Frame frame() const;
  /// Computes so many frames; the state after every `every`-th of them and after the last.
  Recording record(std::size_t frames, std::size_t every);
  /// The last that has come up from downhole, if any.
  std::optional<ToolfaceReading> toolface() const;
  std::optional<MwdReading> survey() const;

  /// Back to the start of a scene's file, or of the present scene where `file` is empty; the bit at `bit_depth` [m MD], 0: where the scene has it.
  void reset(const std::string& file, double bit_depth);
  void load_survey(const NewWell& well);
  void tare();
  void fault(const std::string& name, bool clear, const std::string& target, double depth, double magnitude);
  void slips(bool are_set);
  void connection(std::uint32_t joints, bool remove);
  SavedRig save() const;
  void restore(const SavedRig& saved);

private:
  void require_good() const;
  void build(const Scene& scene);
  /// One frame; false and nothing else where the last one failed.
  bool one_frame() noexcept;
  [[noreturn]] void refuse_failure(std::size_t done, std::size_t frames) const;

  Scene scene_;  // of the file, whatever has been loaded since
  double off_bottom_, rate_;
  std::uint64_t seed_;
  bool play_, playing_ = false, failed_ = false;
  std::optional<Simulator> simulator_;
  ScenePlayer player_;
};

}  // namespace drill_rig_sim

#endif
