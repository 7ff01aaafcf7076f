// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SCENE_QUALITY_FLAGS_H
#define DRILL_RIG_SIM_SCENE_QUALITY_FLAGS_H

#include <string>
#include <vector>

/// Columns of records and surveys that mark values as good or bad: `QC`, `Hook Load Quality`, `Status`. One set of rules for C++
/// and Python.
namespace drill_rig_sim
{
/// What the cells of a column mean, by its name.
enum class FlagSense
{
  none,          ///< it is no column of flags
  status,        ///< it may also hold what the rig does: Status, Flag
  quality,       ///< Quality, QC
  good_if_true,  ///< Valid, Accepted, OK
  bad_if_true    ///< Bad, Rejected
};

/// A column's name, read as that of flags.
struct FlagName
{
  FlagSense sense = FlagSense::none;
  std::string of;  ///< what else the name says, in small letters without blanks and signs: `hkld` of `HKLD_QC`; "": of the row
};

FlagName flag_name(const std::string& name);

/// What a cell says of the values beside it.
enum class FlagMeaning
{
  good,
  bad,
  derived,  ///< interpolated, projected: computed of values beside it
  other     ///< not known
};

/// The cells of a column.
struct FlagCells
{
  std::vector<FlagMeaning> meanings;  ///< of each cell
  bool known = false;                 ///< at least one is good or bad
  bool unclear = false;               ///< they differ, and which of them are bad cannot be known: 0 and 1 of a column QC
};

/// @param cells  the different cells of a column; all, for one of them may show what another means. Null values (-999.25) are
/// bad;
///               of numbers, codes of OPC are known (192 and above: good) and true and false where the name has their sense
FlagCells flag_cells(FlagSense sense, const std::vector<std::string>& cells);

}  // namespace drill_rig_sim

#endif
