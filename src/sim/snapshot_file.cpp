// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/sim/snapshot_file.h"

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "drill_rig_sim/math/hash.h"

namespace drill_rig_sim
{
namespace
{
constexpr char mark[8] = {'D', 'R', 'I', 'G', 'S', 'N', 'A', 'P'};
constexpr std::uintmax_t longest = std::uintmax_t{16} << 20;  // [B]

/// What stands before the bytes. Packed by hand: no padding is written.
struct Head
{
  std::uint32_t format = snapshot_format;
  std::uint64_t scene = 0;
  std::uint64_t fields = 0;
  std::uint64_t size = 0;
  std::uint64_t checksum = 0;
  std::uint32_t kernel = 0;
  SceneStart start;

  static constexpr std::size_t length = sizeof mark + 4 + 8 + 8 + 8 + 8 + 4 + 8 + 8;

  std::vector<unsigned char> bytes() const
  {
    std::vector<unsigned char> out(mark, mark + sizeof mark);
    const auto append = [&out](const void* data, std::size_t n)
    {
      const auto* from = static_cast<const unsigned char*>(data);
      out.insert(out.end(), from, from + n);
    };
    append(&format, sizeof format);
    append(&scene, sizeof scene);
    append(&fields, sizeof fields);
    append(&size, sizeof size);
    append(&checksum, sizeof checksum);
    append(&kernel, sizeof kernel);
    append(&start.scene, sizeof start.scene);
    append(&start.bit_depth, sizeof start.bit_depth);
    return out;
  }
};

[[noreturn]] void refuse(const std::string& file, const std::string& why)
{
  throw std::runtime_error(file + ": " + why);
}

/// Of a snapshot for another hash of the scene; `all`: the whole file.
[[noreturn]] void refuse_scene(const std::string& file, const std::vector<unsigned char>& all, const SceneStart& here)
{
  SceneStart there;
  std::memcpy(&there.scene, all.data() + 48, sizeof there.scene);
  std::memcpy(&there.bit_depth, all.data() + 56, sizeof there.bit_depth);
  if (there.scene != here.scene || there.bit_depth == here.bit_depth)
    refuse(file, "is a snapshot of another scene; allowed is a snapshot of this rig's scene");
  char text[160];
  std::snprintf(text, sizeof text,
                "is a snapshot of this scene with start.bit_depth %.10g m; allowed is that of this rig, %.10g m: reset_well with "
                "that bit_depth first",
                there.bit_depth, here.bit_depth);
  refuse(file, text);
}

std::vector<unsigned char> whole_file(const std::string& file)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    refuse(file, "is not a regular file; allowed is a snapshot written by save_state");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error || size > longest) refuse(file, "is longer than the 16 MiB that are allowed");
  std::vector<unsigned char> bytes(static_cast<std::size_t>(size));
  std::ifstream in(file, std::ios::binary);
  if (!in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()))) refuse(file, "cannot be read");
  return bytes;
}

/// A mistyped name must not overwrite a file; an empty one may be.
void refuse_to_replace_another(const std::string& file)
{
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return;
  if (std::filesystem::is_regular_file(file, error))  // to open a pipe would block
  {
    char start[sizeof mark] = {};
    std::ifstream in(file, std::ios::binary);
    const bool is_ours = in.read(start, sizeof start) && std::memcmp(start, mark, sizeof mark) == 0;
    if (is_ours || std::filesystem::file_size(file, error) == 0) return;
  }
  refuse(file, "exists and is not a snapshot; allowed is a new file or an earlier snapshot");
}
}  // namespace

void write_snapshot(const std::string& file, std::uint64_t scene, const Snapshot& snapshot)
{
  refuse_to_replace_another(file);
  const std::vector<unsigned char>& bytes = snapshot.bytes;
  Head head;
  head.scene = scene;
  head.fields = snapshot.fields;
  head.size = bytes.size();
  head.checksum = hash_bytes(bytes.data(), bytes.size());
  head.kernel = static_cast<std::uint32_t>(snapshot.kernel);
  head.start = snapshot.start;
  const std::vector<unsigned char> start = head.bytes();
  const std::string beside = file + ".part";
  {
    std::ofstream out(beside, std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(start.data()), static_cast<std::streamsize>(start.size()));
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out)
    {
      std::remove(beside.c_str());
      refuse(file, "cannot be written");
    }
  }
  if (std::rename(beside.c_str(), file.c_str()) == 0) return;
  std::remove(beside.c_str());
  refuse(file, "cannot be written");
}

Snapshot read_snapshot(const std::string& file, std::uint64_t scene, std::uint64_t fields, const SceneStart& start)
{
  const std::vector<unsigned char> all = whole_file(file);
  if (all.size() < Head::length || std::memcmp(all.data(), mark, sizeof mark) != 0) refuse(file, "is not a snapshot");
  Snapshot snapshot{Kernel::scalar, std::vector<unsigned char>(all.begin() + Head::length, all.end()), fields, start};
  const std::vector<unsigned char>& bytes = snapshot.bytes;
  Head head;
  head.scene = scene;
  head.fields = fields;
  head.size = bytes.size();
  head.checksum = hash_bytes(bytes.data(), bytes.size());
  const std::vector<unsigned char> expected = head.bytes();
  const auto differs = [&](std::size_t from, std::size_t count)
  { return std::memcmp(all.data() + from, expected.data() + from, count) != 0; };
  if (differs(8, 4)) refuse(file, "is a snapshot of another format; allowed is format " + std::to_string(snapshot_format));
  if (differs(12, 8)) refuse_scene(file, all, start);
  if (differs(20, 8)) refuse(file, "is a snapshot of another version, whose state differs; allowed is one of this version");
  if (differs(28, 16)) refuse(file, "is damaged: its checksum does not match");
  std::memcpy(&head.kernel, all.data() + 44, sizeof head.kernel);
  for (const Kernel kernel : all_kernels)
  {
    if (head.kernel != static_cast<std::uint32_t>(kernel)) continue;
    snapshot.kernel = kernel;
    return snapshot;
  }
  refuse(file, "is damaged: it names no kernel");
}

}  // namespace drill_rig_sim
