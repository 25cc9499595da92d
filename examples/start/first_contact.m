context = rollcon.context_create();
wheel = rollcon.body_create(context, 'halfspace');
rail = rollcon.body_create(context, 'halfspace');
rollcon.body_set_elastic(wheel, 0, 210e3, 0.28);
rollcon.body_set_elastic(rail, 0, 210e3, 0.28);
contact = rollcon.contact_create(context, wheel, rail);
rollcon.contact_set_gap_quadratic(contact, 1/920, 1/600);
rollcon.contact_set_friction(contact, 'coulomb', 0.3);
rollcon.contact_set_rolling(contact, 20e3);
rollcon.contact_set_creep(contact, -1e-3, 0, 0);
rollcon.contact_prescribe(contact, 'normal', 'force', 80e3);
rollcon.contact_solve(contact);
force = rollcon.contact_get_resultant(contact, 'local');
printf('driving force %.0f N, largest pressure %.0f MPa, approach %.4f mm\n', force(1), ...
       rollcon.contact_get_stat(contact, 'max_pressure'), rollcon.contact_get_motion(contact));
