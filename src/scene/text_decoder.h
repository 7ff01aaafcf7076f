// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_TEXT_DECODER_H
#define DRILL_RIG_SIM_SRC_SCENE_TEXT_DECODER_H

#include <cstddef>
#include <string>

namespace drill_rig_sim
{
/// What a file's bytes say.
struct DecodedText
{
  std::string text;      ///< UTF-8 without a byte order mark
  std::string taken_as;  ///< where the bytes are no Unicode, for what they were taken: latin-1 or windows-1251; else empty
  std::string wrong;     ///< why they are no text, in one line; else empty
  int wrong_line = 0;    ///< where, from 1; 0: of the whole
};

/// Text out of UTF-8 with or without a byte order mark, UTF-16 with one, or else latin-1 (windows-1252), in which any bytes are a
/// text; windows-1251 where most bytes beyond ASCII stand in words of three and more, as Cyrillic letters do. NUL bytes are in no
/// text: UTF-16 without its mark, UTF-32 and binary files are known by them.
DecodedText decode_text(std::string bytes);

/// Bytes of the UTF-8 character that begins at `at` < bytes.size(); 0 where none does. Overlong forms, surrogates and points
/// beyond 10FFFF are none.
std::size_t utf8_length(const std::string& bytes, std::size_t at);

}  // namespace drill_rig_sim

#endif
