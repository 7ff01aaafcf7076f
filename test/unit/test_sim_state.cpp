// SPDX-License-Identifier: BSD-3-Clause
// The one list of a state's fields: every number in it survives a snapshot, in memory and as bytes, and nothing else is in a
// state.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>

#include "drill_ahead.h"
#include "drill_rig_sim/math/visit.h"
#include "drill_rig_sim/scene/scene_hash.h"
#include "drill_rig_sim/sim/snapshot_file.h"
#include "sim_numbers.h"
#include "temporary_folder.h"
#include "test_scenes.h"

namespace test_sim_state
{
using namespace drill_rig_sim;

namespace
{
/// The place of every number.
struct PathCollector
{
  std::vector<std::string> paths;
  template <class N>
  void operator()(const std::string& path, N&)
  {
    paths.push_back(path);
  }
  void size(const std::string&, std::size_t&) {}
};

/// Changes the k-th number, whatever it is.
struct Changer
{
  std::size_t k, at = 0;
  template <class N>
  void operator()(const std::string&, N& number)
  {
    if (at++ != k) return;
    if constexpr (std::is_same_v<N, bool>)
      number = !number;
    else if constexpr (std::is_enum_v<N>)
      number = static_cast<N>(static_cast<int>(number) == 0 ? 1 : 0);
    else
      number = static_cast<N>(number + 1);
  }
  void size(const std::string&, std::size_t&) {}
};

void change(SimulatorState& state, std::size_t k)
{
  Changer changer{k};
  visit_numbers(state, changer);
}

constexpr double timeout = 10.0;  // of commands [s]

/// A rig that drills with slow instruments, so that queues and delay lines hold something.
Simulator drilling_rig()
{
  Scene scene = motor_drilling_scene(0.005);
  scene.instruments.hook_load = {500.0, 100.0, 0.02, 0.5};
  scene.instruments.mwd.period = 1.0;
  scene.instruments.mwd.latency = 3.0;
  Simulator rig(scene, 7);
  rig.set_command_timeout(timeout);  // the streams have begun
  drill_ahead(rig, 60.0 * rpm, 0.03, 0.01);
  for (int k = 0; k < 300; ++k) rig.frame(0.01);
  return rig;
}

/// Entries of a history differ by their hashes: a change of one changes the last hash.
std::size_t last_hash_of(const std::vector<std::string>& paths, const std::string& path)
{
  const std::string hash = path.substr(0, path.find(".slots")) + ".slots.hash";
  for (std::size_t k = paths.size(); k-- > 0;)
    if (paths[k] == hash) return k;
  return paths.size();
}

constexpr std::size_t together = 12;  // numbers that are changed at once: each that is lost shows in the bytes

/// Changes the numbers from `begin` on; returns their paths.
std::string change_some(SimulatorState& state, const std::vector<std::string>& paths, std::size_t begin)
{
  std::string changed;
  for (std::size_t k = begin; k < std::min(begin + together, paths.size()); ++k)
  {
    const std::string& path = paths[k];
    // of another rig, of another string than the state's, or of a list that would not be there
    if (path == "scene" || path == "string.length" || path.find("count") != std::string::npos) continue;
    if (path == "mechanics.temperature.opened") continue;  // how many cells of that list, which the scene does not have
    change(state, k);
    if (path.find(".slots.") != std::string::npos && k != last_hash_of(paths, path)) change(state, last_hash_of(paths, path));
    changed += path + " ";
  }
  return changed;
}

std::string bytes_of(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}
}  // namespace

TEST(State, everyNumberComesBack)
{
  Simulator rig = drilling_rig();
  const auto good = rig.save();
  const std::vector<unsigned char> bytes = to_bytes(*good);
  PathCollector list;
  visit_numbers(const_cast<SimulatorState&>(*good), list);
  ASSERT_GT(list.paths.size(), 1000u);
  for (std::size_t begin = 0; begin < list.paths.size(); begin += together)
  {
    SimulatorState changed = *good;
    const std::string paths = change_some(changed, list.paths, begin);
    if (paths.empty()) continue;
    const std::vector<unsigned char> wanted = to_bytes(changed);
    ASSERT_NE(wanted, bytes) << paths;
    ASSERT_TRUE(rig.restore(changed)) << paths;
    ASSERT_EQ(to_bytes(*rig.save()), wanted) << paths << ": one was lost on the way in or out";
    ASSERT_TRUE(rig.restore(*good));
    ASSERT_EQ(to_bytes(*rig.save()), bytes) << paths << ": one did not come back";
  }
}

TEST(State, bytesMakeTheSameState)
{
  Simulator rig = drilling_rig();
  const std::vector<unsigned char> bytes = to_bytes(*rig.save());
  for (int k = 0; k < 50; ++k) rig.frame(0.01);
  SimulatorState read = *rig.save();
  EXPECT_NE(to_bytes(read), bytes);
  ASSERT_TRUE(from_bytes(bytes, read));
  EXPECT_EQ(to_bytes(read), bytes);
  std::vector<unsigned char> cut(bytes.begin(), bytes.end() - 1), longer = bytes;
  longer.push_back(0);
  EXPECT_FALSE(from_bytes(cut, read));
  read = *rig.save();
  EXPECT_FALSE(from_bytes(longer, read));
}

TEST(State, ofAnotherRigIsRefused)
{
  Simulator rig = drilling_rig();
  Scene scene = rig.scene();
  scene.mud.density += 1.0;
  EXPECT_NE(scene_hash(scene), scene_hash(rig.scene()));
  Simulator other(scene);
  const std::vector<unsigned char> before = to_bytes(*other.save());
  EXPECT_FALSE(other.restore(*rig.save()));
  EXPECT_EQ(to_bytes(*other.save()), before);
}

TEST(State, goesOnByAnotherKernelButForRounding)
{
  Scene scene = drilling_rig().scene();
  scene.numerics.kernel = Kernel::scalar;
  Simulator scalar(scene);
  for (int k = 0; k < 100; ++k) scalar.frame(0.01);
  scene.numerics.kernel = Kernel::automatic;
  Simulator best(scene);
  ASSERT_TRUE(best.restore(*scalar.save()));
  for (int k = 0; k < 100; ++k)
  {
    scalar.frame(0.01);
    best.frame(0.01);
  }
  EXPECT_EQ(best.statistics().kernel, resolved(Kernel::automatic));
  EXPECT_NEAR(best.truth().hook_load, scalar.truth().hook_load, 1e-6 * scalar.truth().hook_load);
  EXPECT_NEAR(best.truth().bit_depth, scalar.truth().bit_depth, 1e-9);
}

namespace
{
struct Part
{
  double weight = 0.0;
  int count = 0;

  template <class V>
  void visit(V& v)
  {
    v("weight", weight);
    v("count", count);
  }
};

/// With fields that a test exchanges.
struct Value
{
  const char *first = "first", *second = "second";
  std::vector<Part> parts;
  bool turns = false;

  template <class V>
  void visit(V& v)
  {
    v(first, parts);
    v(second, turns);
  }
};
}  // namespace

TEST(FieldsHash, isThatOfNamesAndTypes)
{
  Value value, other;
  EXPECT_EQ(fields_hash(value), fields_hash(other));
  other.turns = true;
  other.parts.resize(3);
  EXPECT_EQ(fields_hash(value), fields_hash(other)) << "whatever the values are";
  other.first = "new";
  EXPECT_NE(fields_hash(value), fields_hash(other));
  std::swap(value.first, value.second);
  EXPECT_NE(fields_hash(Value()), fields_hash(value));
  Simulator rig = drilling_rig();
  const auto before = rig.save();
  for (int k = 0; k < 100; ++k) rig.frame(0.01);
  EXPECT_EQ(fields_hash(*before), fields_hash(*rig.save()));
}

TEST(SnapshotFile, goesOnBitByBit)
{
  Simulator rig = drilling_rig();
  const TemporaryFolder folder;
  const std::string file = folder.file("snapshot");
  const auto saved = rig.save();
  write_snapshot(file, saved->scene, {Kernel::scalar, to_bytes(*saved), fields_hash(*saved)});
  for (int k = 0; k < 200; ++k) rig.frame(0.01);
  const std::vector<unsigned char> end = to_bytes(*rig.save());

  Simulator other(rig.scene(), 99);
  other.set_command_timeout(timeout);
  SimulatorState read = *other.save();
  ASSERT_TRUE(from_bytes(read_snapshot(file, read.scene, fields_hash(read)).bytes, read));
  ASSERT_TRUE(other.restore(read));
  for (int k = 0; k < 200; ++k) other.frame(0.01);
  EXPECT_EQ(to_bytes(*other.save()), end);
}

TEST(SnapshotFile, anotherStartIsNamed)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("snapshot");
  write_snapshot(file, 5, {Kernel::scalar, {1, 2, 3}, 9, {77, 812.5}});
  const auto refused = [&file](std::uint64_t scene, const SceneStart& start) -> std::string
  {
    try
    {
      read_snapshot(file, scene, 9, start);
    }
    catch (const std::runtime_error& error)
    {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ("", refused(5, {77, 812.5}));
  EXPECT_NE(std::string::npos,
            refused(6, {77, 600.0})
                .find("start.bit_depth 812.5 m; allowed is that of this rig, 600 m: reset_well with that bit_depth first"));
  EXPECT_NE(std::string::npos, refused(6, {78, 600.0}).find("another scene"));
  EXPECT_NE(std::string::npos, refused(6, {}).find("another scene"));
}

TEST(SnapshotFile, aBitDepthIsNoPartOfTheRestOfAScene)
{
  Scene scene = drilling_rig().scene();
  const SceneStart here = scene_start(scene);
  EXPECT_EQ(scene.start.bit_depth, here.bit_depth);
  scene.start.bit_depth -= 5.0;
  EXPECT_EQ(here.scene, scene_start(scene).scene);
  EXPECT_NE(here.bit_depth, scene_start(scene).bit_depth);
  scene.mud.density += 1.0;
  EXPECT_NE(here.scene, scene_start(scene).scene);
}

TEST(SnapshotFile, anythingElseIsRefused)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("refused");
  const std::vector<unsigned char> value(100, 7);
  const Snapshot whole{Kernel::sse4, value};
  const auto refused = [&file](std::uint64_t scene) -> std::string
  {
    try
    {
      read_snapshot(file, scene, 0);
    }
    catch (const std::runtime_error& error)
    {
      return error.what();
    }
    return "";
  };
  write_snapshot(file, 5, whole);
  EXPECT_EQ(read_snapshot(file, 5, 0).bytes, value);
  EXPECT_EQ(read_snapshot(file, 5, 0).kernel, Kernel::sse4);
  EXPECT_NE(refused(6).find("another scene"), std::string::npos);

  const std::string good = bytes_of(file);
  ASSERT_EQ(good.size(), 64u + value.size());
  const std::pair<std::size_t, const char*> damage[] = {
      {0, "not a snapshot"}, {8, "another format"}, {12, "another scene"}, {20, "state differs"}, {27, "state differs"},
      {28, "damaged"},       {36, "damaged"},       {45, "damaged"},       {64, "damaged"},       {good.size() - 1, "damaged"}};
  for (const auto& [place, words] : damage)
  {
    std::string bad = good;
    bad[place] = static_cast<char>(bad[place] ^ 1);
    std::ofstream(file, std::ios::binary) << bad;
    EXPECT_NE(refused(5).find(words), std::string::npos) << place << ": " << refused(5);
  }
  std::ofstream(file, std::ios::binary) << good.substr(0, good.size() - 1);
  EXPECT_NE(refused(5).find("damaged"), std::string::npos);
  std::ofstream(file, std::ios::binary) << "short";
  EXPECT_NE(refused(5).find("not a snapshot"), std::string::npos);
  EXPECT_THROW(write_snapshot(file, 5, whole), std::runtime_error) << "another program's";
  EXPECT_NE(refused(5).find("not a snapshot"), std::string::npos) << "and still there";
  std::ofstream(file, std::ios::binary | std::ios::trunc);
  write_snapshot(file, 5, whole);
  write_snapshot(file, 6, whole);
  EXPECT_EQ(read_snapshot(file, 6, 0).bytes, value) << "in place of an empty one and of an earlier one";
  std::remove(file.c_str());
  EXPECT_NE(refused(5).find("not a regular file"), std::string::npos);
  ASSERT_EQ(0, mkfifo(file.c_str(), 0600));
  EXPECT_THROW(write_snapshot(file, 5, whole), std::runtime_error) << "a pipe without a writer: refused, and not waited for";
  EXPECT_THROW(write_snapshot("/nowhere/at/all", 5, whole), std::runtime_error);
}
}  // namespace test_sim_state
