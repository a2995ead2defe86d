/* tetloft for C, and for every language that calls C: solids from planar cross sections.
 *
 * Status. A function that can fail returns a tetloft_status, TETLOFT_OK (0) on success; what went
 * wrong, and where, is then told by tetloft_last_error() and tetloft_last_place(), for each thread
 * its own, until its next call that fails; texts of more than 4,095 bytes are cut there. On failure
 * outputs are set to NULL or 0, if they can be.
 * No exception leaves a function, and none is thrown across it; memory that ends is a status.
 *
 * Handles. What a function makes is reached through a handle, which belongs to the caller and is
 * given back by the _free function of its type (NULL: nothing is done). A handle is a name, not an
 * address: it must not be dereferenced. NULL, a handle that was freed, one of another type or a
 * made-up one is answered by TETLOFT_BAD_HANDLE.
 *
 * Arrays. Arrays that the library owns (const …**) are valid until their handle is freed; their
 * sizes are told beside them, in elements as said there. An empty one may be NULL. Arrays of the
 * caller come with the number of elements that they hold; an input array may be NULL if that is 0.
 * An output that does not fit is answered by TETLOFT_TOO_SMALL, the number needed is told all the
 * same, and nothing is written; capacity 0 and NULL ask for the number alone.
 *
 * Structs of options and results begin with their version: set it by the …_defaults() function (of
 * options), or to the …_VERSION of this header (of results). A version that the library does not
 * know is TETLOFT_USAGE. Where options are taken, NULL means defaults. They, and all arrays and
 * texts of the caller, are read while the call lasts, and not kept.
 *
 * Texts are UTF-8 as far as their sources are, end with a zero byte, and are the library's: valid
 * as long as the handle that they come from. Ids are zero-based; TETLOFT_NO_ID means none.
 *
 * Threads. Every function may be called from any thread at any time: what a handle names never
 * changes once it is made (but for tetloft_stop, which is made to be shared, and tetloft_delaunay
 * and tetloft_delaunay_plane, whose changes wait for the calls that use them, and these for those),
 * and a handle may be freed while other calls still work with it: they end as if it were there.
 * Arrays and texts of a freed handle are gone. Results do not depend on threads.
 *
 * Lengths are in the units of the input. The contracts of the functions are those of the C++
 * headers named beside them. */
#ifndef TETLOFT_TETLOFT_H
#define TETLOFT_TETLOFT_H

#include <stddef.h>
#include <stdint.h>

#if defined(TETLOFT_SHARED) && defined(_WIN32)
#if defined(TETLOFT_BUILDING)
#define TETLOFT_C_API __declspec(dllexport)
#else
#define TETLOFT_C_API __declspec(dllimport)
#endif
#elif defined(TETLOFT_SHARED)
#define TETLOFT_C_API __attribute__((visibility("default")))
#else
#define TETLOFT_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* --- status --------------------------------------------------------------------------------- */

/* Those from 2 to 7 and from 70 on are the exit codes of the command line. */
typedef enum tetloft_status {
  TETLOFT_OK = 0,
  TETLOFT_USAGE = 2,           /* arguments that are missing, contradict each other, or are none */
  TETLOFT_INVALID_INPUT = 3,   /* the input is not a valid stack, mesh, label or point set */
  TETLOFT_IO = 4,              /* a file cannot be read or written */
  TETLOFT_UNREPRESENTABLE = 5, /* double precision holds no valid model of this input */
  TETLOFT_CANCELLED = 6,       /* stopped at the caller's wish */
  TETLOFT_WORK_LIMIT = 7,      /* more work than the limit allows; a higher one may succeed */
  TETLOFT_BAD_HANDLE = 8,      /* NULL, freed, of another type, or no handle at all */
  TETLOFT_TOO_SMALL = 9,       /* the caller's array does not hold the result */
  TETLOFT_INTERNAL = 70,       /* a defect of the library */
  TETLOFT_OUT_OF_MEMORY = 71,
  TETLOFT_UNFIT_ARITHMETIC = 72 /* compiled or run without the arithmetic that exactness needs */
} tetloft_status;

#define TETLOFT_NO_ID UINT32_C(0xFFFFFFFF)

/* "0.1.0", of the library that runs. */
TETLOFT_C_API const char* tetloft_version(void);

/* "invalid_input"; "unknown" for a number that is no status. */
TETLOFT_C_API const char* tetloft_status_name(int status);

/* Of this thread's last failure: place and message in one line, as the command line prints it;
 * empty if there was none. Valid until this thread's next failure. */
TETLOFT_C_API const char* tetloft_last_error(void);
/* The message without the place. */
TETLOFT_C_API const char* tetloft_last_message(void);

/* Where something is wrong; what is not known is −1, NULL or 0. */
#define TETLOFT_PLACE_VERSION 1
typedef struct tetloft_place {
  uint32_t version;
  const char* file; /* valid until this thread's next failure */
  int64_t line;     /* one-based */
  int64_t section;  /* zero-based, like all below */
  int64_t slab;     /* between sections `slab` and `slab + 1` */
  int64_t contour;
  int64_t vertex;
  int32_t has_point;
  double point[3]; /* if has_point */
} tetloft_place;
/* Of this thread's last failure: tetloft_place place = {TETLOFT_PLACE_VERSION}. Another version is
 * TETLOFT_USAGE, the failure asked about stays the last. */
TETLOFT_C_API tetloft_status tetloft_last_place(tetloft_place* place);

/* Warnings that a function gave: something that was mended, or that one should know. Where a
 * function takes `warnings`, NULL means that they are not wanted; otherwise the caller gets a
 * handle, of no warnings perhaps. */
typedef struct tetloft_warnings tetloft_warnings;
TETLOFT_C_API tetloft_status tetloft_warnings_count(const tetloft_warnings* warnings,
                                                    size_t* count);
/* Place and message in one line. */
TETLOFT_C_API tetloft_status tetloft_warnings_text(const tetloft_warnings* warnings, size_t index,
                                                   const char** text);
TETLOFT_C_API tetloft_status tetloft_warnings_free(tetloft_warnings* warnings);

/* --- how a function runs (tetloft/execution.hpp) -------------------------------------------- */

/* A stop button: pressed from any thread, it ends the calls that it was given to with
 * TETLOFT_CANCELLED; it stays pressed. */
typedef struct tetloft_stop tetloft_stop;
TETLOFT_C_API tetloft_status tetloft_stop_create(tetloft_stop** stop);
TETLOFT_C_API tetloft_status tetloft_stop_request(tetloft_stop* stop);
TETLOFT_C_API tetloft_status tetloft_stop_free(tetloft_stop* stop);

/* Steps done and in all; called from any thread, one call at a time. Not 0: the call ends with
 * TETLOFT_CANCELLED. */
typedef int (*tetloft_progress)(void* user, size_t done, size_t all);

#define TETLOFT_EXECUTION_VERSION 1
typedef struct tetloft_execution {
  uint32_t version;
  uint32_t threads;          /* 0: as many as the machine offers */
  tetloft_stop* stop;        /* NULL: none */
  tetloft_progress progress; /* NULL: none */
  void* user;                /* handed to progress */
} tetloft_execution;
TETLOFT_C_API tetloft_status tetloft_execution_defaults(tetloft_execution* execution);

/* --- bytes ---------------------------------------------------------------------------------- */

typedef struct tetloft_bytes tetloft_bytes;
TETLOFT_C_API tetloft_status tetloft_bytes_data(const tetloft_bytes* bytes, const void** data,
                                                size_t* size);
TETLOFT_C_API tetloft_status tetloft_bytes_free(tetloft_bytes* bytes);

/* --- formats (tetloft/formats.hpp) ---------------------------------------------------------- */

/* Bits of tetloft_format: what a file can hold. */
enum {
  TETLOFT_CONTENTS_STACK = 1,
  TETLOFT_CONTENTS_MODEL = 2,
  TETLOFT_CONTENTS_SURFACE = 4,
  TETLOFT_CONTENTS_POINTS = 8,
  TETLOFT_CONTENTS_LABELS = 16,
  TETLOFT_CONTENTS_LINES = 32
};

#define TETLOFT_FORMAT_VERSION 1
typedef struct tetloft_format {
  uint32_t version;
  const char* name; /* for read and write options; texts are valid for ever */
  const char* summary;
  const char* extension; /* the usual one, with the dot */
  uint32_t reads;        /* TETLOFT_CONTENTS_… */
  uint32_t writes;
} tetloft_format;
TETLOFT_C_API size_t tetloft_format_count(void);
TETLOFT_C_API tetloft_status tetloft_format_info(size_t index, tetloft_format* format);

#define TETLOFT_READ_OPTIONS_VERSION 1
typedef struct tetloft_read_options {
  uint32_t version;
  int32_t unchecked;  /* not 0: stacks are not validated */
  const char* format; /* by name; NULL: it is recognised */
} tetloft_read_options;
TETLOFT_C_API tetloft_status tetloft_read_options_defaults(tetloft_read_options* options);

#define TETLOFT_WRITE_OPTIONS_VERSION 1
typedef struct tetloft_write_options {
  uint32_t version;
  int32_t ascii;      /* 1: text, 2: compressed binary, where the format has them; 0: binary */
  const char* format; /* by name; NULL: as the extension says; required for bytes */
} tetloft_write_options;
TETLOFT_C_API tetloft_status tetloft_write_options_defaults(tetloft_write_options* options);

/* --- stacks of sections (tetloft/sections.hpp, tetloft/formats.hpp) -------------------------- */

/* Sections by increasing z, of closed contours, the first vertex not repeated at the end. */
typedef struct tetloft_stack tetloft_stack;

/* Copies: z and contour_counts have section_count elements, vertex_counts contour_count, xy
 * 2 · vertex_count coordinates x y x y …; contours follow each other section by section, vertices
 * contour by contour. TETLOFT_USAGE where the counts do not add up. The geometry is not validated
 * here; functions that need a valid stack do. */
TETLOFT_C_API tetloft_status tetloft_stack_create(const double* z, const size_t* contour_counts,
                                                  size_t section_count, const size_t* vertex_counts,
                                                  size_t contour_count, const double* xy,
                                                  size_t vertex_count, tetloft_stack** stack);
TETLOFT_C_API tetloft_status tetloft_stack_read(const char* path,
                                                const tetloft_read_options* options,
                                                tetloft_stack** stack, tetloft_warnings** warnings);
/* From bytes; `name` stands for the file in messages and tells the extension. */
TETLOFT_C_API tetloft_status tetloft_stack_parse(const void* data, size_t size, const char* name,
                                                 const tetloft_read_options* options,
                                                 tetloft_stack** stack,
                                                 tetloft_warnings** warnings);

/* What of a file becomes the stack, and how (ReadOptions of tetloft/formats.hpp). */
#define TETLOFT_STACK_OPTIONS_VERSION 1
typedef struct tetloft_stack_options {
  uint32_t version;
  int32_t unchecked;      /* not 0: not validated */
  const char* format;     /* by name; NULL: it is recognised */
  const char* structure;  /* the ROI, object or label by name or number; NULL: the only one */
  const char* property;   /* of GeoJSON the height; NULL: it is found */
  int32_t has_iso;        /* not 0: of a volume the region of values of at least */
  double iso;             /* this */
  int32_t lattice;        /* not 0: contours of volumes along the faces of voxels */
  int32_t axis;           /* of volumes, across which: 1, 2 or 3; 0: the last */
  double plane_tolerance; /* contours so near in height are one section; 0: the default */
  int32_t close_on_frame; /* not 0: open lines are closed along the rectangle around all */
  const tetloft_execution* execution; /* NULL: defaults */
} tetloft_stack_options;
TETLOFT_C_API tetloft_status tetloft_stack_options_defaults(tetloft_stack_options* options);
/* Decisions on contours: see tetloft_labels_create(). */
typedef struct tetloft_labels tetloft_labels;
/* tetloft_stack_read() and _parse() with all options; the labels that the file gives its contours,
 * none in most formats, go to `labels` unless it is NULL. */
TETLOFT_C_API tetloft_status tetloft_stack_read_by(const char* path,
                                                   const tetloft_stack_options* options,
                                                   tetloft_stack** stack, tetloft_labels** labels,
                                                   tetloft_warnings** warnings);
TETLOFT_C_API tetloft_status tetloft_stack_parse_by(const void* data, size_t size, const char* name,
                                                    const tetloft_stack_options* options,
                                                    tetloft_stack** stack, tetloft_labels** labels,
                                                    tetloft_warnings** warnings);
TETLOFT_C_API tetloft_status tetloft_stack_write(const tetloft_stack* stack, const char* path,
                                                 const tetloft_write_options* options,
                                                 tetloft_warnings** warnings);
TETLOFT_C_API tetloft_status tetloft_stack_format(const tetloft_stack* stack,
                                                  const tetloft_write_options* options,
                                                  tetloft_bytes** bytes,
                                                  tetloft_warnings** warnings);
TETLOFT_C_API tetloft_status tetloft_stack_free(tetloft_stack* stack);
/* What the stack's file says of it, each "" where it does not: the structure's name, the unit of
 * length ("mm"), and where x, y and z grow towards in a body ("LPS", "RAS"). UTF-8; the texts live
 * as long as the handle. */
TETLOFT_C_API tetloft_status tetloft_stack_description(const tetloft_stack* stack,
                                                       const char** name, const char** unit,
                                                       const char** orientation);

/* Any of the outputs may be NULL. */
TETLOFT_C_API tetloft_status tetloft_stack_counts(const tetloft_stack* stack, size_t* sections,
                                                  size_t* contours, size_t* vertices);
TETLOFT_C_API tetloft_status tetloft_stack_section(const tetloft_stack* stack, size_t section,
                                                   double* z, size_t* contours);
/* 2 · vertices coordinates. */
TETLOFT_C_API tetloft_status tetloft_stack_contour(const tetloft_stack* stack, size_t section,
                                                   size_t contour, const double** xy,
                                                   size_t* vertices);
/* Twice the signed area, positive if counter-clockwise. */
TETLOFT_C_API tetloft_status tetloft_stack_twice_area(const tetloft_stack* stack, size_t section,
                                                      size_t contour, double* twice_area);
/* Of a valid section: for each contour the innermost one around it, how many are around it (odd: a
 * hole), and the region that it bounds. Each array is NULL, or has room for `capacity`. */
TETLOFT_C_API tetloft_status tetloft_stack_nesting(const tetloft_stack* stack, size_t section,
                                                   uint32_t* parent, uint32_t* depth,
                                                   uint32_t* region, size_t capacity,
                                                   size_t* contours, size_t* regions);
TETLOFT_C_API tetloft_status tetloft_stack_validate(const tetloft_stack* stack,
                                                    const tetloft_execution* execution);
/* A valid stack instead of one that is none; `distance`: how far the boundary may move, below 0 the
 * default; the warnings are all changes (tetloft/repair.hpp, as the two below). */
TETLOFT_C_API tetloft_status tetloft_stack_repair(const tetloft_stack* stack, double distance,
                                                  const tetloft_execution* execution,
                                                  tetloft_stack** repaired,
                                                  tetloft_warnings** changes);

/* Which points make up the region where contours overlap. */
typedef enum tetloft_fill {
  TETLOFT_FILL_ODD = 0,    /* those of odd crossing number */
  TETLOFT_FILL_UNION = 1,  /* traces that overlap in part are united, others are holes by nesting */
  TETLOFT_FILL_WINDING = 2 /* those that the contours wind around */
} tetloft_fill;

#define TETLOFT_REPAIR_OPTIONS_VERSION 1
typedef struct tetloft_repair_options {
  uint32_t version;
  int32_t fill;                       /* tetloft_fill */
  double distance;                    /* how far the boundary may move; below 0: the default */
  double keyholes;                    /* closes channels of holes up to so wide; 0: none */
  const tetloft_execution* execution; /* NULL: defaults */
} tetloft_repair_options;
TETLOFT_C_API tetloft_status tetloft_repair_options_defaults(tetloft_repair_options* options);

#define TETLOFT_REPAIR_REPORT_VERSION 1
typedef struct tetloft_repair_report {
  uint32_t version;
  double moved;       /* how far the boundary moved at most */
  double area_before; /* by the fill rule, of all sections */
  double area_after;
  uint64_t copies;   /* contours left out, for they repeat another */
  uint64_t channels; /* closed */
  uint64_t lost;     /* contours of which nothing is left */
  double area_lost;  /* that these bounded */
} tetloft_repair_report;

/* tetloft_stack_repair() with all options, and what it did. */
TETLOFT_C_API tetloft_status tetloft_stack_repair_by(const tetloft_stack* stack,
                                                     const tetloft_repair_options* options,
                                                     tetloft_stack** repaired,
                                                     tetloft_repair_report* report,
                                                     tetloft_warnings** changes);

typedef enum tetloft_plane_rule {
  TETLOFT_PLANES_SORT = 0, /* by z, those of one z made one */
  TETLOFT_PLANES_FLIP = 1, /* a stack that descends is turned over */
  TETLOFT_PLANES_MERGE = 2 /* sort, and those at most `tolerance` apart made one */
} tetloft_plane_rule;
/* Sections in the order of their planes; the tolerance is of merge alone. The warnings tell which
 * sections were made one. */
TETLOFT_C_API tetloft_status tetloft_stack_arrange_planes(const tetloft_stack* stack, int32_t rule,
                                                          double tolerance,
                                                          tetloft_stack** arranged,
                                                          tetloft_warnings** changes);
TETLOFT_C_API tetloft_status tetloft_stack_snap(const tetloft_stack* stack, int bits,
                                                const tetloft_execution* execution,
                                                tetloft_stack** snapped);
TETLOFT_C_API tetloft_status tetloft_stack_refine(const tetloft_stack* stack, double length,
                                                  const tetloft_execution* execution,
                                                  tetloft_stack** refined);

/* --- correspondence (tetloft/correspondence.hpp, tetloft/voids.hpp) ------------------------- */

/* A user's label on one contour, and decision on one link. */
typedef struct tetloft_label {
  uint32_t section;
  uint32_t contour;
  uint32_t label;
} tetloft_label;
typedef struct tetloft_decision {
  uint32_t slab;
  uint32_t lower; /* contour of the section below; of voids TETLOFT_NO_ID: the exterior */
  uint32_t upper;
  int32_t join; /* 0: part, or of voids close */
} tetloft_decision;

TETLOFT_C_API tetloft_status tetloft_labels_create(
    const tetloft_label* labels, size_t label_count, const tetloft_decision* decisions,
    size_t decision_count, const tetloft_label* hole_labels, size_t hole_label_count,
    const tetloft_decision* void_decisions, size_t void_decision_count, tetloft_labels** out);
TETLOFT_C_API tetloft_status tetloft_labels_read(const char* path, tetloft_labels** labels);
TETLOFT_C_API tetloft_status tetloft_labels_parse(const void* data, size_t size, const char* name,
                                                  tetloft_labels** labels);
TETLOFT_C_API tetloft_status tetloft_labels_write(const tetloft_labels* labels, const char* path);
/* The bytes of such a file. */
TETLOFT_C_API tetloft_status tetloft_labels_format(const tetloft_labels* labels,
                                                   tetloft_bytes** bytes);
TETLOFT_C_API tetloft_status tetloft_labels_free(tetloft_labels* labels);

typedef enum tetloft_criterion {
  TETLOFT_OVERLAP = 0,
  TETLOFT_REVERSE = 1, /* Definition 2 of Nonato et al. (2000) */
  TETLOFT_MOVED = 2
} tetloft_criterion;
typedef enum tetloft_void_rule {
  TETLOFT_VOIDS_OVERLAP = 0,
  TETLOFT_VOIDS_NEAR = 1,
  TETLOFT_VOIDS_FREE = 2
} tetloft_void_rule;

#define TETLOFT_CORRESPONDENCE_VERSION 1
typedef struct tetloft_correspondence {
  uint32_t version;
  int32_t criterion; /* tetloft_criterion */
  double tau;        /* threshold in [0, 1); below 0: the criterion's default */
  int32_t chain;
  int32_t lone;
  int32_t void_rule;            /* tetloft_void_rule */
  double void_reach;            /* of TETLOFT_VOIDS_NEAR, in gaps */
  const tetloft_labels* labels; /* NULL: none */
} tetloft_correspondence;
TETLOFT_C_API tetloft_status tetloft_correspondence_defaults(tetloft_correspondence* options);

/* A link between two regions, or two voids, of neighbouring sections: made, or nearly so. */
typedef struct tetloft_link {
  uint32_t slab;
  uint32_t lower; /* outer contour; of voids the hole, TETLOFT_NO_ID: the exterior */
  uint32_t upper;
  int32_t evidence; /* see tetloft_evidence_name() */
  int32_t fate;     /* 0: made; see tetloft_fate_name() */
  double ratio;
  double moved;
  double distance; /* in gaps */
  double margin;
  double lead; /* NaN: no other pair came into question */
} tetloft_link;
/* "overlap", "made", …; "unknown" for a number that is none. */
TETLOFT_C_API const char* tetloft_evidence_name(int evidence);
TETLOFT_C_API const char* tetloft_fate_name(int fate);

/* What belongs together, without making the solid (tetloft/links.hpp). */
typedef struct tetloft_links tetloft_links;
TETLOFT_C_API tetloft_status tetloft_links_find(const tetloft_stack* stack,
                                                const tetloft_correspondence* options,
                                                const tetloft_execution* execution,
                                                tetloft_links** links, tetloft_warnings** warnings);
TETLOFT_C_API tetloft_status tetloft_links_regions(const tetloft_links* links,
                                                   const tetloft_link** array, size_t* count);
TETLOFT_C_API tetloft_status tetloft_links_voids(const tetloft_links* links,
                                                 const tetloft_link** array, size_t* count);
TETLOFT_C_API tetloft_status tetloft_links_counts(const tetloft_links* links, size_t* components,
                                                  size_t* cavities);
/* The component of each contour of a section. */
TETLOFT_C_API tetloft_status tetloft_links_partition(const tetloft_links* links, size_t section,
                                                     const uint32_t** component, size_t* contours);
TETLOFT_C_API tetloft_status tetloft_links_free(tetloft_links* links);

/* --- reconstruction (tetloft/reconstruct.hpp, tetloft/between.hpp) --------------------------- */

typedef struct tetloft_model tetloft_model;

typedef enum tetloft_ends { TETLOFT_ENDS_FLAT = 0, TETLOFT_ENDS_HALF = 1 } tetloft_ends;
typedef enum tetloft_engine {
  TETLOFT_ENGINE_AUTOMATIC = 0,
  TETLOFT_ENGINE_INCREMENTAL = 1,
  TETLOFT_ENGINE_SLAB = 2
} tetloft_engine;

#define TETLOFT_RECONSTRUCT_OPTIONS_VERSION 1
typedef struct tetloft_reconstruct_options {
  uint32_t version;
  const tetloft_correspondence* correspondence; /* NULL: defaults */
  int32_t ends;                                 /* tetloft_ends */
  int32_t engine;                               /* tetloft_engine; the result is the same */
  int64_t between;       /* sections put between two given ones; −1: as many as are called for */
  int32_t divide_coarse; /* not 0: long edges of contours of few vertices are divided */
  double thickness;      /* of a single section; 0: a tenth of its larger side */
  double work_limit;     /* tets per vertex */
  const tetloft_execution* execution; /* NULL: defaults */
} tetloft_reconstruct_options;
TETLOFT_C_API tetloft_status
tetloft_reconstruct_options_defaults(tetloft_reconstruct_options* options);

TETLOFT_C_API tetloft_status tetloft_reconstruct(const tetloft_stack* stack,
                                                 const tetloft_reconstruct_options* options,
                                                 tetloft_model** model,
                                                 tetloft_warnings** warnings);

/* The stack with sections put between (tetloft/between.hpp), and, unless `decisions` is NULL, the
 * decisions on all links of the longer one. Of the options ends, engine and thickness are not
 * looked at. */
TETLOFT_C_API tetloft_status tetloft_between(const tetloft_stack* stack,
                                             const tetloft_reconstruct_options* options,
                                             tetloft_stack** longer, tetloft_labels** decisions,
                                             tetloft_warnings** warnings);

/* What a reconstruction tells of itself (tetloft/report.hpp). */
#define TETLOFT_REPORT_VERSION 1
typedef struct tetloft_report {
  uint32_t version;
  uint64_t slices;
  uint64_t sections_between;
  uint64_t sections_given_up;
  uint64_t contours;
  uint64_t input_vertices;
  uint64_t split_vertices;
  uint64_t dividing_vertices;
  uint64_t vertices;
  uint64_t tets;
  uint64_t components;
  double volume;
  double smallest_lift;
  uint64_t work;
  double seconds; /* wall clock */
} tetloft_report;
/* TETLOFT_USAGE for a model that was read or created. */
TETLOFT_C_API tetloft_status tetloft_model_report(const tetloft_model* model,
                                                  tetloft_report* report);

/* --- models (tetloft/model.hpp) ------------------------------------------------------------- */

/* Copies: 3 · point_count coordinates, 4 · tet_count point ids. So that any mesh can be checked
 * and written. */
TETLOFT_C_API tetloft_status tetloft_model_create(const double* xyz, size_t point_count,
                                                  const uint32_t* tets, size_t tet_count,
                                                  tetloft_model** model);
TETLOFT_C_API tetloft_status tetloft_model_read(const char* path,
                                                const tetloft_read_options* options,
                                                tetloft_model** model, tetloft_warnings** warnings);
TETLOFT_C_API tetloft_status tetloft_model_parse(const void* data, size_t size, const char* name,
                                                 const tetloft_read_options* options,
                                                 tetloft_model** model,
                                                 tetloft_warnings** warnings);
TETLOFT_C_API tetloft_status tetloft_model_write(const tetloft_model* model, const char* path,
                                                 const tetloft_write_options* options,
                                                 tetloft_warnings** warnings);
TETLOFT_C_API tetloft_status tetloft_model_format(const tetloft_model* model,
                                                  const tetloft_write_options* options,
                                                  tetloft_bytes** bytes,
                                                  tetloft_warnings** warnings);
/* The boundary alone. */
TETLOFT_C_API tetloft_status tetloft_model_write_surface(const tetloft_model* model,
                                                         const char* path,
                                                         const tetloft_write_options* options,
                                                         tetloft_warnings** warnings);
TETLOFT_C_API tetloft_status tetloft_model_format_surface(const tetloft_model* model,
                                                          const tetloft_write_options* options,
                                                          tetloft_bytes** bytes,
                                                          tetloft_warnings** warnings);
TETLOFT_C_API tetloft_status tetloft_model_free(tetloft_model* model);

/* Arrays: of points three coordinates each, of tets four point ids each, positive; then one value
 * for each tet, or point; empty where the model has none. */
TETLOFT_C_API tetloft_status tetloft_model_points(const tetloft_model* model, const double** xyz,
                                                  size_t* points);
TETLOFT_C_API tetloft_status tetloft_model_tets(const tetloft_model* model, const uint32_t** tets,
                                                size_t* count);
TETLOFT_C_API tetloft_status tetloft_model_tet_components(const tetloft_model* model,
                                                          const uint32_t** component,
                                                          size_t* count);
TETLOFT_C_API tetloft_status tetloft_model_tet_slabs(const tetloft_model* model,
                                                     const uint32_t** slab, size_t* count);
/* See tetloft_tet_kind_name(). */
TETLOFT_C_API tetloft_status tetloft_model_tet_kinds(const tetloft_model* model,
                                                     const uint8_t** kind, size_t* count);
/* TETLOFT_NO_ID between sections; off the contours. */
TETLOFT_C_API tetloft_status tetloft_model_point_sections(const tetloft_model* model,
                                                          const uint32_t** section, size_t* count);
TETLOFT_C_API tetloft_status tetloft_model_point_contours(const tetloft_model* model,
                                                          const uint32_t** contour, size_t* count);
/* See tetloft_point_origin_name(). */
TETLOFT_C_API tetloft_status tetloft_model_point_origins(const tetloft_model* model,
                                                         const uint8_t** origin, size_t* count);
TETLOFT_C_API const char* tetloft_tet_kind_name(int kind);
TETLOFT_C_API const char* tetloft_point_origin_name(int origin);

/* As the tets' components say; 0 without them. */
TETLOFT_C_API tetloft_status tetloft_model_component_count(const tetloft_model* model,
                                                           size_t* components);
TETLOFT_C_API tetloft_status tetloft_model_volume(const tetloft_model* model, double* volume);
/* What it is of, as tetloft_stack_description() says. */
TETLOFT_C_API tetloft_status tetloft_model_description(const tetloft_model* model,
                                                       const char** name, const char** unit,
                                                       const char** orientation);
/* What files call a component: UTF-8, without a 0 behind it. */
TETLOFT_C_API tetloft_status tetloft_model_component_name(const tetloft_model* model,
                                                          size_t component, tetloft_bytes** name);
/* One component as a model of its own; links and deviations, which speak of all, stay behind. */
TETLOFT_C_API tetloft_status tetloft_model_component(const tetloft_model* model, size_t component,
                                                     tetloft_model** part);

/* The boundary: triangles over the model's points, normals outwards. Of a model that was read or
 * created TETLOFT_INVALID_INPUT where its tets are no mesh, as tetloft_model_mesh() says it. */
typedef struct tetloft_surface tetloft_surface;
TETLOFT_C_API tetloft_status tetloft_model_boundary(const tetloft_model* model,
                                                    tetloft_surface** surface);
/* Three point ids each. */
TETLOFT_C_API tetloft_status tetloft_surface_triangles(const tetloft_surface* surface,
                                                       const uint32_t** triangles, size_t* count);
/* The tet behind each triangle. */
TETLOFT_C_API tetloft_status tetloft_surface_tets(const tetloft_surface* surface,
                                                  const uint32_t** tets, size_t* count);
/* The component (of the surface) of each triangle. */
TETLOFT_C_API tetloft_status tetloft_surface_components(const tetloft_surface* surface,
                                                        const uint32_t** component, size_t* count,
                                                        size_t* components);
/* Of one component; any output may be NULL. */
TETLOFT_C_API tetloft_status tetloft_surface_topology(const tetloft_surface* surface,
                                                      size_t component, size_t* vertices,
                                                      size_t* edges, size_t* triangles,
                                                      int64_t* genus);
TETLOFT_C_API tetloft_status tetloft_surface_free(tetloft_surface* surface);

/* Pictures, and the viewer's page, by the extension of `path` (.png, .svg, .html);
 * tetloft/render.hpp. */
typedef enum tetloft_colour {
  TETLOFT_COLOUR_COMPONENT = 0,
  TETLOFT_COLOUR_SLAB = 1,
  TETLOFT_COLOUR_KIND = 2,
  TETLOFT_COLOUR_DIHEDRAL = 3,
  TETLOFT_COLOUR_EVIDENCE = 4
} tetloft_colour;

#define TETLOFT_RENDER_OPTIONS_VERSION 1
typedef struct tetloft_render_options {
  uint32_t version;
  int32_t colour; /* tetloft_colour */
  double azimuth; /* degrees */
  double elevation;
  int32_t width; /* pixels */
  int32_t height;
  int32_t cut_axis; /* 0 x, 1 y, 2 z; −1: no cut */
  double cut_position;
  double explode;    /* slabs are moved apart by so many mean heights */
  double stretch;    /* z is drawn so many times as large */
  int32_t edges;     /* not 0: edges of tets are drawn */
  int32_t contours;  /* not 0: contours of `stack` are drawn */
  int32_t white;     /* not 0: white background instead of none */
  const char* title; /* of the page; NULL: none */
  const tetloft_execution* execution;
} tetloft_render_options;
TETLOFT_C_API tetloft_status tetloft_render_options_defaults(tetloft_render_options* options);
/* `stack` may be NULL: no contours are drawn. */
TETLOFT_C_API tetloft_status tetloft_model_render(const tetloft_model* model,
                                                  const tetloft_stack* stack, const char* path,
                                                  const tetloft_render_options* options);

/* --- check (tetloft/check.hpp) -------------------------------------------------------------- */

#define TETLOFT_CHECK_OPTIONS_VERSION 1
typedef struct tetloft_check_options {
  uint32_t version;
  const tetloft_correspondence* correspondence; /* NULL: defaults */
  double split_ulps;
  uint64_t places; /* how many to report for each failure */
  int32_t recompute_motions;
  int32_t strict;
  const tetloft_execution* execution; /* NULL: defaults */
} tetloft_check_options;
TETLOFT_C_API tetloft_status tetloft_check_options_defaults(tetloft_check_options* options);

/* A guarantee that fails is no failure of the call: see tetloft_verdict_pass(). */
typedef struct tetloft_verdict tetloft_verdict;
TETLOFT_C_API tetloft_status tetloft_check(const tetloft_model* model, const tetloft_stack* stack,
                                           const tetloft_check_options* options,
                                           tetloft_verdict** verdict);
TETLOFT_C_API tetloft_status tetloft_verdict_pass(const tetloft_verdict* verdict, int* pass);
/* Guarantee 1 to 5; any output may be NULL. not_asked: why it was not asked, empty if it was. */
TETLOFT_C_API tetloft_status tetloft_verdict_guarantee(const tetloft_verdict* verdict, int number,
                                                       const char** name, int* pass,
                                                       const char** not_asked, size_t* failures);
/* A condition that fails, how often, and the number of places told. */
TETLOFT_C_API tetloft_status tetloft_verdict_failure(const tetloft_verdict* verdict, int number,
                                                     size_t failure, const char** what,
                                                     size_t* count, size_t* places);
TETLOFT_C_API tetloft_status tetloft_verdict_place(const tetloft_verdict* verdict, int number,
                                                   size_t failure, size_t place, const char** text);
#define TETLOFT_FIGURES_VERSION 1
typedef struct tetloft_figures {
  uint32_t version;
  uint64_t components;
  double volume;
  double overshoot; /* in gaps */
  double smallest_dihedral_degrees;
  double largest_split_ulps;
  uint64_t inner_vertices;
  uint64_t dropped_links;
  int64_t cavities; /* −1: not known, as in the three below */
  int64_t expected_cavities;
  int64_t least_genus; /* INT64_MIN: not known, as below */
  int64_t most_genus;
  uint64_t deviations;
  uint64_t forced_voids;
  uint64_t unrealisable_voids;
} tetloft_figures;
TETLOFT_C_API tetloft_status tetloft_verdict_figures(const tetloft_verdict* verdict,
                                                     tetloft_figures* figures);
/* The genus of each boundary surface. */
TETLOFT_C_API tetloft_status tetloft_verdict_genus(const tetloft_verdict* verdict,
                                                   const int64_t** genus, size_t* count);
TETLOFT_C_API tetloft_status tetloft_verdict_free(tetloft_verdict* verdict);

/* --- tetrahedral meshes: star and link (tetloft/tet_mesh.hpp) -------------------------------- */

typedef struct tetloft_mesh tetloft_mesh;

typedef enum tetloft_link_kind {
  TETLOFT_LINK_DISC = 0,
  TETLOFT_LINK_SPHERE = 1,
  TETLOFT_LINK_EMPTY = 2,
  TETLOFT_LINK_COMPONENTS = 3, /* singular, as all below: falls into several components */
  TETLOFT_LINK_PINCH = 4,      /* connected, but pinched */
  TETLOFT_LINK_HOLES = 5       /* a connected surface, neither disc nor sphere */
} tetloft_link_kind;

/* Of 4 · tet_count vertex ids. TETLOFT_INVALID_INPUT for ids that are none, a face of more than two
 * tets, or of two on its same side. */
TETLOFT_C_API tetloft_status tetloft_mesh_create(size_t vertex_count, const uint32_t* tets,
                                                 size_t tet_count, tetloft_mesh** mesh);
TETLOFT_C_API tetloft_status tetloft_model_mesh(const tetloft_model* model, tetloft_mesh** mesh);
TETLOFT_C_API tetloft_status tetloft_mesh_counts(const tetloft_mesh* mesh, size_t* vertices,
                                                 size_t* tets);
/* Four vertex ids each. */
TETLOFT_C_API tetloft_status tetloft_mesh_tets(const tetloft_mesh* mesh, const uint32_t** tets,
                                               size_t* count);
/* By half-face (4 · tet + face, the face opposite that vertex of the tet) the half-face on the
 * other side, TETLOFT_NO_ID on the boundary; count: 4 · tets. */
TETLOFT_C_API tetloft_status tetloft_mesh_opposites(const tetloft_mesh* mesh,
                                                    const uint32_t** opposite, size_t* count);
/* The tets of a vertex, and of an edge, by id. */
TETLOFT_C_API tetloft_status tetloft_mesh_star(const tetloft_mesh* mesh, uint32_t vertex,
                                               uint32_t* tets, size_t capacity, size_t* count);
TETLOFT_C_API tetloft_status tetloft_mesh_edge_star(const tetloft_mesh* mesh, uint32_t a,
                                                    uint32_t b, uint32_t* tets, size_t capacity,
                                                    size_t* count);
/* The triangles opposite a vertex in its star, three ids each, and the edges opposite an edge, two
 * each; capacity and count in triangles, and edges. */
TETLOFT_C_API tetloft_status tetloft_mesh_link(const tetloft_mesh* mesh, uint32_t vertex,
                                               uint32_t* triangles, size_t capacity, size_t* count);
TETLOFT_C_API tetloft_status tetloft_mesh_edge_link(const tetloft_mesh* mesh, uint32_t a,
                                                    uint32_t b, uint32_t* edges, size_t capacity,
                                                    size_t* count);
TETLOFT_C_API tetloft_status tetloft_mesh_link_kind(const tetloft_mesh* mesh, uint32_t vertex,
                                                    tetloft_link_kind* kind);
TETLOFT_C_API tetloft_status tetloft_mesh_edge_link_kind(const tetloft_mesh* mesh, uint32_t a,
                                                         uint32_t b, tetloft_link_kind* kind);
/* The vertices whose link is neither disc nor sphere nor empty. */
TETLOFT_C_API tetloft_status tetloft_mesh_singular_vertices(const tetloft_mesh* mesh,
                                                            uint32_t* vertices, size_t capacity,
                                                            size_t* count);
/* The half-faces without opposite. */
TETLOFT_C_API tetloft_status tetloft_mesh_boundary(const tetloft_mesh* mesh, uint32_t* half_faces,
                                                   size_t capacity, size_t* count);
TETLOFT_C_API tetloft_status tetloft_mesh_free(tetloft_mesh* mesh);

/* --- Delaunay triangulations (tetloft/delaunay.hpp) ------------------------------------------ */

#define TETLOFT_DELAUNAY3_OPTIONS_VERSION 1
typedef struct tetloft_delaunay3_options {
  uint32_t version;
  int32_t engine;     /* tetloft_engine */
  uint64_t most_tets; /* 0: no limit */
  const tetloft_execution* execution;
} tetloft_delaunay3_options;
TETLOFT_C_API tetloft_status tetloft_delaunay3_options_defaults(tetloft_delaunay3_options* options);
/* Of 3 · point_count coordinates; the mesh's vertices are the points by index. `dimension` (of the
 * affine hull; −1 without points) and `representative` may be NULL; the latter has room for
 * point_count: the lowest index with the same point. */
TETLOFT_C_API tetloft_status tetloft_delaunay3(const double* xyz, size_t point_count,
                                               const tetloft_delaunay3_options* options,
                                               tetloft_mesh** mesh, int* dimension,
                                               uint32_t* representative);

/* A triangulation of the plane. */
typedef struct tetloft_triangulation tetloft_triangulation;
/* Of 2 · point_count coordinates. */
TETLOFT_C_API tetloft_status tetloft_delaunay2(const double* xy, size_t point_count,
                                               const tetloft_execution* execution,
                                               tetloft_triangulation** triangulation);
/* With segments, two point ids each, that are unions of edges. */
TETLOFT_C_API tetloft_status tetloft_conforming_delaunay2(const double* xy, size_t point_count,
                                                          const uint32_t* segments,
                                                          size_t segment_count,
                                                          const tetloft_execution* execution,
                                                          tetloft_triangulation** triangulation);
/* Of a section of a stack, its contours being unions of edges (tetloft/conforming_section.hpp). */
TETLOFT_C_API tetloft_status tetloft_stack_triangulate(const tetloft_stack* stack, size_t section,
                                                       const tetloft_execution* execution,
                                                       tetloft_triangulation** triangulation);
/* Two coordinates each. */
TETLOFT_C_API tetloft_status tetloft_triangulation_points(
    const tetloft_triangulation* triangulation, const double** xy, size_t* count);
/* Three point ids each, counter-clockwise. */
TETLOFT_C_API tetloft_status tetloft_triangulation_triangles(
    const tetloft_triangulation* triangulation, const uint32_t** triangles, size_t* count);
/* Three triangles each, opposite vertex 0, 1, 2; TETLOFT_NO_ID on the hull. */
TETLOFT_C_API tetloft_status tetloft_triangulation_neighbours(
    const tetloft_triangulation* triangulation, const uint32_t** neighbours, size_t* count);
/* Of a section: for each triangle, whether it lies in the region; else empty. */
TETLOFT_C_API tetloft_status tetloft_triangulation_internal(
    const tetloft_triangulation* triangulation, const uint8_t** internal, size_t* count);
/* Of a conforming triangulation: the points of a segment from its first to its second end. */
TETLOFT_C_API tetloft_status tetloft_triangulation_chain(const tetloft_triangulation* triangulation,
                                                         size_t segment, const uint32_t** points,
                                                         size_t* count);
TETLOFT_C_API tetloft_status tetloft_triangulation_free(tetloft_triangulation* triangulation);

/* --- Delaunay triangulations that change (tetloft/delaunay_triangulation3.hpp) ---------------- */

/* Of points in space: they come, go and move, and it is that of those that are there. The progress
 * of a call, also of one that only asks, must not use the triangulation that the call works with:
 * it would wait for it for ever. */
typedef struct tetloft_delaunay tetloft_delaunay;

/* A vertex is index + 2^32 · generation: a place, and how many vertices had it before. It is good
 * until it is removed; where one that is gone is handed in, TETLOFT_INVALID_INPUT is the answer. Of
 * a triangulation that was made of points vertex i is point i; of equal points the first has the
 * vertex. */
#define TETLOFT_NO_VERTEX UINT64_C(0xFFFFFFFF)

/* Of 3 · point_count coordinates, as all arrays xyz below. */
TETLOFT_C_API tetloft_status tetloft_delaunay_create(const double* xyz, size_t point_count,
                                                     const tetloft_execution* execution,
                                                     tetloft_delaunay** delaunay);
TETLOFT_C_API tetloft_status tetloft_delaunay_copy(const tetloft_delaunay* delaunay,
                                                   tetloft_delaunay** copy);
TETLOFT_C_API tetloft_status tetloft_delaunay_free(tetloft_delaunay* delaunay);

/* Changes. A call that fails leaves all as it was. */

/* One point. `near`: a vertex where the search starts, or TETLOFT_NO_VERTEX. `is_new` may be NULL;
 * 0: the point had a vertex. */
TETLOFT_C_API tetloft_status tetloft_delaunay_insert(tetloft_delaunay* delaunay, double x, double y,
                                                     double z, uint64_t near, uint64_t* vertex,
                                                     int* is_new);
/* Many, in an order that is fast. `vertices` has room for point_count: that of each point; or is
 * NULL. */
TETLOFT_C_API tetloft_status tetloft_delaunay_insert_all(tetloft_delaunay* delaunay,
                                                         const double* xyz, size_t point_count,
                                                         const tetloft_execution* execution,
                                                         uint64_t* vertices);
TETLOFT_C_API tetloft_status tetloft_delaunay_remove(tetloft_delaunay* delaunay, uint64_t vertex);
/* The vertex stays the same. TETLOFT_INVALID_INPUT where another one is. */
TETLOFT_C_API tetloft_status tetloft_delaunay_move(tetloft_delaunay* delaunay, uint64_t vertex,
                                                   double x, double y, double z);
TETLOFT_C_API tetloft_status tetloft_delaunay_clear(tetloft_delaunay* delaunay);

/* What is there. */

/* Any output may be NULL. All indices are below `slots`; the dimension is that of the affine hull,
 * −1 without points. */
TETLOFT_C_API tetloft_status tetloft_delaunay_counts(const tetloft_delaunay* delaunay,
                                                     size_t* vertices, size_t* slots, size_t* tets,
                                                     int* dimension);
TETLOFT_C_API tetloft_status tetloft_delaunay_is_live(const tetloft_delaunay* delaunay,
                                                      uint64_t vertex, int* is_live);
/* By index; and their points, three coordinates each, capacity and count in points. */
TETLOFT_C_API tetloft_status tetloft_delaunay_vertices(const tetloft_delaunay* delaunay,
                                                       uint64_t* vertices, size_t capacity,
                                                       size_t* count);
TETLOFT_C_API tetloft_status tetloft_delaunay_points(const tetloft_delaunay* delaunay, double* xyz,
                                                     size_t capacity, size_t* count);
/* Three coordinates. */
TETLOFT_C_API tetloft_status tetloft_delaunay_point(const tetloft_delaunay* delaunay,
                                                    uint64_t vertex, double* xyz);
/* Four vertices each; capacity and count in tets. */
TETLOFT_C_API tetloft_status tetloft_delaunay_tets(const tetloft_delaunay* delaunay, uint64_t* tets,
                                                   size_t capacity, size_t* count);
/* The tets of a vertex, the same, and the vertices that it has edges with, by index. */
TETLOFT_C_API tetloft_status tetloft_delaunay_star(const tetloft_delaunay* delaunay,
                                                   uint64_t vertex, uint64_t* tets, size_t capacity,
                                                   size_t* count);
TETLOFT_C_API tetloft_status tetloft_delaunay_neighbours(const tetloft_delaunay* delaunay,
                                                         uint64_t vertex, uint64_t* neighbours,
                                                         size_t capacity, size_t* count);

/* Questions. */

typedef enum tetloft_location {
  TETLOFT_LOCATION_VERTEX = 0,
  TETLOFT_LOCATION_EDGE = 1,
  TETLOFT_LOCATION_FACET = 2,
  TETLOFT_LOCATION_TET = 3,
  TETLOFT_LOCATION_OUTSIDE = 4
} tetloft_location;
/* The smallest simplex that holds each point: `kinds` has room for point_count (tetloft_location),
 * `vertices` for 4 · point_count: its vertices by index, then TETLOFT_NO_VERTEX; either may be
 * NULL. */
TETLOFT_C_API tetloft_status tetloft_delaunay_locate(const tetloft_delaunay* delaunay,
                                                     const double* xyz, size_t point_count,
                                                     const tetloft_execution* execution,
                                                     int32_t* kinds, uint64_t* vertices);
/* The vertex nearest to each point, by exact comparison, the one of lowest index of equally near
 * ones; TETLOFT_NO_VERTEX where there are none. `vertices` has room for point_count. */
TETLOFT_C_API tetloft_status tetloft_delaunay_nearest(const tetloft_delaunay* delaunay,
                                                      const double* xyz, size_t point_count,
                                                      const tetloft_execution* execution,
                                                      uint64_t* vertices);
/* The `most` nearest to one point, or all there are, and all at most `radius` away: by distance,
 * then by index. */
TETLOFT_C_API tetloft_status tetloft_delaunay_nearest_few(const tetloft_delaunay* delaunay,
                                                          double x, double y, double z, size_t most,
                                                          uint64_t* vertices, size_t capacity,
                                                          size_t* count);
TETLOFT_C_API tetloft_status tetloft_delaunay_within(const tetloft_delaunay* delaunay, double x,
                                                     double y, double z, double radius,
                                                     uint64_t* vertices, size_t capacity,
                                                     size_t* count);

/* What the insertion of a point would change; empty where it is a vertex, or there are no tets. The
 * tets that would go, four vertices each; the faces that the point would be joined to, three
 * vertices each, counter-clockwise as seen from outside their tet: of one that goes, or, where the
 * point is outside, of one of the hull; the vertices that would be its neighbours. Each array with
 * its capacity and count; where one does not fit, none is written. */
TETLOFT_C_API tetloft_status tetloft_delaunay_conflict_zone(
    const tetloft_delaunay* delaunay, double x, double y, double z, uint64_t near, uint64_t* tets,
    size_t tet_capacity, size_t* tet_count, uint64_t* horizon, size_t horizon_capacity,
    size_t* horizon_count, uint64_t* neighbours, size_t neighbour_capacity,
    size_t* neighbour_count);

/* The same bytes on every machine; what is made of them has the same vertices.
 * TETLOFT_INVALID_INPUT for bytes that are damaged, or none of these. */
TETLOFT_C_API tetloft_status tetloft_delaunay_serialise(const tetloft_delaunay* delaunay,
                                                        tetloft_bytes** bytes);
TETLOFT_C_API tetloft_status tetloft_delaunay_deserialise(const void* data, size_t size,
                                                          tetloft_delaunay** delaunay);

/* --- the same in the plane (tetloft/delaunay_triangulation2.hpp) ------------------------------ */

/* Of points in the plane, with constraints: segments between vertices that are unions of edges.
 * With them it is the constrained Delaunay triangulation; no vertex is put on a constraint but
 * where two cross, and where that is asked for. What is not said here is as in space. */
typedef struct tetloft_delaunay_plane tetloft_delaunay_plane;

/* Of 2 · point_count coordinates, as all arrays xy below. */
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_create(const double* xy, size_t point_count,
                                                           const tetloft_execution* execution,
                                                           tetloft_delaunay_plane** delaunay);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_copy(const tetloft_delaunay_plane* delaunay,
                                                         tetloft_delaunay_plane** copy);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_free(tetloft_delaunay_plane* delaunay);

TETLOFT_C_API tetloft_status tetloft_delaunay_plane_insert(tetloft_delaunay_plane* delaunay,
                                                           double x, double y, uint64_t near,
                                                           uint64_t* vertex, int* is_new);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_insert_all(tetloft_delaunay_plane* delaunay,
                                                               const double* xy, size_t point_count,
                                                               const tetloft_execution* execution,
                                                               uint64_t* vertices);
/* TETLOFT_INVALID_INPUT, with the constraint's number in the text, for a vertex that one goes over;
 * so is moving it. */
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_remove(tetloft_delaunay_plane* delaunay,
                                                           uint64_t vertex);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_move(tetloft_delaunay_plane* delaunay,
                                                         uint64_t vertex, double x, double y);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_clear(tetloft_delaunay_plane* delaunay);

/* Constraints. They go over all vertices on them, those that come later too; where they overlap
 * they share edges. A constraint is a number that is not given again; of one that is gone, as of a
 * vertex, TETLOFT_INVALID_INPUT is the answer. */

/* What becomes of a constraint that crosses others. */
typedef enum tetloft_crossing {
  TETLOFT_CROSSING_REFUSE = 0, /* TETLOFT_INVALID_INPUT, with the other one's number in the text */
  TETLOFT_CROSSING_SPLIT = 1   /* a vertex is put where they cross, and all go over it */
} tetloft_crossing;
/* The segment from u to v. `crossing`: tetloft_crossing. The point of a crossing is rounded, which
 * bends what goes over it by ulps; where pieces cross on and on, TETLOFT_WORK_LIMIT. */
TETLOFT_C_API tetloft_status
tetloft_delaunay_plane_insert_constraint(tetloft_delaunay_plane* delaunay, uint64_t u, uint64_t v,
                                         int32_t crossing, uint32_t* constraint);
/* Many, one after the other, two vertices each: all or none; a text of what is refused begins with
 * its index. `constraints` has room for segment_count, or is NULL. */
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_insert_constraints(
    tetloft_delaunay_plane* delaunay, const uint64_t* segments, size_t segment_count,
    int32_t crossing, uint32_t* constraints);
/* Its vertices stay. */
TETLOFT_C_API tetloft_status
tetloft_delaunay_plane_remove_constraint(tetloft_delaunay_plane* delaunay, uint32_t constraint);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_has_constraint(
    const tetloft_delaunay_plane* delaunay, uint32_t constraint, int* has);
/* By number. */
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_constraints(
    const tetloft_delaunay_plane* delaunay, uint32_t* constraints, size_t capacity, size_t* count);
/* The two vertices that it was given. */
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_constraint_ends(
    const tetloft_delaunay_plane* delaunay, uint32_t constraint, uint64_t* ends);
/* The edges that it goes over, two vertices each, by index; capacity and count in edges. */
TETLOFT_C_API tetloft_status
tetloft_delaunay_plane_constraint_edges(const tetloft_delaunay_plane* delaunay, uint32_t constraint,
                                        uint64_t* edges, size_t capacity, size_t* count);
/* The constraints over the edge u v, by number; none where there is no such edge. */
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_edge_constraints(
    const tetloft_delaunay_plane* delaunay, uint64_t u, uint64_t v, uint32_t* constraints,
    size_t capacity, size_t* count);
/* The triangles that one comes to from outside across an odd number of constraints, as
 * tetloft_delaunay_plane_triangles has them: of an outline and its holes what is between.
 * TETLOFT_INVALID_INPUT, naming a vertex, where constraints end. */
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_inside(const tetloft_delaunay_plane* delaunay,
                                                           uint64_t* triangles, size_t capacity,
                                                           size_t* count);

/* What is there. */

TETLOFT_C_API tetloft_status tetloft_delaunay_plane_counts(const tetloft_delaunay_plane* delaunay,
                                                           size_t* vertices, size_t* slots,
                                                           size_t* triangles, size_t* constraints,
                                                           int* dimension);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_is_live(const tetloft_delaunay_plane* delaunay,
                                                            uint64_t vertex, int* is_live);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_vertices(const tetloft_delaunay_plane* delaunay,
                                                             uint64_t* vertices, size_t capacity,
                                                             size_t* count);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_points(const tetloft_delaunay_plane* delaunay,
                                                           double* xy, size_t capacity,
                                                           size_t* count);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_point(const tetloft_delaunay_plane* delaunay,
                                                          uint64_t vertex, double* xy);
/* Three vertices each, counter-clockwise; capacity and count in triangles. */
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_triangles(
    const tetloft_delaunay_plane* delaunay, uint64_t* triangles, size_t capacity, size_t* count);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_star(const tetloft_delaunay_plane* delaunay,
                                                         uint64_t vertex, uint64_t* triangles,
                                                         size_t capacity, size_t* count);
TETLOFT_C_API tetloft_status
tetloft_delaunay_plane_neighbours(const tetloft_delaunay_plane* delaunay, uint64_t vertex,
                                  uint64_t* neighbours, size_t capacity, size_t* count);
/* The vertices on the hull, counter-clockwise from that of lowest index; of points in a row all of
 * them, from one end to the other. */
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_hull(const tetloft_delaunay_plane* delaunay,
                                                         uint64_t* vertices, size_t capacity,
                                                         size_t* count);

/* Questions. A triangle is a facet; `vertices` of locate has room for 3 · point_count. */

TETLOFT_C_API tetloft_status tetloft_delaunay_plane_locate(const tetloft_delaunay_plane* delaunay,
                                                           const double* xy, size_t point_count,
                                                           const tetloft_execution* execution,
                                                           int32_t* kinds, uint64_t* vertices);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_nearest(const tetloft_delaunay_plane* delaunay,
                                                            const double* xy, size_t point_count,
                                                            const tetloft_execution* execution,
                                                            uint64_t* vertices);
TETLOFT_C_API tetloft_status
tetloft_delaunay_plane_nearest_few(const tetloft_delaunay_plane* delaunay, double x, double y,
                                   size_t most, uint64_t* vertices, size_t capacity, size_t* count);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_within(const tetloft_delaunay_plane* delaunay,
                                                           double x, double y, double radius,
                                                           uint64_t* vertices, size_t capacity,
                                                           size_t* count);

/* Of the triangles whose circles hold the point those from which it is seen, past no constraint but
 * one that it lies on. The horizon's edges, two vertices each, one behind the other,
 * counter-clockwise around the point, from the vertex of lowest index, or where the point lies
 * outside or on the hull from one end to the other. */
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_conflict_zone(
    const tetloft_delaunay_plane* delaunay, double x, double y, uint64_t near, uint64_t* triangles,
    size_t triangle_capacity, size_t* triangle_count, uint64_t* horizon, size_t horizon_capacity,
    size_t* horizon_count, uint64_t* neighbours, size_t neighbour_capacity,
    size_t* neighbour_count);

/* With the constraints. */
TETLOFT_C_API tetloft_status
tetloft_delaunay_plane_serialise(const tetloft_delaunay_plane* delaunay, tetloft_bytes** bytes);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_deserialise(const void* data, size_t size,
                                                                tetloft_delaunay_plane** delaunay);

/* --- Voronoi cells (tetloft/voronoi.hpp, tetloft/periodic.hpp) -------------------------------- */

/* One cell after the other, and so their corners and faces. An array …_begin tells where those of
 * each begin: it has one element more than what it divides, and what begins at begin[i] ends before
 * begin[i + 1]. */
typedef struct tetloft_cells tetloft_cells;

/* Of all vertices, by index. `box`: six coordinates, low x y z and high x y z, of what the cells
 * are clipped to; NULL: they are whole, and may be unbounded. */
TETLOFT_C_API tetloft_status tetloft_delaunay_cells(const tetloft_delaunay* delaunay,
                                                    const double* box,
                                                    const tetloft_execution* execution,
                                                    tetloft_cells** cells);
/* Of one vertex. */
TETLOFT_C_API tetloft_status tetloft_delaunay_cell(const tetloft_delaunay* delaunay,
                                                   uint64_t vertex, const double* box,
                                                   tetloft_cells** cells);
/* Of the points[i] + s0 a + s1 b + s2 c for all integers s: of 3 · point_count coordinates, and
 * nine, the vectors a, b and c. Corners are relative to the point; points may lie anywhere. */
TETLOFT_C_API tetloft_status tetloft_periodic_voronoi(const double* xyz, size_t point_count,
                                                      const double* box,
                                                      const tetloft_execution* execution,
                                                      tetloft_cells** cells);

/* Of cells. */

/* Whose they are: vertices; of periodic sets indices of points. */
TETLOFT_C_API tetloft_status tetloft_cells_sites(const tetloft_cells* cells, const uint64_t** sites,
                                                 size_t* count);
/* 0: it goes on without end, and its volume is infinite. */
TETLOFT_C_API tetloft_status tetloft_cells_bounded(const tetloft_cells* cells,
                                                   const uint8_t** bounded, size_t* count);
TETLOFT_C_API tetloft_status tetloft_cells_volumes(const tetloft_cells* cells,
                                                   const double** volumes, size_t* count);
TETLOFT_C_API tetloft_status tetloft_cells_corner_begin(const tetloft_cells* cells,
                                                        const size_t** begin, size_t* count);
/* Three coordinates each. */
TETLOFT_C_API tetloft_status tetloft_cells_corners(const tetloft_cells* cells, const double** xyz,
                                                   size_t* count);
TETLOFT_C_API tetloft_status tetloft_cells_face_begin(const tetloft_cells* cells,
                                                      const size_t** begin, size_t* count);

/* Of faces: of each cell one for each of its neighbours, by index, then those on the box. */

/* The sides of a box. */
typedef enum tetloft_side {
  TETLOFT_SIDE_NONE = 0,
  TETLOFT_SIDE_LOW_X = 1,
  TETLOFT_SIDE_HIGH_X = 2,
  TETLOFT_SIDE_LOW_Y = 3,
  TETLOFT_SIDE_HIGH_Y = 4,
  TETLOFT_SIDE_LOW_Z = 5,
  TETLOFT_SIDE_HIGH_Z = 6
} tetloft_side;
/* Whose cell is across, as sites are; TETLOFT_NO_VERTEX on the box. */
TETLOFT_C_API tetloft_status tetloft_cells_neighbours(const tetloft_cells* cells,
                                                      const uint64_t** neighbours, size_t* count);
/* Where it lies on the box (tetloft_side). */
TETLOFT_C_API tetloft_status tetloft_cells_sides(const tetloft_cells* cells, const uint8_t** sides,
                                                 size_t* count);
/* 0: it goes on without end, and its area is infinite. */
TETLOFT_C_API tetloft_status tetloft_cells_faces_bounded(const tetloft_cells* cells,
                                                         const uint8_t** bounded, size_t* count);
TETLOFT_C_API tetloft_status tetloft_cells_areas(const tetloft_cells* cells, const double** areas,
                                                 size_t* count);
TETLOFT_C_API tetloft_status tetloft_cells_face_corner_begin(const tetloft_cells* cells,
                                                             const size_t** begin, size_t* count);
/* Places in all corners, of each face counter-clockwise as seen from outside its cell; perhaps none
 * of a face without area. */
TETLOFT_C_API tetloft_status tetloft_cells_face_corners(const tetloft_cells* cells,
                                                        const uint32_t** corners, size_t* count);
/* Of periodic sets, else empty: three integers of each face, how many times a, b and c the
 * neighbour is away from where it was given; and three coordinates of its normal, of length 1,
 * towards the neighbour. */
TETLOFT_C_API tetloft_status tetloft_cells_shifts(const tetloft_cells* cells,
                                                  const int32_t** shifts, size_t* count);
TETLOFT_C_API tetloft_status tetloft_cells_normals(const tetloft_cells* cells,
                                                   const double** normals, size_t* count);
TETLOFT_C_API tetloft_status tetloft_cells_free(tetloft_cells* cells);

/* The volumes of all whole cells, by index of vertex: infinite where unbounded, 0 in places without
 * a vertex; so many as there are slots. Several times as fast as the cells. */
TETLOFT_C_API tetloft_status tetloft_delaunay_volumes(const tetloft_delaunay* delaunay,
                                                      const tetloft_execution* execution,
                                                      double* volumes, size_t capacity,
                                                      size_t* count);
/* The spheres through the vertices of the tets, as tetloft_delaunay_tets() has them, four numbers
 * each: centre and radius. */
TETLOFT_C_API tetloft_status tetloft_delaunay_circumspheres(const tetloft_delaunay* delaunay,
                                                            double* spheres, size_t capacity,
                                                            size_t* count);
/* That through four points, of twelve coordinates; in a plane they have none: the radius is
 * infinite. */
TETLOFT_C_API tetloft_status tetloft_circumsphere(const double* xyz, double* sphere);

/* --- natural neighbours (tetloft/voronoi.hpp) ------------------------------------------------- */

typedef enum tetloft_natural_weights {
  TETLOFT_SIBSON = 0, /* by what a new vertex's cell would take of theirs */
  TETLOFT_LAPLACE = 1 /* by area over distance of its faces, which takes less time */
} tetloft_natural_weights;

/* The vertices that would be neighbours of a new one at a point, by index, and their weights, of
 * sum 1: capacity and count are of both arrays. TETLOFT_INVALID_INPUT outside of the hull. `kind`:
 * tetloft_natural_weights; `near`: a vertex where the search starts, or TETLOFT_NO_VERTEX. */
TETLOFT_C_API tetloft_status tetloft_delaunay_natural_neighbours(
    const tetloft_delaunay* delaunay, double x, double y, double z, int32_t kind, uint64_t near,
    uint64_t* vertices, double* weights, size_t capacity, size_t* count);

/* Of many points, one after the other: none of those outside of the hull. */
typedef struct tetloft_natural_neighbours tetloft_natural_neighbours;
TETLOFT_C_API tetloft_status tetloft_delaunay_natural_neighbours_all(
    const tetloft_delaunay* delaunay, const double* xyz, size_t point_count, int32_t kind,
    const tetloft_execution* execution, tetloft_natural_neighbours** neighbours);
/* One more than points: those of point i are begin[i] to before begin[i + 1]. */
TETLOFT_C_API tetloft_status tetloft_natural_neighbours_begin(
    const tetloft_natural_neighbours* neighbours, const size_t** begin, size_t* count);
TETLOFT_C_API tetloft_status tetloft_natural_neighbours_vertices(
    const tetloft_natural_neighbours* neighbours, const uint64_t** vertices, size_t* count);
TETLOFT_C_API tetloft_status tetloft_natural_neighbours_weights(
    const tetloft_natural_neighbours* neighbours, const double** weights, size_t* count);
TETLOFT_C_API tetloft_status
tetloft_natural_neighbours_free(tetloft_natural_neighbours* neighbours);

/* --- Voronoi cells and natural neighbours in the plane (tetloft/voronoi2.hpp) ----------------- */

/* As in space; TETLOFT_INVALID_INPUT where there are constraints, whose triangulation is another
 * one than that of the cells. */
typedef struct tetloft_plane_cells tetloft_plane_cells;
/* `rectangle`: four coordinates, low x y and high x y, or NULL. */
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_cells(const tetloft_delaunay_plane* delaunay,
                                                          const double* rectangle,
                                                          const tetloft_execution* execution,
                                                          tetloft_plane_cells** cells);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_cell(const tetloft_delaunay_plane* delaunay,
                                                         uint64_t vertex, const double* rectangle,
                                                         tetloft_plane_cells** cells);
TETLOFT_C_API tetloft_status tetloft_plane_cells_sites(const tetloft_plane_cells* cells,
                                                       const uint64_t** sites, size_t* count);
/* Of the whole cell: 0 where it goes on without end, if only beyond the rectangle. */
TETLOFT_C_API tetloft_status tetloft_plane_cells_bounded(const tetloft_plane_cells* cells,
                                                         const uint8_t** bounded, size_t* count);
TETLOFT_C_API tetloft_status tetloft_plane_cells_areas(const tetloft_plane_cells* cells,
                                                       const double** areas, size_t* count);
TETLOFT_C_API tetloft_status tetloft_plane_cells_corner_begin(const tetloft_plane_cells* cells,
                                                              const size_t** begin, size_t* count);
/* Two coordinates each, of each cell counter-clockwise. */
TETLOFT_C_API tetloft_status tetloft_plane_cells_corners(const tetloft_plane_cells* cells,
                                                         const double** xy, size_t* count);
TETLOFT_C_API tetloft_status tetloft_plane_cells_edge_begin(const tetloft_plane_cells* cells,
                                                            const size_t** begin, size_t* count);
/* Of edges, as of faces. */
TETLOFT_C_API tetloft_status tetloft_plane_cells_neighbours(const tetloft_plane_cells* cells,
                                                            const uint64_t** neighbours,
                                                            size_t* count);
TETLOFT_C_API tetloft_status tetloft_plane_cells_sides(const tetloft_plane_cells* cells,
                                                       const uint8_t** sides, size_t* count);
/* Whether anything of it is in the rectangle. */
TETLOFT_C_API tetloft_status tetloft_plane_cells_inside(const tetloft_plane_cells* cells,
                                                        const uint8_t** inside, size_t* count);
/* Two places in all corners each, counter-clockwise around the cell; TETLOFT_NO_ID for an end that
 * is none, where the edge goes on without it, and of edges of which nothing is inside. */
TETLOFT_C_API tetloft_status tetloft_plane_cells_ends(const tetloft_plane_cells* cells,
                                                      const uint32_t** ends, size_t* count);
/* Infinite without end. */
TETLOFT_C_API tetloft_status tetloft_plane_cells_lengths(const tetloft_plane_cells* cells,
                                                         const double** lengths, size_t* count);
TETLOFT_C_API tetloft_status tetloft_plane_cells_free(tetloft_plane_cells* cells);

/* Of all whole cells, by index of vertex. */
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_areas(const tetloft_delaunay_plane* delaunay,
                                                          const tetloft_execution* execution,
                                                          double* areas, size_t capacity,
                                                          size_t* count);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_natural_neighbours(
    const tetloft_delaunay_plane* delaunay, double x, double y, int32_t kind, uint64_t near,
    uint64_t* vertices, double* weights, size_t capacity, size_t* count);
TETLOFT_C_API tetloft_status tetloft_delaunay_plane_natural_neighbours_all(
    const tetloft_delaunay_plane* delaunay, const double* xy, size_t point_count, int32_t kind,
    const tetloft_execution* execution, tetloft_natural_neighbours** neighbours);

/* --- Delaunay tets of periodic sets (tetloft/periodic.hpp) ------------------------------------ */

/* Each once of all its images, sorted. */
typedef struct tetloft_periodic_tets tetloft_periodic_tets;
/* Of a set as that of tetloft_periodic_voronoi(). */
TETLOFT_C_API tetloft_status tetloft_periodic_delaunay(const double* xyz, size_t point_count,
                                                       const double* box,
                                                       const tetloft_execution* execution,
                                                       tetloft_periodic_tets** tets);
/* Four indices of points each. */
TETLOFT_C_API tetloft_status tetloft_periodic_tets_points(const tetloft_periodic_tets* tets,
                                                          const uint32_t** points, size_t* count);
/* Four times three integers each: how many times a, b and c each of the points is away from where
 * it was given; 0 of the first. */
TETLOFT_C_API tetloft_status tetloft_periodic_tets_shifts(const tetloft_periodic_tets* tets,
                                                          const int32_t** shifts, size_t* count);
TETLOFT_C_API tetloft_status tetloft_periodic_tets_free(tetloft_periodic_tets* tets);

/* --- points from files (tetloft/formats.hpp) ------------------------------------------------- */

typedef struct tetloft_points tetloft_points;
TETLOFT_C_API tetloft_status tetloft_points_read(const char* path,
                                                 const tetloft_read_options* options,
                                                 tetloft_points** points,
                                                 tetloft_warnings** warnings);
TETLOFT_C_API tetloft_status tetloft_points_parse(const void* data, size_t size, const char* name,
                                                  const tetloft_read_options* options,
                                                  tetloft_points** points,
                                                  tetloft_warnings** warnings);
/* Three coordinates each. */
TETLOFT_C_API tetloft_status tetloft_points_data(const tetloft_points* points, const double** xyz,
                                                 size_t* count);
TETLOFT_C_API tetloft_status tetloft_points_free(tetloft_points* points);
TETLOFT_C_API tetloft_status tetloft_points_write(const double* xyz, size_t point_count,
                                                  const char* path,
                                                  const tetloft_write_options* options,
                                                  tetloft_warnings** warnings);
TETLOFT_C_API tetloft_status tetloft_points_format(const double* xyz, size_t point_count,
                                                   const tetloft_write_options* options,
                                                   tetloft_bytes** bytes,
                                                   tetloft_warnings** warnings);

#ifdef __cplusplus
}
#endif

#endif /* TETLOFT_TETLOFT_H */
