// SPDX-License-Identifier: BSD-3-Clause
#include "drill_temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "drill_command.h"

namespace drill_rig_sim
{
TemporaryFolder::TemporaryFolder(const char* option) : path_((std::filesystem::temp_directory_path() / "drill_XXXXXX").string())
{
  if (mkdtemp(path_.data()) == nullptr)
    throw UsageError(std::string(option) + ": " + path_ + " cannot be made: " + std::strerror(errno));
}

TemporaryFolder::~TemporaryFolder()
{
  std::error_code unknown;  // what cannot be removed stays
  std::filesystem::remove_all(path_, unknown);
}

}  // namespace drill_rig_sim
