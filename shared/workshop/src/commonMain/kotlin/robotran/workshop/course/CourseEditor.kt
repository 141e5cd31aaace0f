package robotran.workshop.course

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import robotran.assignments.course.assignmentId
import robotran.assignments.course.unpackedCourses
import robotran.assignments.doing.teacherCopy
import robotran.documents.FileStamp
import robotran.documents.IncomingFile
import robotran.documents.OpenFilesResult
import robotran.documents.defaultProjectName
import robotran.documents.openFiles
import robotran.documents.validProjectName
import robotran.language.history.History
import robotran.projects.AssignmentLimits
import robotran.projects.Course
import robotran.projects.Project
import robotran.workshop.event.CourseEvent
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.Platform
import robotran.workshop.service.Notices
import robotran.workshop.service.Preferences
import robotran.workshop.service.ProjectSwitcher
import robotran.workshop.service.StoredAssignments
import robotran.workshop.state.CourseError
import robotran.workshop.state.CoursePage
import robotran.world.WorldLimits

/**
 * The page on which a teacher makes a course. The device keeps the course from its first assignment on.
 *
 * @param show shows a state of the page; null closes it.
 */
internal class CourseEditor(
    private val platform: Platform,
    private val scope: CoroutineScope,
    private val preferences: Preferences,
    private val shelf: CourseRepository,
    private val switcher: ProjectSwitcher,
    private val stored: StoredAssignments,
    private val notices: Notices,
    private val show: (CoursePage.Making?) -> Unit,
) {
    private val sharing = CourseSharing(platform, preferences)
    private var page: CoursePage.Making? = null
    private var history = History<Course>()

    /** The key under which the course is kept; null while it is not. */
    private var key: String? = null

    /** Whether the kept course is older than the page. */
    private var isOlder = false

    /** Opens the page for the course [known] on this device, or for a new one. */
    suspend fun open(known: String?) {
        val course = known?.let { shelf.course(it) }
        key = known.takeIf { course != null }
        history = History()
        isOlder = false
        page = CoursePage.Making(
            course ?: Course("", id = newId()),
            isKept = course != null,
            hasShareSheet = platform.sharing.hasShareSheet,
        ).also(show)
    }

    /** Leaves the page and returns the key of the course; null if it is not kept. */
    suspend fun close(): String? {
        val last = page
        page = null
        keep(last)
        return key
    }

    suspend fun saveNow() {
        if (page != null) keep()
    }

    fun handle(event: CourseEvent.OfAuthor) {
        val now = page ?: return
        val course = now.course
        when (event) {
            is CourseEvent.TitleChanged -> {
                write(
                    course.copy(
                        title = event.title.filterNot { it.isISOControl() }.take(WorldLimits.MAXIMUM_TITLE_CHARACTERS),
                    ),
                )
            }

            is CourseEvent.TextChanged -> {
                write(course.copy(text = event.text.take(AssignmentLimits.MAXIMUM_TEXT_CHARACTERS)))
            }

            CourseEvent.FilesRequested -> launch { addFiles() }
            is CourseEvent.WorksShown -> launch { showWorks(event.shown) }
            is CourseEvent.WorkAdded -> launch { addWork(event.id) }
            is CourseEvent.TaskMoved -> move(course, event.index, event.by)

            is CourseEvent.TaskRemoved -> {
                change(course.copy(assignments = course.assignments.filterIndexed { index, _ -> index != event.index }))
            }

            is CourseEvent.TaskOpened -> launch { openTask(event.index) }
            CourseEvent.UndoRequested -> undo()
            CourseEvent.TeacherFileSaved -> launch { share { sharing.saveForTeacher(it) } }
            CourseEvent.PupilFileSaved -> launch { share { sharing.saveForPupils(it) } }
            CourseEvent.LinkRequested -> launch { share { sharing.makeLink(it) } }
            CourseEvent.LinkCopied -> launch { share { sharing.copyLink(it) } }
            CourseEvent.LinkShared -> launch { share { sharing.shareLink(it) } }
            CourseEvent.LinkClosed -> update { it.copy(link = null) }
        }
    }

    private fun newId(): String {
        val now = platform.clock.now.coerceAtLeast(0).toString(RADIX)
        return "$now-${FileStamp.of("course $now ${shelf.records.size}").text.take(STAMP_DIGITS)}"
    }

    private fun update(change: (CoursePage.Making) -> CoursePage.Making) {
        page = page?.let(change)
        page?.let(show)
    }

    /** Takes a change of title or text, which is kept with the next change of the list, or when the page is left. */
    private fun write(course: Course) {
        isOlder = true
        update { it.copy(course = course, problem = null, savedAs = null, link = null) }
    }

    private fun change(course: Course) {
        val before = page?.course ?: return
        if (course == before) return
        history = history.recorded(before)
        write(course)
        update { it.copy(canUndo = true) }
        launch { keep() }
    }

    private fun undo() {
        val (before, rest) = history.undone { it } ?: return
        history = rest
        // Title and text have their own undo in their fields.
        page?.let { write(it.course.copy(assignments = before.assignments)) }
        update { it.copy(canUndo = history.canUndo) }
        launch { keep() }
    }

    private fun move(course: Course, index: Int, by: Int) {
        val to = index + by
        if (index !in course.assignments.indices || to !in course.assignments.indices) return
        val moved = course.assignments.toMutableList().apply { add(to, removeAt(index)) }
        change(course.copy(assignments = moved))
    }

    private suspend fun addFiles() {
        val files = platform.files.open(KINDS).map { IncomingFile(it.name, it.bytes) }
        if (files.isEmpty()) return
        val opening = withContext(platform.background) { openFiles(unpackedCourses(files), preferences.language) }
        when (opening) {
            is OpenFilesResult.Failure -> update { it.copy(problem = CourseError.NotOpened(opening.error)) }

            is OpenFilesResult.Success -> {
                val other =
                    opening.projects.firstOrNull { it.project.assignment == null || it.project.handIn != null }?.name
                        ?: opening.world?.title ?: opening.programs.firstOrNull()?.name ?: opening.robot?.title
                val found = opening.projects.map { it.project } + opening.courses.flatMap { it.assignments }
                add(found.filter { it.assignment != null && it.handIn == null }, other)
                notices.add(opening.notes)
            }
        }
    }

    private suspend fun showWorks(shown: Boolean) {
        val works = if (shown) stored.assignmentsToAdd() else null
        update { it.copy(works = works) }
    }

    private suspend fun addWork(id: String) {
        val project = stored.storedProject(id)
        update { it.copy(works = null) }
        add(listOfNotNull(project), null)
    }

    /** Adds [found]; one that the course has already takes its place. [other] is the name of what cannot be added. */
    private fun add(found: List<Project>, other: String?) {
        val course = page?.course ?: return
        val all = course.assignments.toMutableList()
        for (project in found.map(::teacherCopy)) {
            val place = all.indexOfFirst { it.assignmentId == project.assignmentId }
            if (place >= 0) all[place] = project else all += project
        }
        if (all.size > Course.MAXIMUM_ASSIGNMENTS) {
            return update { it.copy(problem = CourseError.TooMany(Course.MAXIMUM_ASSIGNMENTS)) }
        }
        change(course.copy(assignments = all))
        if (other != null) update { it.copy(problem = CourseError.NotAnAssignment(other)) }
    }

    /** Opens the teacher's copy as a project of its own; it can be added again when it has been changed. */
    private suspend fun openTask(index: Int) {
        val project = page?.course?.assignments?.getOrNull(index) ?: return
        keep()
        page = null
        show(null)
        val name = validProjectName(project.world.title) ?: defaultProjectName(preferences.language)
        switcher.beginProject(name, project, into = null)
    }

    private suspend fun share(action: suspend (CoursePage.Making) -> CoursePage.Making) {
        keep()
        val now = page ?: return
        val then = action(now.copy(problem = null))
        update { it.copy(link = then.link, savedAs = then.savedAs, problem = then.problem) }
    }

    /** Keeps the course, if it has changed and can be kept. */
    private suspend fun keep(now: CoursePage.Making? = page) {
        if (now == null || !isOlder || !now.isComplete) return
        isOlder = false
        when (val kept = shelf.keep(now.course, platform.clock.now)) {
            is KeptCourse.Kept -> {
                // With its first solution, a course gets the key of a teacher's copy.
                key?.takeIf { it != kept.key }?.let(shelf::remove)
                key = kept.key
                update { it.copy(isKept = true) }
            }

            KeptCourse.TooLong -> update { it.copy(isKept = false, problem = CourseError.TooLong) }
            else -> update { it.copy(isKept = false, problem = CourseError.NotKept) }
        }
    }

    private fun launch(work: suspend () -> Unit) {
        scope.launch { work() }
    }

    private companion object {
        val KINDS = listOf(FileKind.PROJECT, FileKind.COURSE, FileKind.ZIP)
        const val RADIX = 36
        const val STAMP_DIGITS = 8
    }
}
