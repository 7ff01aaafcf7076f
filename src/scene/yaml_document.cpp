// SPDX-License-Identifier: BSD-3-Clause
#include "yaml_document.h"

#include <yaml-cpp/eventhandler.h>

#include <cstddef>
#include <sstream>

#include "text_file.h"

namespace drill_rig_sim
{
namespace
{
constexpr long most_nodes = 200000;  // some 100 MB once they are loaded; 50,000 survey stations

/// What the first pass ends with where the text is no scene.
struct Refusal
{
  YAML::Mark mark;
  const char* text;
};

/// Counts what a parser meets and builds nothing. YAML::LoadAll goes on for ever, and takes all memory, where a document is
/// followed by something that begins none (a comma, say: yaml-cpp's issue 1040), so a second document ends the pass.
class Counter : public YAML::EventHandler
{
public:
  long documents() const { return documents_; }
  bool empty() const { return only_null_; }
  bool has_aliases() const { return aliases_; }

  void OnDocumentStart(const YAML::Mark&) override { ++documents_; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { count(mark, true); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override
  {
    aliases_ = true;
    count(mark, false);
  }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t, const std::string&) override { count(mark, false); }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override
  {
    count(mark, false);
  }
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override
  {
    count(mark, false);
  }
  void OnMapEnd() override {}

private:
  void count(const YAML::Mark& mark, bool null)
  {
    only_null_ = nodes_ == 0 && null;
    if (documents_ > 1) throw Refusal{mark, "a second YAML document or stray text begins; allowed: one document"};
    if (++nodes_ > most_nodes) throw Refusal{mark, "more than 200000 values: this is not a scene"};
  }

  long documents_ = 0;
  long nodes_ = 0;
  bool only_null_ = true, aliases_ = false;
};

void refuse_hidden_units(const std::string& text, Problems& problems)
{
  std::istringstream in(text);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number)
    if (hides_a_unit(line)) problems.fail(number, "YAML", hidden_unit);
}

// the line of the first tab where YAML allows blanks only, from 1; 0: there is none
int line_with_tab(const std::string& text)
{
  std::istringstream in(text);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number)
    if (line.find('\t') < line.find_first_not_of(" \t") && line.find_first_not_of(" \t\r") != std::string::npos) return number;
  return 0;
}

// a parser's message ends, after a colon, with what it found in the file
std::string without_content(const std::string& message)
{
  return message.substr(0, message.find(':'));
}

[[noreturn]] void refuse_what_is_no_yaml(const std::string& text, const YAML::Exception& e, Problems& problems)
{
  if (const int tab = line_with_tab(text)) problems.fail(tab, "YAML", "the line begins with a tab, allowed: spaces");
  std::string told = without_content(e.msg);
  if (told == "end of map flow not found") told = "a } or a comma is missing";
  if (told == "end of sequence flow not found") told = "a ] or a comma is missing";
  problems.fail(e.mark.line + 1, "YAML", "cannot be parsed: " + told);
}

}  // namespace

std::string text_for_yaml(const std::string& text)
{
#ifdef DRILL_RIG_SIM_YAML_CPP_0_6
  std::string out;
  char quote = 0, before = '\n';
  bool comment = false;
  for (std::size_t i = 0; i < text.size(); before = text[i++])
  {
    const char c = text[i];
    const bool begins = std::string(" \t\n,[{").find(before) != std::string::npos;
    if (c == '\n') comment = false;
    if (c == '\n' || c == quote)
      quote = 0;
    else if (begins && quote == 0 && !comment)
    {
      comment = c == '#';
      if (c == '"' || c == '\'') quote = c;
    }
    out += c;
    if (c == ':' && quote == 0 && !comment && (i + 1 == text.size() || text[i + 1] == ']')) out += ' ';
  }
  return out;
#else
  return text;
#endif
}

bool hides_a_unit(const std::string& line)
{
  const std::size_t sign = line.find(" #");  // a comment begins there; what follows is part of it
  if (sign == std::string::npos || line.compare(sign, 3, " #/") != 0) return false;
  const std::size_t last = line.find_last_not_of(' ', sign);
  return last != std::string::npos && line[last] >= '0' && line[last] <= '9';
}

Document load_document(const std::string& text, Problems& problems)
{
  if (text.size() > longest_text) problems.fail(0, "YAML", "larger than 16 MiB: this is not a scene");
  try
  {
    const std::string given = text_for_yaml(text);
    std::istringstream in(given);
    YAML::Parser parser(in);
    Counter counter;
    while (parser.HandleNextDocument(counter))
    {
    }
    if (counter.documents() == 0 || counter.empty()) problems.fail(1, "YAML", "the file is empty, needed: a scene");
    refuse_hidden_units(text, problems);
    return {YAML::Load(given), counter.has_aliases()};
  }
  catch (const Refusal& refusal)
  {
    problems.fail(refusal.mark.line + 1, "YAML", refusal.text);
  }
  catch (const YAML::Exception& e)
  {
    refuse_what_is_no_yaml(text, e, problems);
  }
}

}  // namespace drill_rig_sim
