// Running the executable through the shell, with both outputs in files.
#include "cli/runner.hpp"

#include <sys/wait.h>

#include <cstdlib>

namespace tetloft::test {

namespace {

// Quoted for the shell.
std::string word_of(const std::string& text) {
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'') {
      word += "'\\''";
    } else {
      word += c;
    }
  }
  return word + '\'';
}

}  // namespace

Outcome run_into(const std::string& file, const std::vector<std::string>& words) {
  TempFolder folder;
  std::string command = word_of(TETLOFT_EXECUTABLE);
  for (const std::string& word : words) command += ' ' + word_of(word);
  const std::string err = folder.file("err");
  command += " </dev/null >" + word_of(file) + " 2>" + word_of(err);
  const int status = std::system(command.c_str());
  Outcome outcome;
  // The shell tells of a signal by an exit code above 128.
  if (WIFEXITED(status) && WEXITSTATUS(status) < 128) outcome.code = WEXITSTATUS(status);
  outcome.err = get(err);
  return outcome;
}

Outcome run(const std::vector<std::string>& words) {
  TempFolder folder;
  const std::string out = folder.file("out");
  Outcome outcome = run_into(out, words);
  outcome.out = get(out);
  return outcome;
}

JsonValue run_json(std::vector<std::string> words, int expected_code) {
  words.emplace_back("--json");
  const Outcome outcome = run(words);
  EXPECT_EQ(outcome.code, expected_code) << outcome.err;
  if (expected_code != 0) {
    EXPECT_FALSE(outcome.err.empty());
  }
  const auto value = parse_json(outcome.out);
  EXPECT_TRUE(value.has_value()) << outcome.out;
  if (!value) return {};
  EXPECT_EQ(value->kind, JsonValue::Kind::object);
  return *value;
}

void expect_failure(const std::vector<std::string>& words, int code, const std::string& name,
                    const std::string& word_in_message, const std::vector<std::string>& outputs) {
  std::string all;
  for (const std::string& word : words) all += word + ' ';
  const auto expect_nothing_written = [&] {
    for (const std::string& output : outputs) {
      EXPECT_FALSE(std::filesystem::exists(output)) << all << output;
    }
  };
  const Outcome plain = run(words);
  EXPECT_EQ(plain.code, code) << all << plain.err;
  EXPECT_TRUE(plain.out.empty()) << all << plain.out;
  EXPECT_NE(plain.err.find(word_in_message), std::string::npos) << all << plain.err;
  expect_nothing_written();
  const JsonValue json = run_json(words, code);
  EXPECT_EQ(json.object.size(), 1U) << all;
  EXPECT_EQ(json.at("error").at("code").string, name) << all;
  EXPECT_FALSE(json.at("error").at("message").string.empty()) << all;
  EXPECT_EQ(json.at("error").at("where").kind, JsonValue::Kind::object) << all;
  expect_nothing_written();
}

}  // namespace tetloft::test
