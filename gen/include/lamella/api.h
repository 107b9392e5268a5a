/* What every public header starts from: version, export and linkage. Included by all of them. */
#ifndef LAMELLA_API_H
#define LAMELLA_API_H

/* The version of these headers; lam_version() is that of the library that runs. */
#define LAM_VERSION_MAJOR 0
#define LAM_VERSION_MINOR 1
#define LAM_VERSION_PATCH 0
#define LAM_VERSION "0.1.0"
/* For #if: LAM_VERSION_NUMBER >= 100 * (100 * 0 + 1) + 0 is version 0.1.0 or later. */
#define LAM_VERSION_NUMBER (100 * (100 * LAM_VERSION_MAJOR + LAM_VERSION_MINOR) + LAM_VERSION_PATCH)

/* Only what is marked so is visible in the shared library. */
#if defined(__GNUC__)
#define LAM_API __attribute__((visibility("default")))
#else
#define LAM_API
#endif

/* Around the declarations of a header: C++ programs see C functions. */
#ifdef __cplusplus
#define LAM_BEGIN_DECLS extern "C" {
#define LAM_END_DECLS }
#else
#define LAM_BEGIN_DECLS
#define LAM_END_DECLS
#endif

#endif
