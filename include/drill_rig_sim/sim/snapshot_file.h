// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_SNAPSHOT_FILE_H
#define DRILL_RIG_SIM_SIM_SNAPSHOT_FILE_H

#include <cstdint>
#include <string>
#include <vector>

#include "drill_rig_sim/math/kernel.h"
#include "drill_rig_sim/scene/scene_hash.h"

namespace drill_rig_sim
{
/// Snapshots as files: a head of fixed length, then the bytes of a value (math/visit.h).
///
///   8 B "DRIGSNAP", 4 B version of the format, 8 B hash of the scene, 8 B hash of the fields (math/visit.h), 8 B number of
///   bytes, 8 B their checksum, 4 B the kernel that the rig ran by, 8 B hash of the scene without its start's bit depth, 8 B that
///   [m]
///
/// A program whose state has the same fields, by name and type, restores them bit for bit on a machine of this byte order.
/// Refused is a file of other fields, for another scene or its rig at another start, of another format, cut, or with a bit
/// changed. What another build computes from there may differ in rounding, and so may a rig of another kernel.
constexpr std::uint32_t snapshot_format = 4;

struct Snapshot
{
  Kernel kernel;  ///< that it was made by
  std::vector<unsigned char> bytes;
  std::uint64_t fields = 0;  ///< fields_hash() of the value
  SceneStart start = {};     ///< of its rig
};

/// Writes the file whole or not at all (a neighbour file first, then renamed).
/// Throws std::runtime_error with one line (which file, why) if it cannot be written.
void write_snapshot(const std::string& file, std::uint64_t scene, const Snapshot& snapshot);

/// What is in a file for the scene of this hash, whose rig starts there, of a value with this fields_hash(). Throws
/// std::runtime_error with one line (which file, what is wrong with it) for anything but a regular file of at most 16 MiB that
/// write_snapshot() has written for it.
Snapshot read_snapshot(const std::string& file, std::uint64_t scene, std::uint64_t fields, const SceneStart& start = {});

}  // namespace drill_rig_sim

#endif
