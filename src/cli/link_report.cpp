// See link_report.hpp.
#include "cli/link_report.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

#include "cli/console.hpp"

namespace tetloft::cli {

namespace {

struct LinkCounts {
  std::array<std::size_t, kEvidences> made{};
  std::array<std::size_t, kLinkFates> not_made{};
  std::size_t all_made = 0;
  std::size_t all_not_made = 0;

  void add(const RegionLink& link) {
    if (link.fate == LinkFate::made) {
      ++made[static_cast<std::size_t>(link.evidence)];
      ++all_made;
    } else {
      ++not_made[static_cast<std::size_t>(link.fate)];
      ++all_not_made;
    }
  }
};

template <class Row>
LinkCounts counts_of(const std::vector<Row>& links) {
  LinkCounts counts;
  for (const RegionLink& link : links) counts.add(link);
  return counts;
}

std::string text_of(const LinkCounts& counts) {
  std::string made;
  for (std::size_t e = 0; e < counts.made.size(); ++e) {
    if (counts.made[e] == 0) continue;
    made += (made.empty() ? "" : ", ") + std::to_string(counts.made[e]) + " by " +
            name_of(static_cast<Evidence>(e));
  }
  std::string nearly;
  for (std::size_t f = 0; f < counts.not_made.size(); ++f) {
    if (counts.not_made[f] == 0) continue;
    nearly += (nearly.empty() ? "" : ", ") + std::to_string(counts.not_made[f]) + ' ' +
              name_of(static_cast<LinkFate>(f));
  }
  const auto part = [](std::size_t n, const char* what, const std::string& details) {
    return std::to_string(n) + ' ' + what + (details.empty() ? "" : " (" + details + ')');
  };
  return part(counts.all_made, "made", made) + "; " + part(counts.all_not_made, "nearly", nearly);
}

// Names as keys and values of JSON: one word.
std::string json_name(const char* name) {
  std::string word = name;
  std::replace(word.begin(), word.end(), ' ', '_');
  return word;
}

std::string three_digits(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", value);
  return buffer;
}

// Behind the # of a line.
std::string measures(const RegionLink& link) {
  std::string text = name_of(link.evidence);
  if (link.fate != LinkFate::made) text += std::string(", ") + name_of(link.fate);
  text += ": ratio " + three_digits(link.ratio) + ", moved " + three_digits(link.moved) +
          ", distance " + three_digits(link.distance) + ", margin " + three_digits(link.margin);
  if (link.lead) text += ", lead " + three_digits(*link.lead);
  return text;
}

std::string hole_name(ContourId contour) {
  return contour.valid() ? std::to_string(contour.index()) : "outside";
}

std::string decision(const RegionLink& link) {
  return (link.fate == LinkFate::made ? "join " : "part ") + std::to_string(link.slab.index()) +
         ' ' + std::to_string(link.lower.index()) + ' ' + std::to_string(link.upper.index());
}
std::string decision(const VoidLink& link) {
  return (link.fate == LinkFate::made ? "open " : "close ") + std::to_string(link.slab.index()) +
         ' ' + hole_name(link.lower) + ' ' + hole_name(link.upper);
}

bool is_decided(const RegionLink& link) {
  return link.evidence == Evidence::decision || link.fate == LinkFate::decided_part;
}

// Those that are listed: all, or the first so many.
template <class Row>
std::vector<Row> listed(const std::vector<Row>& all, const std::optional<std::size_t>& first) {
  std::vector<Row> links = least_sure_first(all);
  if (!first) return links;
  std::size_t left = *first;
  const auto is_left_out = [&left](const RegionLink& link) {
    if (is_decided(link)) return false;
    if (left == 0) return true;
    --left;
    return false;
  };
  // A loop, for erase_if may ask in any order.
  std::vector<Row> kept;
  for (const Row& link : links) {
    if (!is_left_out(link)) kept.push_back(link);
  }
  return kept;
}

std::string lines_listed(std::size_t lines, std::size_t all, const char* of) {
  if (lines == all) return "";
  return "# listed: " + std::to_string(lines) + " of " + std::to_string(all) + of + '\n';
}

std::string header(const LinkListing& listing, std::size_t lines) {
  const auto& links = listing.links.links;
  std::string text =
      "# What belongs together, least sure first. A line \"join S C D\" or \"part S C D\" says "
      "that\n"
      "# contour C of section S and contour D of section S+1 (outer ones of two regions) are, or "
      "are\n"
      "# not, linked directly. To decide otherwise write join for part or part for join, and give\n"
      "# this file, or the changed lines alone, to reconstruct, check or links as --labels FILE.\n"
      "# Behind the #: the evidence and, if not linked, why; overlap ratio of the regions, as they "
      "lie\n"
      "# and moved; their distance in gaps; by what margin it was decided; lead over the best "
      "rival.\n";
  text += "# " + counted(listing.sections, "section") + ", " +
          counted(listing.links.components, "component") + ", links: " + text_of(counts_of(links)) +
          '\n';
  return text + lines_listed(lines, links.size(), "");
}

std::string void_header(const LinkListing& listing, std::size_t lines) {
  const auto& links = listing.links.void_links;
  return "# Which voids are one, likewise. A line \"open S H I\" or \"close S H I\" says that hole "
         "H "
         "of\n"
         "# section S and hole I of section S+1, each a contour or the word outside, hang together "
         "or not.\n"
         "# " +
         (listing.links.cavities == 1 ? std::string("1 cavity")
                                      : std::to_string(listing.links.cavities) + " cavities") +
         ", links of voids: " + text_of(counts_of(links)) + '\n' +
         lines_listed(lines, links.size(), " of voids");
}

template <class Row>
std::string slab_counts(std::size_t sections, const std::vector<Row>& links) {
  std::vector<LinkCounts> slabs(sections - 1);
  for (const RegionLink& link : links) slabs[link.slab.index()].add(link);
  std::string text = "# By slab, between sections S and S+1:\n";
  for (std::size_t k = 0, end = 0; k < slabs.size(); k = end) {
    const std::string counts = text_of(slabs[k]);
    for (end = k + 1; end < slabs.size() && text_of(slabs[end]) == counts;) ++end;
    text += "# S " + std::to_string(k) + (end == k + 1 ? "" : " to " + std::to_string(end - 1)) +
            ": " + counts + '\n';
  }
  return text;
}

std::string label_lines(const std::vector<Label>& labels, const char* word) {
  std::string text;
  for (const Label& label : labels) {
    text += word + std::to_string(label.section.index()) + ' ' +
            std::to_string(label.contour.index()) + ' ' + std::to_string(label.label) +
            "  # label\n";
  }
  return text;
}

template <class Row>
std::string decision_lines(const std::vector<Row>& links) {
  std::string text;
  for (const Row& link : links) text += decision(link) + "  # " + measures(link) + '\n';
  return text;
}

void write_ends(JsonWriter& json, const RegionLink& link) {
  json.member("lower", link.lower.index());
  json.member("upper", link.upper.index());
}
void write_ends(JsonWriter& json, const VoidLink& link) {
  for (const auto& [name, contour] :
       {std::pair("lower", link.lower), std::pair("upper", link.upper)}) {
    if (contour.valid()) {
      json.member(name, contour.index());
    } else {
      json.member(name, hole_name(contour));
    }
  }
}

template <class Row>
void write_link(JsonWriter& json, const Row& link) {
  json.begin_object();
  json.member("slab", link.slab.index());
  write_ends(json, link);
  json.member("made", link.fate == LinkFate::made);
  json.member("evidence", name_of(link.evidence));
  json.member("fate", json_name(name_of(link.fate)));
  json.member("ratio", link.ratio);
  json.member("moved", link.moved);
  json.member("distance", link.distance);
  json.member("margin", link.margin);
  if (link.lead) json.member("lead", *link.lead);
  json.end_object();
}

template <class Row>
void write_all(JsonWriter& json, const std::vector<Row>& links) {
  json.begin_array();
  for (const Row& link : links) write_link(json, link);
  json.end_array();
}

template <class Row>
void write_counts(JsonWriter& json, const std::vector<Row>& links) {
  const LinkCounts counts = counts_of(links);
  json.key("made");
  json.begin_object();
  for (std::size_t e = 0; e < counts.made.size(); ++e) {
    json.member(name_of(static_cast<Evidence>(e)), counts.made[e]);
  }
  json.end_object();
  json.key("not_made");
  json.begin_object();
  for (std::size_t f = 0; f < counts.not_made.size(); ++f) {
    const auto fate = static_cast<LinkFate>(f);
    if (fate != LinkFate::made) json.member(json_name(name_of(fate)), counts.not_made[f]);
  }
  json.end_object();
}

// Positions in `links` of the least sure first, as many as are asked for.
template <class Row>
void write_order(JsonWriter& json, const std::vector<Row>& links,
                 const std::optional<std::size_t>& first) {
  std::map<std::tuple<SlabId, ContourId, ContourId>, std::size_t> position;
  for (std::size_t k = 0; k < links.size(); ++k) {
    position[{links[k].slab, links[k].lower, links[k].upper}] = k;
  }
  std::size_t left = first.value_or(links.size());
  json.key("least_sure");
  json.begin_array();
  for (const Row& link : least_sure_first(links)) {
    if (left == 0) break;
    --left;
    json.value(position[{link.slab, link.lower, link.upper}]);
  }
  json.end_array();
}

template <class Row>
void write_summary(JsonWriter& json, const char* key, const std::vector<Row>& links) {
  constexpr std::size_t kFew = 5;
  json.key(key);
  json.begin_object();
  write_counts(json, links);
  std::vector<Row> few = least_sure_first(links);
  few.resize(std::min(few.size(), kFew));
  json.key("least_sure");
  write_all(json, few);
  json.end_object();
}

template <class Row>
std::string description(const char* what, const std::vector<Row>& links) {
  if (links.empty()) return "";
  const Row least = least_sure_first(links).front();
  return what + text_of(counts_of(links)) + "; the least sure: " + decision(least) + " (" +
         measures(least) + ")\n";
}

}  // namespace

std::string link_lines(const LinkListing& listing, bool told) {
  const auto& all = listing.links;
  const std::vector<RegionLink> links = listed(all.links, listing.first);
  const std::vector<VoidLink> voids = listed(all.void_links, listing.first);
  const bool slabs = told && listing.sections > 1;
  std::string text = told ? header(listing, links.size()) : "";
  text += label_lines(listing.labels, "") + decision_lines(links);
  if (slabs) text += slab_counts(listing.sections, all.links);
  if (told && !all.void_links.empty()) text += void_header(listing, voids.size());
  text += label_lines(listing.hole_labels, "hole ") + decision_lines(voids);
  if (slabs && !all.void_links.empty()) text += slab_counts(listing.sections, all.void_links);
  return text;
}

void write_links(JsonWriter& json, const LinkListing& listing) {
  const StackLinks& found = listing.links;
  write_counts(json, found.links);
  json.key("links");
  write_all(json, found.links);
  write_order(json, found.links, listing.first);
  json.key("voids");
  json.begin_object();
  json.member("cavities", found.cavities);
  write_counts(json, found.void_links);
  json.key("links");
  write_all(json, found.void_links);
  write_order(json, found.void_links, listing.first);
  json.end_object();
}

void write_link_summary(JsonWriter& json, const Model& model) {
  write_summary(json, "links", model.links);
  write_summary(json, "void_links", model.void_links);
}

std::string describe_links(const std::vector<RegionLink>& links,
                           const std::vector<VoidLink>& voids) {
  return description("links: ", links) + description("links of voids: ", voids);
}

}  // namespace tetloft::cli
