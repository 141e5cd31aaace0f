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

/** Keeps the work that is open as it changes, and knows what of it is kept and saved. */
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

    /** What the work that has no id yet is to be called by, as far as is known. */
    private var idToCome: String? = null

    /** By what id something of the work was left with the window, null if nothing was. */
    private var leftId: String? = null

    var name = ""
    var file: SaveTarget? = null
        private set

    /** The id of the work that is open; null as long as there is nothing to keep. */
    val openId: String? get() = id

    /** Whether nothing has changed since the work was opened, begun or written to its file. */
    val isSaved: Boolean get() = savedProject == current.project

    /** Whether all there is has been kept as it is now. */
    val isKept: Boolean get() = keptProject == current.project && keptName == name && keptFile == file

    /**
     * The id of the work to go back to from the one that is open, if nobody has changed that; null if there is none.
     */
    var before: String? = null
        private set

    /**
     * Whether the open work is a world that comes with the app, with programs of another work, and nobody has changed
     * anything about it.
     */
    val isOnlyAChosenWorld: Boolean get() = isOnlyChosen && isSaved

    /** What is on the screen now is a work that was never kept, called [name]; nothing is kept until it changes. */
    fun beginWith(name: String) {
        forget()
        this.name = name
        keptName = name
        keptProject = current.project
        savedProject = current.project
    }

    /**
     * What is on the screen now is a work that was never kept, called [name], from [file], a link or a world; it is
     * kept at once.
     *
     * @param before the id of the work that was there before; null if there is none to go back to.
     * @param isOnlyChosen whether it is a world that comes with the app, with the programs of the work before.
     */
    fun opened(name: String, file: SaveTarget?, before: String? = null, isOnlyChosen: Boolean = false) {
        forget()
        this.name = name
        this.file = file
        this.before = before
        this.isOnlyChosen = isOnlyChosen
        savedProject = current.project
    }

    /** What is on the screen now is [work], which is kept already as [project]; null if it is not kept as it is. */
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

    /** All of [project] is in [file] now; null where the platform does not tell where that is. */
    fun saved(project: Project, file: SaveTarget?) {
        if (file?.place != this.file?.place) releaseFile()
        this.file = file
        savedProject = project
    }

    /** Claims the work's file for this window; false if another window has it open. */
    suspend fun claimFile(): Boolean {
        val address = file?.place?.address
        if (fileClaim != null || address.isNullOrEmpty()) return true
        fileClaim = platform.store.claim("file-${FileStamp.of(address).text}")
        return fileClaim != null
    }

    /** Somebody does something, whether it changes the work or not. */
    fun touched() {
        times = times.changed(platform.clock.now)
    }

    /** Leaves what is not kept yet with the window, which may be gone before it is. */
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

    /** Keeps the work if it has changed and that is due; null if there was nothing to do. */
    suspend fun keepIfDue(): SaveResult? = if (isKept || !times.isDue(platform.clock.now)) null else keepNow()

    /** Keeps the work if it has changed. */
    suspend fun keepNow(): SaveResult? = writing.withLock {
        if (isKept) return null
        val now = platform.clock.now
        times = times.begun(now)
        // A file is known by its own name.
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

    /** The window goes on to another work, or closes with [comesBack]. */
    suspend fun leave(comesBack: Boolean) {
        id?.let { openWorks.closed(it, platform.clock.now, comesBack) }
        isMarkedOpen = false
    }

    /** [wanted] as the name of the work [of], made another if another work is called that. */
    suspend fun freeName(wanted: String = newWorkName(preferences.language), of: String? = null): String =
        freeWorkName(wanted, shelf.works().filter { it.id != of }.map { it.name })

    /** There is no open work any more; gives back what this window has claimed. */
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

    /** Gives back what this window has claimed, since it is gone. */
    fun release() {
        workClaim?.release()
        releaseFile()
    }

    private fun releaseFile() {
        fileClaim?.release()
        fileClaim = null
    }

    /** An id that no window has, made from the time. */
    private suspend fun newId(now: Long): String {
        var number = now
        val taken = shelf.ids()
        while (true) {
            // Should the window go meanwhile, it is left under the id that it is about to have.
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
