// The tables that a model carries about no point or tet: rows of one type, a column for each of its
// members. As fields.hpp, the one list of these, for every reader, writer and check.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <tetloft/model.hpp>

#include "model/fields.hpp"

namespace tetloft::internal {

/// As StoredAs; but a row is about something: its ids are valid, if it does not say otherwise.
template <class Value>
struct StoredInRow : StoredAs<Value> {};
template <class Tag>
struct StoredInRow<Id<Tag>> : StoredAs<Id<Tag>> {
  static constexpr std::int64_t kLeast = 0;
  static bool legal(Id<Tag> id) { return std::int64_t{id.value()} <= StoredAs<Id<Tag>>::kLargest; }
};

template <class Row, class V, class As = StoredInRow<V>>
struct Column {
  using Value = V;
  using Stored = As;

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

/// Of an id that may be invalid.
template <auto kMember>
constexpr auto optional_id_column(std::string_view name) {
  using Row = typename MemberType<decltype(kMember)>::Row;
  using Value = typename MemberType<decltype(kMember)>::Value;
  return Column<Row, Value, StoredAs<Value>>{name, [](const Row& row) { return row.*kMember; },
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
  visit(ModelTable<VoidLink>{"void", &Model::void_links});
  visit(ModelTable<Deviation>{"deviation", &Model::deviations});
}

/// The columns in which links of regions and of voids are alike.
struct LinkColumns {
  std::string_view evidence, fate, ratio, moved, distance, margin, has_lead, lead;

  template <class Visit>
  void for_each(Visit&& visit) const {
    visit(member_column<&RegionLink::evidence>(evidence));
    visit(member_column<&RegionLink::fate>(fate));
    visit(member_column<&RegionLink::ratio>(ratio));
    visit(member_column<&RegionLink::moved>(moved));
    visit(member_column<&RegionLink::distance>(distance));
    visit(member_column<&RegionLink::margin>(margin));
    // No number means none in text: whether there is a lead comes first, and then which.
    visit(Column<RegionLink, bool>{has_lead,
                                   [](const RegionLink& link) { return link.lead.has_value(); },
                                   [](RegionLink& link, bool has) {
                                     link.lead = has ? std::optional<double>(0) : std::nullopt;
                                   }});
    visit(Column<RegionLink, double>{lead,
                                     [](const RegionLink& link) { return link.lead.value_or(0); },
                                     [](RegionLink& link, double value) {
                                       if (link.lead) link.lead = value;
                                     }});
  }
};

/// visit(column), for each of a table, in the order in which a row is set.
template <class Visit>
void for_each_column(const ModelTable<RegionLink>& /*table*/, Visit&& visit) {
  visit(member_column<&RegionLink::slab>("link_slab"));
  visit(member_column<&RegionLink::lower>("link_lower"));
  visit(member_column<&RegionLink::upper>("link_upper"));
  constexpr LinkColumns kColumns{"link_evidence", "link_fate",   "link_ratio",    "link_moved",
                                 "link_distance", "link_margin", "link_has_lead", "link_lead"};
  kColumns.for_each(visit);
}
template <class Visit>
void for_each_column(const ModelTable<VoidLink>& /*table*/, Visit&& visit) {
  visit(member_column<&VoidLink::slab>("void_slab"));
  // The exterior has no hole that names it.
  visit(optional_id_column<&VoidLink::lower>("void_lower"));
  visit(optional_id_column<&VoidLink::upper>("void_upper"));
  visit(member_column<&VoidLink::planes>("void_planes"));
  constexpr LinkColumns kColumns{"void_evidence", "void_fate",   "void_ratio",    "void_moved",
                                 "void_distance", "void_margin", "void_has_lead", "void_lead"};
  kColumns.for_each(visit);
}
template <class Visit>
void for_each_column(const ModelTable<Deviation>& /*table*/, Visit&& visit) {
  visit(member_column<&Deviation::slab>("deviation_slab"));
  visit(member_column<&Deviation::upper>("deviation_upper"));
  visit(member_column<&Deviation::contour>("deviation_contour"));
  visit(member_column<&Deviation::least>("deviation_least"));
  visit(member_column<&Deviation::most>("deviation_most"));
  visit(member_column<&Deviation::got>("deviation_got"));
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
