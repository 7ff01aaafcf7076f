// SPDX-License-Identifier: BSD-3-Clause
#include "drill_verified_scores.h"

#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include "drill_command.h"
#include "drill_python.h"

namespace drill_rig_sim
{
namespace
{
constexpr double every = 0.1;  // between rows, as of `drill run --csv` [s]
const char* const series_names[] = {"run", "finer", "finest"};
}  // namespace

VerifiedScores::VerifiedScores() : folder_("--score"), beat_(every)
{
  for (std::size_t i = 0; i < files_.size(); ++i)
  {
    files_[i] = open_output("--score", file(i));
    write_csv_header(files_[i].get(), false);
  }
}

std::string VerifiedScores::file(std::size_t series) const
{
  return folder_.path() + "/" + series_names[series] + ".csv";
}

void VerifiedScores::add(const Simulator& simulator, const FinerPair& pair, double frame)
{
  if (!beat_.due(simulator.truth().time, frame)) return;
  write_csv_row(files_[0].get(), simulator.truth(), nullptr);
  write_csv_row(files_[1].get(), simulator.companion_truth(pair.finer()), nullptr);
  write_csv_row(files_[2].get(), simulator.companion_truth(pair.finest()), nullptr);
}

std::string VerifiedScores::compare(const ScoreOptions& options, const std::string& units)
{
  const std::string json = folder_.path() + "/scores.json";
  std::vector<std::string> words = words_of(options);
  add_word(words, "--json", json);
  add_word(words, "--units", units);
  words.push_back("--");
  for (std::size_t i = 0; i < files_.size(); ++i)
  {
    close_output(std::move(files_[i]), file(i));
    words.push_back(file(i));
  }
  if (run_python("verified_scores_command", words) != 0) throw ComputationError("the scores could not be computed");
  std::ifstream written(json);
  return {std::istreambuf_iterator<char>(written), {}};
}

}  // namespace drill_rig_sim
