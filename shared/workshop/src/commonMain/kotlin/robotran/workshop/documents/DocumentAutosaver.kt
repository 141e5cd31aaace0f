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
import robotran.documents.SavedBreakpoint
import robotran.documents.SavedProject
import robotran.documents.defaultProjectName
import robotran.documents.handoverText
import robotran.documents.uniqueProjectName
import robotran.projects.Project
import robotran.workshop.platform.Platform
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Preferences
import robotran.workshop.service.ProjectEditor

/** Autosaves the open project on changes, and tracks what is autosaved and what is saved to a file. */
internal class DocumentAutosaver(
    private val platform: Platform,
    private val preferences: Preferences,
    private val current: CurrentProject,
    private val editor: ProjectEditor,
    private val guard: OpeningGuard,
) {
    val repository = ProjectRepository(platform.store)
    val openProjects = OpenProjects(platform.store, repository)
    private val writing = Mutex()
    private var times = AutosaveThrottle()
    private var id: String? = null
        set(value) {
            field = value
            platform.window.projectId = value.orEmpty()
        }
    private var projectLock: ProjectLock? = null
    private var fileClaim: ProjectLock? = null

    /** Keeps the name of a project that is not saved yet from other windows. */
    private var nameLock: ProjectLock? = null
    private var autosavedProject: Project? = null
    private var autosavedName = ""
    private var autosavedFile: SaveTarget? = null
    private var autosavedBreakpoints: List<SavedBreakpoint> = emptyList()
    private var savedProject: Project? = null
    private var isMarkedOpen = false
    private var isOnlyChosen = false

    /** The reserved ID of a project that has no ID yet, if known. */
    private var reservedId: String? = null

    /** The ID of the project whose unsaved changes were left with the window; null if none. */
    private var leftProjectId: String? = null

    var name = ""
    var file: SaveTarget? = null
        private set

    /** The ID of the open project; null until it is first autosaved. */
    val openId: String? get() = id

    /**
     * Whether the project has not changed since it was opened, created or written to its file. To look at another
     * program is no change.
     */
    val isSaved: Boolean get() = equalsExceptViews(savedProject)

    /**
     * Whether the autosaved copy is up to date. In a new project, choosing how programs are shown is not yet work to
     * save: the settings remember it. Neither is a breakpoint.
     */
    val isAutosaved: Boolean get() = autosavedName == name && autosavedFile == file &&
        (id == null || autosavedBreakpoints == current.savedBreakpoints) &&
        (autosavedProject == current.project || (id == null && equalsExceptViews(autosavedProject)))

    /** The ID of the previous project if the open one is unchanged; null if there is none. */
    var before: String? = null
        private set

    /** Whether the open project is an unchanged built-in world with the programs of another project. */
    val isUnchangedBuiltInWorld: Boolean get() = isOnlyChosen && equalsExceptViews(savedProject)

    /** Whether the project is [other], but for how its programs are shown. */
    private fun equalsExceptViews(other: Project?) = other?.withoutViews() == current.project.withoutViews()

    /** Starts a new project with the name [new], which is not autosaved until it changes. */
    fun startNew(new: UnusedName) {
        forget()
        nameLock = new.lock
        name = new.name
        autosavedName = new.name
        autosavedProject = current.project
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
    suspend fun resume(work: SavedProject, claim: ProjectLock, project: Project? = current.project) {
        forget()
        id = work.id
        projectLock = claim
        name = work.name
        file = work.file
        autosavedFile = work.file
        autosavedName = work.name
        autosavedProject = project
        leftProjectId = work.id.takeIf { project == null }
        savedProject = if (work.saved) project ?: current.project else null
        editor.restoreBreakpoints(work.breakpoints)
        autosavedBreakpoints = current.savedBreakpoints
        openProjects.opened(work.id, platform.clock.now)
        isMarkedOpen = true
        if (name.isEmpty() && id == work.id) name = uniqueName()
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
    fun leaveUnsavedChanges() {
        if (isAutosaved) return
        val now = platform.clock.now
        val leaving = id ?: reservedId ?: idOf(now)
        if (id == null) {
            reservedId = leaving
            platform.window.projectId = leaving
        }
        platform.window.leave(leaving, handoverText(workNow(leaving, now)))
        leftProjectId = leaving
    }

    /** Autosaves the project if it has changed and a save is due; null if there was nothing to do. */
    suspend fun saveIfDue(): SaveResult? = if (isAutosaved || !times.isDue(platform.clock.now)) null else saveNow()

    /** Autosaves the project if it has changed. */
    suspend fun saveNow(): SaveResult? = writing.withLock {
        if (isAutosaved) return null
        val now = platform.clock.now
        times = times.begun(now)
        // A project from a file has the file's name.
        if (id == null && file == null) name = uniqueName(name)
        val work = workNow(id ?: newId(now), now)
        val result = withContext(platform.background) { repository.save(work) }
        times = times.ended(platform.clock.now)
        if (result == SaveResult.Saved && id == work.id) {
            autosavedProject = work.project
            autosavedName = work.name
            autosavedFile = work.file
            autosavedBreakpoints = work.breakpoints
            leftProjectId?.let { platform.window.leave(it, null) }
            leftProjectId = null
            if (!isMarkedOpen) openProjects.opened(work.id, now)
            isMarkedOpen = true
            releaseName()
        }
        result
    }

    private fun workNow(id: String, now: Long) =
        SavedProject(id, name, now, current.project, file, isSaved, current.savedBreakpoints)

    /** Called when the window opens another project, or closes with [reopens]. */
    suspend fun leave(reopens: Boolean) {
        id?.let { openProjects.closed(it, platform.clock.now, reopens) }
        isMarkedOpen = false
    }

    /** Returns [wanted] as the name of the project [of], changed if another project has this name. */
    suspend fun uniqueName(wanted: String = defaultProjectName(preferences.language), of: String? = null): String =
        uniqueProjectName(wanted, repository.projects().filter { it.id != of }.map { it.name })

    /**
     * A name for a new project that neither a saved one nor the new one of another window has. The new project of this
     * window gives its own away.
     */
    suspend fun unusedName(): UnusedName {
        releaseName()
        val taken = repository.projects().mapTo(mutableListOf()) { it.name }
        repeat(NEW_NAMES) {
            val free = uniqueProjectName(defaultProjectName(preferences.language), taken)
            platform.store.claim("name-${FileStamp.of(free).text}")?.let { return UnusedName(free, it) }
            taken += free
        }
        return UnusedName(uniqueProjectName(defaultProjectName(preferences.language), taken), null)
    }

    /** Closes the project and releases the claims of this window. */
    fun forget() {
        projectLock?.release()
        projectLock = null
        releaseFile()
        releaseName()
        id = null
        reservedId = null
        leftProjectId = null
        isMarkedOpen = false
        isOnlyChosen = false
        before = null
        file = null
        autosavedProject = null
        autosavedFile = null
        autosavedName = ""
        autosavedBreakpoints = emptyList()
        savedProject = null
    }

    /** Releases the claims of this window when it closes. */
    fun release() {
        projectLock?.release()
        releaseFile()
        releaseName()
    }

    private fun releaseName() {
        nameLock?.release()
        nameLock = null
    }

    private fun releaseFile() {
        fileClaim?.release()
        fileClaim = null
    }

    /** An unused ID for another project, made from the time [now], with the claim to save it. */
    suspend fun claimNewId(now: Long): Pair<String, ProjectLock> {
        val taken = repository.ids()
        var number = now
        while (true) {
            val new = idOf(number++)
            if (new in taken || new == id) continue
            repository.claim(new)?.let { return new to it }
        }
    }

    /** An unused ID, made from the time. */
    private suspend fun newId(now: Long): String {
        var number = now
        val taken = repository.ids()
        while (true) {
            // If the window ends before the write, its changes are left under this ID.
            val new = reservedId ?: idOf(number)
            reservedId = new
            val claim = if (new in taken) null else repository.claim(new)
            reservedId = null
            if (claim != null) {
                projectLock = claim
                id = new
                guard.saved(new)
                return new
            }
            number++
        }
    }

    private fun idOf(number: Long) = "w${number.coerceAtLeast(0).toString(radix = 36)}"

    private companion object {
        /** More windows with new projects may have equal names until they are saved. */
        const val NEW_NAMES = 20
    }
}

/** A name for a new project, with the [lock] that keeps other windows from it; null if there is none. */
internal class UnusedName(val name: String, val lock: ProjectLock?)
