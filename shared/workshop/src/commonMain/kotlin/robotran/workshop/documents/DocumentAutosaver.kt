package robotran.workshop.documents

import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import kotlinx.coroutines.withContext
import robotran.documents.AutosaveThrottle
import robotran.documents.FileStamp
import robotran.documents.OpenProjects
import robotran.documents.ProjectLock
import robotran.documents.ProjectRepository
import robotran.documents.SaveResult
import robotran.documents.SaveTarget
import robotran.documents.SavedProject
import robotran.documents.freeWorkName
import robotran.documents.leftText
import robotran.documents.newWorkName
import robotran.projects.Project
import robotran.workshop.platform.Platform
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Preferences

/** Autosaves the open project on changes, and tracks what is autosaved and what is saved to a file. */
internal class DocumentAutosaver(
    private val platform: Platform,
    private val preferences: Preferences,
    private val current: CurrentProject,
) {
    val shelf = ProjectRepository(platform.store)
    val openWorks = OpenProjects(platform.store, shelf)
    private val writing = Mutex()
    private var times = AutosaveThrottle()
    private var id: String? = null
        set(value) {
            field = value
            platform.window.workId = value.orEmpty()
        }
    private var workClaim: ProjectLock? = null
    private var fileClaim: ProjectLock? = null
    private var keptProject: Project? = null
    private var keptName = ""
    private var keptFile: SaveTarget? = null
    private var savedProject: Project? = null
    private var isMarkedOpen = false
    private var isOnlyChosen = false

    /** The reserved ID of a project that has no ID yet, if known. */
    private var idToCome: String? = null

    /** The ID of the project whose unsaved changes were left with the window; null if none. */
    private var leftId: String? = null

    var name = ""
    var file: SaveTarget? = null
        private set

    /** The ID of the open project; null until it is first autosaved. */
    val openId: String? get() = id

    /** Whether the project has not changed since it was opened, created or written to its file. */
    val isSaved: Boolean get() = savedProject == current.project

    /** Whether the autosaved copy is up to date. */
    val isKept: Boolean get() = keptProject == current.project && keptName == name && keptFile == file

    /** The ID of the previous project if the open one is unchanged; null if there is none. */
    var before: String? = null
        private set

    /** Whether the open project is an unchanged built-in world with the programs of another project. */
    val isOnlyAChosenWorld: Boolean get() = isOnlyChosen && isSaved

    /** Starts a new project [name], which is not autosaved until it changes. */
    fun beginWith(name: String) {
        forget()
        this.name = name
        keptName = name
        keptProject = current.project
        savedProject = current.project
    }

    /**
     * Starts a new project [name] from [file], a link or a world. It is autosaved at once.
     *
     * @param before the ID of the previous project; null if there is none to return to.
     * @param isOnlyChosen whether it is a built-in world with the programs of the previous project.
     */
    fun opened(name: String, file: SaveTarget?, before: String? = null, isOnlyChosen: Boolean = false) {
        forget()
        this.name = name
        this.file = file
        this.before = before
        this.isOnlyChosen = isOnlyChosen
        savedProject = current.project
    }

    /** Sets the open project to [work], autosaved as [project]; null if its autosaved copy differs. */
    suspend fun tookUp(work: SavedProject, claim: ProjectLock, project: Project? = current.project) {
        forget()
        id = work.id
        workClaim = claim
        name = work.name
        file = work.file
        keptFile = work.file
        keptName = work.name
        keptProject = project
        leftId = work.id.takeIf { project == null }
        savedProject = if (work.saved) project ?: current.project else null
        openWorks.opened(work.id, platform.clock.now)
        isMarkedOpen = true
        if (name.isEmpty() && id == work.id) name = freeName()
    }

    /** [project] was written to [file]; null if the platform does not report the location. */
    fun saved(project: Project, file: SaveTarget?) {
        if (file?.place != this.file?.place) releaseFile()
        this.file = file
        savedProject = project
    }

    /** Claims the project's file for this window; false if another window has it open. */
    suspend fun claimFile(): Boolean {
        val address = file?.place?.address
        if (fileClaim != null || address.isNullOrEmpty()) return true
        fileClaim = platform.store.claim("file-${FileStamp.of(address).text}")
        return fileClaim != null
    }

    /** Called on each user action, whether or not it changes the project. */
    fun touched() {
        times = times.changed(platform.clock.now)
    }

    /** Leaves unsaved changes with the window, which may end before they are autosaved. */
    fun leaveUnkept() {
        if (isKept) return
        val now = platform.clock.now
        val leaving = id ?: idToCome ?: idOf(now)
        if (id == null) {
            idToCome = leaving
            platform.window.workId = leaving
        }
        platform.window.leave(leaving, leftText(SavedProject(leaving, name, now, current.project, file, isSaved)))
        leftId = leaving
    }

    /** Autosaves the project if it has changed and a save is due; null if there was nothing to do. */
    suspend fun keepIfDue(): SaveResult? = if (isKept || !times.isDue(platform.clock.now)) null else keepNow()

    /** Autosaves the project if it has changed. */
    suspend fun keepNow(): SaveResult? = writing.withLock {
        if (isKept) return null
        val now = platform.clock.now
        times = times.begun(now)
        // A project from a file has the file's name.
        if (id == null && file == null) name = freeName(name)
        val work = SavedProject(id ?: newId(now), name, now, current.project, file, isSaved)
        val keeping = withContext(platform.background) { shelf.keep(work) }
        times = times.ended(platform.clock.now)
        if (keeping == SaveResult.Kept && id == work.id) {
            keptProject = work.project
            keptName = work.name
            keptFile = work.file
            leftId?.let { platform.window.leave(it, null) }
            leftId = null
            if (!isMarkedOpen) openWorks.opened(work.id, now)
            isMarkedOpen = true
        }
        keeping
    }

    /** Called when the window opens another project, or closes with [comesBack]. */
    suspend fun leave(comesBack: Boolean) {
        id?.let { openWorks.closed(it, platform.clock.now, comesBack) }
        isMarkedOpen = false
    }

    /** Returns [wanted] as the name of the project [of], changed if another project has this name. */
    suspend fun freeName(wanted: String = newWorkName(preferences.language), of: String? = null): String =
        freeWorkName(wanted, shelf.works().filter { it.id != of }.map { it.name })

    /** Closes the project and releases the claims of this window. */
    fun forget() {
        workClaim?.release()
        workClaim = null
        releaseFile()
        id = null
        idToCome = null
        leftId = null
        isMarkedOpen = false
        isOnlyChosen = false
        before = null
        file = null
        keptProject = null
        keptFile = null
        keptName = ""
        savedProject = null
    }

    /** Releases the claims of this window when it closes. */
    fun release() {
        workClaim?.release()
        releaseFile()
    }

    private fun releaseFile() {
        fileClaim?.release()
        fileClaim = null
    }

    /** An unused ID, made from the time. */
    private suspend fun newId(now: Long): String {
        var number = now
        val taken = shelf.ids()
        while (true) {
            // If the window ends before the write, its changes are left under this ID.
            val new = idToCome ?: idOf(number)
            idToCome = new
            val claim = if (new in taken) null else shelf.claim(new)
            idToCome = null
            if (claim != null) {
                workClaim = claim
                id = new
                return new
            }
            number++
        }
    }

    private fun idOf(number: Long) = "w${number.coerceAtLeast(0).toString(radix = 36)}"
}
