// SPDX-License-Identifier: BSD-3-Clause
// The module drill_rig_sim._sim: a simulator in a Python process, under what drill_rig_sim.sim makes of it.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "in_process_rig.h"
#include "python_fields.h"
#include "sim_functions.h"

namespace py = pybind11;

namespace drill_rig_sim
{
namespace
{
/// Frames as numpy arrays: one row each.
template <class Row>
py::array array_of(const std::vector<Row>& rows)
{
  return py::array(dtype_of<Row>(), {rows.size()}, {sizeof(Row)}, rows.data());
}

/// Lets Python see to its signals: Ctrl-C ends a long call.
void look_at_signals()
{
  const py::gil_scoped_acquire python;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

/// Frames of a call, in arrays; what a call that failed or was interrupted had computed by then is there all the same.
class Recorder
{
public:
  void record(InProcessRig& rig, std::size_t frames, std::size_t every)
  {
    const py::gil_scoped_release others;
    rig.record(frames, every, look_at_signals, recording_);
  }
  py::tuple arrays() const
  {
    return py::make_tuple(array_of(recording_.readings), array_of(recording_.truth), array_of(recording_.bit));
  }

private:
  Recording recording_;
};

/// What the rig refuses is drill_rig_sim.lockstep.Refused in Python, with the same line.
void translate(std::exception_ptr error)  // NOLINT(performance-unnecessary-value-param): pybind11's signature
{
  try
  {
    if (error) std::rethrow_exception(error);
  }
  catch (const FrameFailed& failure)
  {
    PyErr_SetString(py::module_::import("drill_rig_sim.lockstep").attr("Failed").ptr(), failure.what());
  }
  catch (const std::runtime_error& refusal)
  {
    PyErr_SetString(py::module_::import("drill_rig_sim.lockstep").attr("Refused").ptr(), refusal.what());
  }
}

/// Lets copies and pickles of a value be made: its bytes, for the same build.
template <class T>
void bind_pickle(py::class_<T>& type)
{
  type.def(py::pickle([](const T& value) { return py::bytes(reinterpret_cast<const char*>(&value), sizeof value); },
                      [](const py::bytes& bytes)
                      {
                        const std::string text = bytes;
                        if (text.size() != sizeof(T)) throw std::runtime_error("the pickle is of another build");
                        T value;
                        std::memcpy(&value, text.data(), sizeof value);
                        return value;
                      }));
}

void bind_setpoints(py::module_& module)
{
  py::class_<WinchSetpoint> winch(module, "Winch");
  winch.def(py::init(
                [](double block_velocity, bool brake) {
                  return WinchSetpoint{block_velocity, brake};
                }),
            py::arg("block_velocity") = 0.0, py::arg("brake") = false);
  bind_fields(winch);

  py::class_<TopDriveSetpoint> drive(module, "TopDrive");
  drive.def(
      py::init(
          [](int mode, double speed, double torque, double angle, double torque_limit, bool brake, double right, double left)
          { return TopDriveSetpoint{static_cast<TopDriveMode>(mode), speed, torque, angle, torque_limit, brake, right, left}; }),
      py::arg("mode") = 0, py::arg("speed") = 0.0, py::arg("torque") = 0.0, py::arg("angle") = 0.0, py::arg("torque_limit") = 0.0,
      py::arg("brake") = false, py::arg("amplitude_right") = 0.0, py::arg("amplitude_left") = 0.0);
  bind_fields(drive);

  py::class_<PumpSetpoint> pump(module, "MudPump");
  pump.def(py::init([](double flow) { return PumpSetpoint{flow}; }), py::arg("flow") = 0.0);
  bind_fields(pump);

  py::class_<SteeringSetpoint> steering(module, "Steering");
  steering.def(py::init(
                   [](double toolface, double ratio) {
                     return SteeringSetpoint{toolface, ratio};
                   }),
               py::arg("toolface") = 0.0, py::arg("ratio") = 0.0);
  bind_fields(steering);
}

template <class T>
py::class_<T> bind_signals(py::module_& module, const char* name)
{
  py::class_<T> signals(module, name);
  bind_fields(signals);
  bind_pickle(signals);
  signals.def_property_readonly("current_operation", [](const T& s) { return s.current_operation(); });
  return signals;
}

void bind_frames(py::module_& module)
{
  bind_signals<ShownFrame>(module, "Readings")
      .def_property_readonly("accuracy_code", [](const ShownFrame& s) { return code_of(s.accuracy.doubt); })
      .def_property_readonly("accuracy_reason", [](const ShownFrame& s) { return text_of(s.accuracy); });
  bind_signals<TrueFrame>(module, "Truth")
      .def_property_readonly("active_faults", [](const TrueFrame& s) { return words_of(s.faults); })
      .def_property_readonly("active_fault_depths",  // a tuple, as in the node's message
                             [](const TrueFrame& s) { return py::tuple(py::cast(depths_of(s.faults, s.fault_depths))); });
  py::class_<Place> place(module, "Place");
  bind_fields(place);
  py::class_<Bit> bit(module, "Bit");
  bind_fields(bit);
  bind_pickle(bit);
  py::class_<Frame>(module, "Frame")
      .def_property_readonly("t", [](const Frame& f) { return f.truth.signals.time; })
      .def_readonly("readings", &Frame::readings)
      .def_readonly("truth", &Frame::truth)
      .def_readonly("bit", &Frame::bit);
}

void bind_telemetry(py::module_& module)
{
  py::class_<ToolfaceReading> toolface(module, "Toolface");
  bind_fields(toolface);
  toolface.def_readonly("t", &ToolfaceReading::time)
      .def_property_readonly("reference", [](const ToolfaceReading& r) { return r.magnetic ? 1 : 0; });  // as MwdToolface has it
  py::class_<MwdReading> survey(module, "Survey");
  bind_fields(survey);
  survey.def_readonly("t", &MwdReading::time);
  py::class_<InclinationReading> inclination(module, "Inclination");
  bind_fields(inclination);
  inclination.def_readonly("t", &InclinationReading::time);
  py::class_<DynamicsReading> dynamics(module, "Dynamics");
  bind_fields(dynamics);
  dynamics.def_readonly("t", &DynamicsReading::time);
}

/// None for what is not a finite number.
py::object shown(double value)
{
  return std::isfinite(value) ? py::object(py::float_(value)) : py::none();
}
py::object shown(bool value)
{
  return py::bool_(value);
}
py::object shown(const char* text)
{
  return py::str(text);
}
py::object shown(const std::vector<double>& values)
{
  py::list list;
  for (const double value : values) list.append(shown(value));
  return list;
}

/// What the finer models beside a rig have found, by the names of `drill verify --json`.
py::dict verified(const InProcessRig& rig)
{
  py::dict out, outputs;
  rig.verified(
      [&](const Simulator& simulator, const FinerPair& pair)
      {
        const Verification& findings = pair.findings();
        out["verdict"] = word_of(findings.verdict());
        out["tolerance"] = simulator.scene().numerics.tolerance;
        out["refined"] = py::make_tuple(pair.times(), pair.times() * pair.times());
        out["simulated_s"] = simulator.truth().time;
        out["warned_from"] = shown(findings.warned_from());
        out["not_measured"] = simulator.statistics().not_measured;
        for (std::size_t i = 0; i < output_count; ++i)
        {
          py::dict one;
          visit(findings, static_cast<Output>(i), [&](const char* name, const auto& value) { one[name] = shown(value); });
          outputs[output_traits[i].name] = one;
        }
      });
  out["outputs"] = outputs;
  return out;
}

void load_survey(InProcessRig& rig, const std::string& file, const std::vector<double>& md,
                 const std::vector<double>& inclination, const std::vector<double>& azimuth, const std::array<double, 3>& tie_in,
                 double hole_depth, double bit_depth, const std::string& columns, bool pass_over)
{
  NewWell well{file, md, inclination, azimuth, std::nullopt, hole_depth, bit_depth, survey_format(columns, pass_over)};
  if (tie_in != std::array<double, 3>{}) well.tie_in = TieIn{tie_in[0], tie_in[1], tie_in[2]};
  rig.load_survey(well);
}
/// Not those of other modules of pybind11, such as matplotlib 3.10's. Before 2.9 the build sees to that (CMakeLists.txt).
void translate_exceptions()
{
#if PYBIND11_VERSION_MAJOR > 2 || PYBIND11_VERSION_MINOR >= 9
  py::register_local_exception_translator(translate);
#else
  py::register_exception_translator(translate);
#endif
}
}  // namespace

PYBIND11_MODULE(_sim, module)
{
  translate_exceptions();
  bind_functions(module);
  bind_setpoints(module);
  bind_frames(module);
  bind_telemetry(module);
  py::class_<Zero>(module, "Zero")  // NOLINT(bugprone-unused-raii): it registers the class
      .def_readonly("duration", &Zero::duration)
      .def_readonly("hook_load", &Zero::hook_load)
      .def_readonly("hook_load_deviation", &Zero::hook_load_deviation)
      .def_readonly("stand_pipe_pressure", &Zero::stand_pipe_pressure)
      .def_readonly("stand_pipe_pressure_deviation", &Zero::stand_pipe_pressure_deviation);
  py::class_<SavedRig>(module, "Saved");  // NOLINT(bugprone-unused-raii): it registers the class
  py::class_<Recorder>(module, "Recorder").def(py::init<>()).def("record", &Recorder::record).def("arrays", &Recorder::arrays);
  using no_gil = py::call_guard<py::gil_scoped_release>;
  py::class_<InProcessRig>(module, "Rig")
      .def(py::init<const std::string&, double, std::uint64_t, bool>(), no_gil())
      .def("command", &InProcessRig::command)
      .def(
          "advance", [](InProcessRig& rig, std::size_t frames) { rig.advance(frames, look_at_signals); }, no_gil())
      .def("frame", &InProcessRig::frame)
      .def("verify", &InProcessRig::verify)
      .def("verified", &verified)
      .def("kernel", &InProcessRig::kernel)
      .def("remarks", &InProcessRig::remarks)
      .def("joint_length", &InProcessRig::joint_length)
      .def("accuracy_warning", &InProcessRig::accuracy_warning)
      .def("accuracy_code", &InProcessRig::accuracy_code)
      .def("active_faults", &InProcessRig::active_faults)
      .def("measured_errors", &InProcessRig::measured_errors)
      .def("not_measured", &InProcessRig::not_measured)
      .def("crew_connects", &InProcessRig::crew_connects)
      .def("drum_height", &InProcessRig::drum_height)
      .def("drum_heights", &InProcessRig::drum_heights)
      .def("wave_impedance", &InProcessRig::wave_impedance)
      .def("block_mass", &InProcessRig::block_mass)
      .def("crown_height", &InProcessRig::crown_height)
      .def("block_acceleration", &InProcessRig::block_acceleration)
      .def("max_rotation", &InProcessRig::max_rotation)
      .def("max_flow", &InProcessRig::max_flow)
      .def("toolface", &InProcessRig::toolface)
      .def("survey", &InProcessRig::survey)
      .def("inclination", &InProcessRig::inclination)
      .def("dynamics", &InProcessRig::dynamics)
      .def("reset", &InProcessRig::reset, no_gil())
      .def("load_survey", &load_survey)
      .def("tare", &InProcessRig::tare)
      .def("tare_over", &InProcessRig::tare_over)
      .def("fault", &InProcessRig::fault)
      .def("slips", &InProcessRig::slips)
      .def("slips_for", &InProcessRig::slips_for)
      .def("connection", &InProcessRig::connection)
      .def("operate", &InProcessRig::operate)
      .def("given_up", &InProcessRig::given_up)
      .def("save", &InProcessRig::save)
      .def("restore", &InProcessRig::restore);
}
}  // namespace drill_rig_sim
