// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_TEMPORARY_FOLDER_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_TEMPORARY_FOLDER_H

#include <string>

namespace drill_rig_sim
{
/// A new folder that is removed with all in it when this ends.
class TemporaryFolder
{
public:
  /// `option` of the command line needs it. Throws UsageError where none can be made.
  explicit TemporaryFolder(const char* option);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const noexcept { return path_; }

private:
  std::string path_;
};

}  // namespace drill_rig_sim

#endif
