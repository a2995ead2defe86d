// Whole reconstructions as what is timed and counted, and what peers have to do at least.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/sections.hpp>

#include "engines.hpp"

namespace tetloft::bench {

/// What is put between sections: `by_need` is the default of all who call, and `nothing` what can
/// be compared with peers, who triangulate the slabs between the given sections.
enum class Between { nothing, by_need };

/// Reads the stack, reconstructs, writes the model as .vtu to a temporary folder, removes it.
Run reconstruct_file(const std::string& path, Between between, unsigned threads);

/// In memory.
Run reconstruct_stack(const SectionStack& stack, Between between, unsigned threads);

/// The vertices of a section, behind those that are there.
void append_vertices(const Section& section, std::vector<Point3>& points);

/// The vertices of every slab: what a reconstruction has to triangulate at least.
std::vector<std::vector<Point3>> slabs_of(const SectionStack& stack);

/// A stack in a file of its own, in the folder for temporary files, as long as this lives.
class StackFile {
 public:
  explicit StackFile(const SectionStack& stack);
  ~StackFile();
  StackFile(const StackFile&) = delete;
  StackFile& operator=(const StackFile&) = delete;
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace tetloft::bench
