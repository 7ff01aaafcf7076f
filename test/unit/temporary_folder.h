// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_TEMPORARY_FOLDER_H
#define DRILL_RIG_SIM_TEST_TEMPORARY_FOLDER_H

#include <stdlib.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace drill_rig_sim
{
/// A new, empty folder that goes with this object: whatever an earlier or another run left behind cannot decide a test.
class TemporaryFolder
{
public:
  TemporaryFolder() : path_(std::filesystem::temp_directory_path() / "drill_rig_sim_XXXXXX")
  {
    if (!mkdtemp(path_.data())) throw std::runtime_error("no temporary folder");
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return path_ + "/" + name; }

private:
  std::string path_;
};

}  // namespace drill_rig_sim

#endif
