#include "problems.h"

#include <cstdio>

#include "drill_rig_sim/scene/read_scene.h"

namespace drill_rig_sim
{
namespace
{
// a hopeless file (a picture, say) need not scroll the screen away
constexpr std::size_t most_problems = 40;

std::string joined(const std::vector<std::string>& lines)
{
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

// control characters and line breaks from a broken file must not reach the one-line messages
std::string printable(const std::string& text)
{
  std::string out;
  for (const char c : text) out += (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) ? '?' : c;
  return out;
}
}  // namespace

SceneError::SceneError(std::vector<std::string> problems) : std::runtime_error(joined(problems)), problems_(std::move(problems))
{
}

void Problems::add_at(int line, const std::string& path, const std::string& text)
{
  if (problems_.size() == most_problems) problems_.push_back(file_ + ": and more problems");
  if (problems_.size() > most_problems) return;
  const std::string where = line == from_outside ? "setting" : line > 0 ? file_ + ":" + std::to_string(line) : file_;
  problems_.push_back(printable(where + ": " + (path.empty() ? "" : path + ": ") + text));
}

void Problems::raise() const
{
  if (!problems_.empty()) throw SceneError(problems_);
}

int Problems::line_of(std::string path) const
{
  while (true)
  {
    const auto found = lines_.find(path);
    if (found != lines_.end()) return found->second;
    if (path.empty()) return 1;
    const std::size_t end = path.find_last_of(".[");
    path.resize(end == std::string::npos ? 0 : end);
  }
}

std::string plain(double value)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace drill_rig_sim
