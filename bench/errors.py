"""Says what the error of a record means. Rolling cases have that of the force vector, never negative, and that of
the spin moment beside it; all others have one signed error."""

MEANING = ("Rolling cases have two errors: that of the force vector, |(dFx, dFy)| / |(Fx, Fy)|, and that of the "
           "spin moment, |dMz| / (mu Fn sqrt(a b)), where a and b are the semi-axes of the contact. Where a "
           "longitudinal force is given, the creepage found takes its place. It is turned like the force, so a "
           "lateral force that should be zero counts as an error. Other errors have a sign. All are relative unless "
           "the text says otherwise.")


def rolling(r):
    return "moment_error" in r


def moment_error(r):
    """Returns None if it is not a rolling case, or a plane one."""
    return r.get("moment_error")


def judged(r):
    """Returns the larger one of both."""
    return max(abs(r["error"]), moment_error(r) or 0)


def uncertainty(r):
    """Returns the uncertainty of the reference, in the error that is judged."""
    return max(r["extra"].get("uncertainty", 0), r["extra"].get("uncertainty_moment", 0))


def _short(x, sign):
    return f"{100 * x:{sign}.{2 if abs(x) >= 1e-4 else 1}g} %"


def error_text(r):
    if not rolling(r):
        return _short(r["error"], "+")
    moment = moment_error(r)
    if moment is None:
        return _short(r["error"], "")
    return _short(r["error"], "") + (", moment " + _short(moment, "") if moment > 5e-6 else ", moment 0")


def percent(x, digits=2):
    """Formats an error that has no sign."""
    return "-" if x is None else f"{100 * x:.{digits}f} %"
