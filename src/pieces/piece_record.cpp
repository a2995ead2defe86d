#include "pieces/piece_record.hpp"

#include <algorithm>
#include <cmath>

#include "core/guard.hpp"
#include "core/record.hpp"

namespace tetloft::internal::pieces {

namespace {

constexpr RecordKind kPiece{"piec", kPieceVersion, "a piece"};
constexpr std::size_t kCluster = 2 * sizeof(std::uint64_t) + 3;

void put_report(const ReconstructReport& report, RecordWriter& out) {
  for (const std::size_t n :
       {report.sections_between, report.sections_given_up, report.dividing_vertices}) {
    out.put(static_cast<std::uint64_t>(n));
  }
  out.put(report.smallest_lift);
  out.put(report.work);
  out.put_all(report.rules);
}

void get_report(RecordReader& in, ReconstructReport& report) {
  for (std::size_t* const n :
       {&report.sections_between, &report.sections_given_up, &report.dividing_vertices}) {
    *n = in.get<std::uint64_t>();
  }
  report.smallest_lift = in.get<double>();
  report.work = in.get<std::uint64_t>();
  const std::vector<std::uint64_t> rules = in.get_all<std::uint64_t>();
  in.require(rules.size() == report.rules.size(), "counts rules that there are not");
  if (in.refused()) return;
  in.require(std::isfinite(report.smallest_lift), "has a number that is not finite");
  std::copy(rules.begin(), rules.end(), report.rules.begin());
}

}  // namespace

std::string to_record(const PieceRecord& piece) {
  RecordWriter out(kPiece);
  out.put(piece.plan);
  for (const std::size_t n :
       {piece.sections, piece.components, piece.slabs.first, piece.slabs.end}) {
    out.put(static_cast<std::uint64_t>(n));
  }
  out.put_count(piece.clusters.size());
  for (const ClusterSpan& cluster : piece.clusters) {
    out.put(static_cast<std::uint64_t>(cluster.slabs.first));
    out.put(static_cast<std::uint64_t>(cluster.slabs.end));
    for (const bool beyond : {cluster.beyond.below, cluster.beyond.above, cluster.beyond.decides}) {
      out.put(static_cast<std::uint8_t>(beyond ? 1 : 0));
    }
  }
  out.put_count(piece.names.size());
  for (const std::string& name : piece.names) out.put_text(name);
  out.put(piece.digest);
  put_report(piece.report, out);
  return out.take();
}

Result<PieceRecord> piece_from_record(std::string_view bytes, const std::string& name) {
  return guard_internal([&]() -> Result<PieceRecord> {
    RecordReader in(bytes, kPiece, name);
    PieceRecord piece;
    piece.plan = in.get<std::uint64_t>();
    for (std::size_t* const n :
         {&piece.sections, &piece.components, &piece.slabs.first, &piece.slabs.end}) {
      *n = in.get<std::uint64_t>();
    }
    const bool single = piece.sections == 1 && piece.slabs == SlabRange{0, 0};
    in.require(single || (piece.slabs.first < piece.slabs.end && piece.slabs.end < piece.sections),
               "has slabs that there are not");
    piece.clusters.resize(in.get_count(kCluster));
    for (ClusterSpan& cluster : piece.clusters) {
      cluster.slabs.first = in.get<std::uint64_t>();
      cluster.slabs.end = in.get<std::uint64_t>();
      for (bool* const beyond :
           {&cluster.beyond.below, &cluster.beyond.above, &cluster.beyond.decides}) {
        *beyond = in.get<std::uint8_t>() != 0;
      }
      in.require(cluster.slabs.first < cluster.slabs.end &&
                     piece.slabs.first <= cluster.slabs.first &&
                     cluster.slabs.end <= piece.slabs.end,
                 "mended slabs that it has not");
    }
    piece.names.resize(in.get_count(sizeof(std::uint64_t)));
    for (std::string& text : piece.names) text = in.get_text();
    piece.digest = in.get<std::uint64_t>();
    in.require(piece.names.empty() || piece.names.size() == piece.components,
               "names other components than it counts");
    get_report(in, piece.report);
    if (Result<void> read = in.end(); !read) return read.error();
    return piece;
  });
}

}  // namespace tetloft::internal::pieces
