/*
 * rollcon's answers to the library interface of CONTACT: the same symbols, units and signs, computed by rollcon.
 *
 * Copyright (c) the rollcon authors. BSD-3-Clause.
 *
 * Every argument is a pointer; inputs are not changed. Each function is exported a second time with an underscore
 * behind its name. docs/contact.md tells what is different from CONTACT.
 */
#ifndef ROLLCON_CNTC_H
#define ROLLCON_CNTC_H

#ifndef CNTC_API
#if defined(_WIN32) && defined(CNTC_BUILDING)
#define CNTC_API __declspec(dllexport)
#elif defined(_WIN32)
#define CNTC_API __declspec(dllimport)
#elif defined(__GNUC__)
#define CNTC_API __attribute__((visibility("default")))
#else
#define CNTC_API
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Units (if_units and what it takes), control digits, further flags, inputs, metadata, fields, errors. */
enum {
  CNTC_if_units = 1933,
  CNTC_un_cntc = 1934,
  CNTC_un_spck = 1935,
  CNTC_un_si = 1936,
  CNTC_un_imper = 1937,
  CNTC_ic_config = 1967,
  CNTC_ic_pvtime = 1970,
  CNTC_ic_bound = 1971,
  CNTC_ic_tang = 1972,
  CNTC_ic_norm = 1973,
  CNTC_ic_force = 1974,
  CNTC_ic_frclaw = 1976,
  CNTC_ic_discns = 1977,
  CNTC_ic_inflcf = 1978,
  CNTC_ic_mater = 1979,
  CNTC_ic_exrhs = 1980,
  CNTC_ic_xflow = 1981,
  CNTC_ic_heat = 1982,
  CNTC_ic_iestim = 1983,
  CNTC_ic_output = 1984,
  CNTC_ic_flow = 1985,
  CNTC_ic_return = 1986,
  CNTC_ic_matfil = 1987,
  CNTC_ic_sens = 1988,
  CNTC_ic_ifmeth = 1989,
  CNTC_ic_ifvari = 1990,
  CNTC_ic_sbsout = 1991,
  CNTC_ic_sbsfil = 1992,
  CNTC_ic_npomax = 1993,
  CNTC_if_idebug = 2000,
  CNTC_if_licdbg = 2001,
  CNTC_if_wrtinp = 2002,
  CNTC_if_openmp = 2003,
  CNTC_if_timers = 2004,
  CNTC_if_ncase = 2005,
  CNTC_if_frames = 2901, /* is rollcon's own: 1 solves on frames that rollcon makes (docs/contact.md) */
  CNTC_inp_vamp = 1984,
  CNTC_inp_modul1 = 1988,
  CNTC_inp_spck = 1990,
  CNTC_inp_gensys = 1992,
  CNTC_mt_tim = 2011,
  CNTC_mt_xr = 2012,
  CNTC_mt_yr = 2013,
  CNTC_mt_xw = 2014,
  CNTC_mt_yw = 2015,
  CNTC_mt_sw = 2016,
  CNTC_mt_run = 2021,
  CNTC_mt_axle = 2022,
  CNTC_mt_side = 2023,
  CNTC_fld_h = 1,
  CNTC_fld_mu = 2,
  CNTC_fld_px = 3,
  CNTC_fld_py = 4,
  CNTC_fld_pn = 5,
  CNTC_fld_ux = 7,
  CNTC_fld_uy = 8,
  CNTC_fld_un = 9,
  CNTC_fld_taucrt = 11,
  CNTC_fld_uplsx = 12,
  CNTC_fld_uplsy = 13,
  CNTC_fld_sx = 15,
  CNTC_fld_sy = 16,
  CNTC_fld_temp1 = 20,
  CNTC_fld_temp2 = 21,
  CNTC_fld_wx = 22,
  CNTC_fld_wy = 23,
  CNTC_err_allow = -12,
  CNTC_err_search = -25,
  CNTC_err_ftot = -26,
  CNTC_err_norm = -27,
  CNTC_err_tang = -28,
  CNTC_err_tol = -29,
  CNTC_err_icp = -31,
  CNTC_err_profil = -32,
  CNTC_err_frclaw = -33,
  CNTC_err_discr = -34,
  CNTC_err_input = -39,
  CNTC_err_other = -99,
  CNTC_err_broydn = -26,
  CNTC_FLAGS_DIM = 25
};

CNTC_API void cntc_setfileunits(const int* nunits, const int* iunits);
CNTC_API void cntc_initializefirst(int* ifcver, int* ierror, const int* ioutput, const char* wrkdir, const char* outdir,
                                   const char* expnam, const int* len_wrkdir, const int* len_outdir,
                                   const int* len_expnam);
CNTC_API void cntc_initializefirst_new(int* ifcver, int* ierror, const int* ioutput, const char* wrkdir,
                                       const char* outdir, const char* expnam, const int* len_wrkdir,
                                       const int* len_outdir, const int* len_expnam);
CNTC_API void cntc_initialize(const int* ire, const int* imodul, int* ifcver, int* ierror, const char* outdir,
                              const int* len_outdir);
CNTC_API void cntc_setglobalflags(const int* lenflg, const int* params, const int* values);
CNTC_API void cntc_getmaxnumthreads(int* mxthrd);
CNTC_API void cntc_finalize(const int* ire);
CNTC_API void cntc_finalizelast(void);
CNTC_API void cntc_setreferencevelocity(const int* ire, const int* icp, const double* veloc);
CNTC_API void cntc_sethertzcontact(const int* ire, const int* icp, const int* ipotcn, const int* nparam,
                                   const double* params);
CNTC_API void cntc_setpenetration(const int* ire, const int* icp, const double* pen);
CNTC_API void cntc_setnormalforce(const int* ire, const int* icp, const double* fn);
CNTC_API void cntc_setundeformeddistc(const int* ire, const int* icp, const int* ibase, const int* nparam,
                                      const double* prmudf);
CNTC_API void cntc_setcreepages(const int* ire, const int* icp, const double* vx, const double* vy, const double* phi);
CNTC_API void cntc_setextrarigidslip(const int* ire, const int* icp, const int* lenarr, const double* wx,
                                     const double* wy);
CNTC_API void cntc_gethertzcontact(const int* ire, const int* icp, const int* lenarr, double* rvalues);
CNTC_API void cntc_calculate3(const int* ire, const int* icp, int* ierror);
CNTC_API void cntc_readinpfile(const int* ire, const int* inp_type, const char* fname, const int* len_fname,
                               int* ierror);
CNTC_API void cntc_setverticalforce(const int* ire, const double* fz);
CNTC_API void cntc_setprofileinputfname(const int* ire, const char* fname, const int* len_fname, const int* nints,
                                        const int* iparam, const int* nreals, const double* rparam);
CNTC_API void cntc_setprofileinputvalues(const int* ire, const int* npoint, const double* values, const int* nints,
                                         const int* iparam, const int* nreals, const double* rparam);
CNTC_API void cntc_settrackdimensions(const int* ire, const int* ztrack, const int* nparam, const double* params);
CNTC_API void cntc_setwheelsetdimensions(const int* ire, const int* ewheel, const int* nparam, const double* params);
CNTC_API void cntc_setwheelsetposition(const int* ire, const int* ewheel, const int* nparam, const double* params);
CNTC_API void cntc_setwheelsetvelocity(const int* ire, const int* ewheel, const int* nparam, const double* params);
CNTC_API void cntc_setwheelsetflexibility(const int* ire, const int* ewheel, const int* nparam, const double* params);
CNTC_API void cntc_getprofilevalues(const int* ire, const int* itask, const int* nints, const int* iparam,
                                    const int* nreals, const double* rparam, const int* lenarr, double* val);
CNTC_API void cntc_getprofilevalues_new(const int* ire, const int* itask, const int* nints, const int* iparam,
                                        const int* nreals, const double* rparam, const int* lenarr, double* val);
CNTC_API void cntc_getwheelsetposition(const int* ire, const int* lenarr, double* rvalues);
CNTC_API void cntc_getwheelsetvelocity(const int* ire, const int* lenarr, double* rvalues);
CNTC_API void cntc_getnumcontactpatches(const int* ire, int* npatch);
CNTC_API void cntc_calculate1(const int* ire, int* ierror);
CNTC_API void cntc_getcontactlocation(const int* ire, const int* icp, const int* lenarr, double* rvalues);
CNTC_API void cntc_getglobalforces(const int* ire, const int* icp, const int* lenarr, double* rvalues);
CNTC_API void cntc_setflags(const int* ire, const int* icp, const int* lenflg, const int* params, const int* values);
CNTC_API void cntc_setmetadata(const int* ire, const int* icp, const int* lenmta, const int* params,
                               const double* values);
CNTC_API void cntc_setsolverflags(const int* ire, const int* icp, const int* gdigit, const int* nints,
                                  const int* iparam, const int* nreals, const double* rparam);
CNTC_API void cntc_setmaterialparameters(const int* ire, const int* icp, const int* imeth, const int* nparam,
                                         const double* rparam);
CNTC_API void cntc_settimestep(const int* ire, const int* icp, const double* dt);
CNTC_API void cntc_setrollingstepsize(const int* ire, const int* icp, const double* chi, const double* dq);
CNTC_API void cntc_setfrictionmethod(const int* ire, const int* icp, const int* imeth, const int* nparam,
                                     const double* params);
CNTC_API void cntc_setpotcontact(const int* ire, const int* icp, const int* ipotcn, const int* nparam,
                                 const double* params);
CNTC_API void cntc_settangentialforces(const int* ire, const int* icp, const double* fx, const double* fy);
CNTC_API void cntc_calculate(const int* ire, const int* icp, int* ierror);
CNTC_API void cntc_getparameters(const int* ire, const int* icp, const int* itask, const int* lenarr, double* values);
CNTC_API void cntc_getreferencevelocity(const int* ire, const int* icp, double* veloc);
CNTC_API void cntc_getnumelements(const int* ire, const int* icp, int* mx, int* my);
CNTC_API void cntc_getpotcontact(const int* ire, const int* icp, const int* lenarr, double* rvalues);
CNTC_API void cntc_getpenetration(const int* ire, const int* icp, double* pen);
CNTC_API void cntc_getcreepages(const int* ire, const int* icp, double* vx, double* vy, double* phi);
CNTC_API void cntc_getcontactforces(const int* ire, const int* icp, double* fn, double* tx, double* ty, double* mz);
CNTC_API void cntc_getcontactpatchareas(const int* ire, const int* icp, double* carea, double* harea, double* sarea);
CNTC_API void cntc_getelementdivision(const int* ire, const int* icp, const int* lenarr, int* eldiv);
CNTC_API void cntc_getmaximumpressure(const int* ire, const int* icp, double* pnmax);
CNTC_API void cntc_getmaximumtraction(const int* ire, const int* icp, double* ptmax);
CNTC_API void cntc_getmaximumtemperature(const int* ire, const int* icp, double* t1max, double* t2max);
CNTC_API void cntc_getfielddata(const int* ire, const int* icp, const int* ifld, const int* lenarr, double* fld);
CNTC_API void cntc_gettractions(const int* ire, const int* icp, const int* lenarr, double* pn, double* px, double* py);
CNTC_API void cntc_getmicroslip(const int* ire, const int* icp, const int* lenarr, double* sx, double* sy);
CNTC_API void cntc_getdisplacements(const int* ire, const int* icp, const int* lenarr, double* un, double* ux,
                                    double* uy);
CNTC_API void cntc_getsensitivities(const int* ire, const int* icp, const int* lenout, const int* lenin, double* sens);
CNTC_API void cntc_getcalculationtime(const int* ire, const int* icp, double* tcpu, double* twall);
CNTC_API void cntc_resetcalculationtime(const int* ire, const int* icp);
CNTC_API void subs_getblocksize(const int* ire, const int* icp, const int* iblk, int* nx, int* ny, int* nz);
CNTC_API void subs_getresults(const int* ire, const int* icp, const int* iblk, const int* lenarr, const int* ncol,
                              const int* icol, double* values);
CNTC_API void cntc_settemperaturedata(const int* ire, const int* icp, const int* imeth, const int* nparam,
                                      const double* params);
CNTC_API void cntc_getflags(const int* ire, const int* icp, const int* lenflg, const int* params, int* values);
CNTC_API void cntc_getgriddiscretization(const int* ire, const int* icp, double* dx, double* dy);
CNTC_API void subs_addblock(const int* ire, const int* icp, const int* iblk, const int* isubs, const int* npx,
                            const int* npy, const int* npz, const double* xparam, const double* yparam,
                            const double* zparam);
CNTC_API void subs_calculate(const int* ire, const int* icp, int* ierror);

#ifdef __cplusplus
}
#endif

#endif
