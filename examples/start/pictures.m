warning('off', 'Octave:gnuplot-graphics');
graphics_toolkit('gnuplot');                              % here, where there is no screen
context = rollcon.context_create();
wheel = rollcon.body_create(context, 'halfspace');
rail = rollcon.body_create(context, 'halfspace');
rollcon.body_set_elastic(wheel, 0, 210e3, 0.28);          % MPa
rollcon.body_set_elastic(rail, 0, 210e3, 0.28);
contact = rollcon.contact_create(context, wheel, rail);
rollcon.contact_frame_rectangle(contact, 'quad4', 32, 24, -8, 8, -6, 6); % elements, mm
rollcon.contact_set_gap_quadratic(contact, 1/920, 1/600); % x^2/(2 460) + y^2/(2 300)
rollcon.contact_set_friction(contact, 'coulomb', 0.3);
rollcon.contact_set_rolling(contact, 30000);              % mm/s
rollcon.contact_prescribe(contact, 'normal', 'force', 80e3);
rollcon.contact_set_creep(contact, 1e-3, 5e-4, 1e-4);
status = rollcon.contact_solve(contact);
force = rollcon.contact_get_resultant(contact, 'local');
printf('force %.0f %.0f %.0f N, largest pressure %.0f MPa\n', force, ...
       rollcon.contact_get_stat(contact, 'max_pressure'));

x = rollcon.contact_get_field(contact, 'point', 'local');
t = rollcon.contact_get_tractions(contact, 'local');
figure('visible', 'off', 'position', [0, 0, 900, 300]);
subplot(1, 3, 1);
scatter(x(:, 1), x(:, 2), 12, -t(:, 3), 'filled');
axis equal; colorbar; title('pressure, MPa'); xlabel('x, mm'); ylabel('y, mm');
subplot(1, 3, 2);
quiver(x(:, 1), x(:, 2), t(:, 1), t(:, 2));
axis equal; title('traction on the wheel');
creep = linspace(0, 4e-3, 21)';
results = rollcon.contact_solve_many(contact, 'longitudinal', creep, 'force');
subplot(1, 3, 3);
plot(1e3 * creep, -results(:, 1) / (0.3 * 80e3), 'o-');
grid on; title('creep curve'); xlabel('creepage, 1/1000'); ylabel('-F_x / (mu F_n)');
print('-dpng', 'octave_wheel.png');
rollcon.contact_release(contact);
