// Running the executable.
#pragma once

#include <string>
#include <vector>

#include "cli/json_value.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft::test {

struct Outcome {
  int code = -1;  ///< exit code; −1 where the program was ended by a signal
  std::string out;
  std::string err;
};

/// Runs tetloft with these words, its standard input empty.
[[nodiscard]] Outcome run(const std::vector<std::string>& words);

/// As run, but standard output goes to `file`.
[[nodiscard]] Outcome run_into(const std::string& file, const std::vector<std::string>& words);

/// Runs with --json added and expects exactly one JSON object and the exit code.
[[nodiscard]] JsonValue run_json(std::vector<std::string> words, int expected_code = 0);

/// Expects the exit code with a message on standard error, that --json makes it an error
/// object of this code too, and that nothing is left at any of `outputs`.
void expect_failure(const std::vector<std::string>& words, int code, const std::string& name,
                    const std::string& word_in_message,
                    const std::vector<std::string>& outputs = {});

/// Stacks as text.
inline const std::string kTube =
    "S 2\nv 4 z 0\n{\n0 0\n2 0\n2 2\n0 2\n}\nv 4 z 1\n{\n0 0\n2 0\n2 2\n0 2\n}\n";
/// One contour below, two above.
inline const std::string kFork =
    "S 2\nv 4 z 0\n{ -3 -1 3 -1 3 1 -3 1 }\nv 8 z 1\n{ -3 -1 -0.5 -1 -0.5 1 -3 1 }\n"
    "{ 0.5 -1 3 -1 3 1 0.5 1 }\n";
/// A square that moves by 1, then by 3: more than its width.
inline const std::string kLeaning =
    "S 3\nv 4 z 0\n{ 0 0 2 0 2 2 0 2 }\nv 4 z 1\n{ 1 0 3 0 3 2 1 2 }\n"
    "v 4 z 4\n{ 4 0 6 0 6 2 4 2 }\n";
/// Crosses itself, in line 3.
inline const std::string kBowtie =
    "S 2\nv 4 z 0\n{ 0 0 10 10 10 0 0 10 }\nv 4 z 1\n{ 0 0 10 0 10 10 0 10 }\n";

}  // namespace tetloft::test
