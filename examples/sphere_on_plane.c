/* An elastic sphere rolls on a rigid plane and transmits 75 % of the force at which it would slide:
   example 3 of Rodriguez-Tembleque and Abascal, Int. J. Solids Struct. 47 (2010) 330-353.

       sphere_on_plane [folder [tri3|tri6|quad4|quad8 [characteristic|least_squares|godunov]]]

   Compares with Hertz's closed form, then leaves in the folder (the present one unless given)
   sphere_on_plane.vtu for ParaView and three text files that plot_contact.gp draws.
   Units: mm, N, s; so MPa and mW. */
#include <stdio.h>
#include <stdlib.h>

#include "disc_frames.h"
#include "rollcon.h"

static const double radius = 50, young = 1e4, poisson = 0.3, mu = 0.1, load = 298.6;
static const double traction_force = 0.75 * 0.1 * 298.6, speed = 0.2 * 50;

static rollcon_context* context;
static rollcon_contact* contact;
static disc_frame frame;
static double t[MOST_NODES][3], slip[MOST_NODES][2], area[MOST_NODES];
static int32_t state[MOST_NODES];

/* Ends the program with the library's own words if a status is below zero. */
static int32_t must(int32_t status) {
  if (status >= 0) return status;
  fprintf(stderr, "%s: %s\n", rollcon_status_string(status), rollcon_last_error());
  exit(1);
}

static double statistic(const char* name) {
  double value = 0;
  must(rollcon_contact_get_stat(contact, name, &value));
  return value;
}

/* ------------------------------------------------------------------------------------- Table */

typedef struct {
  double pressure, radius, approach, creep, force[3], seconds;
} measures;

static measures solve(void) {
  const int32_t status = must(rollcon_contact_solve(contact));
  measures m;
  double creep[3];
  if (status != ROLLCON_OK) {
    fprintf(stderr, "no good solution: %s\n", rollcon_status_string(status));
    exit(1);
  }
  must(rollcon_contact_get_motion(contact, &m.approach, creep));
  must(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, m.force, NULL));
  m.pressure = statistic("max_pressure");
  m.radius = sqrt(statistic("contact_area") / acos(-1.0));
  m.creep = creep[0];
  m.seconds = statistic("seconds_total");
  return m;
}

static void compare(const char* name, const char* unit, double hertz, double smooth, double rolling) {
  printf("  %-22s%-6s %11.5g %11.5g %11.5g\n", name, unit, hertz, smooth, rolling);
}

static void print_table(const measures* smooth, const measures* free, const measures* driven) {
  const double pi = acos(-1.0), modulus = young / (1 - poisson * poisson);
  const double a = cbrt(3 * load * radius / (4 * modulus));
  double stick = 0, sliding = 0, fastest = 0;
  int k;
  for (k = 0; k < frame.nodes; ++k) {
    if (state[k] == ROLLCON_STICK) stick += area[k];
    if (state[k] != ROLLCON_SLIP) continue;
    sliding += area[k];
    fastest = fmax(fastest, hypot(slip[k][0], slip[k][1]));
  }
  printf("\n                                     Hertz     rollcon     rollcon\n");
  printf("                                    mu = 0      mu = 0    mu = 0.1\n");
  compare("largest pressure", "MPa", 3 * load / (2 * pi * a * a), smooth->pressure, driven->pressure);
  compare("radius from the area", "mm", a, smooth->radius, driven->radius);
  compare("approach", "mm", a * a / radius, smooth->approach, driven->approach);
  compare("normal force", "N", load, -smooth->force[2], -driven->force[2]);
  printf("\nrolling with mu = 0.1\n");
  printf("  force along t1         N     %11.5g   = %.4f mu Fn\n", driven->force[0], driven->force[0] / (mu * load));
  printf("  creepage                     %11.3e   free rolling %.3e, by the force %.3e\n", driven->creep, free->creep,
         driven->creep - free->creep);
  printf("  sticking               mm2   %11.5g   = %.0f %% of the contact\n", stick, 100 * stick / (stick + sliding));
  printf("  slipping               mm2   %11.5g   at up to %.4f mm/s\n", sliding, fastest);
  printf("  power of friction      mW    %11.5g\n", statistic("friction_power"));
  printf("\nlaws recomputed from the tractions (relative residuals)\n");
  printf("  no tension, no overlap  %8.1e     friction bound    %8.1e\n", statistic("law_normal"),
         statistic("law_friction"));
  printf("  slip against friction   %8.1e     forces as given   %8.1e\n", statistic("law_slip"),
         statistic("law_equilibrium"));
  printf("\n%.0f Newton iterations for the last solution; %.2f s for the three solutions\n", statistic("iterations"),
         smooth->seconds + free->seconds + driven->seconds);
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

static FILE *nodes, *patches, *section;

static void write_row(FILE* file, int k) {
  fprintf(file, "%.6f %.6f %.4e %.4e %.4e %.4e %.4e %d\n", frame.x[k][0], frame.x[k][1], -t[k][2], t[k][0], t[k][1],
          slip[k][0], slip[k][1], (int)state[k]);
}

/* Writes the point where the edge from a to b crosses the rolling axis. */
static void write_crossing(int a, int b) {
  const double ya = frame.x[a][1], yb = frame.x[b][1], s = ya / (ya - yb);
  int c;
  if ((ya < 0) == (yb < 0)) return;
  fprintf(section, "%.6f 0", frame.x[a][0] + s * (frame.x[b][0] - frame.x[a][0]));
  fprintf(section, " %.4e", -(t[a][2] + s * (t[b][2] - t[a][2])));
  for (c = 0; c < 2; ++c) fprintf(section, " %.4e", t[a][c] + s * (t[b][c] - t[a][c]));
  for (c = 0; c < 2; ++c) fprintf(section, " %.4e", slip[a][c] + s * (slip[b][c] - slip[a][c]));
  fprintf(section, "\n");
}

/* Writes a triangle (c = d) or quadrilateral in the form of gnuplot's pm3d. */
static void write_patch(int a, int b, int c, int d) {
  write_row(patches, a);
  write_row(patches, b);
  fprintf(patches, "\n");
  write_row(patches, d);
  write_row(patches, c);
  fprintf(patches, "\n\n");
  write_crossing(a, b);
  write_crossing(b, c);
  if (c != d) write_crossing(c, d);
  write_crossing(d, a);
}

/* Columns of all files: x y p t1 t2 s1 s2, and the node's status in the first two. Quadratic
   elements are cut into linear patches. */
static void write_text(const char* folder) {
  const int n = frame.corners;
  int e, i, k;
  nodes = open_file(folder, "nodes.txt");
  patches = open_file(folder, "patches.txt");
  section = open_file(folder, "section.txt");
  fprintf(nodes, "# x y [mm] p t1 t2 [MPa] s1 s2 [mm/s] status (0 open, 1 stick, 2 slip)\n");
  for (k = 0; k < frame.nodes; ++k) write_row(nodes, k);
  for (e = 0; e < frame.elements; ++e) {
    const int32_t* id = frame.id + e * frame.per_element;
    const int32_t* middle = frame.per_element > n ? id + n : id;
    if (middle != id)
      for (i = 0; i < n; ++i) {
        const int before = middle[(i + n - 1) % n];
        write_patch(id[i], middle[i], before, before);
      }
    write_patch(middle[0], middle[1], middle[2], middle[n - 1]);
  }
  fclose(nodes);
  fclose(patches);
  fclose(section);
}

int main(int argc, char** argv) {
  const char* folder = argc > 1 ? argv[1] : ".";
  const char* type = argc > 2 ? argv[2] : "tri3";
  const char* scheme = argc > 3 ? argv[3] : "characteristic";
  const double no_friction = 0;
  rollcon_body *sphere, *plane;
  measures smooth, free_rolling, driven;
  char path[1000];

  /* Step 1 makes the bodies. */
  must(rollcon_context_create(ROLLCON_ABI, &context));
  must(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, &sphere));
  must(rollcon_body_create(context, ROLLCON_BODY_RIGID, &plane));
  must(rollcon_contact_create(context, sphere, plane, &contact));

  /* Step 2 lays the frame on the tangent plane, 1.3 times as wide as the contact, and gives the gap above it. */
  if (!make_disc_frame(&frame, type, 1.3 * 1.0063)) {
    fprintf(stderr, "frame '%s': tri3, tri6, quad4 or quad8 is wanted\n", type);
    return 1;
  }
  must(rollcon_contact_frame_nodes(contact, frame.nodes, &frame.x[0][0], 3, 1));
  must(rollcon_contact_frame_add_elements(contact, frame.type, frame.elements, frame.id, 0, 1));
  must(rollcon_contact_set_gap_quadratic(contact, 1 / (2 * radius), 1 / (2 * radius), 0));

  /* Step 3 sets the material, first without friction. */
  must(rollcon_body_set_elastic(sphere, 0, young, poisson));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &no_friction));
  must(rollcon_contact_set_str(contact, "convection", scheme));

  /* Steps 4 and 5 set loads and solve: pressed together, rolling freely, rolling under a tangential force. The creepage
     is an unknown of the last two. */
  must(rollcon_contact_set_rolling(contact, speed));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, load));
  smooth = solve();
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  must(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, 0));
  free_rolling = solve();
  must(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, traction_force));
  driven = solve();

  /* Step 6 reads the results. */
  must(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, MOST_NODES, &t[0][0]));
  must(rollcon_contact_get_field(contact, ROLLCON_FIELD_SLIP, ROLLCON_LOCAL, 2 * MOST_NODES, &slip[0][0], NULL));
  must(rollcon_contact_get_field(contact, ROLLCON_FIELD_AREA, ROLLCON_LOCAL, MOST_NODES, area, NULL));
  must(rollcon_contact_get_node_states(contact, MOST_NODES, state));
  printf("elastic sphere (R %g mm, E %g MPa, nu %g) on a rigid plane; V %g mm/s\n", radius, young, poisson, speed);
  printf("frame %s: %d nodes, %d elements; %.0f nodes in contact; %s\n", type, frame.nodes, frame.elements,
         statistic("nodes_contact"), scheme);
  print_table(&smooth, &free_rolling, &driven);

  snprintf(path, sizeof path, "%s/sphere_on_plane.vtu", folder);
  must(rollcon_contact_write(contact, path));
  write_text(folder);
  printf("written: %s, nodes.txt, patches.txt, section.txt\n", path);

  rollcon_contact_release(contact);
  rollcon_body_release(plane);
  rollcon_body_release(sphere);
  rollcon_context_release(context);
  return 0;
}
