// Sections in the order of their planes, and those of one plane, or of nearly one, made one.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/repair.hpp>

#include "core/enums.hpp"
#include "core/guard.hpp"
#include "core/option_rules.hpp"

namespace tetloft {

using namespace internal;

namespace {

using Sections = std::vector<SectionId>;

Result<void> check_plane_options(const PlaneOptions& options) {
  if (!is_enumerator(options.rule, PlaneRule::merge)) {
    return Error{ErrorCode::usage, "there is no such rule for planes", {}};
  }
  if (options.rule != PlaneRule::merge) return {};
  return check_length(options.tolerance, "the tolerance of planes");
}

std::string height_text(double z) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", z);
  return text;
}

Result<void> check_heights(const SectionStack& stack, PlaneRule rule) {
  for (const SectionId s : stack.sections.ids()) {
    const double z = stack.sections[s].z;
    Error error{ErrorCode::invalid_input, {}, {}};
    error.where.section = s.index();
    if (!std::isfinite(z)) {
      error.message = "z: coordinate is not finite (" + height_text(z) + ')';
      return error;
    }
    if (rule != PlaneRule::flip || s.index() == 0) continue;
    const double above = stack.sections[SectionId(s.index() - 1)].z;
    if (z < above) continue;
    error.message = "z does not decrease (" + height_text(z) + " after " + height_text(above) +
                    "): the stack cannot be turned over, but sorted";
    return error;
  }
  return {};
}

// The sections that become one, by z.
std::vector<Sections> groups_of(const SectionStack& stack, double tolerance) {
  Sections order;
  for (const SectionId s : stack.sections.ids()) order.push_back(s);
  const auto z = [&](SectionId s) { return stack.sections[s].z; };
  std::stable_sort(order.begin(), order.end(),
                   [&](SectionId a, SectionId b) { return z(a) < z(b); });
  std::vector<Sections> groups;
  for (const SectionId s : order) {
    if (groups.empty() || z(s) - z(groups.back().front()) > tolerance) groups.emplace_back();
    groups.back().push_back(s);
  }
  return groups;
}

// The one at which most contours lie, the lowest of those.
double height_of(const SectionStack& stack, const Sections& group) {
  double best = stack.sections[group.front()].z;
  std::size_t most = 0;
  for (std::size_t i = 0; i < group.size();) {
    const double z = stack.sections[group[i]].z;
    std::size_t contours = 0;
    for (; i < group.size() && stack.sections[group[i]].z == z; ++i) {
      contours += stack.sections[group[i]].contours.size();
    }
    if (contours <= most) continue;
    most = contours;
    best = z;
  }
  return best;
}

Warning merged_warning(const SectionStack& stack, const Sections& group, SectionId made) {
  std::string numbers;
  for (std::size_t i = 0; i < group.size(); ++i) {
    const char* const separator = i == 0 ? "" : i + 1 == group.size() ? " and " : ", ";
    numbers += separator + std::to_string(group[i].index());
  }
  const double low = stack.sections[group.front()].z;
  const double high = stack.sections[group.back()].z;
  Warning warning{"the sections " + numbers + " are one now", {}};
  if (low != high) warning.message += ", from z " + height_text(low) + " to " + height_text(high);
  warning.where.section = made.index();
  return warning;
}

Result<ArrangedPlanes> arrange(const SectionStack& stack, const PlaneOptions& options) {
  if (Result<void> good = check_plane_options(options); !good) return good.error();
  if (Result<void> good = check_heights(stack, options.rule); !good) return good.error();
  ArrangedPlanes result;
  const double tolerance = options.rule == PlaneRule::merge ? options.tolerance : 0;
  result.stack.frame = stack.frame;
  result.stack.about = stack.about;
  for (const Sections& group : groups_of(stack, tolerance)) {
    Section section;
    section.z = height_of(stack, group);
    for (const SectionId s : group) {
      for (const Contour& contour : stack.sections[s].contours) section.contours.push_back(contour);
    }
    const SectionId made = result.stack.sections.push_back(std::move(section));
    if (group.size() > 1) result.changes.push_back(merged_warning(stack, group, made));
    result.origin.push_back(group);
  }
  return result;
}

}  // namespace

Result<ArrangedPlanes> arrange_planes(const SectionStack& stack, const PlaneOptions& options) {
  return guard_internal([&] { return arrange(stack, options); });
}

}  // namespace tetloft
