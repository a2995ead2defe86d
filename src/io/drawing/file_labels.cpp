// Labels and adjacency, looked up contour by contour.
#include "io/drawing/file_labels.hpp"

#include <map>

#include <tetloft/nesting.hpp>

#include "core/union_find.hpp"

namespace tetloft::internal::io {

namespace {

// take(section, contour, line, whether it is a hole), in the order of contours.
template <class Take>
void for_each_contour(const LineOfContour& origin, const SectionStack& stack, Take&& take) {
  for (std::size_t s = 0; s < origin.size(); ++s) {
    const Nesting nesting = nest(stack.sections[SectionId(s)]);
    for (std::size_t c = 0; c < origin[s].size(); ++c) {
      take(SectionId(s), ContourId(c), origin[s][c], nesting.depth[ContourId(c)] % 2 == 1);
    }
  }
}

}  // namespace

Labels labels_of_lines(const LineOfContour& origin, const std::vector<ChosenLine>& lines,
                       const SectionStack& stack) {
  Labels labels;
  for_each_contour(origin, stack, [&](SectionId s, ContourId c, std::size_t line, bool hole) {
    if (hole) return;
    labels.labels.push_back({s, c, static_cast<std::uint32_t>(lines[line].line.label)});
  });
  return labels;
}

Labels labels_of_joins(const LineOfContour& origin, const std::vector<ChosenLine>& lines,
                       const std::vector<DrawnJoin>& joins, const SectionStack& stack) {
  // By position in the file, some of which were left out.
  std::map<std::size_t, std::size_t> line_at;
  for (std::size_t i = 0; i < lines.size(); ++i) line_at.emplace(lines[i].position, i);
  std::vector<bool> is_hole(lines.size());
  for_each_contour(origin, stack, [&](SectionId, ContourId, std::size_t line, bool hole) {
    is_hole[line] = hole;
  });
  UnionFind sets(lines.size());
  for (const DrawnJoin& join : joins) {
    const auto lower = line_at.find(join.lower);
    const auto upper = line_at.find(join.upper);
    if (lower == line_at.end() || upper == line_at.end()) continue;
    // What one section has as a hole and the next as a body hangs together by no rule.
    if (is_hole[lower->second] == is_hole[upper->second]) sets.unite(lower->second, upper->second);
  }
  Labels labels;
  std::map<std::size_t, std::uint32_t> number;  // by the set's least line
  for_each_contour(origin, stack, [&](SectionId s, ContourId c, std::size_t line, bool hole) {
    const auto next = static_cast<std::uint32_t>(number.size() + 1);
    const std::uint32_t label = number.emplace(sets.find(line), next).first->second;
    (hole ? labels.hole_labels : labels.labels).push_back({s, c, label});
  });
  return labels;
}

}  // namespace tetloft::internal::io
