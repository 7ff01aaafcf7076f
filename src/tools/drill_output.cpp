// SPDX-License-Identifier: BSD-3-Clause
#include "drill_output.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "drill_command.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/companion.h"
#include "drill_rig_sim/instruments/signal_rows.h"
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

/// A column of a time series.
template <class From>
struct Column
{
  const char* name;
  int digits;
  double (*value)(const From&);
};

/// Depths and places are large numbers that change little.
int digits_of(const SignalRow& row)
{
  if (row.dimension != Dimension::length) return 9;
  if (row.of == SignalOf::bit) return 11;
  const std::string name = row.name;
  return name == "bit_depth" || name == "hole_depth" ? 10 : 9;
}

/// The signals of the list: `first` in that order, the others behind them.
template <class From>
std::vector<Column<From>> columns_of(const std::vector<std::string>& first, double (*SignalRow::*value)(const From&))
{
  std::vector<Column<From>> columns;
  const auto add = [&](const SignalRow& row)
  {
    if (row.*value) columns.push_back({row.name, digits_of(row), row.*value});
  };
  for (const std::string& name : first)
    for (const SignalRow& row : signal_rows())
      if (name == row.name) add(row);
  for (const SignalRow& row : signal_rows())
    if (std::find(first.begin(), first.end(), row.name) == first.end()) add(row);
  return columns;
}

/// Behind the time. The columns of version 0.2 keep their places: there are readers that count.
const std::vector<Column<Truth>>& truth_columns()
{
  static const auto columns = columns_of<Truth>({"hook_load",
                                                 "torque",
                                                 "block_height",
                                                 "top_drive_speed",
                                                 "wob",
                                                 "bit_torque",
                                                 "bit_speed",
                                                 "bit_depth",
                                                 "hole_depth",
                                                 "rop",
                                                 "inclination",
                                                 "azimuth",
                                                 "toolface",
                                                 "bit_east",
                                                 "bit_north",
                                                 "bit_up",
                                                 "bit_inclination",
                                                 "in_slips",
                                                 "motor_stalled",
                                                 "winch_limited",
                                                 "top_drive_limited",
                                                 "stop_reached",
                                                 "slack_line",
                                                 "relief_valve_open",
                                                 "over_stress",
                                                 "over_torque",
                                                 "buckled",
                                                 "accuracy_warning",
                                                 "stand_pipe_pressure",
                                                 "differential_pressure",
                                                 "flow",
                                                 "floor_height"},
                                                &SignalRow::in_truth);
  return columns;
}

const std::vector<Column<Readings>>& reading_columns()
{
  static const auto columns = columns_of<Readings>({"hook_load", "torque", "stand_pipe_pressure", "flow", "block_height",
                                                    "bit_depth", "hole_depth", "rop", "surface_wob", "differential_pressure"},
                                                   &SignalRow::in_readings);
  return columns;
}

template <class From>
void write_cells(std::FILE* file, const std::vector<Column<From>>& columns, const From& from)
{
  for (const Column<From>& column : columns) write_cell(file, column.digits, column.value(from));
}

template <class From>
void write_names(std::FILE* file, const char* prefix, const std::vector<Column<From>>& columns)
{
  for (const Column<From>& column : columns) std::fprintf(file, ",%s%s", prefix, column.name);
}

void write_profile_row(std::FILE* file, const StringProfile& p, std::size_t i)
{
  std::fprintf(file, "%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.6g\n", p.md[i], p.from_bit[i], p.position[i].x(),
               p.position[i].y(), p.position[i].z(), p.tension[i], p.true_axial_force[i], p.torque[i], p.bending_moment[i],
               p.contact_force[i], p.contact_side[i] / degree);
}

/// Measured errors and the companion's truth.
void write_errors(std::FILE* file, const Simulator& measured)
{
  for (std::size_t i = 0; i < output_count; ++i) write_cell(file, 4, measured.measured_error(static_cast<Output>(i)));
  if (const Truth* companion = truth_of_companion(measured))
    write_cells(file, truth_columns(), *companion);
  else
    for (std::size_t i = 0; i < truth_columns().size(); ++i) std::fputs(",", file);
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
    throw ComputationError(name + " could not be written completely; is the disk full?");
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
  write_names(file, "", truth_columns());
  if (with_readings) write_names(file, "reading_", reading_columns());
  if (with_errors)
  {
    for (const OutputTraits& output : output_traits) std::fprintf(file, ",error_%s", output.name);
    write_names(file, "companion_", truth_columns());
  }
  std::fputs("\n", file);
}

void write_csv_row(std::FILE* file, const Truth& m, const Readings* readings, const Simulator* measured)
{
  std::fprintf(file, "%.9g", m.time);
  write_cells(file, truth_columns(), m);
  if (readings) write_cells(file, reading_columns(), *readings);
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
