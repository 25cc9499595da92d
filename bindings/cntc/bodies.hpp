#pragma once
#include "dispatch.hpp"

// Declares the bodies of the functions that functions.inc lists: scalars are values, outputs are references, arrays are
// pointers.
namespace cntc {

void set_file_units(const char* name, const int* nunits, const int* iunits);
void initialize_first(const char* name, int* version, int* error, const int* ioutput, const char* wrkdir,
                      const char* outdir, const char* expnam, const int* len_wrkdir, const int* len_outdir,
                      const int* len_expnam);
void initialize(const char* name, const int* ire, const int* module, int* version, int* error, const char* outdir,
                const int* len_outdir);
void set_global_flags(const char* name, const int* n, const int* params, const int* values);
void get_max_threads(const char* name, int* threads);
void finalize(const char* name, const int* ire);
void finalize_last();

void set_reference_velocity(Call& c, double veloc);
void set_hertz_contact(Call& c, int ipotcn, int n, const double* params);
void set_penetration(Call& c, double pen);
void set_normal_force(Call& c, double fn);
void set_undeformed_distance(Call& c, int ibase, int n, const double* params);
void set_creepages(Call& c, double vx, double vy, double phi);
void set_extra_slip(Call& c, int n, const double* wx, const double* wy);
void get_hertz_contact(Call& c, int n, double* values);

void read_inp_file(Call& c, int type, const char* fname, int length, ErrorCode error);
void set_vertical_force(Call& c, double fz);
void set_profile_file(Call& c, const char* fname, int length, int nints, const int* ints, int nreals,
                      const double* reals);
void set_profile_values(Call& c, int npoint, const double* values, int nints, const int* ints, int nreals,
                        const double* reals);
void keep_profile_file(Call& c, std::string path, bool wheel, ProfileOptions options);
void set_track(Call& c, int kind, int n, const double* params);
void set_wheelset_dimensions(Call& c, int kind, int n, const double* params);
void set_wheelset_position(Call& c, int kind, int n, const double* params);
void set_wheelset_velocity(Call& c, int kind, int n, const double* params);
void set_wheelset_flexibility(Call& c, int kind, int n, const double* params);
void get_profile_values(Call& c, int task, int nints, const int* ints, int nreals, const double* reals, int n,
                        double* values);
void get_wheelset_position(Call& c, int n, double* values);
void get_wheelset_velocity(Call& c, int n, double* values);
void get_patch_count(Call& c, int& patches);
void get_location(Call& c, int n, double* values);
void get_global_forces(Call& c, int n, double* values);

void set_flags(Call& c, int n, const int* params, const int* values);
void set_metadata(Call& c, int n, const int* params, const double* values);
void set_solver_flags(Call& c, int g, int nints, const int* ints, int nreals, const double* reals);
void set_material(Call& c, int method, int n, const double* params);
void set_time_step(Call& c, double dt);
void set_rolling_step(Call& c, double chi, double dq);
void set_friction(Call& c, int method, int n, const double* params);
void set_potential_contact(Call& c, int ipotcn, int n, const double* params);
void set_tangential_forces(Call& c, double fx, double fy);
void set_temperature_data(Call& c, int method, int n, const double* params);
void calculate(Call& c, ErrorCode error);

void get_flags(Call& c, int n, const int* params, int* values);
void get_grid_steps(Call& c, double& dx, double& dy);
void get_parameters(Call& c, const Totals& r, int task, int n, double* values);
void get_reference_velocity(Call& c, const Totals& r, double& veloc);
void get_element_numbers(Call& c, const ContactResult& r, int& mx, int& my);
void get_potential_contact(Call& c, const ContactResult& r, int n, double* values);
void get_penetration(Call& c, const Totals& r, double& pen);
void get_creepages(Call& c, const Totals& r, double& vx, double& vy, double& phi);
void get_contact_forces(Call& c, const Totals& r, double& fn, double& tx, double& ty, double& mz);
void get_areas(Call& c, const ContactResult& r, double& contact, double& stick, double& slip);
void get_element_division(Call& c, const ContactResult& r, int n, int* division);
void get_max_pressure(Call& c, const Totals& r, double& value);
void get_max_traction(Call& c, const ContactResult& r, double& value);
void get_max_temperature(Call& c, const ContactResult& r, double& t1, double& t2);
void get_field(Call& c, const ContactResult& r, int field, int n, double* values);
void get_tractions(Call& c, const ContactResult& r, int n, double* pn, double* px, double* py);
void get_slip(Call& c, const ContactResult& r, int n, double* sx, double* sy);
void get_displacements(Call& c, const ContactResult& r, int n, double* un, double* ux, double* uy);
void get_sensitivities(Call& c, const Totals& r, int rows, int columns, double* values);
void get_calculation_time(Call& c, double& cpu, double& wall);
void reset_calculation_time(Call& c);
void get_block_size(Call& c, int block, int& nx, int& ny, int& nz);
void get_block_results(Call& c, int block, int n, int columns, const int* which, double* values);
void add_block(Call& c, int block, int isubs, int npx, int npy, int npz, const double* x, const double* y,
               const double* z);
void calculate_subsurface(Call& c, ErrorCode error);

}  // namespace cntc
