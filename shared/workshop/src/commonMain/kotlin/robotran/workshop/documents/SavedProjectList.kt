package robotran.workshop.documents

import kotlinx.coroutines.yield
import robotran.documents.ProjectLock
import robotran.documents.ProjectSummary
import robotran.documents.SaveResult
import robotran.documents.SavedProject
import robotran.documents.SavedProjectResult
import robotran.documents.StoreResult
import robotran.documents.validProjectName
import robotran.workshop.event.DocumentEvent
import robotran.workshop.platform.Platform
import robotran.workshop.service.Notices
import robotran.workshop.service.Preferences
import robotran.workshop.service.ProjectEditor
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import robotran.workshop.state.ProjectListEntry
import robotran.workshop.state.StoppedWork

/** The list of stored projects, to open, rename, duplicate and delete. */
internal class SavedProjectList(
    private val platform: Platform,
    private val preferences: Preferences,
    private val editor: ProjectEditor,
    private val notices: Notices,
    private val autosaver: DocumentAutosaver,
    private val view: DocumentView,
    private val replacement: ProjectReplacement,
    private val guard: OpeningGuard,
) {
    /** What can be brought back. */
    private var lastDeleted: SavedProject? = null

    suspend fun handle(event: DocumentEvent.OfProjectList) {
        val asked = (view.dialog as? DocumentDialog.ProjectList)?.copy(notice = null)
        if (asked != null) view.show(asked)
        when (event) {
            DocumentEvent.ProjectListRequested -> showAll()
            is DocumentEvent.SavedProjectChosen -> open(event.id)
            is DocumentEvent.ProjectRenamingRequested -> if (asked != null) askForName(asked, event.id)
            is DocumentEvent.ProjectRenamed -> rename(asked?.renaming, event.name)
            is DocumentEvent.ProjectDuplicated -> duplicate(event.id)
            is DocumentEvent.ProjectDeleted -> delete(asked, event.id)
            DocumentEvent.ProjectDeletionUndone -> undoDeletion()
        }
    }

    /** The project [id] with a claim to change it; null if another window has it or it is invalid. */
    suspend fun claim(id: String): Pair<SavedProject, ProjectLock>? {
        val claim = autosaver.repository.claim(id) ?: return null
        val found = autosaver.repository.read(id) as? SavedProjectResult.Found
        if (found == null) claim.release()
        return found?.let { it.work to claim }
    }

    private suspend fun showAll() {
        val isPlain = guard.hasStopped(OpeningGuard.LIST)
        guard.begin(OpeningGuard.LIST)
        if (view.dialog !is DocumentDialog.ProjectList) view.show(DocumentDialog.ProjectList(projects = null))
        view.saveNow()
        val language = preferences.settings.language?.tag.orEmpty()
        val projects = autosaver.repository.projects().map {
            ProjectListEntry(it, platform.clock.describe(it.keptAt, language), it.id == autosaver.openId)
        }
        (view.dialog as? DocumentDialog.ProjectList)?.let {
            view.show(DocumentDialog.ProjectList(projects, notice = it.notice))
        }
        for (work in projects) {
            // A picture of what stops the app would stop the list.
            if (isPlain || guard.hasStopped(work.entry.id)) continue
            yield()
            loadDetails(work.entry)
        }
    }

    /** Shows the content of the project [entry] in the list, if the list is still open. */
    private suspend fun loadDetails(entry: ProjectSummary) {
        if (view.dialog !is DocumentDialog.ProjectList) return
        val project = (autosaver.repository.read(entry.id) as? SavedProjectResult.Found)?.work?.project ?: return
        val now = view.dialog as? DocumentDialog.ProjectList ?: return
        view.show(
            now.copy(
                projects = now.projects?.map {
                    if (it.entry == entry) {
                        it.copy(project = project)
                    } else {
                        it
                    }
                },
            ),
        )
    }

    /** Opens the project [id]. If it stopped the app the last time, asks first unless it is opened [anyway]. */
    suspend fun open(id: String, anyway: Boolean = false) {
        if (id == autosaver.openId) return view.show(null)
        if (!anyway && guard.hasStopped(id)) return tellStopped(id)
        val claim = autosaver.repository.claim(id) ?: return tellOpenElsewhere(id)
        guard.begin(id)
        when (val reading = autosaver.repository.read(id)) {
            is SavedProjectResult.Found -> {
                val isOpen = replacement.replace {
                    editor.openProject(reading.work.project)
                    autosaver.resume(reading.work, claim)
                    view.show(null)
                }
                if (isOpen) replacement.claimFile() else leave(claim)
            }

            is SavedProjectResult.Unusable -> {
                leave(claim)
                tell(Notice.ProjectUnusable(reading.reason(preferences.language)))
            }

            SavedProjectResult.Missing -> {
                leave(claim)
                showAll()
            }
        }
    }

    /** The project of [claim] is not opened after all. */
    private fun leave(claim: ProjectLock) {
        claim.release()
        guard.settled()
    }

    /** Says that the project [id] stopped the app the last time, and offers what can be done. */
    suspend fun tellStopped(id: String) {
        view.show(DocumentDialog.StoppedLastTime(nameOf(id), StoppedWork.Stored(id)))
    }

    private suspend fun tellOpenElsewhere(id: String) = tell(Notice.ProjectOpenElsewhere(nameOf(id)))

    private suspend fun nameOf(id: String): String =
        autosaver.repository.projects().firstOrNull { it.id == id }?.name.orEmpty()

    /** Shows [notice] within the list if it is open, because it covers all other notices. */
    private fun tell(notice: Notice) {
        val list = view.dialog as? DocumentDialog.ProjectList ?: return notices.show(notice)
        view.show(list.copy(notice = notice))
    }

    /** The entry of a deleted project goes, and with it the offer to bring the project back. */
    private fun askForName(list: DocumentDialog.ProjectList, id: String) {
        val projects = list.projects?.filter { it.entry.id != list.deleted }
        view.show(list.copy(projects = projects, renaming = id, deleted = null))
    }

    private suspend fun rename(id: String?, name: String?) {
        val wanted = name?.let(::validProjectName)
        if (id == null || wanted == null) return showAll()
        val unique = autosaver.uniqueName(wanted, of = id)
        if (id == autosaver.openId) {
            autosaver.name = unique
        } else {
            changing(id) { work -> save(work.copy(name = unique)) }
        }
        showAll()
    }

    private suspend fun duplicate(id: String) {
        view.saveNow()
        val reading = autosaver.repository.read(id)
        if (reading is SavedProjectResult.Unusable) {
            tell(Notice.ProjectUnusable(reading.reason(preferences.language)))
        }
        if (reading is SavedProjectResult.Found) {
            val (newId, lock) = autosaver.claimNewId(platform.clock.now)
            try {
                val name = autosaver.uniqueName(reading.work.name)
                save(SavedProject(newId, name, platform.clock.now, reading.work.project))
            } finally {
                lock.release()
            }
        }
        showAll()
    }

    private suspend fun delete(asked: DocumentDialog.ProjectList?, id: String) {
        var isDeleted = false
        changing(id) { work ->
            val result = autosaver.repository.delete(id)
            when (result) {
                is StoreResult.Failed -> tell(Notice.ProjectNotDeleted(result.reason))
                StoreResult.NoAnswer -> tell(Notice.StoreSilent)

                StoreResult.Done, StoreResult.Full -> {
                    lastDeleted = work
                    isDeleted = true
                }
            }
        }
        // The entry keeps its place, so that nothing moves under the finger, and offers to bring the project back.
        val left = asked?.projects?.filter { it.entry.id != asked.deleted }
        if (isDeleted) view.show(DocumentDialog.ProjectList(left, deleted = id)) else showAll()
    }

    private suspend fun undoDeletion() {
        val work = lastDeleted ?: return
        val lock = autosaver.repository.claim(work.id)
        val isSaved = try {
            save(work)
        } finally {
            lock?.release()
        }
        // Without room it stays in the list, to be tried again.
        if (!isSaved) return
        lastDeleted = null
        showAll()
    }

    /** Calls [change] with the stored project [id] while no other window can change it; tells if that is impossible. */
    private suspend fun changing(id: String, change: suspend (SavedProject) -> Unit) {
        val lock = autosaver.repository.claim(id) ?: return tellOpenElsewhere(id)
        try {
            when (val reading = autosaver.repository.read(id)) {
                is SavedProjectResult.Found -> change(reading.work)
                is SavedProjectResult.Unusable -> tell(Notice.ProjectUnusable(reading.reason(preferences.language)))

                SavedProjectResult.Missing -> {
                    // Another window has removed it.
                }
            }
        } finally {
            lock.release()
        }
    }

    /** Returns whether [work] is stored; tells why if it is not. */
    private suspend fun save(work: SavedProject): Boolean {
        val result = autosaver.repository.save(work)
        when (result) {
            SaveResult.Saved -> Unit
            SaveResult.Full -> tell(Notice.FileNotSaved("", isFull = true))
            SaveResult.TooLong -> tell(Notice.ProjectTooLong)
            SaveResult.NoAnswer -> tell(Notice.StoreSilent)
            is SaveResult.Failed -> tell(Notice.FileNotSaved(result.reason, isFull = false))
        }
        return result == SaveResult.Saved
    }
}
