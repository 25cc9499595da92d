/* A ring meshed by finite elements rolls on an elastic half-space that is a hundred times as stiff:
   example 2 of Rodriguez-Tembleque and Abascal, Int. J. Solids Struct. 47 (2010) 330-353.

       ring_on_halfspace [folder [hex8|hex20 [characteristic|least_squares|godunov
                         [halfspace|block|equal]]]]

   `block` puts a block of boundary elements in the place of the half-space, as the paper does;
   `equal` gives both bodies one material with which Hertz's pressure stays as it is. Compares with
   long cylinders and with the paper, and leaves in the folder (the present one unless given)
   ring_on_halfspace.vtu for ParaView and text files that plot_ring_on_halfspace.gp draws.
   Units: mm, N, s; so MPa and mW. */
#include "contact_output.h"
#include "frame_line.h"
#include "long_cylinders.h"
#include "ring_mesh.h"

static const double radius = 50, width = 8, mu = 0.1, load = 1345, ratio = 0.5373, omega = 0.2;
static double young[2] = {1e4, 1e6}, poisson[2] = {0.3, 0.3}; /* ring, ground */

static rollcon_body *ring, *ground;
static rollcon_contact* contact;
static frame_results r;

/* Returns 2016 hexahedra: 28 around, 12 across, 6 deep; 12 x 12 of their faces are the zone. Pressure
   varies within a fraction of a millimetre below the surface, and the layers must show it: the
   first is as deep as its faces are long. It has half as many faces each way with hex20, 480 in all. */
static ring_shape ring_of(int32_t type) {
  ring_shape shape = paper_ring();
  shape.zone = 3.1; /* not in the paper: its widest gap comes out */
  shape.around = 28;
  shape.deep = 6;
  shape.top_layer = 0.25;
  shape.largest = 40;
  if (type == ROLLCON_HEX20) {
    shape.around = 20;
    shape.zone_around = shape.across = 6;
    shape.deep = 4;
    shape.top_layer = 0.6;
    shape.largest = 30;
  }
  return shape;
}

/* ------------------------------------------------------------------------------------- Ground */

static void as_it_is(const double q[3], const void* shape, double x[3]) {
  (void)shape;
  x[0] = q[0];
  x[1] = q[1];
  x[2] = q[2];
}

/* Makes a block of 80 x 80 x 40 mm with the ring's zone in the middle of its top, z = 0, which has the
   paper's 288 quadrilaterals: 16 x 18, 12 x 12 of them in the zone. Tags: 1 top outside the zone,
   2 zone, 3 bottom, 4 to 7 the sides. */
static int make_block_mesh(body_mesh* m, double zone) {
  static const int32_t tag[6] = {4, 5, 6, 7, 3, 1};
  double along[17], across[19], down[5];
  body_grid g = {{16, 18, 4}, {along, across, down}, 0, {0}, {2, 3}, {14, 15}, 2, as_it_is, NULL};
  int k;
  for (k = 0; k < 6; ++k) g.face_tag[k] = tag[k];
  lines_with_zone(along, 16, 40, 12, zone / 2, 0);
  lines_with_zone(across, 18, 40, 12, width / 2, 0);
  graded_lines(down, 4, 0, -40, 1, 0);
  reverse_lines(down, 4);
  return make_grid_mesh(m, &g, ROLLCON_QUAD4);
}

/* Writes a piece of the plane, for the picture only. */
static void write_plane(const char* folder, const char* name) {
  FILE* file = open_file(folder, name);
  fprintf(file, "-40 -40 0 1\n40 -40 0 1\n\n-40 40 0 1\n40 40 0 1\n");
  fclose(file);
}

/* ------------------------------------------------------------------------------------- Table */

/* Rolls under the tangential force `share` mu times the load; returns the creepage. */
static double roll(double share) {
  double creep[3];
  must(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, share * mu * load));
  must_solve(contact);
  must(rollcon_contact_get_motion(contact, NULL, creep));
  return creep[0];
}

static void print_table(const char* folder, double zone, double free_rolling, double driven) {
  const cylinder_pair cylinders = {{young[0], young[1]}, {poisson[0], poisson[1]}, 1 / radius, load / width, mu,
                                   omega * radius};
  FILE* file = open_file(folder, "ring_on_halfspace_long.txt");
  const cylinder_results h = roll_long_cylinders(&cylinders, ratio, file);
  const double h_free = roll_long_cylinders(&cylinders, 0, NULL).creepage;
  double force[3], approach, pressure, half_width, edge, fastest = 0, middle = 0, widest = 0;
  int k;
  fclose(file);
  must(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, NULL));
  must(rollcon_contact_get_motion(contact, &approach, NULL));
  for (k = 0; k < r.nodes; ++k) {
    const double speed = hypot(r.slip[k][0], r.slip[k][1]);
    fastest = fmax(fastest, speed);
    if (r.state[k] == ROLLCON_SLIP && fabs(r.x[k][1]) < 1e-6) middle = fmax(middle, speed);
    widest = fmax(widest, r.gap[k]);
  }
  on_line(&r, -width / 2, &edge, &half_width);
  on_line(&r, 0, &pressure, &half_width);
  printf("\n                                 long cylinders     paper     rollcon\n");
  printf("  pressure at mid-plane   MPa      %11.5g    107.9* %11.5g\n", h.pressure, pressure);
  printf("  half-width there        mm       %11.4g     0.99* %11.4g\n", h.half_width, half_width);
  printf("  pressure at the sides   MPa                           %11.5g\n", edge);
  printf("  creepage, no force      %%        %11.4f           %11.4f\n", 100 * h_free, 100 * free_rolling);
  printf("  creepage                %%        %11.4f           %11.4f\n", 100 * h.creepage, 100 * driven);
  printf("  creepage by the force   %%        %11.4f           %11.4f\n", 100 * (h.creepage - h_free),
         100 * (driven - free_rolling));
  printf("    Carter, equal bodies  %%        %11.4f\n", -100 * mu * h.half_width / radius * (1 - sqrt(1 - ratio)));
  printf("  widest gap of frame     mm       %11.5f   0.0086  %11.5f\n", hertz_gap(&cylinders, h.half_width, zone / 2),
         widest);
  printf("  fastest slip of frame   mm/s                  0.0139  %11.4f\n", fastest);
  printf("  in contact at mid-plane mm/s     %11.4f           %11.4f\n", h.fastest, middle);
  printf("  normal force            N        %11.6g   1345    %11.6g\n", load, -force[2]);
  printf("  force along t1          mu Fn    %11.4f   0.5373  %11.4f\n", ratio, force[0] / (-mu * force[2]));
  printf("  approach                mm                            %11.5f\n", approach);
  printf("  power of friction       mW                            %11.5g\n", statistic(contact, "friction_power"));
  printf("  (* Hertz's values; long cylinders: half-spaces in plane strain, rolled by rollcon)\n");
  if (young[0] < young[1])
    printf(
        "  Most of the creepage is there without any force: pressure shortens the soft ring's "
        "surface\n"
        "  more than the ground's. The slip that this causes is several times the paper's, in the\n"
        "  plane problem too; what it left out or where it read its value, the paper does not "
        "say.\n");
  printf("\nlaws recomputed from the tractions (relative residuals)\n");
  printf("  no tension, no overlap  %8.1e     friction bound    %8.1e\n", statistic(contact, "law_normal"),
         statistic(contact, "law_friction"));
  printf("  slip against friction   %8.1e     forces as given   %8.1e\n", statistic(contact, "law_slip"),
         statistic(contact, "law_equilibrium"));
}

static void print_cost(const char* name, const rollcon_body* body) {
  printf("%s: %.0f unknowns, %.0f of them condensed; %.2g nonzeros in the factor, at most %.0f MB\n", name,
         body_statistic(body, "unknowns"), body_statistic(body, "condensed_unknowns"),
         body_statistic(body, "factor_nonzeros"), 1e-6 * body_statistic(body, "peak_bytes"));
  printf("  assembly %.3f s, order %.3f s, factor %.3f s, condensation %.3f s\n",
         body_statistic(body, "seconds_assembly"), body_statistic(body, "seconds_order"),
         body_statistic(body, "seconds_factor"), body_statistic(body, "seconds_condense"));
}

int main(int argc, char** argv) {
  const char* folder = argc > 1 ? argv[1] : ".";
  const int32_t type = argc > 2 && strcmp(argv[2], "hex20") == 0 ? ROLLCON_HEX20 : ROLLCON_HEX8;
  const char* scheme = argc > 3 ? argv[3] : "characteristic";
  const int on_block = argc > 4 && strcmp(argv[4], "block") == 0;
  const int equal = argc > 4 && strcmp(argv[4], "equal") == 0;
  const ring_shape shape = ring_of(type);
  /* The mesh has its contact at the top: it is turned over, and its contact put in the origin. */
  const double upside_down[9] = {1, 0, 0, 0, -1, 0, 0, 0, -1}, up[3] = {0, 0, radius};
  const double as_meshed[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, origin[3] = {0, 0, 0};
  const double rolling[3] = {1, 0, 0}, normal[3] = {0, 0, -1};
  static const int held[1] = {3}; /* the hub of the ring, the bottom of the block */
  static const int32_t outside[2] = {1, 2};
  double free_rolling, driven;
  body_mesh ring_mesh, block_mesh;
  char path[1000];

  /* Step 1 makes the bodies: the ring by finite elements, the ground as a half-space or by boundary elements. */
  must(rollcon_context_create(ROLLCON_ABI, &context));
  must(rollcon_body_create(context, ROLLCON_BODY_FEM, &ring));
  must(rollcon_body_create(context, on_block ? ROLLCON_BODY_BEM : ROLLCON_BODY_HALFSPACE, &ground));
  if (!make_ring_mesh(&ring_mesh, &shape, type) || !make_block_mesh(&block_mesh, shape.zone)) {
    fprintf(stderr, "not enough memory\n");
    return 1;
  }
  give_mesh(ring, &ring_mesh, 1, held);
  must(rollcon_body_set_contact_faces(ring, 2, outside));
  if (on_block) {
    give_mesh(ground, &block_mesh, 1, held);
    must(rollcon_body_set_contact_faces(ground, 2, outside));
  }
  must(rollcon_contact_create(context, ring, ground, &contact));

  /* Step 2 sets poses and frame: the zone of the ring; the gap is that of the ring's faces above the ground. */
  must(rollcon_contact_set_pose(contact, ROLLCON_BODY1, upside_down, up));
  must(rollcon_contact_set_axes(contact, origin, rolling, normal));
  must(rollcon_contact_frame_from_body(contact, ROLLCON_BODY1, 2));
  frame_of_tag(&r, &ring_mesh, 2);

  /* Step 3 sets the materials. */
  if (equal) young[0] = young[1] = 2 / (1 / young[0] + 1 / young[1]);
  must(rollcon_body_set_elastic(ring, 0, young[0], poisson[0]));
  must(rollcon_body_set_elastic(ground, 0, young[1], poisson[1]));
  must(rollcon_contact_set_friction(contact, "coulomb", 1, &mu));
  must(rollcon_contact_set_str(contact, "convection", scheme));

  /* Steps 4 and 5 set loads and solve: rolling freely, then driven; approach and creepage are unknown. */
  must(rollcon_contact_set_rolling(contact, omega * radius));
  must(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, load));
  free_rolling = roll(0);
  driven = roll(ratio);

  /* Step 6 reads the results. */
  read_results(&r, contact);
  printf("ring (radii %g and %g mm, width %g mm, E %g MPa) on %s (E %g MPa); nu %g; V %g mm/s\n", shape.inner, radius,
         width, young[0], on_block ? "a block" : "a half-space", young[1], poisson[0], omega * radius);
  printf("ring: %d nodes, %d %s, %d around x %d across x %d deep, the first layer %g mm\n", ring_mesh.nodes,
         ring_mesh.cells, type == ROLLCON_HEX8 ? "hex8" : "hex20", shape.around, shape.across, shape.deep,
         shape.top_layer);
  if (on_block)
    printf("block: 80 x 80 x 40 mm, %d nodes, %d quad4, 16 x 18 of them on its top\n", block_mesh.nodes,
           block_mesh.elements);
  printf("frame: %g x %g mm, %d nodes, %d elements; %.0f nodes in contact; %s\n", shape.zone, width, r.nodes,
         r.elements, statistic(contact, "nodes_contact"), scheme);
  print_table(folder, shape.zone, free_rolling, driven);
  printf("\n");
  print_cost("ring", ring);
  if (on_block) print_cost("block", ground);
  printf("contact: %.0f iterations, %.0f ms, after those of free rolling\n", statistic(contact, "iterations"),
         1e3 * statistic(contact, "seconds_newton"));
  snprintf(path, sizeof path, "%s/ring_on_halfspace.vtu", folder);
  must(rollcon_contact_write(contact, path));
  write_frame(&r, folder, "ring_on_halfspace");
  write_body(&ring_mesh, upside_down, up, folder, "ring_on_halfspace_ring.txt");
  if (on_block) {
    write_body(&block_mesh, as_meshed, origin, folder, "ring_on_halfspace_ground.txt");
  } else {
    write_plane(folder, "ring_on_halfspace_ground.txt");
  }
  printf("written: %s and ring_on_halfspace_{nodes,patches,section,long,ring,ground}.txt\n", path);

  free_body_mesh(&ring_mesh);
  free_body_mesh(&block_mesh);
  rollcon_contact_release(contact);
  rollcon_body_release(ground);
  rollcon_body_release(ring);
  rollcon_context_release(context);
  return 0;
}
