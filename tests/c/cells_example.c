/* The neighbours of each point in a periodic box, by the faces of their Voronoi cells. */
#include <stdio.h>
#include <stdlib.h>

#include <tetloft/tetloft.h>

static void require(tetloft_status status) {
  if (status == TETLOFT_OK) return;
  fprintf(stderr, "%s: %s\n", tetloft_status_name(status), tetloft_last_error());
  exit(status);
}

int main(void) {
  const double points[] = {0, 0, 0, 0.5, 0.5, 0.5};      /* body centred */
  const double box[] = {1, 0, 0, 0, 1, 0, 0.25, 0, 1.5}; /* a, b and c, which is oblique */
  tetloft_cells* cells = NULL;
  const size_t* face_begin; /* one more than cells */
  const double *volumes, *areas;
  const uint64_t* neighbours;
  const int32_t* shifts; /* three of each face */
  size_t cell_count, face_count, count, i, f;
  double sum = 0;

  require(tetloft_periodic_voronoi(points, 2, box, NULL, &cells));
  /* Arrays of the handle, without copies: valid until it is freed. */
  require(tetloft_cells_volumes(cells, &volumes, &cell_count));
  require(tetloft_cells_face_begin(cells, &face_begin, &count));
  require(tetloft_cells_areas(cells, &areas, &face_count));
  require(tetloft_cells_neighbours(cells, &neighbours, &face_count));
  require(tetloft_cells_shifts(cells, &shifts, &face_count));
  for (i = 0; i < cell_count; ++i) {
    printf("point %zu: volume %g\n", i, volumes[i]);
    sum += volumes[i];
    for (f = face_begin[i]; f < face_begin[i + 1]; ++f) {
      if (areas[f] < 0.1) continue;
      printf("  point %d, %+d a %+d b %+d c away: area %.4f\n", (int)neighbours[f],
             (int)shifts[3 * f], (int)shifts[3 * f + 1], (int)shifts[3 * f + 2], areas[f]);
    }
  }
  printf("in all %g\n", sum);
  tetloft_cells_free(cells);
  return 0;
}
