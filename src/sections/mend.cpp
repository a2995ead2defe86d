// Harmless slips, mended with a warning: repeated vertices change no region.
#include <string>
#include <vector>

#include <tetloft/repair.hpp>

namespace tetloft {

namespace {

// What was removed from one contour.
struct Mended {
  std::size_t duplicates = 0;
  bool closing = false;  // the first vertex stood again at the end
};

Mended mend(Contour& contour) {
  Mended mended;
  std::vector<Point2>& vertices = contour.vertices;
  std::vector<Point2> kept;
  kept.reserve(vertices.size());
  for (const Point2& p : vertices) {
    if (kept.empty() || !(kept.back() == p)) kept.push_back(p);
  }
  mended.duplicates = vertices.size() - kept.size();
  if (kept.size() > 1 && kept.back() == kept.front()) {
    kept.pop_back();
    mended.closing = true;
  }
  if (mended.duplicates > 0 || mended.closing) vertices = std::move(kept);
  return mended;
}

std::string message(const Mended& mended) {
  std::string text;
  if (mended.closing) text = "first vertex repeated at the end";
  if (mended.duplicates > 0) {
    if (!text.empty()) text += " and ";
    text += std::to_string(mended.duplicates) + " consecutive duplicate " +
            (mended.duplicates == 1 ? "vertex" : "vertices");
  }
  return text + " removed";
}

}  // namespace

std::vector<Warning> mend(SectionStack& stack) {
  std::vector<Warning> warnings;
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    Section& section = stack.sections[SectionId(s)];
    for (std::size_t c = 0; c < section.contours.size(); ++c) {
      const Mended mended = mend(section.contours[ContourId(c)]);
      if (mended.duplicates == 0 && !mended.closing) continue;
      Warning warning{message(mended), {}};
      warning.where.section = s;
      warning.where.contour = c;
      warnings.push_back(std::move(warning));
    }
  }
  return warnings;
}

}  // namespace tetloft
