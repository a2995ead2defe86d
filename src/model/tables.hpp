// The tables that a model carries about no point or tet: rows of one type, a column for each of its
// members. As fields.hpp, the one list of these, for every reader, writer and check.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <tetloft/model.hpp>

#include "model/fields.hpp"

namespace tetloft::internal {

/// As StoredAs; but a row is about something: its ids are valid.
template <class Value>
struct StoredInRow : StoredAs<Value> {};
template <class Tag>
struct StoredInRow<Id<Tag>> : StoredAs<Id<Tag>> {
  static constexpr std::int64_t kLeast = 0;
  static bool legal(Id<Tag> id) { return std::int64_t{id.value()} <= StoredAs<Id<Tag>>::kLargest; }
};

template <class Row, class V>
struct Column {
  using Value = V;
  using Stored = StoredInRow<V>;

  std::string_view name;  ///< that of the row, an underscore, its own
  V (*get)(const Row&);
  void (*set)(Row&, V);
};

template <class Member>
struct MemberType;
template <class R, class V>
struct MemberType<V R::*> {
  using Row = R;
  using Value = V;
};

template <auto kMember>
constexpr auto member_column(std::string_view name) {
  using Row = typename MemberType<decltype(kMember)>::Row;
  using Value = typename MemberType<decltype(kMember)>::Value;
  return Column<Row, Value>{name, [](const Row& row) { return row.*kMember; },
                            [](Row& row, Value value) { row.*kMember = value; }};
}

template <class R>
struct ModelTable {
  using Row = R;
  std::string_view row;  ///< what a row is called
  std::vector<R> Model::*rows;
};

/// visit(table), for each.
template <class Visit>
void for_each_table(Visit&& visit) {
  visit(ModelTable<RegionLink>{"link", &Model::links});
  visit(ModelTable<RegionMotion>{"motion", &Model::motions});
}

/// visit(column), for each of a table, in the order in which a row is set.
template <class Visit>
void for_each_column(const ModelTable<RegionLink>& /*table*/, Visit&& visit) {
  visit(member_column<&RegionLink::slab>("link_slab"));
  visit(member_column<&RegionLink::lower>("link_lower"));
  visit(member_column<&RegionLink::upper>("link_upper"));
  visit(member_column<&RegionLink::evidence>("link_evidence"));
  visit(member_column<&RegionLink::fate>("link_fate"));
  visit(member_column<&RegionLink::ratio>("link_ratio"));
  visit(member_column<&RegionLink::moved>("link_moved"));
  visit(member_column<&RegionLink::distance>("link_distance"));
  visit(member_column<&RegionLink::margin>("link_margin"));
  // No number means none in text: whether there is a lead comes first, and then which.
  visit(Column<RegionLink, bool>{"link_has_lead",
                                 [](const RegionLink& link) { return link.lead.has_value(); },
                                 [](RegionLink& link, bool has_lead) {
                                   link.lead = has_lead ? std::optional<double>(0) : std::nullopt;
                                 }});
  visit(Column<RegionLink, double>{"link_lead",
                                   [](const RegionLink& link) { return link.lead.value_or(0); },
                                   [](RegionLink& link, double lead) {
                                     if (link.lead) link.lead = lead;
                                   }});
}
template <class Visit>
void for_each_column(const ModelTable<RegionMotion>& /*table*/, Visit&& visit) {
  visit(member_column<&RegionMotion::slab>("motion_slab"));
  visit(member_column<&RegionMotion::upper>("motion_upper"));
  visit(member_column<&RegionMotion::contour>("motion_contour"));
  visit(Column<RegionMotion, double>{"motion_x",
                                     [](const RegionMotion& motion) { return motion.by.x; },
                                     [](RegionMotion& motion, double x) { motion.by.x = x; }});
  visit(Column<RegionMotion, double>{"motion_y",
                                     [](const RegionMotion& motion) { return motion.by.y; },
                                     [](RegionMotion& motion, double y) { motion.by.y = y; }});
}

}  // namespace tetloft::internal
