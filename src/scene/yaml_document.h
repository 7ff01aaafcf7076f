#ifndef DRILL_RIG_SIM_SRC_SCENE_YAML_DOCUMENT_H
#define DRILL_RIG_SIM_SRC_SCENE_YAML_DOCUMENT_H

#include <yaml-cpp/yaml.h>

#include <string>

#include "problems.h"

namespace drill_rig_sim
{
struct Document
{
  YAML::Node root;
  bool has_aliases = false;  ///< nodes may stand in several places: a change in one is one in all
};

/// Parses `text` as exactly one YAML document of bounded size. Throws SceneError, with `problems`' file and the line, if it is not.
Document load_document(const std::string& text, Problems& problems);

}  // namespace drill_rig_sim

#endif
