// The README's example says what it claims.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <tetloft/tet_mesh.hpp>

namespace {

std::string example(){
#include "mesh_readme_example.inc"
}

TEST(MeshReadme, ExampleRunsAsPrinted) {
  EXPECT_EQ(example(), "vertex 0 holds 3 tets in separate sheets; then none");
}

}  // namespace
