package robotran.workshop.documents

import kotlinx.coroutines.withContext
import robotran.documents.OpenFilesResult
import robotran.documents.fileNameFor
import robotran.documents.openLinkText
import robotran.documents.projectFile
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.Platform
import robotran.workshop.platform.Saving
import robotran.workshop.service.Notices
import robotran.workshop.service.Preferences
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import robotran.workshop.state.StoppedWork

/** What can be done with work that stopped the app when it was opened last. */
internal class StoppedProjects(
    private val platform: Platform,
    private val preferences: Preferences,
    private val notices: Notices,
    private val autosaver: DocumentAutosaver,
    private val view: DocumentView,
    private val opener: FileOpener,
    private val projects: SavedProjectList,
) {
    private val asked get() = view.dialog as? DocumentDialog.StoppedLastTime

    /** Opens it all the same. */
    suspend fun open() {
        val work = asked?.work ?: return
        view.show(null)
        when (work) {
            is StoppedWork.Stored -> projects.open(work.id, anyway = true)
            is StoppedWork.OfLink -> opener.openLink(work.link, anyway = true)
            StoppedWork.OfFiles -> opener.open(opener.stoppedFiles, anyway = true)
        }
    }

    /** Writes it to a chosen file. It is neither compiled nor drawn for that. */
    suspend fun save() {
        val dialog = asked ?: return
        val bytes = bytesOf(dialog.work) ?: return
        val saving = platform.files.save(fileNameFor(dialog.name, FileKind.PROJECT), FileKind.PROJECT, bytes)
        when (saving) {
            is Saving.Saved -> notices.show(Notice.FileSaved(saving.name))
            is Saving.Failed -> notices.show(Notice.FileNotSaved(saving.reason, saving.isFull))
            Saving.Cancelled -> Unit
        }
    }

    private suspend fun bytesOf(work: StoppedWork): ByteArray? = when (work) {
        is StoppedWork.Stored -> autosaver.repository.fileText(work.id)?.encodeToByteArray()

        is StoppedWork.OfLink -> withContext(platform.background) {
            val opened = openLinkText(work.link, preferences.language) as? OpenFilesResult.Success
            opened?.projects?.firstOrNull()?.let { projectFile(it.project) }
        }

        // They are where they came from.
        StoppedWork.OfFiles -> null
    }
}
