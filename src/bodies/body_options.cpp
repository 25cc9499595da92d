#include "bodies/body_options.hpp"

namespace rollcon {

const SettingTable<BodyOptions>& body_option_table() {
  static const SettingTable<BodyOptions> table{
      {"accuracy", &BodyOptions::accuracy, 1e-12, 1e-2, "Relative accuracy of the boundary integrals."},
      {"edge_angle", &BodyOptions::edge_angle, 1, 180,
       "Degrees between the normals of neighbouring faces beyond which their common edge is sharp: "
       "tractions may jump there."},
      {"keep_factors", &BodyOptions::keep_factors, 0, 1,
       "1: keeps the factorised matrix for further frames; 0: frees it once a frame has its "
       "compliance."},
      {"between_nodes", &BodyOptions::between_nodes, 0, 1,
       "Displacements between the nodes of the body. 0: a half-space supplies what the body's mesh "
       "cannot show of the tractions on the frame; "
       "1: by the elements' shape functions alone."},
      {"hex8", &BodyOptions::hex8, 0, 1,
       "Finite elements: 0 hex8 with incompatible modes, exact in bending; 1 B-bar, constant "
       "dilatation."},
      {"prepare", &BodyOptions::prepare, 0, 1,
       "1: preparing factorises what contacts are known to need; 0: it checks only, and what a "
       "contact then asks for comes with it. Bodies with loads or given displacements of their own "
       "are factorised in any case."},
      {"factor", &BodyOptions::factor, 0, 2,
       "Boundary elements. 0: hierarchical factors from 12,000 unknowns on, where this library has them, else dense "
       "ones; 1: dense; 2: hierarchical."},
      {"factor_accuracy", &BodyOptions::factor_accuracy, 1e-10, 1e-2,
       "Relative accuracy of hierarchical factors, and of the blocks that they are made of."},
      {"factor_ranks", &BodyOptions::factor_ranks, 0, 1,
       "Finite elements. 1: preparing is a joint call of the ranks of the context's communicator, which factorise the "
       "body together; 0: each rank does it by itself."},
      {"stations", &BodyOptions::stations, 0, 1e6,
       "Sections: nodes of the surface once round, or over a period, made even. 0: half as many again for a length "
       "as the section's contact edges have on the average."},
      {"sector", &BodyOptions::sector, 0, 360,
       "Sections: degrees of the way, with the contact in their middle, that rollcon_contact_write_body and "
       "rollcon_body_write show with their inside; 360: all of it, 0: the surface alone."},
      {"smooth_slices", &BodyOptions::smooth_slices, 0, 1,
       "Profiles that vary. 0: splines lead through all slices; 1: they come near to each, by two thirds of its "
       "distance "
       "from the chord of its neighbours, which smooths measured slices."},
      {"filter_order", &BodyOptions::filter_order, 2, 3,
       "Profiles to be filtered, as the next four options before they are set. A wave of length l keeps "
       "1 / (1 + (filter_length / l)^2m) of its height, m: 3, which leaves curvatures of arcs alone, or 2, a cubic "
       "smoothing spline."},
      {"points_alike", &BodyOptions::points_alike, 0, 1,
       "0: a point weighs in the filter by the length of the curve beside it; 1: all weigh the same, as in a plain "
       "smoothing spline."},
      {"kink_angle", &BodyOptions::kink_angle, 1, 180,
       "Degrees by which a profile turns at a kink, at least: the curve is broken there, and filters do not round it."},
      {"kink_beside", &BodyOptions::kink_beside, 0, 1,
       "The points beside a kink turn by at most this fraction of its angle."},
      {"zigzag_angle", &BodyOptions::zigzag_angle, 1, 150,
       "Degrees: two points in succession at which the path turns by more, to and fro, are replaced by their mean. A "
       "single turn by more than that and than 90 is refused."},
      {"cache_bytes", &BodyOptions::cache_bytes, 0, 1e15,
       "Bytes of responses (to the frames of contacts) that the body keeps: beyond them those not "
       "used for longest are dropped, but never the last one."},
  };
  return table;
}

}  // namespace rollcon
