package robotran.workshop.documents

import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import robotran.workshop.service.Notices
import robotran.workshop.state.DocumentAnswer
import robotran.workshop.state.Notice

/**
 * Replaces the open project by another one, one replacement at a time, only if no changes are lost or the user agrees.
 */
internal class ProjectReplacement(
    private val autosaver: DocumentAutosaver,
    private val view: DocumentView,
    private val saver: FileSaver,
    private val notices: Notices,
) {
    private val replacing = Mutex()

    /**
     * Calls [put] to open the other project, with the ID of the previous project or null.
     *
     * @return false if the user keeps the open project, since it cannot be saved.
     */
    suspend fun replace(put: suspend (before: String?) -> Unit): Boolean {
        if (replacing.withLock { replaceSaved(put) }) return true
        if (!confirmsLoss()) return false
        autosaver.leave(reopens = false)
        put(null)
        view.refresh()
        return true
    }

    /** Asks whether to continue without saving. Also true if the user saves the project to a file. */
    suspend fun confirmsLoss(): Boolean = when (view.askAboutLoss()) {
        null -> false
        DocumentAnswer.SAVE_AS -> saver.saveAs()
        else -> true
    }

    /** Claims the file of the open project for this window; says so, and returns false, if another one has it. */
    suspend fun claimFile(): Boolean = autosaver.claimFile().also { isClaimed ->
        if (!isClaimed) notices.show(Notice.FileOpenElsewhere(autosaver.file?.place?.name.orEmpty()))
    }

    /** Reports that the project [before] is saved and offers to return to it; does nothing for null. */
    fun offerPreviousProject(before: String?) {
        if (before != null) notices.show(Notice.EarlierProjectSaved(before))
    }

    private suspend fun replaceSaved(put: suspend (before: String?) -> Unit): Boolean {
        if (!view.saveAll()) return false
        autosaver.leave(reopens = false)
        val id = autosaver.openId
        if (id != null && autosaver.isUnchangedBuiltInWorld) {
            val before = autosaver.before
            autosaver.repository.delete(id)
            put(before)
        } else {
            put(id)
        }
        view.saveNow()
        return true
    }
}
