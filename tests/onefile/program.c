/* What a C program does that takes the library in as one object: models of stacks, by tetloft.h
 * alone.
 *
 *   program FOLDER STACK...      writes FOLDER/NAME.vtu for each STACK, .../NAME.cnt */
#include <stdio.h>
#include <string.h>

#include "tetloft.h"

static int report(tetloft_status status) {
  fprintf(stderr, "%s\n", tetloft_last_error());
  return (int)status;
}

static int reconstruct_file(const char* folder, const char* path) {
  tetloft_stack* stack = NULL;
  tetloft_model* model = NULL;
  char output[4096];
  const char* slash = strrchr(path, '/');
  const char* name = slash != NULL ? slash + 1 : path;
  const int length = (int)strcspn(name, ".");
  tetloft_status status = tetloft_stack_read(path, NULL, &stack, NULL);
  if (status == TETLOFT_OK) status = tetloft_reconstruct(stack, NULL, &model, NULL);
  if (status == TETLOFT_OK) {
    snprintf(output, sizeof output, "%s/%.*s.vtu", folder, length, name);
    status = tetloft_model_write(model, output, NULL, NULL);
  }
  tetloft_model_free(model);
  tetloft_stack_free(stack);
  return status == TETLOFT_OK ? 0 : report(status);
}

int main(int argc, char** argv) {
  int i;
  if (argc < 3) return 2;
  for (i = 2; i < argc; ++i) {
    const int status = reconstruct_file(argv[1], argv[i]);
    if (status != 0) return status;
  }
  return 0;
}
