package robotran.workshop.handins

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.Job
import kotlinx.coroutines.launch
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import kotlinx.coroutines.withContext
import robotran.assignments.collecting.CollectedFile
import robotran.assignments.collecting.CourseHandIns
import robotran.assignments.collecting.Submission
import robotran.assignments.comparing.compareSubmissions
import robotran.documents.StoreResult
import robotran.projects.Course
import robotran.projects.linksIn
import robotran.simulation.physics.PhysicsEngine
import robotran.workshop.event.HandInsEvent
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenedFile
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.SchoolRoomEvent
import robotran.workshop.service.Services
import robotran.workshop.state.AlikeHandIn
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInsDialog
import robotran.workshop.state.HandInsMessage
import robotran.workshop.state.HandInsState
import robotran.workshop.state.OpenedHandIn

/**
 * The page on which a teacher looks at what pupils have handed in for the open project. Everything happens on this
 * device. Not thread-safe.
 *
 * @param title the project's name.
 */
class HandInsStateHolder internal constructor(
    services: Services,
    physics: PhysicsEngine,
    private val visits: HandInPreviews,
    private val title: () -> String,
) {
    private val platform = services.platform
    private val scope = services.scope
    private val preferences = services.preferences
    private val current = services.current

    /** Null while the page is closed. */
    var state: HandInsState? by mutableStateOf(null)
        private set

    /** Whether the open project was opened from a hand-in. */
    val isVisiting: Boolean get() = visits.isVisiting

    /** What the page showed last; it is shown again after a replay. */
    private var resting: HandInsState? = null
    private var open: OpenAssignment? = null
    private var reading: Job? = null
    private val bringing = Mutex()
    private val scanning = HandInScan(platform.qrScanner, scope, ::show, ::bringLinks)
    private val grading = GradingRuns(platform, scope, physics, ::state, ::show)
    private val comments = CommentWriter(scope, ::tell)
    private var removed: HandInRow? = null
    private val exports = HandInExports(platform, scope, ::tell)

    fun on(event: RoomEvent) {
        if (event is SchoolRoomEvent.HandInsRequested) openCourse(event.course)
    }

    fun handle(event: HandInsEvent) {
        if (event == HandInsEvent.Requested) return request()
        val now = state ?: return
        val open = open ?: return
        when (event) {
            HandInsEvent.Requested -> Unit
            HandInsEvent.Closed -> closeForNow(open)
            HandInsEvent.FilesRequested -> scope.launch { bring(platform.files.open(KINDS)) }
            HandInsEvent.PastingRequested -> show { copy(dialog = HandInsDialog.PastingLinks) }
            is HandInsEvent.LinksPasted -> bringLinks(event.text)
            is HandInsEvent.ScanRequested -> scanning.begin(event.kind, event.words)
            HandInsEvent.ScanEnded -> scanning.end()
            is HandInsEvent.OrderChosen -> show { copy(order = event.order).sorted(open.language) }
            HandInsEvent.GradingCancelled -> stopGrading()
            HandInsEvent.GradingResumed -> grading.begin(open)
            is HandInsEvent.HandInChosen -> choose(event.id)
            HandInsEvent.ComparisonsRequested -> show { copy(dialog = HandInsDialog.Comparing) }

            is HandInsEvent.ComparisonChosen -> show {
                copy(opened = opened?.copy(beside = event.other), dialog = null)
            }

            is HandInsEvent.CommentChanged -> comment(open, event.id, event.comment)
            is HandInsEvent.ReplayRequested -> replay(open, now, event)
            HandInsEvent.CsvRequested -> exports.saveCsv(open, now)
            HandInsEvent.PageRequested -> exports.savePage(open, now)
            HandInsEvent.FeedbackRequested -> exports.saveFeedback(open, now)
            is HandInsEvent.FeedbackFileRequested -> exports.saveFeedback(open, now, event.id)
            is HandInsEvent.HandInRemoved -> removeOne(open, event.id)
            HandInsEvent.RemovalUndone -> undoRemoval(open)
            HandInsEvent.RemovalRequested -> show { copy(dialog = HandInsDialog.Removing(rows.size)) }
            HandInsEvent.RemovalConfirmed -> remove(open)
            HandInsEvent.DialogClosed -> show { copy(dialog = null) }
            HandInsEvent.MessageDismissed -> show { copy(message = null) }
        }
    }

    /** Brings in what was dropped on the page or sent to the app, if the page is open. Returns whether it is. */
    fun takes(arrival: OpenRequest): Boolean {
        if (state == null) return false
        when (arrival) {
            is OpenRequest.OfFiles -> scope.launch { bring(arrival.files) }
            is OpenRequest.OfLink -> bringLinks(arrival.link)
            is OpenRequest.Unreadable -> tell(HandInsMessage.Unreadable(arrival.sentence))
        }
        return true
    }

    /** Opens the assignment again after a replay, and the page as it was. */
    fun goBack() {
        val open = open ?: return
        scope.launch { if (visits.returnTo(open)) showAgain() }
    }

    /** Opens the page again if it was open for the open project before a reload. */
    suspend fun restore() {
        val project = current.project
        if (project.world.goals.isEmpty() || state != null) return
        if (OpenAssignment(title(), project, preferences.language, platform.store).kept.wasOpen()) request()
    }

    private fun closeForNow(open: OpenAssignment) {
        close()
        scope.launch { open.kept.writeOpen(false) }
    }

    /** Closes the page and stops all work. */
    fun close() {
        reading?.cancel()
        grading.stop()
        scanning.end()
        resting = state?.copy(progress = null, isReading = false, dialog = null, message = null) ?: resting
        state = null
        comments.flush()
    }

    /** Waits until all comments are kept. */
    suspend fun saveNow() = comments.saveNow()

    /** Opens the page for all assignments of [course] together. */
    private fun openCourse(course: Course) {
        val first = course.assignments.firstOrNull()
        if (state != null || first == null) return
        val known = open
        if (known != null && known.isFor(course, preferences.language)) return showAgain()
        open(OpenAssignment(course.title, first, preferences.language, platform.store, course))
    }

    private fun request() {
        if (visits.isVisiting) return goBack()
        if (state != null) return
        val known = open
        if (known != null && known.isFor(current.project, preferences.language)) return showAgain()
        open(OpenAssignment(title(), current.project, preferences.language, platform.store))
    }

    private fun open(opened: OpenAssignment) {
        open = opened
        resting = null
        state = opened.firstState(scanning.kinds).copy(isReading = true)
        reading = scope.launch {
            val batches = opened.kept.read()
            for (batch in batches) opened.take(collect(opened, batch))
            opened.removeAll(opened.kept.removed)
            opened.lastLink = PastedLinks.last(batches.flatten())
            show { copy(isReading = false) }
            update(opened)
            opened.kept.writeOpen(true)
        }
    }

    private fun showAgain() {
        state = resting
        val open = open
        if (state != null && open != null) scope.launch { open.kept.writeOpen(true) }
        when {
            // Reading was cut short.
            state == null -> {
                this.open = null
                if (open == null) request() else open(open.emptied())
            }

            open == null -> request()
            state?.isStopped == false -> grading.begin(open)
        }
    }

    private fun choose(id: String?) =
        show { copy(opened = id?.let { OpenedHandIn(it) }, last = id ?: last, message = null) }

    private fun bringLinks(text: String) {
        if (open == null) return
        show { copy(dialog = null) }
        scope.launch {
            val links = linksIn(text)
            val open = open ?: return@launch
            val files = PastedLinks.filesFor(links, first = open.lastLink + 1)
            open.lastLink += files.size
            if (files.isEmpty()) show { copy(message = HandInsMessage.NothingFound()) }
            bring(files)
        }
    }

    /** Everything that was brought together belongs together, such as the files of a program. */
    private suspend fun bring(files: List<OpenedFile>) = bringing.withLock {
        reading?.join()
        val open = open
        if (open == null || files.isEmpty() || state == null) return@withLock
        show { copy(isReading = true, message = null) }
        val collected = files.map { CollectedFile(it.path, it.bytes) }
        val hasRoom = open.kept.size + collected.size <= KeptHandIns.MAXIMUM_FILES &&
            open.kept.bytes + collected.sumOf { it.bytes.size.toLong() } <= KeptHandIns.MAXIMUM_BYTES
        val message = if (hasRoom) take(open, collected) else TOO_MUCH
        show { copy(isReading = false, message = message) }
        update(open)
        open.kept.writeOpen(true)
    }

    private suspend fun take(open: OpenAssignment, files: List<CollectedFile>): HandInsMessage {
        val collected = collect(open, files)
        val found = collected.tasks.flatten() + collected.unsorted
        if (found.isEmpty()) return HandInsMessage.NothingFound(collected.notes)
        val new = open.take(collected)
        open.kept.writeRemoved(open.removed)
        val kept = if (new.isEmpty()) StoreResult.Done else open.kept.add(files)
        val unusable = new.count { it is Submission.Unusable }
        return notKept(kept)
            ?: HandInsMessage.Brought(new.size - unusable, found.size - new.size, collected.notes, unusable)
    }

    private suspend fun collect(open: OpenAssignment, files: List<CollectedFile>): CourseHandIns =
        withContext(platform.background) { PastedLinks.named(open.collect(files), open.language) }

    /** Shows what is there now, and grades what is not graded. */
    private suspend fun update(open: OpenAssignment) {
        val all = open.all.map { placed ->
            PlacedSubmission(placed.id, placed.task, PastedLinks.named(placed.submission, open.language))
        }
        show { copy(rows = rowsFor(all, rows, open.kept.comments)).sorted(open.language) }
        grading.begin(open)
        compare(open)
    }

    private suspend fun compare(open: OpenAssignment) {
        val alike = mutableMapOf<String, MutableList<AlikeHandIn>>()
        for ((task, all) in state?.rows.orEmpty().groupBy { it.task }) {
            val project = open.tasks.getOrNull(task)?.project ?: continue
            val pairs = withContext(platform.background) { compareSubmissions(all.map { it.submission }, project) }
            for (pair in pairs.filter { it.isMarked }) {
                val (one, other) = all[pair.first] to all[pair.second]
                alike.getOrPut(one.id) { mutableListOf() } += AlikeHandIn(other.id, other.name, pair.isEqual)
                alike.getOrPut(other.id) { mutableListOf() } += AlikeHandIn(one.id, one.name, pair.isEqual)
            }
        }
        show { copy(rows = rows.map { it.copy(alike = alike[it.id].orEmpty()) }) }
    }

    private fun stopGrading() {
        grading.stop()
        show { copy(isStopped = true) }
    }

    private fun comment(open: OpenAssignment, id: String, comment: String) {
        show { copy(rows = rows.map { if (it.id == id) it.copy(comment = comment) else it }) }
        keepComments(open)
    }

    private fun keepComments(open: OpenAssignment) {
        val all = state?.rows.orEmpty().filter { it.comment.isNotEmpty() }.associate { it.id to it.comment }
        comments.write(open.kept, all)
    }

    private fun replay(open: OpenAssignment, now: HandInsState, event: HandInsEvent.ReplayRequested) {
        val row = now.rows.firstOrNull { it.id == event.id } ?: return
        show { copy(last = row.id) }
        scope.launch { if (visits.visit(open, row, event.run)) close() }
    }

    private fun removeOne(open: OpenAssignment, id: String) {
        val row = state?.rows?.firstOrNull { it.id == id } ?: return
        removed = row
        open.remove(id)
        show {
            copy(
                rows = rows.filter { it.id != id },
                opened = opened?.takeIf { it.id != id },
                message = HandInsMessage.Removed(row.name),
            )
        }
        afterRemoval(open)
    }

    private fun undoRemoval(open: OpenAssignment) {
        val row = removed?.takeIf { state?.message is HandInsMessage.Removed } ?: return
        removed = null
        open.remove(row.id, isRemoved = false)
        show { copy(rows = rows + row, last = row.id, message = null).sorted(open.language) }
        afterRemoval(open)
    }

    private fun afterRemoval(open: OpenAssignment) {
        show { copy(rows = withNamesakes(rows)) }
        keepComments(open)
        if (state?.isStopped == false) grading.begin(open)
        scope.launch {
            notKept(open.kept.writeRemoved(open.removed))?.let(::tell)
            compare(open)
        }
    }

    private fun remove(open: OpenAssignment) {
        grading.stop()
        comments.forget()
        show { open.firstState(scanning.kinds) }
        this.open = open.emptied()
        reading = scope.launch { open.kept.clear() }
    }

    private fun tell(message: HandInsMessage) = show { copy(message = message) }

    private fun show(change: HandInsState.() -> HandInsState) {
        state = state?.change()
    }

    private companion object {
        val KINDS = listOf(FileKind.PROJECT, FileKind.ZIP) + FileKind.sources + listOf(
            FileKind.RCX_IMAGE,
            FileKind.TEXT,
            FileKind.MAIL,
            FileKind.HTML,
        )
        val TOO_MUCH = HandInsMessage.TooMany(KeptHandIns.MAXIMUM_FILES, KeptHandIns.MAXIMUM_MEGABYTES)
    }
}

internal fun notKept(result: StoreResult): HandInsMessage? = when (result) {
    StoreResult.Done -> null
    StoreResult.Full -> HandInsMessage.NotKept("")
    StoreResult.NoAnswer -> HandInsMessage.NotKept("timeout")
    is StoreResult.Failed -> HandInsMessage.NotKept(result.reason)
}
