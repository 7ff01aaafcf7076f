// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_TEXT_FILE_H
#define DRILL_RIG_SIM_SRC_SCENE_TEXT_FILE_H

#include <cstddef>
#include <string>

namespace drill_rig_sim
{
/// Largest scene, survey or plan [bytes]; a larger file is none of them.
constexpr std::size_t longest_text = 16u << 20;

/// A text file's content.
struct TextFile
{
  std::string text;    ///< UTF-8 without a byte order mark
  std::string remark;  ///< to be reported, in one line with the file's name: it is not Unicode and was read as latin-1 or
                       ///< windows-1251; else empty
};

/// Reads the whole of a regular file of at most `longest` bytes, in any of decode_text()'s encodings (text_decoder.h). Anything
/// else (a folder, a pipe, a device, a larger file) is refused before it is opened or read, so that nothing blocks. Throws
/// SceneError with one line that says what is wrong; `needed` names in it what the file should have been ("a scene file").
TextFile read_text_file(const std::string& file, const char* needed, std::size_t longest = longest_text);

}  // namespace drill_rig_sim

#endif
