// A folder with the files that calls read.
#pragma once

#include <string>

#include "c/calls/samples.hpp"
#include "unit/io/io_support.hpp"

namespace tetloft::c_test {

class SampleFolder {
 public:
  SampleFolder() {
    test::put(folder_.file("sample.cnt"), std::string(kMendedText));
    test::put(folder_.file("sample.labels"), std::string(kLabelText));
    test::put(folder_.file("sample.xyz"), std::string(kPointText));
    tetloft_model* model = nullptr;
    tetloft_model_create(kTetPoints.data(), 5, kTets.data(), 2, &model);
    tetloft_model_write(model, folder_.file("sample.vtu").c_str(), nullptr, nullptr);
    tetloft_model_free(model);
  }
  [[nodiscard]] std::string file(const std::string& name) const { return folder_.file(name); }
  [[nodiscard]] std::string path() const {
    std::string path = folder_.file("");
    path.pop_back();
    return path;
  }

 private:
  test::TempFolder folder_;
};

}  // namespace tetloft::c_test
