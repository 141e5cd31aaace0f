package robotran.workshop.documents

import kotlinx.coroutines.yield
import robotran.documents.ProjectLock
import robotran.documents.SavedProject
import robotran.documents.StoreResult
import robotran.documents.WorkEntry
import robotran.documents.WorkReading
import robotran.workshop.event.DocumentEvent
import robotran.workshop.platform.Platform
import robotran.workshop.service.Notices
import robotran.workshop.service.Preferences
import robotran.workshop.service.ProjectEditor
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import robotran.workshop.state.ShownWork

/**
 * The works that are kept: shown to choose from, opened and deleted.
 */
internal class DocumentWorks(
    private val platform: Platform,
    private val preferences: Preferences,
    private val editor: ProjectEditor,
    private val notices: Notices,
    private val keeper: DocumentKeeper,
    private val view: DocumentView,
    private val replacement: ProjectReplacement,
) {
    suspend fun handle(event: DocumentEvent.OfWorks) {
        val asked = view.dialog as? DocumentDialog.Works
        when (event) {
            DocumentEvent.WorksWanted -> showAll()
            is DocumentEvent.WorkOpened -> open(event.id)
            is DocumentEvent.WorkDeletionWanted -> view.show(asked?.copy(deleting = asked.works?.firstOrNull { it.entry.id == event.id }))
            is DocumentEvent.WorkDeletionAnswered -> delete(asked?.deleting?.takeIf { event.delete })
        }
    }

    /** The work called [id] and the right to change it; null if another window has it, or it cannot be used. */
    suspend fun claim(id: String): Pair<SavedProject, ProjectLock>? {
        val claim = keeper.shelf.claim(id) ?: return null
        val found = keeper.shelf.read(id) as? WorkReading.Found
        if (found == null) claim.release()
        return found?.let { it.work to claim }
    }

    private suspend fun showAll() {
        if (view.dialog !is DocumentDialog.Works) view.show(DocumentDialog.Works(works = null))
        view.keepNow()
        val language = preferences.settings.language?.tag.orEmpty()
        val works = keeper.shelf.works().map { ShownWork(it, platform.clock.describe(it.keptAt, language), it.id == keeper.openId) }
        if (view.dialog is DocumentDialog.Works) view.show(DocumentDialog.Works(works))
        for (work in works) {
            yield()
            lookInto(work.entry)
        }
    }

    /** Tells in the list what is in the work of [entry], if that is still to be seen. */
    private suspend fun lookInto(entry: WorkEntry) {
        if (view.dialog !is DocumentDialog.Works) return
        val project = (keeper.shelf.read(entry.id) as? WorkReading.Found)?.work?.project ?: return
        val programs = project.robots.flatMap { robot -> robot.programs.map { it.name } }
        val now = view.dialog as? DocumentDialog.Works ?: return
        view.show(now.copy(works = now.works?.map { if (it.entry == entry) it.copy(world = project.world, programs = programs) else it }))
    }

    private suspend fun open(id: String) {
        if (id == keeper.openId) return view.show(null)
        val claim = keeper.shelf.claim(id)
        if (claim == null) {
            notices.say(Notice.ProjectOpenElsewhere)
            return
        }
        when (val reading = keeper.shelf.read(id)) {
            is WorkReading.Found -> {
                replacement.replace {
                    editor.openProject(reading.work.project)
                    keeper.tookUp(reading.work, claim)
                    view.show(null)
                }
            }

            is WorkReading.Unusable -> {
                claim.release()
                notices.say(Notice.ProjectUnusable(reading.reason(preferences.language)))
            }

            WorkReading.Missing -> {
                claim.release()
                showAll()
            }
        }
    }

    private suspend fun delete(work: ShownWork?) {
        if (work == null) return showAll()
        val claim = keeper.shelf.claim(work.entry.id)
        if (claim == null) {
            notices.say(Notice.ProjectOpenElsewhere)
        } else {
            val result = keeper.shelf.delete(work.entry.id)
            if (result is StoreResult.Failed) notices.say(Notice.ProjectNotDeleted(result.reason))
            claim.release()
        }
        showAll()
    }
}
