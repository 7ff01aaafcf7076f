#ifndef DRILL_RIG_SIM_SRC_SCENE_YAML_DOCUMENT_H
#define DRILL_RIG_SIM_SRC_SCENE_YAML_DOCUMENT_H

#include <yaml-cpp/yaml.h>

#include <string>

#include "problems.h"

namespace drill_rig_sim
{
/// Parses `text` as exactly one YAML document of bounded size. Throws SceneError, with `problems`' file and the line, if it is not.
YAML::Node load_document(const std::string& text, Problems& problems);

}  // namespace drill_rig_sim

#endif
