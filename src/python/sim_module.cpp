// The module drill_rig_sim._sim: a simulator in a Python process, under what drill_rig_sim.sim makes of it.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "in_process_rig.h"
#include "python_fields.h"

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

/// What the rig refuses is drill_rig_sim.lockstep.Refused in Python, with the same line.
void translate(std::exception_ptr error)
{
  try
  {
    if (error) std::rethrow_exception(error);
  }
  catch (const std::runtime_error& refusal)
  {
    PyErr_SetString(py::module_::import("drill_rig_sim.lockstep").attr("Refused").ptr(), refusal.what());
  }
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
  drive.def(py::init(
                [](int mode, double speed, double torque, double angle, double torque_limit, bool brake, double right, double left) {
                  return TopDriveSetpoint{static_cast<TopDriveMode>(mode), speed, torque, angle, torque_limit, brake, right, left};
                }),
            py::arg("mode") = 0, py::arg("speed") = 0.0, py::arg("torque") = 0.0, py::arg("angle") = 0.0, py::arg("torque_limit") = 0.0,
            py::arg("brake") = false, py::arg("amplitude_right") = 0.0, py::arg("amplitude_left") = 0.0);
  bind_fields(drive);

  py::class_<PumpSetpoint> pump(module, "MudPump");
  pump.def(py::init([](double flow) { return PumpSetpoint{flow}; }), py::arg("flow") = 0.0);
  bind_fields(pump);

  py::class_<SteeringSetpoint> steering(module, "Steering");
  steering.def(py::init([](double toolface, double ratio) { return SteeringSetpoint{toolface, ratio}; }), py::arg("toolface") = 0.0,
               py::arg("ratio") = 0.0);
  bind_fields(steering);
}

void bind_frames(py::module_& module)
{
  py::class_<Signals> signals(module, "Signals");
  bind_fields(signals);
  signals.def_property_readonly("current_operation", [](const Signals& s) { return s.current_operation(); });
  py::class_<Place> place(module, "Place");
  bind_fields(place);
  py::class_<Bit> bit(module, "Bit");
  bind_fields(bit);
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
  toolface.def_readonly("t", &ToolfaceReading::time).def_property_readonly("reference", [](const ToolfaceReading& r) { return r.magnetic ? 1 : 0; });  // as MwdToolface has it
  py::class_<MwdReading> survey(module, "Survey");
  bind_fields(survey);
  survey.def_readonly("t", &MwdReading::time);
}

void load_survey(InProcessRig& rig, const std::string& file, const std::vector<double>& md, const std::vector<double>& inclination,
                 const std::vector<double>& azimuth, const std::array<double, 3>& tie_in, double hole_depth, double bit_depth)
{
  NewWell well{file, md, inclination, azimuth, std::nullopt, hole_depth, bit_depth};
  if (tie_in != std::array<double, 3>{}) well.tie_in = TieIn{tie_in[0], tie_in[1], tie_in[2]};
  rig.load_survey(well);
}
}  // namespace

PYBIND11_MODULE(_sim, module)
{
  py::register_exception_translator(translate);
  bind_setpoints(module);
  bind_frames(module);
  bind_telemetry(module);
  py::class_<SavedRig>(module, "Saved");
  using no_gil = py::call_guard<py::gil_scoped_release>;
  py::class_<InProcessRig>(module, "Rig")
      .def(py::init<const std::string&, double, std::uint64_t, bool>(), no_gil())
      .def("command", &InProcessRig::command)
      .def("advance", &InProcessRig::advance, no_gil())
      .def("frame", &InProcessRig::frame)
      .def(
          "record",
          [](InProcessRig& rig, std::size_t frames, std::size_t every)
          {
            Recording r;
            {
              const py::gil_scoped_release release;
              r = rig.record(frames, every);
            }
            return py::make_tuple(array_of(r.readings), array_of(r.truth), array_of(r.bit));
          })
      .def("toolface", &InProcessRig::toolface)
      .def("survey", &InProcessRig::survey)
      .def("reset", &InProcessRig::reset, no_gil())
      .def("load_survey", &load_survey)
      .def("tare", &InProcessRig::tare)
      .def("fault", &InProcessRig::fault)
      .def("slips", &InProcessRig::slips)
      .def("connection", &InProcessRig::connection)
      .def("save", &InProcessRig::save)
      .def("restore", &InProcessRig::restore);
}
}  // namespace drill_rig_sim
