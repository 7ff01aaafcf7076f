#include "survey_units.h"

#include <algorithm>
#include <vector>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
struct Spelled
{
  SurveyUnit unit;
  std::vector<const char*> spellings;
};

// `grad` is none of them: it is a gon in English and a degree in German
const std::vector<Spelled>& lengths()
{
  static const std::vector<Spelled> table = {
      {{"m", 1.0}, {"m", "meter", "meters", "metre", "metres", "mtr", "mtrs"}},
      {{"ft", 0.3048}, {"ft", "feet", "foot", "ift", "'"}},
      {{"ftUS", 1200.0 / 3937.0}, {"ftus", "usft", "ussft", "ftsurvey", "ussurveyfeet"}},
  };
  return table;
}

const std::vector<Spelled>& angles()
{
  static const std::vector<Spelled> table = {
      {{"deg", degree}, {"deg", "degs", "degree", "degrees", "dega", "\xc2\xb0", "\xc2\xba"}},
      {{"rad", 1.0}, {"rad", "rads", "radian", "radians"}},
      {{"gon", pi / 200.0}, {"gon", "gons"}},
  };
  return table;
}

const SurveyUnit* find(const std::vector<Spelled>& table, const std::string& spelling)
{
  for (const Spelled& entry : table)
    if (std::find(entry.spellings.begin(), entry.spellings.end(), spelling) != entry.spellings.end()) return &entry.unit;
  return nullptr;
}

// letters and signs only: "US ft" and "ft." are "usft" and "ft"
std::string compact(const std::string& spelling)
{
  std::string text;
  for (const char c : lowered(spelling))
    if (std::string(" ._-").find(c) == std::string::npos) text += c;
  return text;
}
}  // namespace

std::string lowered(std::string text)
{
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

const SurveyUnit* length_unit(const std::string& spelling)
{
  const std::string text = compact(spelling);
  if (const SurveyUnit* unit = find(lengths(), text)) return unit;
  // the rotary table's names, from which depths are counted
  for (const std::string& datum : std::vector<std::string> {"brkb", "bkb", "rkb", "kb", "brt", "mdrt", "rte", "rt", "df", "ahrt", "ahd", "md"})
  {
    if (text.size() <= datum.size() || text.compare(text.size() - datum.size(), datum.size(), datum) != 0) continue;
    if (const SurveyUnit* unit = find(lengths(), text.substr(0, text.size() - datum.size()))) return unit;
  }
  return nullptr;
}

const SurveyUnit* angle_unit(const std::string& spelling)
{
  return find(angles(), compact(spelling));
}

}  // namespace drill_rig_sim
