/* Serves examples whose frame is a part of a body's surface: reads all nodal results of a contact and writes them as
   text that gnuplot draws, together with the meshes of the bodies. */
#ifndef CONTACT_OUTPUT_H
#define CONTACT_OUTPUT_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "body_mesh.h"
#include "rollcon.h"

enum { MOST_FRAME_NODES = 2000, MOST_FRAME_IDS = 8000 };

static rollcon_context* context;

/* Ends the program with the library's own words if a status is below zero. */
static int32_t must(int32_t status) {
  if (status >= 0) return status;
  fprintf(stderr, "%s: %s\n", rollcon_status_string(status), rollcon_last_error());
  exit(1);
}

static void must_solve(rollcon_contact* contact) {
  const int32_t status = must(rollcon_contact_solve(contact));
  if (status == ROLLCON_INACCURATE) fprintf(stderr, "%s\n", rollcon_last_caveat());
  if (status == ROLLCON_OK || status == ROLLCON_INACCURATE) return;
  fprintf(stderr, "no good solution: %s\n", rollcon_status_string(status));
  exit(1);
}

static double statistic(const rollcon_contact* contact, const char* name) {
  double value = 0;
  must(rollcon_contact_get_stat(contact, name, &value));
  return value;
}

static double body_statistic(const rollcon_body* body, const char* name) {
  double value = 0;
  must(rollcon_body_get_stat(body, name, &value));
  return value;
}

/* ----------------------------------------------------------------------------------- Results */

typedef struct {
  int nodes, elements, per_element;
  int32_t id[MOST_FRAME_IDS];       /* node ids of the elements, one after the other */
  double x[MOST_FRAME_NODES][3];    /* positions along t1, t2, n from the origin */
  double t[MOST_FRAME_NODES][3];    /* traction on body 1 */
  double slip[MOST_FRAME_NODES][2]; /* slip of body 1 relative to body 2 */
  double gap[MOST_FRAME_NODES], area[MOST_FRAME_NODES], weight[MOST_FRAME_NODES];
  int32_t state[MOST_FRAME_NODES];
} frame_results;

/* Makes the frame that rollcon_contact_frame_from_body makes of a tag: the nodes of these faces in the order of their
   ids. */
static void frame_of_tag(frame_results* r, const body_mesh* m, int tag) {
  const int32_t* from = m->id + m->first[tag] * m->per_element;
  int32_t* list = (int32_t*)malloc((size_t)m->nodes * sizeof *list);
  int32_t* place = (int32_t*)malloc((size_t)m->nodes * sizeof *place);
  int k;
  r->elements = m->first[tag + 1] - m->first[tag];
  r->per_element = m->per_element;
  if (list == NULL || place == NULL || r->elements * r->per_element > MOST_FRAME_IDS) {
    fprintf(stderr, "no room for the frame\n");
    exit(1);
  }
  r->nodes = nodes_of_tag(m, tag, list);
  for (k = 0; k < r->nodes; ++k) place[list[k]] = k;
  for (k = 0; k < r->elements * r->per_element; ++k) r->id[k] = place[from[k]];
  free(list);
  free(place);
}

static void read_results(frame_results* r, const rollcon_contact* contact) {
  const int64_t most = MOST_FRAME_NODES;
  must(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, most, &r->t[0][0]));
  must(rollcon_contact_get_field(contact, ROLLCON_FIELD_POINT, ROLLCON_LOCAL, 3 * most, &r->x[0][0], NULL));
  must(rollcon_contact_get_field(contact, ROLLCON_FIELD_SLIP, ROLLCON_LOCAL, 2 * most, &r->slip[0][0], NULL));
  must(rollcon_contact_get_field(contact, ROLLCON_FIELD_GAP, ROLLCON_LOCAL, most, r->gap, NULL));
  must(rollcon_contact_get_field(contact, ROLLCON_FIELD_AREA, ROLLCON_LOCAL, most, r->area, NULL));
  must(rollcon_contact_get_field(contact, ROLLCON_FIELD_WEIGHT, ROLLCON_LOCAL, most, r->weight, NULL));
  must(rollcon_contact_get_node_states(contact, most, r->state));
}

/* ------------------------------------------------------------------------------------- Files */

static FILE* open_file(const char* folder, const char* name) {
  char path[1000];
  FILE* file;
  snprintf(path, sizeof path, "%s/%s", folder, name);
  file = fopen(path, "w");
  if (file == NULL) {
    perror(path);
    exit(1);
  }
  return file;
}

static void write_row(FILE* file, const frame_results* r, int k) {
  fprintf(file, "%.6f %.6f %.5e %.5e %.5e %.5e %.5e %.5e %d\n", r->x[k][0], r->x[k][1], -r->t[k][2], r->t[k][0],
          r->t[k][1], r->slip[k][0], r->slip[k][1], r->gap[k], (int)r->state[k]);
}

/* Writes the point where the edge from a to b crosses the line y = 0. */
static void write_crossing(FILE* file, const frame_results* r, int a, int b) {
  const double ya = r->x[a][1], yb = r->x[b][1], s = ya / (ya - yb);
  int c;
  if ((ya < 0) == (yb < 0)) return;
  fprintf(file, "%.6f 0", r->x[a][0] + s * (r->x[b][0] - r->x[a][0]));
  fprintf(file, " %.5e", -(r->t[a][2] + s * (r->t[b][2] - r->t[a][2])));
  for (c = 0; c < 2; ++c) fprintf(file, " %.5e", r->t[a][c] + s * (r->t[b][c] - r->t[a][c]));
  for (c = 0; c < 2; ++c) fprintf(file, " %.5e", r->slip[a][c] + s * (r->slip[b][c] - r->slip[a][c]));
  fprintf(file, " %.5e\n", r->gap[a] + s * (r->gap[b] - r->gap[a]));
}

/* Writes the columns x y p t1 t2 s1 s2 gap, and the node's status in the first two files.
     STEM_nodes.txt    all nodes of the frame
     STEM_patches.txt  quadrilaterals (quadratic ones: their corners) in the form of pm3d
     STEM_section.txt  the line y = 0 */
static void write_frame(const frame_results* r, const char* folder, const char* stem) {
  char name[200];
  FILE *nodes, *patches, *section;
  int e, i, k;
  snprintf(name, sizeof name, "%s_nodes.txt", stem);
  nodes = open_file(folder, name);
  snprintf(name, sizeof name, "%s_patches.txt", stem);
  patches = open_file(folder, name);
  snprintf(name, sizeof name, "%s_section.txt", stem);
  section = open_file(folder, name);
  fprintf(nodes, "# x y [mm] p t1 t2 [MPa] s1 s2 [mm/s] gap [mm] status (0 open, 1 stick, 2 slip)\n");
  for (k = 0; k < r->nodes; ++k) write_row(nodes, r, k);
  for (e = 0; e < r->elements; ++e) {
    const int32_t* id = r->id + e * r->per_element;
    for (i = 0; i < 4; ++i) write_crossing(section, r, id[i], id[(i + 1) % 4]);
    write_row(patches, r, id[0]);
    write_row(patches, r, id[1]);
    fprintf(patches, "\n");
    write_row(patches, r, id[3]);
    write_row(patches, r, id[2]);
    fprintf(patches, "\n\n");
  }
  fclose(nodes);
  fclose(patches);
  fclose(section);
}

/* Writes all faces of a body where its pose has put it, x y z and tag, in the form of pm3d. */
static void write_body(const body_mesh* m, const double rotation[9], const double translation[3], const char* folder,
                       const char* name) {
  static const int corner[4] = {0, 1, 3, 2};
  FILE* file = open_file(folder, name);
  int tag, e, i, c;
  fprintf(file, "# x y z [mm] tag\n");
  for (tag = 0; tag < MOST_TAGS; ++tag)
    for (e = m->first[tag]; e < m->first[tag + 1]; ++e) {
      for (i = 0; i < 4; ++i) {
        const double* x = m->x[m->id[e * m->per_element + corner[i]]];
        for (c = 0; c < 3; ++c)
          fprintf(file, "%.5f ",
                  translation[c] + rotation[3 * c] * x[0] + rotation[3 * c + 1] * x[1] + rotation[3 * c + 2] * x[2]);
        fprintf(file, i % 2 == 1 ? "%d\n\n" : "%d\n", tag);
      }
      fprintf(file, "\n");
    }
  fclose(file);
}

/* Hands a mesh over to a body, faces by tags, and holds the nodes of some tags. The inside of a
   solid has tag 0. */
static void give_mesh(rollcon_body* body, const body_mesh* m, int held_tags, const int* held) {
  int32_t* list = (int32_t*)malloc((size_t)m->nodes * sizeof *list);
  int tag, i;
  must(rollcon_body_set_nodes(body, m->nodes, &m->x[0][0], 3, 1));
  if (m->cells > 0) must(rollcon_body_add_elements(body, m->solid_type, m->cells, m->cell, 0, 0));
  for (tag = 1; tag < MOST_TAGS; ++tag) {
    const int count = m->first[tag + 1] - m->first[tag];
    if (count > 0)
      must(rollcon_body_add_elements(body, m->type, count, m->id + m->first[tag] * m->per_element, 0, tag));
  }
  for (i = 0; list != NULL && i < held_tags; ++i)
    must(rollcon_body_set_support(body, nodes_of_tag(m, held[i], list), list, 0, ROLLCON_DOF_XYZ, NULL));
  free(list);
}

#endif
