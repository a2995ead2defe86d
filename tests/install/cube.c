/* A cube from its lower and upper side, in C. */
#include <stdio.h>
#include <tetloft/tetloft.h>

int main(void) {
  const double z[] = {0, 10};
  const size_t contours[] = {1, 1}, vertices[] = {4, 4};
  const double xy[] = {0, 0, 10, 0, 10, 10, 0, 10, 0, 0, 10, 0, 10, 10, 0, 10};
  tetloft_stack* stack = NULL;
  tetloft_model* cube = NULL;
  double volume = 0;
  int status = tetloft_stack_create(z, contours, 2, vertices, 2, xy, 8, &stack);
  if (status == TETLOFT_OK) status = tetloft_reconstruct(stack, NULL, &cube, NULL);
  if (status == TETLOFT_OK) status = tetloft_model_volume(cube, &volume);
  if (status == TETLOFT_OK) {
    printf("tetloft %s: volume %g\n", tetloft_version(), volume);
  } else {
    fprintf(stderr, "%s\n", tetloft_last_error());
  }
  tetloft_model_free(cube);
  tetloft_stack_free(stack);
  return status;
}
