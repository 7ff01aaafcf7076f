#include "drill_json.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace drill_rig_sim
{
namespace
{
std::string quoted(const std::string& text)
{
  std::string out = "\"";
  for (const char c : text)
  {
    if (c == '"' || c == '\\')
    {
      out += '\\';
      out += c;
    }
    else if (static_cast<unsigned char>(c) < 0x20)
    {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
      out += escape;
    }
    else
    {
      out += c;
    }
  }
  return out + "\"";
}

std::string number(double value)
{
  if (!std::isfinite(value)) return "null";
  char text[40];
  for (int digits = 6; digits <= 17; ++digits)
  {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value) break;
  }
  return text;
}
}  // namespace

void Json::add(const std::string& key, double value)
{
  members_.emplace_back(key, number(value));
}

void Json::add(const std::string& key, const std::string& value)
{
  members_.emplace_back(key, quoted(value));
}

void Json::add(const std::string& key, const Json& value)
{
  members_.emplace_back(key, value.text(1));
}

std::string Json::text(int level) const
{
  const std::string indent(static_cast<std::size_t>(2 * level), ' ');
  std::string out = "{";
  for (std::size_t i = 0; i < members_.size(); ++i)
  {
    out += (i == 0 ? "\n" : ",\n") + indent + "  " + quoted(members_[i].first) + ": " + members_[i].second;
  }
  return out + (members_.empty() ? "}" : "\n" + indent + "}");
}

}  // namespace drill_rig_sim
