// Small stacks, planned and cut into pieces: what the target `pieces` damages. They are made by the
// library as it is, so that no file of an earlier version stands for them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <tetloft/pieces.hpp>
#include <tetloft/reconstruct.hpp>

#include "fuzz/target.hpp"
#include "support/temp_files.hpp"

namespace tetloft::fuzz {

inline void write_bytes(const std::string& path, std::string_view bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  require(file.good(), "no room for files");
}

/// A stack, with its plan and pieces as files.
struct PlannedCase {
  SectionStack stack;
  ReconstructOptions options;
  std::vector<std::size_t> cuts;  ///< where pieces begin, and the end
  std::string plan;
  std::vector<std::string> pieces;
  std::uint64_t identity = 0;  ///< of the plan
  bool any_open = false;
  Model model;  ///< of the single run
};

inline Contour rectangle(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

/// Section i at z = i.
inline SectionStack stack_of(const std::vector<std::vector<Contour>>& sections) {
  SectionStack stack;
  for (const std::vector<Contour>& contours : sections) {
    Section section;
    section.z = static_cast<double>(stack.sections.size());
    for (const Contour& contour : contours) section.contours.push_back(contour);
    stack.sections.push_back(section);
  }
  return stack;
}

// A body with a hole that ends, which becomes two; with ends, a name, a label and a decision.
inline PlannedCase branching_case() {
  PlannedCase made;
  made.stack = stack_of({{rectangle(0, 0, 8, 4)},
                         {rectangle(0, 0, 8, 4), rectangle(1, 1, 3, 3)},
                         {rectangle(0, 0, 3, 4), rectangle(5, 0, 8, 4)},
                         {rectangle(0, 1, 3, 4)}});
  made.stack.about.name = "branching";
  made.options.ends = Ends::half;
  made.options.correspondence.labels = {{SectionId(0), ContourId(0), 1}};
  made.options.correspondence.decisions = {{SlabId(2), ContourId(1), ContourId(0), false}};
  made.cuts = {0, 1, 3};
  return made;
}

// A body that moves far, so that sections are put between.
inline PlannedCase moving_case() {
  PlannedCase made;
  made.stack = stack_of({{rectangle(0, 0, 4, 4), rectangle(1, 1, 2, 3)},
                         {rectangle(3, 0, 7, 4), rectangle(4, 1, 5, 3)},
                         {rectangle(6, 0, 10, 4)}});
  made.options.between = 2;
  made.cuts = {0, 1, 2};
  return made;
}

// A slab that needs refined contours where the stack is cut: its pieces leave it open.
inline PlannedCase open_case() {
  const Contour plate = rectangle(-1000, 0, 100, 100);
  const Contour tip = {{{103, 50}, {104, 49}, {104, 51}}};
  const std::vector<Contour> nest = {rectangle(97, 49, 99, 51), rectangle(95, 47, 101, 53),
                                     rectangle(90, 42, 106, 58)};
  PlannedCase made;
  made.stack = stack_of({{plate}, {plate, tip}, nest, {plate}});
  made.options.divide_coarse = false;
  made.options.correspondence.criterion = Criterion::overlap;
  made.options.correspondence.labels = {{SectionId(1), ContourId(0), 1},
                                        {SectionId(1), ContourId(1), 101},
                                        {SectionId(2), ContourId(0), 1},
                                        {SectionId(2), ContourId(1), 102}};
  made.cuts = {0, 2, 3};
  return made;
}

inline PlannedCase single_case() {
  PlannedCase made;
  made.stack = stack_of({{rectangle(0, 0, 4, 2), rectangle(1, 0.5, 2, 1.5)}});
  made.cuts = {0, 0};
  return made;
}

inline void write_case(const test::TempFolder& folder, std::size_t number, PlannedCase& one) {
  one.options.execution.threads = 1;
  auto made = reconstruct(one.stack, one.options);
  require(made.ok(), "the stack of a case is refused");
  one.model = std::move(made->model);
  const std::string name = "case" + std::to_string(number);
  one.plan = folder.file(name + ".plan");
  const auto planned = write_plan(one.plan, one.stack, one.options);
  require(planned.ok(), "a case is not planned");
  one.identity = planned->summary.identity;
  PieceOptions options;
  options.execution.threads = 1;
  options.encoding = Encoding::ascii;  // each byte of which means something
  for (std::size_t k = 0; k + 1 < one.cuts.size(); ++k) {
    one.pieces.push_back(folder.file(name + '_' + std::to_string(k) + ".vtu"));
    const auto piece =
        write_piece(one.pieces.back(), one.plan, one.cuts[k], one.cuts[k + 1], options);
    require(piece.ok(), "a piece of a case is refused");
    one.any_open = one.any_open || !piece->summary.open.empty();
  }
}

inline std::vector<PlannedCase> written_cases(const test::TempFolder& folder) {
  std::vector<PlannedCase> all = {branching_case(), moving_case(), open_case(), single_case()};
  for (std::size_t k = 0; k < all.size(); ++k) write_case(folder, k, all[k]);
  return all;
}

}  // namespace tetloft::fuzz
