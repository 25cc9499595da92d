% The package for MATLAB and Octave: values arrive in their places and come back, failures are errors with names.
1;

function within(what, value, bound)
  printf('%-50s error %9.2e  bound %8.1e\n', what, value, bound);
  assert(value <= bound, what);
end

function fails(id, words, code)
  try
    code();
  catch e
    assert(e.identifier, ['rollcon:', id]);
    assert(~isempty(strfind(e.message, words)), e.message);
    return
  end
  error(['no error: ', words]);
end

context = rollcon.context_create();

% Facts: texts and numbers.
assert(ischar(rollcon.version_string()) && rollcon.version() > 0);
assert(rollcon.has_feature('halfspace'), 1);
assert(rollcon.status_string(0), 'success');

% Every function is there and says which argument it misses, or that there are too many; each has a help text.
here = getenv('ROLLCON_OCTAVE');
files = dir(fullfile(here, '+rollcon', '*.m'));
assert(numel(files) > 130);
for k = 1:numel(files)
  verb = files(k).name(1:end - 2);
  try
    feval(['rollcon.', verb], -1, [], [], [], [], [], [], [], [], [], [], [], [], [], [], []);
    error('rollcon:none', verb);
  catch e
    assert(any(strcmp(e.identifier, {'rollcon:ERR_ARGUMENT'})), [verb, ': ', e.message]);
    assert(~isempty(strfind(e.message, verb)), e.message);
  end
  text = fileread(fullfile(here, '+rollcon', files(k).name));
  assert(~isempty(strfind(text, ['% ', upper(verb), '  '])), verb);
end
printf('%d functions answer\n', numel(files));

% A Hertzian contact: load by approach, R = 100 and 100, against the closed form.
E = 1000; nu = 0.25;
a = rollcon.body_create(context, 'halfspace');
b = rollcon.body_create(context, 'rigid');
rollcon.body_set_elastic(a, 0, E, nu);
contact = rollcon.contact_create(context, a, b);
rollcon.contact_frame_rectangle(contact, 'quad4', 40, 40, -2, 2, -2, 2);
rollcon.contact_set_gap_quadratic(contact, 1/200, 1/200);
rollcon.contact_prescribe(contact, 'normal', 'motion', 0.02);
rollcon.contact_set_friction(contact, 'coulomb', 0);
assert(rollcon.contact_solve(contact), 0);
force = rollcon.contact_get_resultant(contact, 'local');
assert(size(force), [1, 3]);
radius = sqrt(100 * 0.02);
exact = 4/3 * E / (1 - nu^2) * sqrt(100) * 0.02^1.5;
within('Hertz: normal force', abs(force(3) + exact) / exact, 0.005);
x = rollcon.contact_get_field(contact, 'point', 'local');
t = rollcon.contact_get_tractions(contact, 'local');
assert(size(x), [41^2, 3]);
inside = hypot(x(:, 1), x(:, 2)) < 0.7 * radius;
p0 = 1.5 * exact / (pi * radius^2);
p = p0 * sqrt(1 - (x(inside, 1).^2 + x(inside, 2).^2) / radius^2);
within('Hertz: pressures where they belong', max(abs(-t(inside, 3) - p)) / p0, 0.01);
states = rollcon.contact_get_node_states(contact);
assert(numel(states), 41^2);
assert(sum(states ~= 0), sum(t(:, 3) < 0));

% A list of cases says what single solves say; columns stand in their places.
[results, status] = rollcon.contact_solve_many(contact, 'normal', [0.01; 0.02; 0.03], 'force approach max_pressure');
assert(size(results), [3, 5]);
assert(status', [0, 0, 0]);
within('a case of the list: force', abs(results(2, 3) - force(3)) / exact, 1e-9);
within('a case of the list: approach', abs(results(3, 4) - 0.03), 1e-12);
within('a case of the list: pressure', abs(results(2, 5) - max(-t(:, 3))) / p0, 1e-9);
fails('ERR_ARGUMENT', 'values has 2 column(s); needed: 1', ...
      @() rollcon.contact_solve_many(contact, 'normal', [1, 2], 'force'));

% Caveats are warnings, and the status is returned.
rollcon.contact_prescribe(contact, 'normal', 'motion', -1);
assert(rollcon.contact_solve(contact), 2);
[~, id] = lastwarn();
assert(id, 'rollcon:NO_CONTACT');

% Failures are errors with the text of the library, or name the argument.
fails('ERR_ARGUMENT', 'speed is -1', @() rollcon.contact_set_rolling(contact, -1));
fails('ERR_HANDLE', 'no live contact', @() rollcon.contact_solve(context));
fails('ERR_ARGUMENT', 'direction is ''up''; allowed: longitudinal, lateral, normal, spin', ...
      @() rollcon.contact_prescribe(contact, 'up', 'force', 1));
fails('ERR_ARGUMENT', 'speed is not one real number', @() rollcon.contact_set_rolling(contact, [1, 2]));
fails('ERR_ARGUMENT', 'speed is missing', @() rollcon.contact_set_rolling(contact));
fails('ERR_ARGUMENT', '1 argument(s) too many', @() rollcon.contact_set_rolling(contact, 1, 2));
fails('ERR_ARGUMENT', 'tag is no integer', @() rollcon.body_set_elastic(a, 0.5, 1, 0));
fails('ERR_ARGUMENT', 'there is no function ''nothing''', @() rollcon_mex('nothing'));

% Meshes: rows are nodes and elements, which count from 1; a bar by hand and one from a file stretch alike.
if rollcon.has_feature('fem')
  [X, Y, Z] = ndgrid([0, 1], [0, 1], [0, 1, 2]);
  x = [X(:), Y(:), Z(:)];
  hexahedra = [1, 2, 4, 3, 5, 6, 8, 7; 5, 6, 8, 7, 9, 10, 12, 11];
  for from_file = [false, true]
    bar = rollcon.body_create(context, 'fem');
    if from_file
      rollcon.body_read_mesh(bar, fullfile(getenv('ROLLCON_TEST_DATA'), 'meshes', 'hex8.inp'));
      assert(rollcon.body_get_group_count(bar), 6);
      assert(rollcon.body_get_group_name(bar, 5), 'High_End');
      low = rollcon.body_get_group_nodes(bar, 'low_end');
      assert(low', [1, 2, 3, 4]);
      rollcon.body_tag_group(bar, 'high_end', 7);
      high = rollcon.body_get_group_nodes(bar, 'high_end');
    else
      rollcon.body_set_nodes(bar, x);
      rollcon.body_add_elements(bar, 'hex8', hexahedra, 0);
      rollcon.body_tag_faces(bar, 2, 2, 7);
      low = find(x(:, 3) == 0);
      high = find(x(:, 3) == 2);
    end
    rollcon.body_set_elastic(bar, 0, 1000, 0);
    rollcon.body_set_support(bar, low, 'x y z');
    rollcon.body_set_traction(bar, 7, [0, 0, 3]);
    rollcon.body_prepare(bar);
    u = rollcon.body_get_displacements(bar);
    within('a bar under tension: its end', max(abs(u(high, 3) - 0.006)), 1e-12);
    [force, moment] = rollcon.body_get_reaction(bar);
    within('a bar under tension: its reaction', norm(force - [0, 0, -3]), 1e-12);
    rollcon.body_release(bar);
  end
  fails('ERR_HANDLE', 'no live body', @() rollcon.body_prepare(bar));
end

% Rows in, rows out: stresses, tables.
[principal, von_mises, shear] = rollcon.stress_invariants([1, 2, 3, 0, 0, 0; 5, 0, 0, 0, 0, 0]);
within('principal stresses', max(max(abs(sort(principal, 2) - [1, 2, 3; 0, 0, 5]))), 1e-14);
within('von Mises', max(abs(von_mises - [sqrt(3); 5])), 1e-14);
within('largest shear', max(abs(shear - [1; 2.5])), 1e-14);
tabled = rollcon.table_standard(context);
% Shear modulus, Poisson's ratio, friction, half axes, load, creepages, spin.
inputs = [80769, 0.3, 0.3, 5, 4, 1e5, 1e-3, 0, 0; 80769, 0.3, 0.3, 5, 4, 1e5, 0, 1e-3, 0];
results = rollcon.table_evaluate(tabled, inputs);
assert(size(results), [2, 3]);
assert(abs(results(1, 1)) > 100 * abs(results(1, 2)) && abs(results(2, 2)) > 100 * abs(results(2, 1)));
[again, slopes] = rollcon.table_evaluate_derivatives(tabled, inputs);
within('a table twice', max(max(abs(again - results))), 0);
assert(size(slopes), [2, 27]);
h = 1e-6;
moved = rollcon.table_evaluate(tabled, inputs + [0, 0, 0, 0, 0, 0, h, 0, 0]);
slope = (moved(1, 1) - results(1, 1)) / h;   % of the first result by the seventh input
within('a derivative in its place', abs(slopes(1, 7) - slope) / abs(slope), 1e-2);

% Profiles: points (y, z) are rows.
rail = rollcon.body_create(context, 'rigid');
rollcon.body_set_profile(rail, [-1, 0; 0, 0; 1, 0; 2, 0]);
within('length of a profile', abs(rollcon.body_get_profile_length(rail) - 3), 1e-12);
[point, tangent, curvature] = rollcon.body_get_profile_point(rail, 1);
within('a point of it', norm(point - [0, 0]) + norm(tangent - [1, 0]) + abs(curvature), 1e-12);

rollcon.contact_release(contact);
rollcon.context_release(context);
printf('all is well\n');
