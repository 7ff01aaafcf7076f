#ifndef DRILL_RIG_SIM_SRC_SCENE_TEXT_FILE_H
#define DRILL_RIG_SIM_SRC_SCENE_TEXT_FILE_H

#include <cstddef>
#include <string>

namespace drill_rig_sim
{
/// Largest scene or survey [bytes]; a larger file is neither.
constexpr std::size_t longest_text = 16u << 20;

/// Reads the whole of a regular file of at most longest_text bytes. Anything else (a folder, a pipe, a device, a larger file) is
/// refused before it is opened or read, so that nothing blocks. On success `text` holds the file and an empty string is returned,
/// otherwise one line that says what is wrong; `needed` names in it what the file should have been ("a scene file").
std::string read_text_file(const std::string& file, const char* needed, std::string& text);

}  // namespace drill_rig_sim

#endif
