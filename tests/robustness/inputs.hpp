// Small stacks that lead through most of the library.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <tetloft/tetloft.hpp>

namespace tetloft::test {

inline std::string case_path(const std::string& name) {
  return TETLOFT_DATA_DIR "/cases/" + name + ".cnt";
}

inline SectionStack case_stack(const std::string& name) {
  Result<ReadStack> read = read_cnt(case_path(name));
  if (!read) throw std::runtime_error(to_string(read.error()));
  return std::move(read->stack);
}

inline Contour polygon(Point2 centre, double radius, std::size_t corners) {
  Contour contour;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    contour.vertices.push_back(
        {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return contour;
}

/// Spread over the unit cube: enough for threads to be given parts of.
inline std::vector<Point3> many_points_in_space() {
  std::vector<Point3> points;
  for (int i = 0; i < 5000; ++i) {
    points.push_back({std::fmod(i * 0.6180339887, 1), std::fmod(i * 0.4142135624, 1),
                      std::fmod(i * 0.7320508076, 1)});
  }
  return points;
}

/// Polygons, one in each section, each with a hole.
inline SectionStack tower(std::size_t sections, std::size_t corners = 8) {
  SectionStack stack;
  for (std::size_t s = 0; s < sections; ++s) {
    Section section;
    section.z = static_cast<double>(s);
    const Point2 centre{0.1 * static_cast<double>(s % 3), 0.05 * static_cast<double>(s % 2)};
    section.contours.push_back(polygon(centre, 2, corners));
    section.contours.push_back(polygon(centre, 1, corners - 1));
    stack.sections.push_back(section);
  }
  return stack;
}

/// Squares that move by their width and more: nothing overlaps.
inline SectionStack leaning_stack() {
  SectionStack stack;
  double x = 0;
  for (const double z : {0.0, 1.0, 4.0}) {
    x += z;
    Section section;
    section.z = z;
    section.contours.push_back({{{x, 0}, {x + 2, 0}, {x + 2, 2}, {x, 2}}});
    stack.sections.push_back(section);
  }
  return stack;
}

inline SectionStack single_section() {
  SectionStack stack;
  stack.sections.push_back(tower(1).sections[SectionId(0)]);
  return stack;
}

/// One label on all contours of data/cases/fork.
inline std::vector<Label> fork_labels() {
  std::vector<Label> labels;
  const SectionStack stack = case_stack("fork");
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    for (std::size_t c = 0; c < stack.sections[SectionId(s)].contours.size(); ++c) {
      labels.push_back({SectionId(s), ContourId(c), 1});
    }
  }
  return labels;
}

inline Model model_of(const SectionStack& stack) {
  Result<Reconstruction> made = reconstruct(stack, {.execution = {.threads = 1}});
  if (!made) throw std::runtime_error(to_string(made.error()));
  return std::move(made->model);
}

}  // namespace tetloft::test
