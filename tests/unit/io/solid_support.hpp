// Solids for the tests of files of simulation programs, and words of such files.
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <tetloft/model.hpp>

namespace tetloft::test {

/// Seven tets apart from each other, but for the first two, which share a face: of components 0, 0,
/// 1, 2, 3, 4 and none. Names are hard: with a quote and a line feed, beyond ASCII, twice the same,
/// a number; one has none.
inline Model named_solid() {
  Model model;
  const auto add = [&](double x, ComponentId component) {
    const VertexId first = model.points.end_id();
    for (const Point3& p : std::vector<Point3>{{x, 0.1, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x, 0, 1}}) {
      model.points.push_back(p);
    }
    const auto corner = [&](std::size_t k) { return VertexId(first.index() + k); };
    model.tets.push_back({corner(0), corner(1), corner(2), corner(3)});
    model.component.push_back(component);
  };
  add(0, ComponentId(0));
  model.points.push_back({1, 1, 1});
  model.tets.push_back({VertexId(1), VertexId(2), VertexId(3), VertexId(4)});
  model.component.push_back(ComponentId(0));
  for (const int c : {1, 2, 3, 4}) add(3 * c + 1.0 / 3, ComponentId(c));
  add(100, ComponentId());
  model.component_count = 5;
  model.component_names =
      IdVector<ComponentId, std::string>(std::vector<std::string>{"left \"lobe\"\nof it",
                                                                  "Gr\xC3\xB6\xC3\x9F"
                                                                  "e 7",
                                                                  "lobe a", "lobe A", "7"});
  model.about = {"liver", "mm", "LPS"};
  return model;
}

/// As comments have it.
inline std::string first_name_printed() { return "left \"lobe\"\\x0aof it"; }

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Commas are blanks.
inline std::vector<std::string> words_of_line(std::string line) {
  for (char& c : line) c = c == ',' ? ' ' : c;
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

inline std::vector<double> numbers_of_line(const std::string& line) {
  std::vector<double> numbers;
  for (const std::string& word : words_of_line(line)) {
    char* end = nullptr;
    numbers.push_back(std::strtod(word.c_str(), &end));
    if (*end != '\0') ADD_FAILURE() << word << " is no number";
  }
  return numbers;
}

/// Six times the volume of a tet.
inline double determinant(const std::array<Point3, 4>& p) {
  const auto from = [&](std::size_t k) {
    return Point3{p[k].x - p[0].x, p[k].y - p[0].y, p[k].z - p[0].z};
  };
  const Point3 a = from(1), b = from(2), c = from(3);
  return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
         a.z * (b.x * c.y - b.y * c.x);
}

}  // namespace tetloft::test
