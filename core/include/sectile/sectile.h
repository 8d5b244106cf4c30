// Sectile: exact Boolean operations on polyhedral solids. This header brings all the others.
#pragma once

#include "sectile/arrangement.h"
#include "sectile/boolean.h"
#include "sectile/box_search.h"
#include "sectile/errors.h"
#include "sectile/exact_file.h"
#include "sectile/exact_transform.h"
#include "sectile/files.h"
#include "sectile/mesh.h"
#include "sectile/primitives.h"
#include "sectile/repair.h"
#include "sectile/rounding.h"
#include "sectile/solid.h"
#include "sectile/trace.h"
#include "sectile/transform.h"
#include "sectile/triangulation.h"
#include "sectile/validate.h"
