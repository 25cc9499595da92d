"""Says in docs/procedures.md what is not in numbers."""

OPTIONS = """The standard procedure eliminates the bodies' unknowns once and solves the contact by an
exact semismooth Newton iteration with a start and fallbacks of its own ([theory](theory.md)). The
procedures of Rodriguez-Tembleque and Abascal (Int. J. Solids Struct. 47, 2010, section 11; numbers in
brackets are its equations) are options of a contact:

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

Combinations that make no sense are refused with the reason. With directions of friction frozen
(`simplified`, `reduced`) nothing in the system depends on an unknown creepage once every pair slides,
and the matrix is singular; such a step takes all pairs in contact for sticking instead.

### Error function

`rollcon_contact_get_error_function` gives the error function of every iteration and when it was
reached: half the sum of the squared residuals of the contact laws over all nodes, each over the
largest pressure or tangential traction of the iterate, and of the squared relative errors of the
loads, times the nodes in contact.
"""

CHOICE = """## Which to choose

- The default (condensed, exact). It converges in about ten iterations from nothing and in two or three
  after a small change, needs no parameter, and is the only one with fallbacks. What it costs: the
  compliance of the bodies, once for a pair of meshes; after that a solve works on the nodes in contact
  alone.
- `b_derivative` takes a few iterations more for want of a start, and was as reliable here.
- `simplified` and `reduced` converge linearly: the direction of friction (and the slip of sticking
  pairs) is always one iterate old. They take tens to hundreds of iterations, more on finer meshes.
  Their systems are smaller and better conditioned, which GMRES with adaptive tolerance turns to
  account; it does not make up for their number.
- **Where they fail:** a tangential load given, and hardly a pair sticks. Frozen directions then leave
  the creepage undetermined (above), and the iteration goes to and fro between full stick and full
  slip. With creepages given they never failed here.
- `reduced` hands the news of a sticking particle's displacement from node to node, one iteration each,
  and a shift of the whole sticking zone decays only by as much as the node ahead of it stays behind.
  Where bodies give way as a whole, that is little: the rings of example 1 take a thousand iterations, parts
  of them, held at their ends, a hundred and fifty.
- `pseudo_temporal` uses one time step for all nodes, that of the fastest passed; nodes on larger cells
  relax slowly, and with least squares the sphere's frame did not converge. The paper's step of 0.15,
  whose unit it does not give, is too small in units of the shortest passing time (no convergence within
  thousands of iterations); here it is 1. `extrapolation` saves up to a sixth of Jacobi's iterations.
- Adaptive tolerance: while the outer iteration converges linearly, (73) stays near its bound
  `linear_tolerance`, and an error of that part of the residual is fed back. With a bound of 0.5
  `reduced` needs twice the iterations or does not converge; the default is 0.01.
- `monolithic` needs no compliance of the bodies, and with GMRES, adaptive tolerance and the bodies'
  factors a cold solve costs a few times what the standard's does. It was never faster here, and every
  re-solve costs it nearly as much as the first.
- Preconditioners: without one GMRES needs hundreds to thousands of iterations for the monolithic system,
  because stiffness, tractions and gaps differ by orders. The bodies' own factors make the number of
  iterations independent of the mesh; factors of an earlier iteration of the whole took 1.7 to 3.3 times as long on
  every mesh, as they had to be made anew when the contact changed, and are left to the condensed
  system. In that the number without preconditioner grows like the nodes across the contact, with kept
  factors hardly.
"""
