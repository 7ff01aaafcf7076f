#include "drill_output.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <vector>

#include "drill_command.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/companion.h"
#include "drill_rig_sim/well/directions.h"
#include "drill_rig_sim/well/wellbore.h"

namespace drill_rig_sim
{
namespace
{
void write_path_row(std::FILE* file, double md, const Eigen::Vector3d& p, const Eigen::Vector3d& t, double radius)
{
  std::fprintf(file, "%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.6g\n", md, p.x(), p.y(), p.z(), inclination_of(t), azimuth_of(t), radius);
}

constexpr const char* profile_columns =
    "md,from_bit,east,north,up,tension,true_axial_force,torque,bending_moment,contact_force,contact_side_deg\n";

/// Of the truth, behind the time.
constexpr const char* truth_columns[] = {
    "hook_load", "torque", "block_height", "top_drive_speed", "wob", "bit_torque", "bit_speed", "bit_depth", "hole_depth",
    "rop", "inclination", "azimuth", "toolface", "bit_east", "bit_north", "bit_up", "bit_inclination", "in_slips",
    "motor_stalled", "winch_limited", "top_drive_limited", "stop_reached", "slack_line", "relief_valve_open", "over_stress",
    "over_torque", "buckled", "accuracy_warning", "stand_pipe_pressure", "differential_pressure", "flow", "floor_height"};

void write_profile_row(std::FILE* file, const StringProfile& p, std::size_t i)
{
  std::fprintf(file, "%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.6g\n", p.md[i], p.from_bit[i], p.position[i].x(), p.position[i].y(),
               p.position[i].z(), p.tension[i], p.true_axial_force[i], p.torque[i], p.bending_moment[i], p.contact_force[i],
               p.contact_side[i] / degree);
}

/// Up or not, in the order of the header.
void write_flags(std::FILE* file, const RigSignals& m)
{
  for (const bool up : {m.in_slips, m.motor_stalled, m.winch_limited, m.top_drive_limited, m.stop_reached, m.slack_line, m.relief_valve_open,
                        m.over_stress, m.over_torque, m.buckled, m.accuracy_warning})
    std::fputs(up ? ",1" : ",0", file);
}

/// Cells of truth_columns.
void write_truth(std::FILE* file, const Truth& m)
{
  std::fprintf(file, ",%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.10g,%.10g,%.9g,%.9g,%.9g,%.9g,", m.hook_load, m.torque, m.block_height, m.top_drive_speed,
               m.wob, m.bit_torque, m.bit_speed, m.bit_depth, m.hole_depth, m.rop, m.bit_inclination, m.bit_azimuth, m.bend_toolface);
  std::fprintf(file, "%.11g,%.11g,%.11g,%.9g", m.bit_position.x(), m.bit_position.y(), m.bit_position.z(),
               inclination_of(m.bit_orientation * Eigen::Vector3d::UnitX()));
  write_flags(file, m);
  std::fprintf(file, ",%.9g,%.9g,%.9g,%.9g", m.stand_pipe_pressure, m.differential_pressure, m.flow, m.floor_height);
}

/// Measured errors and the companion's truth.
void write_errors(std::FILE* file, const Simulator& measured)
{
  for (std::size_t i = 0; i < output_count; ++i) write_cell(file, 4, measured.measured_error(static_cast<Output>(i)));
  if (const Truth* companion = truth_of_companion(measured))
    write_truth(file, *companion);
  else
    for (std::size_t i = 0; i < std::size(truth_columns); ++i) std::fputs(",", file);
}

void write_readings(std::FILE* file, const Readings& r)
{
  std::fprintf(file, ",%.9g,%.9g,%.9g,%.9g,%.9g,%.10g,%.10g,%.9g", r.hook_load, r.torque, r.stand_pipe_pressure, r.flow, r.block_height, r.bit_depth,
               r.hole_depth, r.rop);
  write_cell(file, 9, r.zeroed(r.surface_wob));
  write_cell(file, 9, r.zeroed(r.differential_pressure));
}
}  // namespace

bool is_same_file(const std::string& one, const std::string& other)
{
  namespace fs = std::filesystem;
  if (one.empty() || other.empty()) return false;
  std::error_code unreadable;
  const fs::path a = fs::weakly_canonical(one, unreadable), b = fs::weakly_canonical(other, unreadable);
  return a == b && a != "/dev/null";
}

File open_output(const char* option, const std::string& name)
{
  if (name.empty()) return File();
  File file(std::fopen(name.c_str(), "w"));
  if (!file) throw UsageError(std::string(option) + ": " + name + " cannot be written: " + std::strerror(errno));
  return file;
}

void close_output(File file, const std::string& name)
{
  if (!file) return;
  const bool written = std::ferror(file.get()) == 0;
  if (std::fclose(file.release()) != 0 || !written)
    throw ComputationError(name + " could not be written whole; is the disk full?");
}

void write_cell(std::FILE* file, int digits, double value)
{
  std::fputs(",", file);
  if (std::isfinite(value)) std::fprintf(file, "%.*g", digits, value);
}

void write_profile(std::FILE* file, const StringProfile& p)
{
  std::fputs(profile_columns, file);
  for (std::size_t i = 0; i < p.md.size(); ++i) write_profile_row(file, p, i);
}

void write_profile_series_header(std::FILE* file)
{
  std::fputs("time,", file);
  std::fputs(profile_columns, file);
}

void write_profile_series_rows(std::FILE* file, double time, const StringProfile& p)
{
  for (std::size_t i = 0; i < p.md.size(); ++i)
  {
    std::fprintf(file, "%.9g,", time);
    write_profile_row(file, p, i);
  }
}

void write_csv_header(std::FILE* file, bool with_readings, bool with_errors)
{
  std::fputs("time", file);
  for (const char* name : truth_columns) std::fprintf(file, ",%s", name);
  if (with_readings)
    std::fputs(
        ",reading_hook_load,reading_torque,reading_stand_pipe_pressure,reading_flow,reading_block_height,reading_bit_depth,"
        "reading_hole_depth,reading_rop,reading_surface_wob,reading_differential_pressure",
        file);
  if (with_errors)
  {
    for (const OutputTraits& output : output_traits) std::fprintf(file, ",error_%s", output.name);
    for (const char* name : truth_columns) std::fprintf(file, ",companion_%s", name);
  }
  std::fputs("\n", file);
}

void write_csv_row(std::FILE* file, const Truth& m, const Readings* readings, const Simulator* measured)
{
  std::fprintf(file, "%.9g", m.time);
  write_truth(file, m);
  if (readings) write_readings(file, *readings);
  if (measured) write_errors(file, *measured);
  std::fputs("\n", file);
}

void write_path(std::FILE* file, const Simulator& simulator)
{
  const Wellbore& well = simulator.wellbore();
  std::fputs("md,east,north,up,inclination,azimuth,radius\n", file);
  for (int i = 0; i < well.node_count(); ++i)
  {
    const WellNode node = well.node(i);
    write_path_row(file, node.md, node.position, node.tangent, node.radius);
  }
  write_path_row(file, well.hole_depth(), well.bottom_position(), well.end_direction(), well.bottom_radius());
}

void write_raw_path(std::FILE* file, const Simulator& simulator)
{
  std::vector<Eigen::Vector3d> points;
  simulator.raw_path(points);
  std::fputs("east,north,up\n", file);
  for (const Eigen::Vector3d& p : points) std::fprintf(file, "%.12g,%.12g,%.12g\n", p.x(), p.y(), p.z());
}

}  // namespace drill_rig_sim
