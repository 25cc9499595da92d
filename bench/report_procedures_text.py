"""Says in docs/procedures.md what is not in numbers."""

OPTIONS = """The standard procedure eliminates the bodies' unknowns once and solves the contact by an exact semismooth
Newton iteration with a start and fallbacks of its own ([theory](theory.md), section 6). The procedures of
Rodriguez-Tembleque and Abascal (Int. J. Solids Struct. 47, 2010, section 11; numbers in brackets are its equations)
are chosen by `rollcon_contact_set_procedure(contact, "system=monolithic jacobian=reduced")`; `linear_solver`,
`linear_tolerance` and `preconditioner` are settings of a contact. [Theory](theory.md), section 12, describes them:

| option | value | what it is |
| --- | --- | --- |
| `system` | `condensed` | nodal tractions and unknown motions are left; the default |
| | `monolithic` | the bodies' unknowns written out: (48) finite elements, (58) boundary elements, (62) one of each; (88) with reduced unknowns |
| `jacobian` | `exact` | the standard iteration; monolithic: the same linearisation and start in the iteration of section 11.1 |
| | `b_derivative` | (68)-(70): all laws at once from zero tractions (section 11.6) |
| | `simplified` | (77)-(83): friction of a sliding pair keeps the direction that it had in the last iterate |
| | `reduced` | section 11.8: the same, a sliding pair with one unknown traction and a sticking one with estimated displacements; needs `convection` `godunov` or `least_squares` |
| `slip_estimate` | `jacobi` | (90): displacement that makes the slip vanish, those of the neighbours as they were; the choice of `auto` |
| | `pseudo_temporal` | (91): a time step: the shortest time in which a particle passes a node |
| | `extrapolation` | (92): that of (90), extrapolated by 1.2 |
| `linear_solver` | `lu` | every system is factorised: LAPACK where it is dense, UMFPACK where it is sparse |
| | `gmres` | GMRES to a tolerance `linear_tolerance` (71); 0: chosen from the iteration's progress |
| | `gmres_adaptive` | tolerance by (72)-(74), at most `linear_tolerance` (0: 0.01) |
| `preconditioner` | `none`, `diagonal` | of GMRES, not of the standard iteration; diagonal: each unknown's own entry |
| | `bodies` | the bodies' matrices, factorised once, and the pairs as if on half-spaces; monolithic only, its `auto` |
| | `kept_lu` | factors of an earlier iteration, made anew when they no longer serve; condensed only, its `auto` |
| `line_search` | `armijo`, `off` | section 11.1 (III); `auto`: armijo |

Combinations that make no sense are refused with the reason. The columns `error_function` and `seconds` of
`rollcon_contact_get_history` tell the error function of every iteration and the time at which it was reached.
"""

CHOICE = """## Which to choose

- The default (condensed, exact) converges in about ten iterations from nothing and in two or three after a small
  change, needs no parameter, and is the only procedure with fallbacks. It costs the compliance of the bodies, once
  for a pair of meshes; after that a solve works on the nodes in contact alone.
- `b_derivative` takes a few iterations more, because it has no start of its own, and was as reliable here.
- `simplified` and `reduced` converge linearly, because the direction of friction (and the slip of sticking pairs) is
  always one iterate old. They take tens to hundreds of iterations, more on finer meshes. Their systems are smaller
  and better conditioned. GMRES with adaptive tolerance benefits from this, but it does not make up for the number of
  iterations.
- Both fail where a tangential load is given and hardly a pair sticks. With frozen directions of friction, nothing in
  the system depends on an unknown creepage once every pair slides, and the matrix is singular; such a step takes all
  pairs in contact for sticking instead. The iteration then alternates between full stick and full slip. With
  creepages given they never failed here.
- `reduced` passes the displacement of a sticking particle on from node to node, one iteration each. A shift of the
  whole sticking zone decays only by as much as the node ahead of it stays behind. Where bodies give way as a whole,
  this is little: the rings of example 1 take a thousand iterations, parts of them that are held at their ends a
  hundred and fifty.
- `pseudo_temporal` uses one time step for all nodes: the shortest time in which a particle passes one. Nodes on
  larger cells relax slowly, and with least squares the sphere's frame did not converge. The paper's step of 0.15,
  whose unit it does not give, is too small in units of this time (no convergence within thousands of iterations);
  here it is 1. `extrapolation` saves up to a sixth of Jacobi's iterations.
- Adaptive tolerance: while the outer iteration converges linearly, (73) stays near its bound `linear_tolerance`, and
  an error of this fraction of the residual is fed back. With a bound of 0.5 `reduced` needs twice the iterations or
  does not converge; the default is 0.01.
- `monolithic` needs no compliance of the bodies. With GMRES, adaptive tolerance and the bodies' factors a cold solve
  costs a few times as much as that of the standard procedure. It was never faster here, and every re-solve costs
  nearly as much as the first solve.
- Preconditioners: without one GMRES needs hundreds to thousands of iterations for the monolithic system, because
  stiffness, tractions and gaps differ by orders of magnitude. The bodies' own factors make the number of iterations
  independent of the mesh. Factors of an earlier iteration of the whole system (`kept_lu`) are for the condensed
  system alone; on the monolithic one they took 1.7 to 3.3 times as long on every mesh, because they had to be made
  anew when the contact changed. In the condensed system the number of iterations grows like the nodes across the
  contact without a preconditioner, and hardly with these factors.
"""
