/* A stack of sections made into a solid, checked, walked and written:
 *
 *   example IN.cnt OUT.vtu */
#include <stdio.h>
#include <stdlib.h>

#include <tetloft/tetloft.h>

/* Ends the program where a call failed: the status is its exit code. */
static void require(tetloft_status status) {
  if (status == TETLOFT_OK) return;
  fprintf(stderr, "%s: %s\n", tetloft_status_name(status), tetloft_last_error());
  exit(status);
}

/* A progress bar; to return 1 would end the reconstruction with TETLOFT_CANCELLED. */
static int show_progress(void* user, size_t done, size_t all) {
  fprintf((FILE*)user, "\r%zu of %zu", done, all);
  return 0;
}

int main(int argc, char** argv) {
  tetloft_stack* stack = NULL;
  tetloft_model* model = NULL;
  tetloft_verdict* verdict = NULL;
  tetloft_mesh* mesh = NULL;
  tetloft_surface* surface = NULL;
  tetloft_execution execution;
  tetloft_reconstruct_options options;
  const double* xyz; /* three coordinates of each point */
  const uint32_t* tets; /* four points of each tet */
  const uint32_t* component; /* of each boundary triangle */
  uint32_t star[1000];
  size_t points, tet_count, star_size, triangles, components;
  int64_t genus;
  double volume;
  int pass;

  if (argc != 3) {
    fprintf(stderr, "usage: %s IN.cnt OUT.vtu\n", argv[0]);
    return TETLOFT_USAGE;
  }
  require(tetloft_stack_read(argv[1], NULL, &stack, NULL));

  require(tetloft_execution_defaults(&execution));
  execution.progress = show_progress;
  execution.user = stderr;
  require(tetloft_reconstruct_options_defaults(&options));
  options.execution = &execution;
  options.ends = TETLOFT_ENDS_HALF;
  require(tetloft_reconstruct(stack, &options, &model, NULL));

  require(tetloft_check(model, stack, NULL, &verdict));
  require(tetloft_verdict_pass(verdict, &pass));

  /* Arrays of the model, without copies: valid until it is freed. */
  require(tetloft_model_points(model, &xyz, &points));
  require(tetloft_model_tets(model, &tets, &tet_count));
  require(tetloft_model_volume(model, &volume));
  printf("\n%zu points, %zu tets, volume %g, guarantees %s\n", points, tet_count, volume,
         pass ? "kept" : "broken");

  /* Which tets meet in the first vertex of the first tet? */
  require(tetloft_model_mesh(model, &mesh));
  require(tetloft_mesh_star(mesh, tets[0], star, 1000, &star_size));
  printf("%zu tets at (%g, %g, %g)\n", star_size, xyz[3 * tets[0]], xyz[3 * tets[0] + 1],
         xyz[3 * tets[0] + 2]);

  require(tetloft_model_boundary(model, &surface));
  require(tetloft_surface_components(surface, &component, &triangles, &components));
  require(tetloft_surface_topology(surface, 0, NULL, NULL, NULL, &genus));
  printf("%zu boundary triangles, %zu surfaces, the first of genus %d\n", triangles, components,
         (int)genus);

  require(tetloft_model_write(model, argv[2], NULL, NULL));

  tetloft_surface_free(surface);
  tetloft_mesh_free(mesh);
  tetloft_verdict_free(verdict);
  tetloft_model_free(model);
  tetloft_stack_free(stack);
  return 0;
}
