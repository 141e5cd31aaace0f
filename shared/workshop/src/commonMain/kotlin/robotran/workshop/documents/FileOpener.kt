package robotran.workshop.documents

import kotlinx.coroutines.withContext
import robotran.assignments.course.unpackedCourses
import robotran.brick.program.BrickProgram
import robotran.documents.FileReference
import robotran.documents.IncomingFile
import robotran.documents.OpenFilesError
import robotran.documents.OpenFilesResult
import robotran.documents.OpenedProject
import robotran.documents.ProjectSummary
import robotran.documents.SavedProject
import robotran.documents.SavedProjectResult
import robotran.documents.defaultProjectName
import robotran.documents.openFiles
import robotran.documents.openLinkText
import robotran.documents.projectNameOfFile
import robotran.documents.validProjectName
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.projects.Course
import robotran.projects.Project
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.OpenedFile
import robotran.workshop.service.Services
import robotran.workshop.service.WorldRoomEvent
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import robotran.workshop.state.StoppedWork

/**
 * Opens files and links.
 *
 * @param openStored opens the stored project with this ID.
 */
internal class FileOpener(
    private val services: Services,
    private val autosaver: DocumentAutosaver,
    private val view: DocumentView,
    private val replacement: ProjectReplacement,
    private val guard: OpeningGuard,
    private val openCourses: suspend (List<Course>) -> Unit,
    private val openStored: suspend (id: String) -> Unit,
) {
    private val platform = services.platform
    private val preferences = services.preferences
    private val current = services.current
    private val editor = services.editor
    private val tabs = services.tabs
    private val navigator = services.navigator
    private val notices = services.notices

    /** What was to be opened, and what My work has of it, until the pupil has chosen. */
    private var asked: Pair<OpenFilesResult.Success, ProjectSummary>? = null

    /** The files that stopped the app the last time, until the pupil has chosen. */
    var stoppedFiles: List<OpenedFile> = emptyList()
        private set

    suspend fun choose() {
        val files = platform.files.open(KINDS)
        if (files.isNotEmpty()) open(files)
    }

    /**
     * Opens [files]. If they stopped the app the last time, asks first unless they are opened [anyway]. If My work has
     * newer changes, asks unless the files are [wanted][isWanted] as they are.
     */
    suspend fun open(files: List<OpenedFile>, anyway: Boolean = false, isWanted: Boolean = false) {
        val mark = OpeningGuard.nameOfFiles(files)
        if (!anyway && guard.hasContentStopped(mark)) {
            stoppedFiles = files
            val name = projectNameOfFile(files.first().name)
            return view.show(DocumentDialog.StoppedLastTime(name, StoppedWork.OfFiles))
        }
        guard.begin(mark)
        val given = files.map { file ->
            IncomingFile(file.name, file.bytes, file.location?.let { FileReference(it, file.name) })
        }
        when (
            val opening = withContext(platform.background) {
                openFiles(unpackedCourses(given), preferences.language)
            }
        ) {
            is OpenFilesResult.Success -> take(opening, isWanted)
            is OpenFilesResult.Failure -> view.show(DocumentDialog.Rejected(opening.error))
        }
    }

    /** The same for [link]. */
    suspend fun openLink(link: String, anyway: Boolean = false) {
        val mark = OpeningGuard.nameOfLink(link)
        if (!anyway && guard.hasContentStopped(mark)) {
            return view.show(DocumentDialog.StoppedLastTime("", StoppedWork.OfLink(link)))
        }
        guard.begin(mark)
        when (val opening = openLinkText(link, preferences.language)) {
            is OpenFilesResult.Success -> {
                view.show(null)
                take(opening)
            }

            is OpenFilesResult.Failure -> {
                view.show(DocumentDialog.PastingLink((opening.error as? OpenFilesError.InLink)?.message))
            }
        }
    }

    /** Reopens the file after another app has changed it. */
    suspend fun reopen() {
        val location = autosaver.file?.place ?: return
        val bytes = platform.files.read(location.address) ?: return
        open(listOf(OpenedFile(location.name, bytes, location.address)), isWanted = true)
    }

    private suspend fun take(opened: OpenFilesResult.Success, isWanted: Boolean = false) {
        navigator.leavePages()
        takeWork(opened, isWanted)
        if (opened.courses.isNotEmpty()) openCourses(opened.courses)
        notices.add(opened.notes)
    }

    /**
     * Opens what is in files. If My work has newer changes of the first project's file, asks, unless the file [isWanted]
     * as it is.
     */
    private suspend fun takeWork(opened: OpenFilesResult.Success, isWanted: Boolean = false) {
        val first = opened.projects.firstOrNull() ?: return takeParts(opened)
        view.saveNow()
        val known = if (isWanted) null else known(first)
        if (known != null && known.id == autosaver.openId && (!known.saved || known.file == first.file)) {
            // It is open here, perhaps with changes that the file lacks.
            if (known.saved) return view.show(null)
            return ask(opened, known)
        }
        if (known != null && !known.saved) return ask(opened, known)
        val others = saveOthers(opened.projects.drop(1).filter { known(it) == null })
        if (known != null && goOnWith(known, opened)) return
        val begun = begunBefore(first.project)
        replacement.replace { before ->
            editor.openProject(first.project)
            // A second copy of an assignment goes again if the pupil goes on with the first.
            autosaver.opened(first.name, first.file, before, isOnlyChosen = begun != null)
            view.show(null)
            opened.world?.let { editor.changeWorld(it) }
            if (begun == null) {
                replacement.offerPreviousProject(before)
            } else {
                notices.show(Notice.AssignmentBegunBefore(begun))
            }
            addPrograms(opened)
        }
        if (replacement.claimFile() && others) notices.show(Notice.MoreProjectsOpened(opened.projects.size - 1))
    }

    /** Answers the question whether to go on with My work ([isWork]) or to open the file. */
    suspend fun answer(isWork: Boolean) {
        val (opened, known) = asked ?: return
        asked = null
        view.show(null)
        if (isWork) openStored(known.id) else takeWork(opened, isWanted = true)
    }

    private suspend fun ask(opened: OpenFilesResult.Success, known: ProjectSummary) {
        asked = opened to known
        val language = preferences.settings.language?.tag.orEmpty()
        val place = known.file?.place ?: return
        view.show(
            DocumentDialog.NewerInMyWork(
                place.name,
                workTime = platform.clock.describe(known.keptAt, language),
                fileTime = platform.files.changedAt(place.address)?.let { platform.clock.describe(it, language) },
            ),
        )
    }

    /** The newest entry of My work that was opened from or saved to the file of [opened]; null if there is none. */
    private suspend fun known(opened: OpenedProject): ProjectSummary? {
        val address = opened.file?.place?.address?.takeIf { it.isNotEmpty() } ?: return null
        return autosaver.repository.projects().firstOrNull { it.file?.place?.address == address }
    }

    /**
     * Opens the file of [opened] as the entry [known] of My work, which has nothing that the file lacks. Returns false
     * if another window has that entry.
     */
    private suspend fun goOnWith(known: ProjectSummary, opened: OpenFilesResult.Success): Boolean {
        val first = opened.projects.first()
        val isOpen = known.id == autosaver.openId
        val claim = if (isOpen) null else autosaver.repository.claim(known.id) ?: return false
        val isDone = replacement.replace { before ->
            if (isOpen) autosaver.forget()
            val own = claim ?: autosaver.repository.claim(known.id)
            guard.begin(known.id)
            editor.openProject(first.project)
            if (own == null) {
                autosaver.opened(first.name, first.file, before)
            } else {
                // Other texts have other lines.
                val breakpoints = (autosaver.repository.read(known.id) as? SavedProjectResult.Found)
                    ?.takeIf { known.file == first.file }?.work?.breakpoints.orEmpty()
                val work =
                    SavedProject(known.id, known.name, known.keptAt, first.project, first.file, true, breakpoints)
                autosaver.resume(work, own, current.project.takeIf { known.file == first.file })
            }
            view.show(null)
            opened.world?.let { editor.changeWorld(it) }
            replacement.offerPreviousProject(before.takeIf { it != known.id })
            addPrograms(opened)
        }
        if (!isDone) claim?.release()
        replacement.claimFile()
        return true
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
    private suspend fun takeParts(opened: OpenFilesResult.Success) {
        val world = opened.world ?: return addPrograms(opened)
        replacement.replace { before ->
            editor.changeWorld(world, isAnother = true)
            autosaver.opened(validProjectName(world.title) ?: defaultProjectName(preferences.language), null, before)
            view.show(null)
            replacement.offerPreviousProject(before)
            addPrograms(opened)
        }
    }

    private fun addPrograms(opened: OpenFilesResult.Success) {
        opened.programs.forEach { program ->
            tabs.addProgram(Program.of(program.files.map { SourceFile(it.name, it.text) }), replacing = true)
        }
        val names = current.project.robots.firstOrNull()?.programs.orEmpty().map { it.name }
        val missing = opened.programs.filterNot { it.name in names }
        val isFull = current.project.robots.firstOrNull()?.programs.orEmpty().size >= BrickProgram.MAX_PROGRAMS
        if (missing.isNotEmpty() && isFull) {
            notices.show(Notice.NoSlotForProgram(missing.first().name, BrickProgram.MAX_PROGRAMS))
        }
        if (opened.world != null && opened.programs.isEmpty()) navigator.show(Pane.WORLD)
        opened.robot?.let { services.publish(WorldRoomEvent.RobotOpened(it)) }
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
            listOf(FileKind.PROJECT, FileKind.WORLD, FileKind.ROBOT, FileKind.COURSE) + FileKind.sources + listOf(
                FileKind.RCX_IMAGE,
                FileKind.ZIP,
                // Windows and mail programs put .txt behind the name of a program, and links come in mails.
                FileKind.TEXT,
                FileKind.MAIL,
            )
    }
}
