/* The rim of a railway wheel, meshed by boundary elements, rolls over a rigid rail head: example 4
   of Rodriguez-Tembleque and Abascal, Int. J. Solids Struct. 47 (2010) 330-353.

       wheel_on_rail [folder [straight|spin [characteristic|least_squares|godunov]]]

   A 28-inch wheel, cone 1:20, is pressed 15 um against a rail head with a crown of 8 inches and
   transmits 57 % of the force at which it would slide. `spin` adds the spin that the cone causes;
   the paper has none. Leaves in the folder (the present one unless given) wheel_on_rail.vtu for
   ParaView and text files that plot_wheel.gp and plot_wheel_fields.gp draw.
   Units: mm, N, s; so MPa and mW. */
#include "contact_output.h"
#include "wheel_mesh.h"

static const double radius = 355.6, cone = 0.05, rail_radius = 203.2;
static const double young = 1e4, poisson = 0.3, mu = 0.1, ratio = 0.57;
static const double depth = 0.015, omega = 0.1;

static rollcon_body *wheel, *rail;
static rollcon_contact* contact;
static frame_results r;
static double seconds, iterations; /* sums over all solutions so far */
static int solutions;

/* Makes a part of a cylinder along x whose top is the origin: n x n faces. The rail is rigid, so only what
   lies near the contact is wanted. */
static int make_rail_head(body_mesh* m, double half_length, double half_width, int n) {
  static const int place[9][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}};
  const int side = 2 * n + 1;
  int i, j, k;
  m->type = ROLLCON_QUAD9;
  m->per_element = 9;
  m->nodes = side * side;
  m->elements = m->cells = 0;
  m->cell = NULL;
  m->x = (double(*)[3])malloc((size_t)m->nodes * sizeof *m->x);
  m->id = (int32_t*)malloc((size_t)(9 * n * n) * sizeof *m->id);
  if (m->x == NULL || m->id == NULL) {
    free_body_mesh(m);
    return 0;
  }
  for (k = 0; k < m->nodes; ++k) {
    const double angle = half_width / rail_radius * ((double)(k / side) / n - 1);
    m->x[k][0] = half_length * ((double)(k % side) / n - 1);
    m->x[k][1] = rail_radius * sin(angle);
    m->x[k][2] = rail_radius * (cos(angle) - 1);
  }
  for (j = 0; j < side - 1; j += 2)
    for (i = 0; i < side - 1; i += 2, ++m->elements)
      for (k = 0; k < 9; ++k) m->id[9 * m->elements + k] = (j + place[k][1]) * side + i + place[k][0];
  for (k = 0; k <= MOST_TAGS; ++k) m->first[k] = k < 2 ? 0 : m->elements; /* all have tag 1 */
  return 1;
}

/* ------------------------------------------------------------------------------------- Table */

typedef struct {
  double force[3], pressure, semi[2], creep[3];
} measures;

/* Computes semi-axes by the second moments of the pressure: a^2 = 5 <x^2> under Hertz's ellipsoid. */
static void semi_axes(double semi[2]) {
  int c, k;
  for (c = 0; c < 2; ++c) {
    double sum = 0, first = 0, second = 0;
    for (k = 0; k < r.nodes; ++k) {
      const double force = -r.t[k][2] * r.weight[k];
      sum += force;
      first += force * r.x[k][c];
      second += force * r.x[k][c] * r.x[k][c];
    }
    semi[c] = sqrt(5 * (second / sum - first * first / (sum * sum)));
  }
}

static measures solve(void) {
  measures m;
  must_solve(contact);
  read_results(&r, contact);
  must(rollcon_contact_get_motion(contact, NULL, m.creep));
  must(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, m.force, NULL));
  m.pressure = statistic(contact, "max_pressure");
  seconds += statistic(contact, "seconds_total");
  iterations += statistic(contact, "iterations");
  ++solutions;
  semi_axes(m.semi);
  return m;
}

static void compare(const char* name, const char* unit, double smooth, double rolling) {
  printf("  %-24s%-5s %11.5g %11.5g\n", name, unit, smooth, rolling);
}

static void print_table(const measures* smooth, const measures* free_rolling, const measures* driven) {
  double stick = 0, sliding = 0, fastest = 0;
  int k;
  for (k = 0; k < r.nodes; ++k) {
    if (r.state[k] == ROLLCON_STICK) stick += r.area[k];
    if (r.state[k] != ROLLCON_SLIP) continue;
    sliding += r.area[k];
    fastest = fmax(fastest, hypot(r.slip[k][0], r.slip[k][1]));
  }
  printf("\n                                    mu = 0    mu = 0.1\n");
  compare("normal force", "N", -smooth->force[2], -driven->force[2]);
  printf("    in the paper                       457         457\n");
  compare("largest pressure", "MPa", smooth->pressure, driven->pressure);
  compare("semi-axis along rolling", "mm", smooth->semi[0], driven->semi[0]);
  compare("semi-axis across", "mm", smooth->semi[1], driven->semi[1]);
  printf("\nrolling with mu = 0.1\n");
  printf("  force along t1         N     %11.5g   = %.4f mu Fn\n", driven->force[0],
         driven->force[0] / (-mu * driven->force[2]));
  printf("  creepage               %%     %11.4f   free rolling %.4f, by the force %.4f\n", 100 * driven->creep[0],
         100 * free_rolling->creep[0], 100 * (driven->creep[0] - free_rolling->creep[0]));
  printf("  force along t2         N     %11.3f   no lateral creepage\n", driven->force[1]);
  printf("  spin                   1/mm  %11.3e\n", driven->creep[2]);
  printf("  sticking               mm2   %11.5g   = %.0f %% of the contact\n", stick, 100 * stick / (stick + sliding));
  printf("  slipping               mm2   %11.5g   at up to %.4f mm/s\n", sliding, fastest);
  printf("  power of friction      mW    %11.5g\n", statistic(contact, "friction_power"));
  printf("\nlaws recomputed from the tractions (relative residuals)\n");
  printf("  no tension, no overlap  %8.1e     friction bound    %8.1e\n", statistic(contact, "law_normal"),
         statistic(contact, "law_friction"));
  printf("  slip against friction   %8.1e     forces as given   %8.1e\n", statistic(contact, "law_slip"),
         statistic(contact, "law_equilibrium"));
}

static void print_cost(void) {
  printf("\nwheel: %.0f unknowns, condition %.1e, at most %.0f MB\n", body_statistic(wheel, "unknowns"),
         body_statistic(wheel, "condition"), 1e-6 * body_statistic(wheel, "peak_bytes"));
  printf(
      "%.2f s for all: assembly %.2f, factors %.2f, condensation %.2f s; %d solutions of %.0f "
      "iterations\n",
      seconds, body_statistic(wheel, "seconds_assembly"), body_statistic(wheel, "seconds_factor"),
      body_statistic(wheel, "seconds_condense"), solutions, iterations);
}

int main(int argc, char** argv) {
  const char* folder = argc > 1 ? argv[1] : ".";
  const int spinning = argc > 2 && strcmp(argv[2], "spin") == 0;
  const char* scheme = argc > 3 ? argv[3] : "characteristic";
  const double c = 1 / sqrt(1 + cone * cone), s = cone * c, no_friction = 0;
  /* The mesh has its contact at the top: it is turned over, and its contact put in the origin. The
     tread slopes like the cone there, and the rail is inclined to meet it. */
  const double upside_down[9] = {1, 0, 0, 0, -1, 0, 0, 0, -1}, up[3] = {0, 0, radius};
  const double inclined[9] = {1, 0, 0, 0, c, s, 0, -s, c}, origin[3] = {0, 0, 0};
  const double rolling[3] = {1, 0, 0}, normal[3] = {0, -s, -c};
  static const int held[3] = {3, 6, 7}; /* inner face of the rim and the cut faces */
  static const int32_t tread[2] = {1, 2};
  wheel_shape shape = paper_wheel(0);
  body_mesh wheel_mesh, rail_mesh;
  measures smooth, free_rolling, driven;
  char path[1000];

  /* Step 1 makes the bodies. */
  must(rollcon_context_create(ROLLCON_ABI, &context));
  must(rollcon_body_create(context, ROLLCON_BODY_BEM, &wheel));
  must(rollcon_body_create(context, ROLLCON_BODY_RIGID, &rail));
  if (!make_wheel_mesh(&wheel_mesh, &shape, ROLLCON_QUAD4) || !make_rail_head(&rail_mesh, 10, 20, 8)) {
    fprintf(stderr, "not enough memory\n");
    return 1;
  }
  give_mesh(wheel, &wheel_mesh, 3, held);
  give_mesh(rail, &rail_mesh, 0, NULL);
  must(rollcon_body_set_contact_faces(wheel, 2, tread));
  must(rollcon_contact_create(context, wheel, rail, &contact));

  /* Step 2 sets poses and frame: the zone of the wheel; the gap follows from both surfaces. */
  must(rollcon_contact_set_pose(contact, ROLLCON_BODY1, upside_down, up));
  must(rollcon_contact_set_pose(contact, ROLLCON_BODY2, inclined, origin));
  must(rollcon_contact_set_axes(contact, origin, rolling, normal));
  must(rollcon_contact_frame_from_body(contact, ROLLCON_BODY1, 2));
  frame_of_tag(&r, &wheel_mesh, 2);

  /* Step 3 sets the material, first without friction. */
  must(rollcon_body_set_elastic(wheel, 0, young, poisson));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &no_friction));
  must(rollcon_contact_set_str(contact, "convection", scheme));

  /* Steps 4 and 5 set loads and solve: pressed together, rolling freely, rolling under a tangential force. Friction
     changes the normal force a little, since only one body is elastic: the tangential force follows. */
  must(rollcon_contact_set_rolling(contact, omega * radius));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, depth));
  smooth = solve();
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  if (spinning) must(rollcon_contact_prescribe(contact, ROLLCON_SPIN, ROLLCON_BY_MOTION, -s / radius));
  must(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, 0));
  driven = free_rolling = solve();
  while (solutions < 6 && fabs(driven.force[0] / (mu * driven.force[2]) + ratio) > 1e-6) {
    must(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, -ratio * mu * driven.force[2]));
    driven = solve();
  }

  /* Step 6 reads the results. */
  printf("wheel (R %g mm, cone 1:%g, E %g MPa, nu %g) on a rigid rail head (R %g mm); V %g mm/s\n", radius, 1 / cone,
         young, poisson, rail_radius, omega * radius);
  printf("wheel: %d nodes, %d quad4; frame: %d nodes, %d elements; %.0f nodes in contact; %s\n", wheel_mesh.nodes,
         wheel_mesh.elements, r.nodes, r.elements, statistic(contact, "nodes_contact"), scheme);
  print_table(&smooth, &free_rolling, &driven);
  print_cost();
  snprintf(path, sizeof path, "%s/wheel_on_rail.vtu", folder);
  must(rollcon_contact_write(contact, path));
  write_frame(&r, folder, "wheel_on_rail");
  write_body(&wheel_mesh, upside_down, up, folder, "wheel_on_rail_wheel.txt");
  write_body(&rail_mesh, inclined, origin, folder, "wheel_on_rail_rail.txt");
  printf("written: %s and wheel_on_rail_{nodes,patches,section,wheel,rail}.txt\n", path);

  free_body_mesh(&wheel_mesh);
  free_body_mesh(&rail_mesh);
  rollcon_contact_release(contact);
  rollcon_body_release(rail);
  rollcon_body_release(wheel);
  rollcon_context_release(context);
  return 0;
}
