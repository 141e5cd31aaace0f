package robotran.ui.workshop

import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import kotlinx.coroutines.withContext
import robotran.documents.FileStamp
import robotran.documents.Keeping
import robotran.documents.KeepingTimes
import robotran.documents.KeptWork
import robotran.documents.OpenWorks
import robotran.documents.WorkClaim
import robotran.documents.WorkFile
import robotran.documents.WorkShelf
import robotran.projects.Project

/** Keeps the work that is open as it changes, and knows what of it is kept and saved. */
internal class DocumentKeeper(private val bench: Bench) {
    val shelf = WorkShelf(bench.platform.store)
    val openWorks = OpenWorks(bench.platform.store, shelf)
    private val writing = Mutex()
    private var times = KeepingTimes()
    private var id: String? = null
    private var workClaim: WorkClaim? = null
    private var fileClaim: WorkClaim? = null
    private var keptProject: Project? = null
    private var keptName = ""
    private var keptFile: WorkFile? = null
    private var savedProject: Project? = null
    private var isMarkedOpen = false

    var name = ""
    var file: WorkFile? = null
        private set

    /** The id of the work that is open; null as long as there is nothing to keep. */
    val openId: String? get() = id

    /** Whether nothing has changed since the work was opened, begun or written to its file. */
    val isSaved: Boolean get() = savedProject == bench.project

    /** Whether all there is has been kept as it is now. */
    val isKept: Boolean get() = keptProject == bench.project && keptName == name && keptFile == file

    /** What is on the screen now is a work that was never kept, called [name]; nothing is kept until it changes. */
    fun beginWith(name: String) {
        forget()
        this.name = name
        keptName = name
        keptProject = bench.project
        savedProject = bench.project
    }

    /** What is on the screen now is a work that was never kept, called [name], from [file] or a link; it is kept at once. */
    fun opened(name: String, file: WorkFile?) {
        forget()
        this.name = name
        this.file = file
        savedProject = bench.project
    }

    /** What is on the screen now is [work], which is kept already. */
    suspend fun tookUp(work: KeptWork, claim: WorkClaim) {
        forget()
        id = work.id
        workClaim = claim
        name = work.name
        file = work.file
        keptFile = work.file
        keptName = work.name
        keptProject = bench.project
        savedProject = if (work.saved) bench.project else null
        openWorks.opened(work.id, bench.platform.clock.now)
        isMarkedOpen = true
    }

    /** All of [project] is in [file] now; null where the platform does not tell where that is. */
    fun saved(project: Project, file: WorkFile?) {
        if (file?.place != this.file?.place) releaseFile()
        this.file = file
        savedProject = project
    }

    /** Claims the work's file for this window; false if another window has it open. */
    suspend fun claimFile(): Boolean {
        val address = file?.place?.address
        if (fileClaim != null || address.isNullOrEmpty()) return true
        fileClaim = bench.platform.store.claim("file-${FileStamp.of(address).text}")
        return fileClaim != null
    }

    /** Keeps the work if it has changed and that is due; null if there was nothing to do. */
    suspend fun keepIfDue(): Keeping? = if (isKept || !times.isDue(bench.platform.clock.now)) null else keepNow()

    /** Keeps the work if it has changed. */
    suspend fun keepNow(): Keeping? = writing.withLock {
        if (isKept) return null
        val now = bench.platform.clock.now
        times = times.begun(now)
        val work = KeptWork(id ?: newId(now), name, now, bench.project, file, isSaved)
        val keeping = withContext(bench.platform.background) { shelf.keep(work) }
        if (keeping == Keeping.Kept && id == work.id) {
            keptProject = work.project
            keptName = work.name
            keptFile = work.file
            if (!isMarkedOpen) openWorks.opened(work.id, now)
            isMarkedOpen = true
        }
        keeping
    }

    /** The window goes on to another work, or closes with [comesBack]. */
    suspend fun leave(comesBack: Boolean) {
        id?.let { openWorks.closed(it, bench.platform.clock.now, comesBack) }
        isMarkedOpen = false
    }

    /** Gives back what this window has claimed. */
    fun forget() {
        workClaim?.release()
        workClaim = null
        releaseFile()
        id = null
        isMarkedOpen = false
        file = null
        keptProject = null
        keptFile = null
        keptName = ""
        savedProject = null
    }

    private fun releaseFile() {
        fileClaim?.release()
        fileClaim = null
    }

    /** An id that no window has, made from the time. */
    private suspend fun newId(now: Long): String {
        var number = now.coerceAtLeast(0)
        val taken = shelf.ids()
        while (true) {
            val new = "w${number.toString(radix = 36)}"
            val claim = if (new in taken) null else shelf.claim(new)
            if (claim != null) {
                workClaim = claim
                id = new
                return new
            }
            number++
        }
    }
}
