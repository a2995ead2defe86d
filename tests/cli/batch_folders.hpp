// What the tests of reconstruct of many stacks share.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/runner.hpp"

namespace tetloft::test {

/// Three stacks in a folder, and another one for what becomes of them.
class BatchFolders : public ::testing::Test {
 protected:
  BatchFolders() {
    std::filesystem::create_directory(in_);
    put(stack("fork"), kFork);
    put(stack("leaning"), kLeaning);
    put(stack("tube"), kTube);
  }

  [[nodiscard]] std::string stack(const std::string& name) const {
    return in_ + '/' + name + ".cnt";
  }
  [[nodiscard]] std::string solid(const std::string& name) const {
    return out_ + '/' + name + ".vtu";
  }
  [[nodiscard]] std::string log() const { return out_ + "/tetloft.jsonl"; }
  [[nodiscard]] std::vector<JsonValue> lines() const {
    std::vector<JsonValue> lines;
    const std::string all = get(log());
    for (std::size_t at = 0; at < all.size();) {
      const std::size_t end = all.find('\n', at);
      EXPECT_NE(end, std::string::npos) << "the last line has no end";
      if (end == std::string::npos) break;
      const auto value = parse_json(all.substr(at, end - at));
      EXPECT_TRUE(value.has_value()) << all.substr(at, end - at);
      lines.push_back(value.value_or(JsonValue{}));
      at = end + 1;
    }
    return lines;
  }
  // By name, what became of each.
  [[nodiscard]] static std::map<std::string, std::string> fates(const JsonValue& told) {
    std::map<std::string, std::string> fates;
    for (const JsonValue& one : told.at("stacks").array) {
      fates[std::filesystem::path(one.at("input").string).stem().string()] =
          one.at("outcome").string;
    }
    return fates;
  }
  [[nodiscard]] JsonValue batch(std::vector<std::string> options = {}, int code = 0) const {
    options.insert(options.begin(), {"reconstruct", in_, "-o", out_});
    return run_json(options, code);
  }

  TempFolder folder_;
  std::string in_ = folder_.file("in");
  std::string out_ = folder_.file("out");
};

}  // namespace tetloft::test
