// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_LATIN_LETTERS_H
#define DRILL_RIG_SIM_MATH_LATIN_LETTERS_H

#include <string>

namespace drill_rig_sim
{
/// A text in UTF-8 with Latin letters without accents in the place of those with accents (é, ł, ø) and of Cyrillic ones (й as y,
/// х as kh, ц as ts; soft and hard signs are left out), so that names and units are known by one spelling. Other signs stay.
std::string latin_letters(const std::string& text);

}  // namespace drill_rig_sim

#endif
