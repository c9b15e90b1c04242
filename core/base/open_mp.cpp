#include "open_mp.h"

#include "job.h"
#include "worker_team.h"

#include <omp.h>

namespace mirrorball {

OpenMpThreads::OpenMpThreads(int threads) : m_before(omp_get_max_threads()), m_several(threads > 1 && !WorkerTeam::isWorking())
{
    if (m_several)
        needThreads(threads);
    omp_set_num_threads(m_several ? threads : 1);
}

OpenMpThreads::~OpenMpThreads()
{
    omp_set_num_threads(m_before);
    if (m_several)
        omp_pause_resource_all(omp_pause_soft);
}

} // namespace mirrorball
