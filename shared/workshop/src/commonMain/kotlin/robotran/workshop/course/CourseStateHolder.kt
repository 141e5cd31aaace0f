package robotran.workshop.course

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import robotran.assignments.course.OwnCourses
import robotran.assignments.course.assignmentId
import robotran.assignments.course.courseFile
import robotran.assignments.doing.pupilCopy
import robotran.documents.defaultProjectName
import robotran.documents.fileNameFor
import robotran.documents.validProjectName
import robotran.projects.Course
import robotran.projects.Project
import robotran.workshop.event.CourseEvent
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.Saving
import robotran.workshop.service.ProgramRoomEvent
import robotran.workshop.service.ProjectRoomEvent
import robotran.workshop.service.ProjectSwitcher
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.RunRoomEvent
import robotran.workshop.service.SchoolRoomEvent
import robotran.workshop.service.Services
import robotran.workshop.service.StoredAssignments
import robotran.workshop.service.SwitchResult
import robotran.workshop.service.WindowRoomEvent
import robotran.workshop.service.WorldRoomEvent
import robotran.workshop.state.CoursePage
import robotran.workshop.state.CourseState
import robotran.workshop.state.Notice
import robotran.workshop.state.OpenCourseTask
import robotran.workshop.state.SavedOwnCourse

/**
 * Holds the courses on this device, the pupil's way through them, and what a teacher makes.
 *
 */
class CourseStateHolder(
    private val services: Services,
    private val switcher: ProjectSwitcher,
    private val stored: StoredAssignments,
) {
    private val platform = services.platform
    private val scope = services.scope
    private val preferences = services.preferences
    private val current = services.current
    private val notices = services.notices
    private val shelf = CourseRepository(platform.store, scope)
    private val author = CourseEditor(platform, scope, preferences, shelf, switcher, stored, notices) { show(it) }

    /** The course from which the open project was begun last. */
    private var openKey: String? = null

    /** Whether closing the page of a course leads back to the list. */
    private var isFromList = false

    var state: CourseState by mutableStateOf(CourseState())
        private set

    /** Restores what this device keeps. */
    suspend fun start() {
        shelf.load()
        projectChanged()
    }

    fun on(event: RoomEvent) {
        when (event) {
            is ProjectRoomEvent.Opened -> projectChanged()
            is ProjectRoomEvent.WorldChanged -> if (event.isAnother) projectChanged()
            ProjectRoomEvent.AssignmentChanged -> triesChanged()
            is ProjectRoomEvent.Leaving, is ProjectRoomEvent.WorldSaved, is ProjectRoomEvent.RunSettingsChanged,
            ProjectRoomEvent.Touched, is ProgramRoomEvent, is RunRoomEvent, is WorldRoomEvent, is SchoolRoomEvent,
            is WindowRoomEvent,
            -> Unit
        }
    }

    fun handle(event: CourseEvent) {
        when (event) {
            CourseEvent.ListRequested -> showList()
            is CourseEvent.CourseChosen -> launch { showCourse(event.key, fromList = true) }
            CourseEvent.PageClosed -> closePage()
            is CourseEvent.TaskChosen -> shownKey?.let { key -> launch { begin(key, event.index) } }
            CourseEvent.NextTaskChosen -> launch { goOn() }
            CourseEvent.OpenCourseRequested -> state.open?.let { launch { showCourse(it.key, fromList = false) } }
            is CourseEvent.RemovalRequested -> askForRemoval(event.key)
            CourseEvent.Removed -> remove()
            is CourseEvent.OwnCourseSaved -> launch { saveOwn(event.name) }
            is CourseEvent.HandInsRequested -> launch {
                shelf.course(event.key)?.let { services.publish(SchoolRoomEvent.HandInsRequested(it)) }
            }
            is CourseEvent.MakingRequested -> launch { author.open(event.key) }
            is CourseEvent.OfAuthor -> author.handle(event)
        }
    }

    /** Keeps [courses], which were opened, and shows them. */
    suspend fun opened(courses: List<Course>) {
        author.close()
        val keys = courses.mapNotNull { keep(it) }
        // The notice that tells why is below the page.
        if (keys.size < courses.size) return show(null)
        if (keys.size == 1) showCourse(keys.single(), fromList = false) else showList()
    }

    /** Called after another project was opened, which a page would hide. */
    private fun projectChanged() {
        if (currentId == null) openKey = null
        if (state.page != null) {
            show(null)
            launch { author.close() }
        }
        triesChanged()
    }

    /** Called after the tries of the open project have changed. */
    private fun triesChanged() {
        val id = currentId
        val key = id?.let(::courseWith)
        val best = current.project.tries?.best
        if (key != null && best != null) shelf.update(key) { it.changed(id) { task -> task.after(best.result) } }
        refresh()
    }

    /** Waits until everything is stored. */
    suspend fun saveNow() {
        author.saveNow()
        shelf.saveNow()
    }

    /** The ID of the assignment at which the pupil works. */
    private val currentId: String?
        get() = current.project.takeIf { it.handIn == null && it.assignment?.checks == null }?.assignment?.id

    private val shownKey: String? get() = (state.page as? CoursePage.OneCourse)?.key

    /** The course to which work at the assignment [id] belongs; that used last if there are several. */
    private fun courseWith(id: String): String? = openKey?.takeIf { shelf.records[it]?.task(id) != null }
        ?: shelf.records.entries.filter { it.value.task(id) != null }.maxByOrNull { it.value.usedAt }?.key

    private fun refresh() {
        val now = openTask()
        if (now != state.open) state = state.copy(open = now)
    }

    private fun openTask(): OpenCourseTask? {
        val id = currentId ?: return null
        val key = courseWith(id) ?: return null
        val record = shelf.records.getValue(key)
        val index = record.present.indexOfFirst { it.id == id }
        return OpenCourseTask(key, record.title, index + 1, record.present.size, nextAfter(record, index)?.title)
    }

    /** The next assignment that is not done, from the beginning after the last one. */
    private fun nextAfter(record: CourseRecord, index: Int): TaskOfRecord? =
        (record.present.drop(index + 1) + record.present.take(index)).firstOrNull { !it.shown().isDone }

    private fun show(page: CoursePage?) {
        state = state.copy(page = page)
        refresh()
    }

    private fun showList() {
        isFromList = false
        show(
            CoursePage.MyCourses(
                shelf.records.entries.sortedByDescending { it.value.usedAt }.map { it.value.entry(it.key) },
            ),
        )
    }

    private suspend fun showCourse(key: String, fromList: Boolean) {
        val course = shelf.course(key)
        if (course == null) {
            // The file is damaged or was removed in another window.
            shelf.remove(key)
            return showList()
        }
        isFromList = fromList
        lookAtWork(key)
        shelf.update(key) { it.copy(usedAt = platform.clock.now) }
        val record = shelf.records.getValue(key)
        val tasks = course.assignments.map { record.task(it.assignmentId)?.shown() }
        show(CoursePage.OneCourse(key, course.title, course.text, tasks.filterNotNull(), record.isForTeachers))
    }

    /** Work that was done in another window, opened from a file or deleted counts, too. */
    private suspend fun lookAtWork(key: String) {
        for (task in shelf.records.getValue(key).present) {
            val project = task.project ?: continue
            val now = stored.storedProject(project)?.takeIf { it.isWorkAt(task.id) }
            val best = now?.tries?.best
            shelf.update(key) { record ->
                record.changed(task.id) { old ->
                    val seen = if (now == null) old.copy(project = null) else old
                    if (best == null) seen else seen.after(best.result)
                }
            }
        }
    }

    private fun closePage() {
        when (val page = state.page) {
            is CoursePage.OneCourse -> if (isFromList) showList() else show(null)

            is CoursePage.Making -> launch {
                val key = author.close()
                if (key == null) showList() else showCourse(key, fromList = true)
            }

            is CoursePage.MyCourses -> if (page.removing == null) show(null) else askForRemoval(null)
            null -> Unit
        }
    }

    /** Opens the pupil's project for the assignment at [index], so that work goes on; a new one if there is none. */
    private suspend fun begin(key: String, index: Int) {
        val assignment = shelf.course(key)?.assignments?.getOrNull(index) ?: return
        val id = assignment.assignmentId
        val known = shelf.records[key]?.task(id)?.project?.takeIf { stored.storedProject(it)?.isWorkAt(id) == true }
        val project = known ?: stored.worksAt(setOf(id))[id]
        openKey = key
        show(null)
        if (project != null) {
            stored.openStored(project)
            remember(key, id, project)
        } else {
            val name = validProjectName(assignment.world.title) ?: defaultProjectName(preferences.language)
            val result = switcher.beginProject(name, pupilCopy(assignment), into = null)
            if (result is SwitchResult.Switched) result.currentId?.let { remember(key, id, it) }
        }
        refresh()
    }

    private fun remember(key: String, id: String, project: String) =
        shelf.update(key) { it.copy(usedAt = platform.clock.now).changed(id) { task -> task.copy(project = project) } }

    private suspend fun goOn() {
        val open = state.open ?: return
        val record = shelf.records[open.key] ?: return
        val next = nextAfter(record, open.number - 1) ?: return showCourse(open.key, fromList = false)
        begin(open.key, record.present.indexOf(next))
    }

    /** Keeps [course] on the device and returns its key; tells why if that is impossible. */
    private suspend fun keep(course: Course): String? {
        val isNew = CourseRepository.keyOf(course) !in shelf.records
        val kept = withContext(platform.background) { shelf.keep(course, platform.clock.now) }
        if (kept !is KeptCourse.Kept) return null.also { notices.show(noticeOf(kept)) }
        if (isNew) {
            val works = stored.worksAt(course.assignments.map { it.assignmentId }.toSet())
            works.forEach { (id, project) ->
                shelf.update(kept.key) { it.changed(id) { task -> task.copy(project = project) } }
            }
        }
        refresh()
        return kept.key
    }

    private fun askForRemoval(key: String?) {
        val page = state.page as? CoursePage.MyCourses ?: return
        show(page.copy(removing = key))
    }

    private fun remove() {
        val key = (state.page as? CoursePage.MyCourses)?.removing ?: return
        shelf.remove(key)
        showList()
    }

    private suspend fun saveOwn(name: String) {
        val course = OwnCourses.named(name, preferences.language, preferences.words) ?: return
        val bytes = checkNotNull(withContext(platform.background) { courseFile(course) }) { "Our courses are files." }
        val saved = when (
            val saving = platform.files.save(fileNameFor(course.title, FileKind.COURSE), FileKind.COURSE, bytes)
        ) {
            is Saving.Saved -> SavedOwnCourse(name, saving.name)
            is Saving.Failed -> SavedOwnCourse(name, null, saving.reason)
            Saving.Cancelled -> null
        }
        state = state.copy(saved = saved)
    }

    private fun launch(work: suspend () -> Unit) {
        scope.launch { work() }
    }
}

internal fun noticeOf(kept: KeptCourse): Notice = when (kept) {
    KeptCourse.TooMany -> Notice.TooManyCourses(CourseRepository.MAXIMUM_COURSES)
    KeptCourse.TooLong -> Notice.CourseTooLong
    is KeptCourse.Failed -> Notice.FileNotSaved(kept.reason, isFull = false)
    KeptCourse.Full, is KeptCourse.Kept -> Notice.FileNotSaved("", isFull = true)
}

/** Whether this is a pupil's work at the assignment [id]. */
internal fun Project.isWorkAt(id: String): Boolean = assignmentId == id && handIn == null && assignment?.checks == null
