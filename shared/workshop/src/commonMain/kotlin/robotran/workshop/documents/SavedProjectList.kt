package robotran.workshop.documents

import kotlinx.coroutines.yield
import robotran.documents.ProjectLock
import robotran.documents.ProjectSummary
import robotran.documents.SavedProject
import robotran.documents.SavedProjectResult
import robotran.documents.StoreResult
import robotran.workshop.event.DocumentEvent
import robotran.workshop.platform.Platform
import robotran.workshop.service.Notices
import robotran.workshop.service.Preferences
import robotran.workshop.service.ProjectEditor
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import robotran.workshop.state.ProjectListEntry

/** The list of stored projects, to open and delete. */
internal class SavedProjectList(
    private val platform: Platform,
    private val preferences: Preferences,
    private val editor: ProjectEditor,
    private val notices: Notices,
    private val autosaver: DocumentAutosaver,
    private val view: DocumentView,
    private val replacement: ProjectReplacement,
) {
    suspend fun handle(event: DocumentEvent.OfProjectList) {
        val asked = view.dialog as? DocumentDialog.ProjectList
        when (event) {
            DocumentEvent.ProjectListRequested -> showAll()

            is DocumentEvent.SavedProjectChosen -> open(event.id)

            is DocumentEvent.ProjectDeletionRequested -> view.show(
                asked?.copy(
                    deleting = asked.projects?.firstOrNull {
                        it.entry.id == event.id
                    },
                ),
            )

            is DocumentEvent.ProjectDeletionAnswered -> delete(asked?.deleting?.takeIf { event.delete })
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
        if (view.dialog !is DocumentDialog.ProjectList) view.show(DocumentDialog.ProjectList(projects = null))
        view.saveNow()
        val language = preferences.settings.language?.tag.orEmpty()
        val projects = autosaver.repository.projects().map {
            ProjectListEntry(
                it,
                platform.clock.describe(it.keptAt, language),
                it.id == autosaver.openId,
            )
        }
        if (view.dialog is DocumentDialog.ProjectList) view.show(DocumentDialog.ProjectList(projects))
        for (work in projects) {
            yield()
            loadDetails(work.entry)
        }
    }

    /** Shows the content of the project [entry] in the list, if the list is still open. */
    private suspend fun loadDetails(entry: ProjectSummary) {
        if (view.dialog !is DocumentDialog.ProjectList) return
        val project = (autosaver.repository.read(entry.id) as? SavedProjectResult.Found)?.work?.project ?: return
        val programs = project.robots.flatMap { robot -> robot.programs.map { it.name } }
        val now = view.dialog as? DocumentDialog.ProjectList ?: return
        view.show(
            now.copy(
                projects = now.projects?.map {
                    if (it.entry == entry) {
                        it.copy(world = project.world, programs = programs)
                    } else {
                        it
                    }
                },
            ),
        )
    }

    private suspend fun open(id: String) {
        if (id == autosaver.openId) return view.show(null)
        val claim = autosaver.repository.claim(id)
        if (claim == null) {
            notices.show(Notice.ProjectOpenElsewhere)
            return
        }
        when (val reading = autosaver.repository.read(id)) {
            is SavedProjectResult.Found -> {
                replacement.replace {
                    editor.openProject(reading.work.project)
                    autosaver.resume(reading.work, claim)
                    view.show(null)
                }
            }

            is SavedProjectResult.Unusable -> {
                claim.release()
                notices.show(Notice.ProjectUnusable(reading.reason(preferences.language)))
            }

            SavedProjectResult.Missing -> {
                claim.release()
                showAll()
            }
        }
    }

    private suspend fun delete(work: ProjectListEntry?) {
        if (work == null) return showAll()
        val claim = autosaver.repository.claim(work.entry.id)
        if (claim == null) {
            notices.show(Notice.ProjectOpenElsewhere)
        } else {
            val result = autosaver.repository.delete(work.entry.id)
            if (result is StoreResult.Failed) notices.show(Notice.ProjectNotDeleted(result.reason))
            claim.release()
        }
        showAll()
    }
}
