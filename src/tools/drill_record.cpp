// SPDX-License-Identifier: BSD-3-Clause
#include "drill_record.h"

#include "drill_options.h"
#include "drill_python.h"

namespace drill_rig_sim
{
void add_record(CLI::App& command, RecordOptions& options)
{
  add_file(command, "RECORD", options.record,
           "a log of WITSML or LAS, or a table (of drill run --csv --readings, with columns of known names, or with --columns)");
}

void add_record_options(CLI::App& command, RecordOptions& options)
{
  command.add_option("--with", options.more, "a further file of the same well, joined by time; may be given again")
      ->type_name("FILE")
      ->allow_extra_args(false);
  add_text(command, "--columns", options.columns, "FILE",
           "map of columns and units, a line each: `hook_load: {column: HL, unit: klbf}`");
  add_text(command, "--from", options.from, "TIME", "begin of the part of the record to use: s, or an ISO date");
  add_text(command, "--to", options.to, "TIME", "end of that part");
  command
      .add_option("--leave-out", options.left_out, "an interval A:B of the record to leave out (dates: A..B); may be given again")
      ->type_name("A:B")
      ->allow_extra_args(false);
}

std::vector<std::string> words_of(const RecordOptions& options)
{
  std::vector<std::string> words;
  for (const std::string& file : options.more) add_word(words, "--with", file);
  add_word(words, "--columns", options.columns);
  add_word(words, "--from", options.from);
  add_word(words, "--to", options.to);
  for (const std::string& stretch : options.left_out) add_word(words, "--leave-out", stretch);
  return words;
}

}  // namespace drill_rig_sim
