function varargout = last_caveat(varargin)
% LAST_CAVEAT  text = rollcon.last_caveat()
%
% Returns the text of the last call in this thread that returned a status above zero: name of the
% function, what the status means, and what is known of this case: how many nodes touch, how far the
% iteration came, where the frame ends. It is empty before the first one, and failures and successes
% do not change it. It is valid until the next such call in this thread; texts beyond 1023 bytes are
% cut.
%
% Nodes, elements and rows count from 1. Failures are errors rollcon:ERR_..., caveats are warnings.
% Generated from bindings/api.toml; do not edit.
[varargout{1:max(nargout, 1)}] = rollcon_mex('last_caveat', varargin{:});
end
