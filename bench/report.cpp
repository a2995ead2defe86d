#include "report.hpp"

#include <algorithm>
#include <cstdio>

namespace tetloft::bench {

namespace {

template <class... Values>
std::string format(const char* pattern, Values... values) {
  char buffer[256];
  std::snprintf(buffer, sizeof buffer, pattern, values...);
  return buffer;
}

double nanoseconds_each(double seconds, std::size_t n) {
  return n == 0 ? 0 : 1e9 * seconds / static_cast<double>(n);
}

constexpr std::pair<const char*, PredicateCounters::Stages PredicateCounters::*> kCounted[] = {
    {"orient2d", &PredicateCounters::orient2d},
    {"orient3d", &PredicateCounters::orient3d},
    {"incircle", &PredicateCounters::incircle},
    {"insphere", &PredicateCounters::insphere}};

unsigned long long number(std::uint64_t n) { return n; }

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result + '"';
}

std::string json_of(const Measurement& m, std::size_t points) {
  std::string json = "{\"name\": " + quoted(m.name);
  if (!m.left_out.empty()) return json + ", \"left_out\": " + quoted(m.left_out) + "}";
  if (!m.failure.empty()) return json + ", \"failure\": " + quoted(m.failure) + "}";
  json += format(", \"best\": %.6g, \"median\": %.6g, \"ns_per_point\": %.4g", m.best(), m.median(),
                 nanoseconds_each(m.best(), points));
  json += format(", \"ns_per_simplex\": %.4g, \"simplices\": %zu, \"peak_mb\": %.1f",
                 nanoseconds_each(m.best(), m.simplices), m.simplices, m.peak_megabytes);
  if (!m.steps.empty()) {
    json += ", \"steps\": {";
    for (std::size_t i = 0; i < m.steps.size(); ++i) {
      json += (i == 0 ? "" : ", ") + quoted(m.steps[i].first) + format(": %.6g", m.steps[i].second);
    }
    json += "}";
  }
  if (m.counters) {
    json += ", \"settled\": {";
    bool first = true;
    for (const auto& [name, member] : kCounted) {
      const PredicateCounters::Stages& s = (*m.counters).*member;
      json +=
          (first ? "" : ", ") + quoted(name) +
          format(": {\"filter\": %llu, \"lattice\": %llu, \"expansion\": %llu", number(s.filter),
                 number(s.lattice), number(s.expansion)) +
          format(", \"integer\": %llu, \"symbolic\": %llu}", number(s.integer), number(s.symbolic));
      first = false;
    }
    json += "}";
  }
  return json + "}";
}

std::string why_invalid(const Measurement& m) {
  return m.left_out.empty() ? "failed: " + m.failure : m.left_out;
}

// What a row has below it: steps, and by which stage predicates were settled.
std::string details_of(const Measurement& m) {
  std::string text;
  if (!m.steps.empty()) {
    text += "    steps:";
    for (const auto& [name, seconds] : m.steps) text += format(" %s %.4f", name.c_str(), seconds);
    text += '\n';
  }
  if (!m.counters) return text;
  for (const auto& [name, member] : kCounted) {
    const PredicateCounters::Stages& s = (*m.counters).*member;
    if (s.filter + s.lattice + s.expansion + s.integer + s.symbolic == 0) continue;
    text += format("    %s settled by filter %llu, lattice %llu, expansion %llu", name,
                   number(s.filter), number(s.lattice), number(s.expansion));
    text += format(", integer %llu, symbolic %llu\n", number(s.integer), number(s.symbolic));
  }
  return text;
}

// Seconds of the best run, and megabytes, by distribution and size.
std::string distribution_table(const Report& report) {
  std::vector<std::string> names;
  const auto for_each = [](const CaseReport& one, const auto& visit) {
    for (const Measurement& m : one.own) visit(m);
    for (const Measurement& m : one.peers) visit(m);
  };
  for (const CaseReport& one : report.cases) {
    if (one.distribution.empty()) continue;
    for_each(one, [&](const Measurement& m) {
      if (std::find(names.begin(), names.end(), m.name) == names.end()) names.push_back(m.name);
    });
  }
  if (names.empty()) return {};
  std::string text = "Seconds (MB) of the best run.\n\n| distribution | points |";
  for (const std::string& name : names) text += ' ' + name + " |";
  text += "\n|---|---|";
  for (std::size_t k = 0; k < names.size(); ++k) text += "---|";
  text += '\n';
  for (const CaseReport& one : report.cases) {
    if (one.distribution.empty()) continue;
    text += "| " + one.distribution + " | " + std::to_string(one.points) + " |";
    for (const std::string& name : names) {
      std::string cell;
      for_each(one, [&](const Measurement& m) {
        if (m.name != name) return;
        cell = m.valid() ? format("%.3g (%.0f)", m.best(), m.peak_megabytes) : why_invalid(m);
      });
      text += ' ' + cell + " |";
    }
    text += '\n';
  }
  return text + '\n';
}

std::string case_table(const Report& report) {
  std::string text =
      "| case | points | who | best (s) | median (s) | MB | ratio of bests (median of rounds) |\n"
      "|---|---|---|---|---|---|---|\n";
  std::string details;
  for (const CaseReport& one : report.cases) {
    if (!one.distribution.empty()) continue;
    const auto row = [&](const Measurement& m, const std::string& ratio) {
      text += "| " + one.name + " | " + std::to_string(one.points) + " | " + m.name + " | ";
      text += m.valid() ? format("%.3f | %.3f | %.0f", m.best(), m.median(), m.peak_megabytes)
                        : why_invalid(m) + " | | ";
      text += " | " + ratio + " |\n";
      if (!m.valid() || (m.steps.empty() && !m.counters)) return;
      details += "- " + one.name + ", " + m.name + ":\n" + details_of(m);
    };
    for (const Measurement& own : one.own) {
      std::string ratios;
      for (const Measurement& peer : one.peers) {
        if (!own.valid() || !peer.valid()) continue;
        ratios += (ratios.empty() ? "" : ", ") + peer.name +
                  format(" %.2f (%.2f)", own.best() / peer.best(), median_ratio(own, peer));
      }
      row(own, ratios);
    }
    for (const Measurement& peer : one.peers) row(peer, "");
  }
  if (!details.empty()) text += "\n" + details;
  return text;
}

}  // namespace

std::string text_of(const CaseReport& report) {
  std::string text =
      report.name + " (" + report.what + "), " + std::to_string(report.points) + " points\n";
  const auto line = [&](const Measurement& m) {
    if (!m.valid()) {
      text += "  " + m.name + ": " + why_invalid(m) + '\n';
      return;
    }
    text += format("  %-14s best %8.4f s  median %8.4f s  %7.0f ns/point  %6.1f ns/simplex",
                   m.name.c_str(), m.best(), m.median(), nanoseconds_each(m.best(), report.points),
                   nanoseconds_each(m.best(), m.simplices));
    text += format("  %9zu simplices  %6.0f MB\n", m.simplices, m.peak_megabytes);
    text += details_of(m);
  };
  for (const Measurement& m : report.own) line(m);
  for (const Measurement& peer : report.peers) {
    line(peer);
    if (!peer.valid()) continue;
    for (const Measurement& own : report.own) {
      if (!own.valid()) continue;
      text += format("    %s / %s: %.3f of bests, %.3f median of rounds\n", own.name.c_str(),
                     peer.name.c_str(), own.best() / peer.best(), median_ratio(own, peer));
    }
  }
  return text;
}

std::string text_of(const std::vector<PredicateTime>& times) {
  std::string text = "predicates\n";
  for (const PredicateTime& t : times) {
    text += format("  %-18s %-8s %-10s %8.1f ns a call, settles %3.0f %%\n", t.predicate.c_str(),
                   t.input.c_str(), t.stage.c_str(), t.nanoseconds, 100 * t.share);
  }
  return text;
}

std::string json_of(const Report& report) {
  std::string json = "{\"rounds\": " + std::to_string(report.rounds) +
                     format(", \"limit\": %g", report.limit) + ", \"peers\": [";
  for (std::size_t i = 0; i < report.versions.size(); ++i) {
    json += (i == 0 ? "" : ", ") + quoted(report.versions[i]);
  }
  json += "],\n \"cases\": [";
  for (std::size_t c = 0; c < report.cases.size(); ++c) {
    const CaseReport& one = report.cases[c];
    json += std::string(c == 0 ? "" : ",") + "\n  {\"name\": " + quoted(one.name) +
            ", \"points\": " + std::to_string(one.points) + ",\n   \"own\": [";
    for (std::size_t i = 0; i < one.own.size(); ++i) {
      json += (i == 0 ? "" : ", ") + json_of(one.own[i], one.points);
    }
    json += "],\n   \"peers\": [";
    for (std::size_t i = 0; i < one.peers.size(); ++i) {
      json += (i == 0 ? "" : ", ") + json_of(one.peers[i], one.points);
    }
    json += "],\n   \"ratios\": [";
    bool first = true;
    for (const Measurement& own : one.own) {
      for (const Measurement& peer : one.peers) {
        if (!own.valid() || !peer.valid()) continue;
        json += (first ? "" : ", ") + ("{\"own\": " + quoted(own.name)) +
                ", \"peer\": " + quoted(peer.name) +
                format(", \"best\": %.4f, \"median\": %.4f}", own.best() / peer.best(),
                       median_ratio(own, peer));
        first = false;
      }
    }
    json += "]}";
  }
  json += "],\n \"predicates\": [";
  for (std::size_t i = 0; i < report.predicates.size(); ++i) {
    const PredicateTime& t = report.predicates[i];
    json += (i == 0 ? "\n  " : ",\n  ") + ("{\"predicate\": " + quoted(t.predicate)) +
            ", \"input\": " + quoted(t.input) + ", \"stage\": " + quoted(t.stage) +
            format(", \"ns\": %.1f, \"share\": %.3f}", t.nanoseconds, t.share);
  }
  return json + "]}\n";
}

std::string markdown_of(const Report& report) {
  std::string text = distribution_table(report);
  const bool others = std::any_of(report.cases.begin(), report.cases.end(),
                                  [](const CaseReport& one) { return one.distribution.empty(); });
  if (others) text += case_table(report);
  if (report.predicates.empty()) return text;
  text += "\n| predicate | input | stage | ns a call | settled |\n|---|---|---|---|---|\n";
  for (const PredicateTime& t : report.predicates) {
    text += "| " + t.predicate + " | " + t.input + " | " + t.stage +
            format(" | %.1f | %.0f %% |\n", t.nanoseconds, 100 * t.share);
  }
  return text;
}

}  // namespace tetloft::bench
