/* Two equal rings, meshed by boundary elements, roll on each other: example 1 of
   Rodriguez-Tembleque and Abascal, Int. J. Solids Struct. 47 (2010) 330-353.

       two_rings [folder [linear|quadratic [characteristic|least_squares|godunov [zone]]]]

   Both rings are one body, placed twice. `zone` is the length of the frame along the rolling
   direction [mm], 12 elements (quadratic: 6). Compares with Hertz's and Carter's closed forms for
   long cylinders and with the paper, and leaves in the folder (the present one unless given)
   two_rings.vtu for ParaView and text files that plot_rings.gp draws. Units: mm, N, s; so MPa, mW.
 */
#include "contact_output.h"
#include "frame_line.h"
#include "ring_mesh.h"

static const double radius = 50, width = 8, young = 1e4, poisson = 0.3, mu = 0.1;
static const double load = 1233.85, ratio = 0.6271, omega = 0.2;

static rollcon_body* ring;
static rollcon_contact* contact;
static frame_results r;

/* ------------------------------------------------------------------------------------- Table */

/* Prints the sides along the lines that have all nodes (quadratic elements: those through vertices). */
static void print_sides(void) {
  double pressure, half_width, previous = -1e-6;
  const int full = on_line(&r, 0, &pressure, &half_width);
  printf("\ntowards a free side: without the stress 2 nu p along the axle the same strain leaves\n");
  printf("(1 + nu)(1 - 2 nu)/(1 - nu) = %.2f of the pressure\n", (1 + poisson) * (1 - 2 * poisson) / (1 - poisson));
  printf("  y [mm]          largest pressure [MPa]  half-width [mm]\n");
  for (;;) {
    double y = width;
    int k;
    for (k = 0; k < r.nodes; ++k)
      if (r.x[k][1] > previous) y = fmin(y, r.x[k][1]);
    if (y == width) break;
    previous = y + 1e-6;
    if (on_line(&r, y, &pressure, &half_width) < full) continue;
    printf("  %6.3f          %8.2f                %8.4f\n", fabs(y), pressure, half_width);
  }
}

static void print_table(void) {
  /* Long cylinders under this load per length have 1/E* = 2 (1 - nu^2)/E, 1/R = 2/radius. */
  const double pi = acos(-1.0), per_length = load / width;
  const double a = sqrt(4 * per_length * (radius / 2) * 2 * (1 - poisson * poisson) / (pi * young));
  const double p0 = 2 * per_length / (pi * a);
  const double carter = -mu * a / (radius / 2) * (1 - sqrt(1 - ratio));
  double force[3], creep[3], approach, pressure, half_width, fastest = 0, contact_fastest = 0;
  double widest = 0;
  int k;
  must(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, NULL));
  must(rollcon_contact_get_motion(contact, &approach, creep));
  for (k = 0; k < r.nodes; ++k) {
    const double speed = hypot(r.slip[k][0], r.slip[k][1]);
    fastest = fmax(fastest, speed);
    if (r.state[k] == ROLLCON_SLIP) contact_fastest = fmax(contact_fastest, speed);
    widest = fmax(widest, r.gap[k]);
  }
  on_line(&r, 0, &pressure, &half_width);
  printf("\n                                 long cylinders     paper     rollcon\n");
  printf("  pressure at mid-plane   MPa      %11.5g           %11.5g\n", p0, pressure);
  printf("  half-width there        mm       %11.5g           %11.5g\n", a, half_width);
  printf("  creepage                %%        %11.5f           %11.5f\n", 100 * carter, 100 * creep[0]);
  printf("  fastest slip of frame   mm/s                   0.0428 %11.5f\n", fastest);
  printf("  fastest slip in contact mm/s                          %11.5f\n", contact_fastest);
  printf("  widest gap of frame     mm                     0.0156 %11.5f\n", widest);
  printf("  normal force            N        %11.6g           %11.6g\n", load, -force[2]);
  printf("  force along t1          mu Fn    %11.5g           %11.5g\n", ratio, force[0] / (-mu * force[2]));
  printf("  approach                mm                            %11.5f\n", approach);
  printf("  power of friction       mW                            %11.5g\n", statistic(contact, "friction_power"));
  print_sides();
  printf("\nlaws recomputed from the tractions (relative residuals)\n");
  printf("  no tension, no overlap  %8.1e     friction bound    %8.1e\n", statistic(contact, "law_normal"),
         statistic(contact, "law_friction"));
  printf("  slip against friction   %8.1e     forces as given   %8.1e\n", statistic(contact, "law_slip"),
         statistic(contact, "law_equilibrium"));
}

static void print_cost(void) {
  printf(
      "\nring: %.0f unknowns, condition %.1e, assembled %.0f time; assembly %.2f s, factors %.2f "
      "s, condensation %.2f s, at most %.0f MB\n",
      body_statistic(ring, "unknowns"), body_statistic(ring, "condition"), body_statistic(ring, "assemblies"),
      body_statistic(ring, "seconds_assembly"), body_statistic(ring, "seconds_factor"),
      body_statistic(ring, "seconds_condense"), 1e-6 * body_statistic(ring, "peak_bytes"));
  printf("contact: %.2f s, the ring's preparation included; %.0f iterations, %.0f ms\n",
         statistic(contact, "seconds_total"), statistic(contact, "iterations"),
         1e3 * statistic(contact, "seconds_newton"));
}

/* Returns the paper's mesh; with quadratic elements it has half as many of them each way. */
static ring_shape ring_of(int quadratic, double zone) {
  ring_shape shape = paper_ring();
  shape.zone = zone > 0 ? zone : 2.98; /* not in the paper: its widest gap comes out */
  if (quadratic) {
    shape.around = 28;
    shape.zone_around /= 2;
    shape.across /= 2;
    shape.deep = 3;
    shape.top_layer = 2.4;
    shape.largest = 20;
  }
  return shape;
}

int main(int argc, char** argv) {
  const char* folder = argc > 1 ? argv[1] : ".";
  const int quadratic = argc > 2 && strcmp(argv[2], "quadratic") == 0;
  const char* scheme = argc > 3 ? argv[3] : "characteristic";
  const ring_shape shape = ring_of(quadratic, argc > 4 ? atof(argv[4]) : 0);
  const double as_meshed[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, here[3] = {0, 0, 0};
  const double upside_down[9] = {1, 0, 0, 0, -1, 0, 0, 0, -1}, above[3] = {0, 0, 2 * radius};
  const double origin[3] = {0, 0, radius}, rolling[3] = {1, 0, 0}, normal[3] = {0, 0, 1};
  static const int hub[1] = {3};
  static const int32_t outside[2] = {1, 2};
  body_mesh mesh;
  char path[1000];

  /* Step 1 makes the bodies: the same ring twice. */
  must(rollcon_context_create(ROLLCON_ABI, &context));
  must(rollcon_body_create(context, ROLLCON_BODY_BEM, &ring));
  if (!make_ring_mesh(&mesh, &shape, quadratic ? ROLLCON_QUAD8 : ROLLCON_QUAD4)) {
    fprintf(stderr, "not enough memory\n");
    return 1;
  }
  give_mesh(ring, &mesh, 1, hub);
  must(rollcon_body_set_contact_faces(ring, 2, outside));
  must(rollcon_contact_create(context, ring, ring, &contact));

  /* Step 2 sets poses and frame: the second ring stands upside down on the first, whose zone is the frame. */
  must(rollcon_contact_set_pose(contact, ROLLCON_BODY1, as_meshed, here));
  must(rollcon_contact_set_pose(contact, ROLLCON_BODY2, upside_down, above));
  must(rollcon_contact_set_axes(contact, origin, rolling, normal));
  must(rollcon_contact_frame_from_body(contact, ROLLCON_BODY1, 2));
  frame_of_tag(&r, &mesh, 2);

  /* Step 3 sets the material. */
  must(rollcon_body_set_elastic(ring, 0, young, poisson));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  must(rollcon_contact_set_str(contact, "convection", scheme));

  /* Steps 4 and 5 set loads and solve: pressed together and driven by forces; approach and creepage are unknown. */
  must(rollcon_contact_set_rolling(contact, omega * radius));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, load));
  must(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, ratio * mu * load));
  must_solve(contact);

  /* Step 6 reads the results. */
  read_results(&r, contact);
  printf("two rings (radii %g and %g mm, width %g mm, E %g MPa, nu %g); V %g mm/s\n", shape.inner, radius, width, young,
         poisson, omega * radius);
  printf(
      "each ring: %d nodes, %d %s; frame: %d nodes, %d elements, %g mm long; %.0f nodes in "
      "contact; %s\n",
      mesh.nodes, mesh.elements, quadratic ? "quad8" : "quad4", r.nodes, r.elements, shape.zone,
      statistic(contact, "nodes_contact"), scheme);
  print_table();
  print_cost();
  snprintf(path, sizeof path, "%s/two_rings.vtu", folder);
  must(rollcon_contact_write(contact, path));
  write_frame(&r, folder, "two_rings");
  write_body(&mesh, as_meshed, here, folder, "two_rings_lower.txt");
  write_body(&mesh, upside_down, above, folder, "two_rings_upper.txt");
  printf("written: %s and two_rings_{nodes,patches,section,lower,upper}.txt\n", path);

  free_body_mesh(&mesh);
  rollcon_contact_release(contact);
  rollcon_body_release(ring);
  rollcon_context_release(context);
  return 0;
}
