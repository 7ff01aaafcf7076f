#ifndef DRILL_RIG_SIM_SIM_INSTRUMENTS_H
#define DRILL_RIG_SIM_SIM_INSTRUMENTS_H

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "drill_rig_sim/scene/instruments_spec.h"
#include "drill_rig_sim/sim/measurements.h"

namespace drill_rig_sim
{
/// A stream of random numbers whose whole state is one integer: a snapshot restores it exactly.
struct NoiseSource
{
  std::uint64_t state = 0;
  /// Uniform in (0, 1).
  double uniform() noexcept;
  /// Standard normal.
  double normal() noexcept;

  template <class V>
  void visit(V& v)
  {
    v("state", state);
  }
};

/// A surface sensor: delayed, filtered to first order, offset, noisy.
class Sensor
{
public:
  Sensor() = default;
  /// `interval` [s]: between samples, at the shortest; allocates the delay line.
  Sensor(const SensorSpec& spec, double interval);
  /// Next reading of a signal that is `truth` at `time` [s].
  double read(double truth, double time, NoiseSource& noise) noexcept;
  /// Moves all it remembers by `shift` [s].
  void shift_time(double shift) noexcept;

  /// What it remembers; its specification is the scene's.
  template <class V>
  void visit(V& v)
  {
    v("line", line_);
    v("next", next_);
    v("held", held_);
    v("filtered", filtered_);
    v("last_time", last_time_);
    v("started", started_);
  }

private:
  struct Sample
  {
    double time, value;

    template <class V>
    void visit(V& v)
    {
      v("time", time);
      v("value", value);
    }
  };
  SensorSpec spec_;
  std::vector<Sample> line_;  // ring
  std::size_t next_ = 0, held_ = 0;
  double filtered_ = 0.0;
  double last_time_ = 0.0;
  bool started_ = false;
};

/// What the MWD's sensor sees.
struct SensorView
{
  double md = 0.0;                                      ///< [m]
  Eigen::Vector3d axis = -Eigen::Vector3d::UnitZ();     ///< along the string, towards the bit
  Eigen::Vector3d scribe = Eigen::Vector3d::UnitY();    ///< across the string: the bend's direction without twist
};

/// Measurement while drilling: surveys by period, or after a pumps-off/on cycle when the period is 0, and the faster toolface; each
/// reaches the surface late. No reading without flow but the survey that a cycle takes.
class Mwd
{
public:
  Mwd() = default;
  Mwd(const MwdSpec& survey, const ToolfaceSpec& toolface);
  /// Takes what is due at `time` [s] and hands over what has arrived by now.
  void update(double time, double flow, const SensorView& view, NoiseSource& noise, MwdReading& survey, ToolfaceReading& toolface) noexcept;
  /// Moves all it remembers by `shift` [s].
  void shift_time(double shift) noexcept;

  /// What it remembers; its specification is the scene's.
  template <class V>
  void visit(V& v)
  {
    v("surveys", surveys_);
    v("toolfaces", toolfaces_);
    v("next_survey", next_survey_);
    v("next_toolface", next_toolface_);
    v("flowing", flowing_);
    v("magnetic", magnetic_);
    v("survey_count", survey_count_);
    v("toolface_count", toolface_count_);
  }

private:
  template <class Reading>
  struct Queue  // readings on their way up
  {
    std::array<Reading, 32> entry;
    std::size_t first = 0, count = 0;
    void push(const Reading& r) noexcept;
    bool pop_before(double time, Reading& r) noexcept;

    template <class V>
    void visit(V& v)
    {
      v("entry", entry);
      v("first", first);
      v("count", count);
    }
  };
  MwdReading measure(double time, const SensorView& view, NoiseSource& noise) const noexcept;

  MwdSpec survey_;
  ToolfaceSpec toolface_;
  Queue<MwdReading> surveys_;
  Queue<ToolfaceReading> toolfaces_;
  double next_survey_ = 0.0;
  double next_toolface_ = 0.0;
  bool flowing_ = false;
  bool magnetic_ = true;
  std::uint64_t survey_count_ = 0;
  std::uint64_t toolface_count_ = 0;
};

}  // namespace drill_rig_sim

#endif
