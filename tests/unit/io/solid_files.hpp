// What the tests of solids in other programs' formats share.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>

#include "unit/io/io_support.hpp"

namespace tetloft::test {

/// Two tets with a face in common, of two components, and a point of neither.
inline Model two_tets() {
  Model model;
  for (const Point3& p : std::vector<Point3>{{0.5, 0, -0.0},
                                             {1, 0, 0},
                                             {0, 1, 0},
                                             {0, 0, 2},
                                             {1, 1, 0x1.0000000000001p0},
                                             {7, 8, 9}}) {
    model.points.push_back(p);
  }
  const auto add = [&](int a, int b, int c, int d, int component) {
    model.tets.push_back({VertexId(a), VertexId(b), VertexId(c), VertexId(d)});
    model.component.push_back(ComponentId(component));
  };
  add(0, 1, 2, 3, 1);
  add(1, 4, 2, 3, 0);
  model.component_count = 2;
  return model;
}

inline Model with_names(Model model) {
  model.about = {"left \"lung\" of A/B", "mm", "LPS"};
  model.component_names.push_back("Gr\xC3\xBCn \xF0\x9F\xAB\x80");
  model.component_names.push_back("two  words");
  return model;
}

inline std::string written(const Model& model, const std::string& format, Encoding encoding) {
  const auto made = format_model(model, {encoding, format});
  EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
  return made ? made->bytes : std::string();
}

template <class T>
std::string in_order(T value, bool big) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// The bytes of numbers, each as a T.
template <class T>
std::string packed(const std::vector<double>& values, bool big) {
  std::string bytes;
  for (const double value : values) bytes += in_order(static_cast<T>(value), big);
  return bytes;
}

inline std::vector<double> coordinates_of(const Model& model) {
  std::vector<double> all;
  for (const Point3& p : model.points) all.insert(all.end(), {p.x, p.y, p.z});
  return all;
}

/// The error of a file that ends in `name`, in this line, 0 where it has none.
template <class Read>
void expect_error_at(const Read& read, const std::string& name, std::size_t line,
                     const std::string& reason) {
  ASSERT_FALSE(read.ok()) << reason;
  EXPECT_EQ(read.error().code, ErrorCode::invalid_input);
  EXPECT_TRUE(read.error().where.file.ends_with(name)) << read.error().where.file;
  EXPECT_EQ(read.error().where.line.value_or(0), line) << reason;
  EXPECT_NE(read.error().message.find(reason), std::string::npos)
      << read.error().message << " instead of " << reason;
}

inline void expect_refused(const std::string& bytes, const std::string& name,
                           const std::string& reason) {
  const auto read = parse_model(bytes, name);
  ASSERT_FALSE(read.ok()) << reason << '\n' << bytes;
  EXPECT_EQ(read.error().code, ErrorCode::invalid_input);
  EXPECT_EQ(read.error().where.file, name);
  EXPECT_NE(read.error().message.find(reason), std::string::npos)
      << read.error().message << " instead of " << reason << '\n'
      << bytes;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace tetloft::test
