package robotran.workshop.documents

import kotlinx.coroutines.delay
import robotran.documents.ProjectLock
import robotran.documents.RestoredProject
import robotran.workshop.platform.Platform
import robotran.workshop.service.Notices
import robotran.workshop.state.Notice

/** Finds the initial project of a window and reports what was restored. */
internal class ProjectRestoration(
    private val platform: Platform,
    private val notices: Notices,
    private val autosaver: DocumentAutosaver,
    private val guard: OpeningGuard,
) {
    /** The project that is not restored, because it stopped the app the last time; null if there is none. */
    var stopped: String? = null
        private set

    /**
     * The project to restore in this window: its own after a reload, otherwise the last open one; null for a new
     * project.
     *
     * @param isBroughtSomething whether files were passed to the window; they replace the last open project.
     */
    suspend fun take(hasIncomingFiles: Boolean): RestoredProject? {
        val own = platform.window.projectId
        for (id in platform.window.leftIds()) if (id != own) saveHandover(id)
        return when {
            own != null -> takeOwn(own)
            hasIncomingFiles || !platform.restoresLastProject -> null

            else -> autosaver.openProjects.takeBack(platform.window::hasEnded, ::mayOpen)
                ?: null.also { tellElsewhere() }
        }
    }

    /** Reports what was restored, unless everything was restored normally. */
    fun show(back: RestoredProject) {
        if (!back.endedAbnormally && back.others == 0) return
        notices.show(
            if (back.others > 0) {
                Notice.OtherProjectsOpen(back.endedAbnormally)
            } else {
                Notice.ProjectRestored(back.work.name)
            },
        )
    }

    /**
     * The project [id] that this window showed before; null if it is gone. If another window has it, reports that and
     * returns null.
     */
    private suspend fun takeOwn(id: String): RestoredProject? {
        val left = platform.window.left(id)
        if (left == null && id !in autosaver.repository.ids()) return null
        val claim = claim(id)
        if (claim == null) {
            notices.show(Notice.OwnProjectOpenElsewhere)
            return null
        }
        val back = if (mayOpen(id)) {
            autosaver.openProjects.takeBack(id, claim, platform.window.hasEnded(id), left)
        } else {
            autosaver.openProjects.closed(id, platform.clock.now, comesBack = false)
            null
        }
        if (back == null) claim.release()
        if (back?.isAutosaved == true && left != null) platform.window.leave(id, null)
        return back
    }

    /** Says where the work is of a pupil who opens a second window, in which another project begins. */
    private suspend fun tellElsewhere() {
        val id = autosaver.openProjects.elsewhere().firstOrNull() ?: return
        val name = autosaver.repository.projects().firstOrNull { it.id == id }?.name
        notices.show(Notice.LastProjectOpenElsewhere(name.orEmpty()))
    }

    /** Marks the project [id], which is restored next, unless it stopped the app the last time. */
    private fun mayOpen(id: String): Boolean {
        val hasStopped = guard.hasStopped(id)
        if (hasStopped) stopped = id else guard.begin(id)
        return !hasStopped
    }

    /** Stores the changes of project [id] that a closed window could not autosave. */
    private suspend fun saveHandover(id: String) {
        val left = platform.window.left(id) ?: return
        val claim = claim(id) ?: return
        if (autosaver.openProjects.saveHandover(id, left)) platform.window.leave(id, null)
        claim.release()
    }

    /** A page that is closing releases its project slightly after the next page opens. */
    private suspend fun claim(id: String): ProjectLock? {
        repeat(CLAIM_ATTEMPTS) {
            autosaver.repository.claim(id)?.let { return it }
            delay(CLAIM_PAUSE)
        }
        return autosaver.repository.claim(id)
    }

    private companion object {
        const val CLAIM_ATTEMPTS = 4
        const val CLAIM_PAUSE = 100L
    }
}
