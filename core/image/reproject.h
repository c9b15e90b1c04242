#pragma once
#include "environment_map.h"
#include "../job.h"
namespace mirrorball { struct ReprojectOptions { MapLayout target{}; double yaw = 0.0; }; EnvironmentMap reproject(const EnvironmentMap& source, const ReprojectOptions&, const JobControl& = {}); }
