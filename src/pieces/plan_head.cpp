#include "pieces/plan_head.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "core/enums.hpp"
#include "core/guard.hpp"
#include "core/record.hpp"

namespace tetloft::internal::pieces {

namespace {

constexpr RecordKind kHead{"plan", kPlanVersion, "a plan"};
constexpr std::size_t kLabel = 3 * sizeof(std::uint32_t);
// Of a unit of length: doubles are below 2^1024, and multiples of 2^-1074.
constexpr std::int64_t kLargestExponent = 1024 + 1074;
constexpr std::size_t kDecision = 3 * sizeof(std::uint32_t) + 1;

template <class T>
void put_optional(const std::optional<T>& value, RecordWriter& out) {
  out.put(static_cast<std::uint8_t>(value ? 1 : 0));
  out.put(value.value_or(T{}));
}

template <class T>
std::optional<T> get_optional(RecordReader& in) {
  const bool is_there = in.get<std::uint8_t>() != 0;
  const T value = in.get<T>();
  if constexpr (std::is_floating_point_v<T>) {
    in.require(std::isfinite(value), "has a number that is not finite");
  }
  return is_there ? std::optional(value) : std::nullopt;
}

template <class Enum>
void put_enum(Enum value, RecordWriter& out) {
  out.put(static_cast<std::uint8_t>(value));
}

template <class Enum>
Enum get_enum(Enum last, RecordReader& in) {
  const auto value = static_cast<Enum>(in.get<std::uint8_t>());
  in.require(is_enumerator(value, last), "has an option that there is not");
  return value;
}

void put_wishes(const std::vector<Label>& labels, const std::vector<LinkDecision>& decisions,
                RecordWriter& out) {
  out.put_count(labels.size());
  for (const Label& label : labels) {
    out.put(label.section);
    out.put(label.contour);
    out.put(label.label);
  }
  out.put_count(decisions.size());
  for (const LinkDecision& decision : decisions) {
    out.put(decision.slab);
    out.put(decision.lower);
    out.put(decision.upper);
    out.put(static_cast<std::uint8_t>(decision.join ? 1 : 0));
  }
}

void get_wishes(RecordReader& in, std::vector<Label>& labels,
                std::vector<LinkDecision>& decisions) {
  labels.resize(in.get_count(kLabel));
  for (Label& label : labels) {
    label.section = in.get<SectionId>();
    label.contour = in.get<ContourId>();
    label.label = in.get<std::uint32_t>();
  }
  decisions.resize(in.get_count(kDecision));
  for (LinkDecision& decision : decisions) {
    decision.slab = in.get<SlabId>();
    decision.lower = in.get<ContourId>();
    decision.upper = in.get<ContourId>();
    decision.join = in.get<std::uint8_t>() != 0;
  }
}

void put_options(const ReconstructOptions& options, RecordWriter& out) {
  const CorrespondenceOptions& rule = options.correspondence;
  put_enum(rule.criterion, out);
  put_optional(rule.tau, out);
  out.put(static_cast<std::uint8_t>(rule.chain ? 1 : 0));
  out.put(static_cast<std::uint8_t>(rule.lone ? 1 : 0));
  put_wishes(rule.labels, rule.decisions, out);
  put_enum(rule.voids.rule, out);
  out.put(rule.voids.reach);
  put_wishes(rule.voids.labels, rule.voids.decisions, out);
  put_enum(options.ends, out);
  put_optional<std::uint64_t>(options.between, out);
  put_enum(options.delaunay, out);
  out.put(static_cast<std::uint8_t>(options.divide_coarse ? 1 : 0));
  put_optional(options.thickness, out);
  out.put(options.work_limit);
}

ReconstructOptions get_options(RecordReader& in) {
  ReconstructOptions options;
  CorrespondenceOptions& rule = options.correspondence;
  rule.criterion = get_enum(Criterion::moved, in);
  rule.tau = get_optional<double>(in);
  rule.chain = in.get<std::uint8_t>() != 0;
  rule.lone = in.get<std::uint8_t>() != 0;
  get_wishes(in, rule.labels, rule.decisions);
  rule.voids.rule = get_enum(VoidRule::free, in);
  rule.voids.reach = in.get<double>();
  get_wishes(in, rule.voids.labels, rule.voids.decisions);
  options.ends = get_enum(Ends::half, in);
  options.between = get_optional<std::uint64_t>(in);
  options.delaunay = get_enum(DelaunayEngine::slab, in);
  options.divide_coarse = in.get<std::uint8_t>() != 0;
  options.thickness = get_optional<double>(in);
  options.work_limit = in.get<double>();
  in.require(options.work_limit > 0, "has a work limit that is none");
  return options;
}

void put_frame(const Frame& frame, RecordWriter& out) {
  for (const Point3& axis : {frame.axes[0], frame.axes[1], frame.axes[2], frame.origin}) {
    out.put(axis.x);
    out.put(axis.y);
    out.put(axis.z);
  }
}

Frame get_frame(RecordReader& in) {
  Frame frame;
  for (Point3* const axis : {&frame.axes[0], &frame.axes[1], &frame.axes[2], &frame.origin}) {
    for (double* const x : {&axis->x, &axis->y, &axis->z}) {
      *x = in.get<double>();
      in.require(std::isfinite(*x), "has a frame that is not finite");
    }
  }
  return frame;
}

}  // namespace

std::string to_record(const PlanHead& head) {
  RecordWriter out(kHead);
  out.put(static_cast<std::uint64_t>(head.facts.sections));
  out.put(static_cast<std::uint64_t>(head.facts.components));
  out.put(static_cast<std::int32_t>(head.facts.exponent));
  put_optional(head.facts.ends.below, out);
  put_optional(head.facts.ends.above, out);
  put_optional(head.facts.least_long, out);
  put_options(head.options, out);
  out.put_text(head.source.name);
  out.put(head.source.bytes);
  out.put(head.source.checksum);
  out.put(head.source.sampled);
  for (const std::size_t count : {head.contours, head.vertices, head.cavities}) {
    out.put(static_cast<std::uint64_t>(count));
  }
  out.put(head.lowest);
  out.put(head.highest);
  put_frame(head.frame, out);
  for (const std::string& text : {head.about.name, head.about.unit, head.about.orientation}) {
    out.put_text(text);
  }
  out.put_count(head.component_names.size());
  for (const std::string& name : head.component_names) out.put_text(name);
  return out.take();
}

bool begins_as_plan(std::string_view bytes) { return begins_as(bytes, kHead); }

Result<PlanHead> plan_head_from_record(std::string_view bytes, const std::string& name) {
  return guard_internal([&]() -> Result<PlanHead> {
    RecordReader in(bytes, kHead, name);
    PlanHead head;
    head.facts.sections = in.get<std::uint64_t>();
    head.facts.components = in.get<std::uint64_t>();
    head.facts.exponent = in.get<std::int32_t>();
    head.facts.ends.below = get_optional<double>(in);
    head.facts.ends.above = get_optional<double>(in);
    head.facts.least_long = get_optional<double>(in);
    head.options = get_options(in);
    head.source.name = in.get_text();
    head.source.bytes = in.get<std::uint64_t>();
    head.source.checksum = in.get<std::uint64_t>();
    head.source.sampled = in.get<std::uint64_t>();
    for (std::size_t* const count : {&head.contours, &head.vertices, &head.cavities}) {
      *count = in.get<std::uint64_t>();
    }
    head.lowest = in.get<double>();
    head.highest = in.get<double>();
    head.frame = get_frame(in);
    for (std::string* const text : {&head.about.name, &head.about.unit, &head.about.orientation}) {
      *text = in.get_text();
    }
    head.component_names.resize(in.get_count(sizeof(std::uint64_t)));
    for (std::string& text : head.component_names) text = in.get_text();
    in.require(head.facts.sections > 0, "has no section");
    in.require(head.facts.components <= head.contours, "has more components than contours");
    in.require(head.component_names.empty() || head.component_names.size() == head.facts.components,
               "names other components than it counts");
    in.require(std::abs(std::int64_t{head.facts.exponent}) <= kLargestExponent,
               "has a unit that no stack has");
    if (Result<void> read = in.end(); !read) return read.error();
    return head;
  });
}

}  // namespace tetloft::internal::pieces
