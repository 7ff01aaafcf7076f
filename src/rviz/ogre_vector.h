// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_OGRE_VECTOR_H
#define DRILL_RIG_SIM_SRC_RVIZ_OGRE_VECTOR_H

// version_check.h needs it
#include <OgrePrerequisites.h>
#include <rviz/ogre_helpers/version_check.h>
#if OGRE_VERSION < OGRE_VERSION_CHECK(1, 12, 0)
#include <OgreVector3.h>
#else
#include <OgreVector.h>
#endif

/// Ogre's vectors by the header of its version. Newer versions of rviz have the same, 1.14.4 of Debian 11 has not.

#endif
