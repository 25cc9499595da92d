context = rollcon.context_create();
ring = rollcon.body_create(context, 'halfspace');
roller = rollcon.body_create(context, 'halfspace');
rollcon.body_set_elastic(ring, 0, 208e3, 0.3);
rollcon.body_set_elastic(roller, 0, 208e3, 0.3);
rollcon.body_set_profile_shape(ring, 'line', [10, 0]);           % half width, slope
rollcon.body_revolve_profile(ring, [0, 0, -30], [0, 1, 0], 30);  % its centre, its axis, its radius
rollcon.body_set_profile_shape(roller, 'arc', [2000, 5]);        % radius of the crown, half width
rollcon.body_revolve_profile(roller, [0, 0, 6], [0, 1, 0], 6);
contact = rollcon.contact_create(context, ring, roller);
rollcon.contact_set_friction(contact, 'coulomb', 0.05);
rollcon.contact_prescribe(contact, 'normal', 'force', 1500);
printf('tilt, mrad  pressure, MPa  approach, um\n');
for tilt = [0, 1e-4, 2e-4]
  rollcon.contact_set_pose(contact, 'body2', [1, 0, 0; 0, 1, -tilt; 0, tilt, 1], [0, 0, 0]);
  rollcon.contact_solve(contact);
  printf('%10.1f %14.0f %13.2f\n', 1e3 * tilt, rollcon.contact_get_stat(contact, 'max_pressure'), ...
         1e3 * rollcon.contact_get_motion(contact));
end
