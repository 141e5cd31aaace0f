package robotran.workshop.documents

import kotlinx.coroutines.withContext
import robotran.documents.FileReference
import robotran.documents.FileStamp
import robotran.documents.SaveTarget
import robotran.documents.SavingCheck
import robotran.documents.checkBeforeSaving
import robotran.documents.fileNameFor
import robotran.documents.projectFile
import robotran.documents.projectNameOfFile
import robotran.projects.Project
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.Platform
import robotran.workshop.platform.Saving
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Notices
import robotran.workshop.service.fileNameFor
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice

/** Saves the project to its file or to a chosen one. */
internal class FileSaver(
    private val platform: Platform,
    private val current: CurrentProject,
    private val notices: Notices,
    private val autosaver: DocumentAutosaver,
    private val view: DocumentView,
) {
    /** Writes to the project's file. Returns whether it was saved. */
    suspend fun save(overOthers: Boolean = false): Boolean {
        val file = autosaver.file ?: return saveAs()
        val project = current.project
        val bytes = bytesOf(project) ?: return false
        val now = if (overOthers) null else platform.files.read(file.place.address)
        if (checkBeforeSaving(file, now, bytes) == SavingCheck.CHANGED) {
            view.show(DocumentDialog.ChangedElsewhere(file.place.name))
            return false
        }
        return tell(platform.files.write(file.place.address, file.place.name, bytes), project, bytes)
    }

    /** Lets the user choose a file and writes to it. Returns whether it was saved. */
    suspend fun saveAs(): Boolean {
        val project = current.project
        val bytes = bytesOf(project) ?: return false
        val name = fileNameFor(autosaver.name.ifEmpty { project.world.title }, FileKind.PROJECT)
        return tell(platform.files.save(name, FileKind.PROJECT, bytes), project, bytes)
    }

    private suspend fun bytesOf(project: Project): ByteArray? {
        val bytes = withContext(platform.background) { projectFile(project) }
        if (bytes == null) notices.show(Notice.ProjectTooLong)
        return bytes
    }

    private suspend fun tell(saving: Saving, project: Project, bytes: ByteArray): Boolean {
        when (saving) {
            is Saving.Saved -> {
                val file = saving.location?.let { SaveTarget(FileReference(it, saving.name), FileStamp.of(bytes)) }
                autosaver.saved(project, file)
                autosaver.name = projectNameOfFile(saving.name)
                view.show(null)
                if (autosaver.claimFile()) {
                    notices.show(Notice.FileSaved(saving.name))
                } else {
                    notices.show(Notice.FileOpenElsewhere(saving.name))
                }
            }

            Saving.Cancelled -> {}
            is Saving.Failed -> notices.show(Notice.FileNotSaved(saving.reason, saving.isFull))
        }
        return saving is Saving.Saved
    }
}
