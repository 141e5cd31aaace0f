package robotran.workshop.documents

import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import robotran.workshop.service.Notices
import robotran.workshop.state.DocumentAnswer
import robotran.workshop.state.Notice

/**
 * Puts another project in place of the open one, one after the other, and only if nothing is lost by it or the pupil
 * does not mind.
 */
internal class ProjectReplacement(
    private val keeper: DocumentAutosaver,
    private val view: DocumentView,
    private val saver: FileSaver,
    private val notices: Notices,
) {
    private val replacing = Mutex()

    /**
     * Lets [put] open the other project; it is given the id of the project to go back to, null if there is none.
     *
     * @return false if the pupil keeps the open one, since it cannot be saved.
     */
    suspend fun replace(put: suspend (before: String?) -> Unit): Boolean {
        if (replacing.withLock { replaceSaved(put) }) return true
        if (!acceptsLoss()) return false
        keeper.leave(comesBack = false)
        put(null)
        view.refresh()
        return true
    }

    /** Asks about work that cannot be saved: whether to go on, which is so too once it was saved to a file. */
    suspend fun acceptsLoss(): Boolean = when (view.askAboutLoss()) {
        null -> false
        DocumentAnswer.SAVE_AS -> saver.saveAs()
        else -> true
    }

    /** Says that the project [before] is saved, and offers the way back to it; nothing if there is none. */
    fun sayKept(before: String?) {
        if (before != null) notices.say(Notice.EarlierProjectSaved(before))
    }

    private suspend fun replaceSaved(put: suspend (before: String?) -> Unit): Boolean {
        if (!view.keepAll()) return false
        keeper.leave(comesBack = false)
        val id = keeper.openId
        if (id != null && keeper.isOnlyAChosenWorld) {
            val before = keeper.before
            keeper.shelf.delete(id)
            put(before)
        } else {
            put(id)
        }
        view.keepNow()
        return true
    }
}
