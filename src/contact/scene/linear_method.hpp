#pragma once
/// Names how the linear systems of an iteration are solved.

namespace rollcon {

/// Lists the methods; gmres_adaptive uses the tolerance of Kelley (1995), equations (72)-(74) of the paper.
enum class LinearMethod { automatic, lu, gmres, gmres_adaptive };
/// Lists the preconditioners of GMRES. diagonal: each pair's own block (published procedures: each unknown's own
/// entry); bodies: matrices of the bodies factorised once, pairs as on half-spaces (monolithic form only); kept_lu:
/// factors of an earlier system (condensed form only).
enum class Preconditioner { automatic, none, diagonal, bodies, kept_lu };

}  // namespace rollcon
