package robotran.workshop.documents

import kotlinx.coroutines.delay
import robotran.documents.ProjectLock
import robotran.documents.RestoredProject
import robotran.workshop.platform.Platform
import robotran.workshop.service.Notices
import robotran.workshop.state.Notice

/** Finds the work with which a window begins, and says what is to be said about it. */
internal class ProjectRestoration(
    private val platform: Platform,
    private val notices: Notices,
    private val keeper: DocumentAutosaver,
) {
    /**
     * The work that comes back into this window: its own if it was loaded anew, otherwise what was open last; null if
     * it begins a new one.
     *
     * @param isBroughtSomething whether something was brought to the window, which takes the place of what was open
     * last.
     */
    suspend fun take(isBroughtSomething: Boolean): RestoredProject? {
        val own = platform.window.workId
        for (id in platform.window.leftIds()) if (id != own) keepLeft(id)
        return when {
            own != null -> takeOwn(own)
            isBroughtSomething || !platform.goesOn -> null
            else -> keeper.openWorks.takeBack(platform.window::hasEnded)
        }
    }

    /** Says what came back, if it did not come back as if nothing had been. */
    fun say(back: RestoredProject) {
        if (!back.wasCutShort && back.others == 0) return
        notices.say(
            if (back.others >
                0
            ) {
                Notice.OtherProjectsOpen(back.wasCutShort)
            } else {
                Notice.ProjectRestored(back.work.name)
            },
        )
    }

    /**
     * The work [id], which this window has shown before; null if it is gone, or if another window has it, which is then
     * said.
     */
    private suspend fun takeOwn(id: String): RestoredProject? {
        val left = platform.window.left(id)
        if (left == null && id !in keeper.shelf.ids()) return null
        val claim = claim(id)
        if (claim == null) {
            notices.say(Notice.OwnProjectOpenElsewhere)
            return null
        }
        val back = keeper.openWorks.takeBack(id, claim, platform.window.hasEnded(id), left)
        if (back == null) claim.release()
        if (back?.isKept == true && left != null) platform.window.leave(id, null)
        return back
    }

    /** Keeps what a window that is gone has left of the work [id], but could not keep any more. */
    private suspend fun keepLeft(id: String) {
        val left = platform.window.left(id) ?: return
        val claim = claim(id) ?: return
        if (keeper.openWorks.keepLeft(id, left)) platform.window.leave(id, null)
        claim.release()
    }

    /** A page that goes lets go of its work a little later than the next one comes. */
    private suspend fun claim(id: String): ProjectLock? {
        repeat(CLAIM_ATTEMPTS) {
            keeper.shelf.claim(id)?.let { return it }
            delay(CLAIM_PAUSE)
        }
        return keeper.shelf.claim(id)
    }

    private companion object {
        const val CLAIM_ATTEMPTS = 4
        const val CLAIM_PAUSE = 100L
    }
}
