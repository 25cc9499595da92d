function rollcon_build(varargin)
% ROLLCON_BUILD  Compiles the gateway to the library: once, in MATLAB or Octave.
%
%   rollcon_build            with the flags that pkg-config has for rollcon
%   rollcon_build(flags...)  with these: rollcon_build('-I/opt/rollcon/include', '-L/opt/rollcon/lib', '-lrollcon')
%
% Then addpath this folder. The functions are rollcon.context_create, ...; help rollcon.body_create tells of each.
here = fileparts(mfilename('fullpath'));
if ~exist(fullfile(here, 'rollcon_calls.c'), 'file')
  error('rollcon:build', ['%s has no rollcon_calls.c: in sources from git, "python3 bindings/generate.py" writes it ' ...
                          'and the functions'], here);
end
flags = varargin;
if isempty(flags)
  [status, text] = system('pkg-config --cflags --libs rollcon');
  if status ~= 0
    error('rollcon:build', 'pkg-config does not know rollcon: set PKG_CONFIG_PATH, or give the flags');
  end
  flags = strsplit(strtrim(text));
  % The place of the library, where it is none of the system's.
  places = flags(strncmp(flags, '-L', 2));
  if exist('OCTAVE_VERSION', 'builtin')
    flags = [flags, strcat('-Wl,-rpath,', strrep(places, '-L', ''))];
  elseif ~isempty(places)
    flags = [flags, {['LDFLAGS=$LDFLAGS ', strjoin(strcat('-Wl,-rpath,', strrep(places, '-L', '')))]}];
  end
end
sources = {fullfile(here, 'gateway.c'), fullfile(here, 'rollcon_calls.c')};
if exist('OCTAVE_VERSION', 'builtin')
  mex('-o', fullfile(here, ['rollcon_mex.', mexext()]), ['-I', here], sources{:}, flags{:});
  objects = {'gateway.o', 'rollcon_calls.o'};
  for i = 1:numel(objects)
    if exist(objects{i}, 'file'), delete(objects{i}); end
  end
else
  mex('-output', 'rollcon_mex', '-outdir', here, ['-I', here], sources{:}, flags{:});
end
end
