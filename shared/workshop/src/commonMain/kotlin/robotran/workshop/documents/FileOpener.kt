package robotran.workshop.documents

import kotlinx.coroutines.withContext
import robotran.assignments.course.unpackedCourses
import robotran.brick.program.BrickProgram
import robotran.documents.FileReference
import robotran.documents.IncomingFile
import robotran.documents.OpenFilesError
import robotran.documents.OpenFilesResult
import robotran.documents.OpenedProject
import robotran.documents.SavedProject
import robotran.documents.SavedProjectResult
import robotran.documents.defaultProjectName
import robotran.documents.openFiles
import robotran.documents.openLinkText
import robotran.documents.validProjectName
import robotran.projects.Course
import robotran.projects.Project
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.OpenedFile
import robotran.workshop.platform.Platform
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Notices
import robotran.workshop.service.Preferences
import robotran.workshop.service.ProgramTabs
import robotran.workshop.service.ProjectEditor
import robotran.workshop.service.ScreenNavigator
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import robotran.workshop.state.ProgramFile
import robotran.workshop.state.PupilProgram
import robotran.world.RobotDescription

/**
 * Opens files and links.
 *
 * @param putRobot puts a robot into the world that is open.
 */
internal class FileOpener(
    private val platform: Platform,
    private val preferences: Preferences,
    private val current: CurrentProject,
    private val editor: ProjectEditor,
    private val tabs: ProgramTabs,
    private val navigator: ScreenNavigator,
    private val notices: Notices,
    private val autosaver: DocumentAutosaver,
    private val view: DocumentView,
    private val replacement: ProjectReplacement,
    private val openCourses: suspend (List<Course>) -> Unit,
    private val putRobot: (RobotDescription) -> Unit,
) {
    suspend fun choose() {
        val files = platform.files.open(KINDS)
        if (files.isNotEmpty()) open(files)
    }

    suspend fun open(files: List<OpenedFile>) {
        val given = files.map { file ->
            IncomingFile(file.name, file.bytes, file.location?.let { FileReference(it, file.name) })
        }
        when (
            val opening = withContext(platform.background) {
                openFiles(unpackedCourses(given), preferences.language)
            }
        ) {
            is OpenFilesResult.Opened -> take(opening)
            is OpenFilesResult.Rejected -> view.show(DocumentDialog.Rejected(opening.error))
        }
    }

    suspend fun openLink(link: String) {
        when (val opening = openLinkText(link, preferences.language)) {
            is OpenFilesResult.Opened -> {
                view.show(null)
                take(opening)
            }

            is OpenFilesResult.Rejected -> {
                view.show(DocumentDialog.PastingLink((opening.error as? OpenFilesError.InLink)?.message))
            }
        }
    }

    /** Reopens the file after another app has changed it. */
    suspend fun reopen() {
        val location = autosaver.file?.place ?: return
        val bytes = platform.files.read(location.address) ?: return
        open(listOf(OpenedFile(location.name, bytes, location.address)))
    }

    private suspend fun take(opened: OpenFilesResult.Opened) {
        navigator.leavePages()
        takeWork(opened)
        if (opened.courses.isNotEmpty()) openCourses(opened.courses)
        notices.add(opened.remarks)
    }

    private suspend fun takeWork(opened: OpenFilesResult.Opened) {
        val first = opened.projects.firstOrNull() ?: return takeParts(opened)
        val others = saveOthers(opened.projects.drop(1))
        view.saveNow()
        val begun = begunBefore(first.project)
        replacement.replace { before ->
            editor.openProject(first.project)
            // A second copy of an assignment goes again if the pupil goes on with the first.
            autosaver.opened(first.name, first.file, before, isOnlyChosen = begun != null)
            view.show(null)
            opened.world?.let { editor.changeWorld(it) }
            if (begun ==
                null
            ) {
                replacement.offerPreviousProject(before)
            } else {
                notices.show(Notice.AssignmentBegunBefore(begun))
            }
            addPrograms(opened)
        }
        if (!autosaver.claimFile()) {
            notices.show(Notice.FileOpenElsewhere(autosaver.file?.place?.name.orEmpty()))
        } else if (others) {
            notices.show(Notice.MoreProjectsOpened(opened.projects.size - 1))
        }
    }

    /** The ID of the newest stored project with the same assignment that has been worked at; null if there is none. */
    private suspend fun begunBefore(project: Project): String? {
        val id = project.assignment?.id
        if (id == null || project.handIn != null || project.tries != null) return null
        return autosaver.repository.projects().firstOrNull { summary ->
            val stored = (autosaver.repository.read(summary.id) as? SavedProjectResult.Found)?.work?.project
            stored?.assignment?.id == id && stored.handIn == null &&
                (stored.tries != null || stored.isChangedFrom(project))
        }?.id
    }

    private fun Project.isChangedFrom(other: Project): Boolean =
        robots.map { it.programs.map { program -> program.files } } !=
            other.robots.map { it.programs.map { program -> program.files } }

    /** A world becomes a new project with the current programs; programs are added to the current ones. */
    private suspend fun takeParts(opened: OpenFilesResult.Opened) {
        val world = opened.world ?: return addPrograms(opened)
        replacement.replace { before ->
            editor.changeWorld(world, isAnother = true)
            autosaver.opened(validProjectName(world.title) ?: defaultProjectName(preferences.language), null, before)
            view.show(null)
            replacement.offerPreviousProject(before)
            addPrograms(opened)
        }
    }

    private fun addPrograms(opened: OpenFilesResult.Opened) {
        opened.programs.forEach { program ->
            tabs.addProgram(PupilProgram(program.files.map { ProgramFile(it.name, it.text) }), replacing = true)
        }
        val names = current.project.robots.firstOrNull()?.programs.orEmpty().map { it.name }
        val missing = opened.programs.filterNot { it.name in names }
        if (missing.isNotEmpty()) {
            notices.show(Notice.NoSlotForProgram(missing.first().name, BrickProgram.MAX_PROGRAMS))
        }
        if (opened.world != null && opened.programs.isEmpty()) navigator.show(Pane.WORLD)
        opened.robot?.let(putRobot)
    }

    /** Stores all projects but the first without opening them. Returns whether there are any. */
    private suspend fun saveOthers(projects: List<OpenedProject>): Boolean {
        val now = platform.clock.now
        projects.forEachIndexed { number, opened ->
            val id = "o${(now + number).toString(radix = 36)}"
            autosaver.repository.save(
                SavedProject(
                    id,
                    opened.name,
                    now - 1 - number,
                    opened.project,
                    opened.file,
                    saved = opened.file != null,
                ),
            )
        }
        return projects.isNotEmpty()
    }

    private companion object {
        val KINDS =
            listOf(
                FileKind.PROJECT,
                FileKind.WORLD,
                FileKind.ROBOT,
                FileKind.COURSE,
                FileKind.ROBOLANG,
                FileKind.JAVA,
                FileKind.NQC,
                FileKind.NQC_HEADER,
                FileKind.LASM,
                FileKind.RCX_IMAGE,
                FileKind.ZIP,
                // Windows and mail programs put .txt behind the name of a program, and links come in mails.
                FileKind.TEXT,
                FileKind.MAIL,
            )
    }
}
