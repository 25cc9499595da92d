context = rollcon.context_create();
profiles = {'s1002', '60e1'};
for i = 1:2
  body(i) = rollcon.body_create(context, 'halfspace');
  rollcon.body_set_elastic(body(i), 0, 210e3, 0.28);
  rollcon.body_set_profile_shape(body(i), profiles{i}, 1);
end
wheel = rollcon.wheelrail_create(context, body(1), body(2), 'right');
rollcon.wheelrail_set_track(wheel, 1435, 14, atan(1/40));
rollcon.wheelrail_set_wheelset(wheel, 1360, -70, 460);
rollcon.wheelrail_set_friction(wheel, 'coulomb', 0.3);
rollcon.wheelrail_prescribe_vertical(wheel, 'force', 80e3);
rollcon.wheelrail_set_velocity(wheel, [20e3, 0, 0, 0, 0, -20e3/460]);
printf('   y  patches   Fx, kN   Fy, kN   Fz, kN\n');
for y = 0:2:6
  rollcon.wheelrail_set_position(wheel, [0, y, 0, 0, 0, 0]);
  rollcon.wheelrail_solve(wheel);
  force = rollcon.wheelrail_get_resultant(wheel);
  printf('%4d %8d %8.2f %8.2f %8.2f\n', y, rollcon.wheelrail_get_patch_count(wheel), force / 1e3);
end
