// The pieces of a plan by MPI: mpi_pieces PLAN RANGES FOLDER, RANGES being a file of lines A:B.
// Each rank makes every n-th piece, FOLDER/A:B.vtu, but those that are there and of this plan; so a
// run that was ended goes on where it was. The ranks share a file system and nothing else.
//
//   mpicxx -std=c++20 -O2 mpi_pieces.cpp -o mpi_pieces -ltetloft -pthread
#define OMPI_SKIP_MPICXX 1  // bindings that MPI has no longer, with warnings
#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <tetloft/pieces.hpp>

namespace {

struct Range {
  std::size_t first = 0;
  std::size_t end = 0;
};

// What follows the first line that is no range is not looked at: the caller sees too few pieces.
std::vector<Range> read_ranges(const char* path) {
  std::vector<Range> ranges;
  std::ifstream file(path);
  Range range;
  for (char colon = 0; file >> range.first >> colon >> range.end && colon == ':';) {
    ranges.push_back(range);
  }
  return ranges;
}

bool is_there(const std::string& path, const Range& range, std::uint64_t plan) {
  const auto piece = tetloft::read_piece(path);
  return piece && piece->plan == plan && piece->first == range.first && piece->end == range.end;
}

// All ranks end: the launcher tells whoever started it.
int give_up(int rank, const std::string& message) {
  std::fprintf(stderr, "rank %d: %s\n", rank, message.c_str());
  MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
  return EXIT_FAILURE;
}

int make_pieces(const std::string& plan, const char* ranges_file, const std::string& folder) {
  int rank = 0;
  int ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const auto planned = tetloft::read_plan(plan);
  if (!planned) return give_up(rank, to_string(planned.error()));
  const std::vector<Range> ranges = read_ranges(ranges_file);
  if (ranges.empty()) return give_up(rank, std::string(ranges_file) + " has no line A:B");
  tetloft::PieceOptions options;
  options.execution.threads = 1;  // a rank is a core
  unsigned long long made = 0;
  for (auto k = static_cast<std::size_t>(rank); k < ranges.size();
       k += static_cast<std::size_t>(ranks)) {
    const Range& range = ranges[k];
    const std::string path =
        folder + '/' + std::to_string(range.first) + ':' + std::to_string(range.end) + ".vtu";
    if (is_there(path, range, planned->identity)) continue;
    const auto piece = tetloft::write_piece(path, plan, range.first, range.end, options);
    if (!piece) return give_up(rank, to_string(piece.error()));
    ++made;
  }
  unsigned long long all = 0;
  MPI_Reduce(&made, &all, 1, MPI_UNSIGNED_LONG_LONG, MPI_SUM, 0, MPI_COMM_WORLD);
  if (rank == 0) std::printf("%llu of %zu pieces made by %d ranks\n", all, ranges.size(), ranks);
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  if (argc != 4) return give_up(0, "usage: mpi_pieces PLAN RANGES FOLDER");
  const int status = make_pieces(argv[1], argv[2], argv[3]);
  MPI_Finalize();
  return status;
}
