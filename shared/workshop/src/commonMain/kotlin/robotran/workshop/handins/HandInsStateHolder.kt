package robotran.workshop.handins

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import kotlinx.coroutines.withContext
import robotran.assignments.collecting.CollectedFile
import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.collectSubmissions
import robotran.assignments.comparing.compareSubmissions
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingState
import robotran.documents.StoreResult
import robotran.projects.isLink
import robotran.simulation.physics.PhysicsEngine
import robotran.workshop.event.HandInsEvent
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenedFile
import robotran.workshop.platform.Platform
import robotran.workshop.platform.QrScanResult
import robotran.workshop.platform.QrScannerWords
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Preferences
import robotran.workshop.state.AlikeHandIn
import robotran.workshop.state.GradingProgress
import robotran.workshop.state.HandInOrder
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
    private val platform: Platform,
    private val scope: CoroutineScope,
    private val preferences: Preferences,
    private val current: CurrentProject,
    private val physics: PhysicsEngine,
    private val visits: HandInVisits,
    private val title: () -> String,
) {
    /** Null while the page is closed. */
    var state: HandInsState? by mutableStateOf(null)
        private set

    /** What the page showed last; it is shown again after a replay. */
    private var resting: HandInsState? = null
    private var open: OpenAssignment? = null
    private var reading: Job? = null
    private val bringing = Mutex()
    private var grading: Job? = null
    private val comments = CommentWriter(scope, ::tell)
    private val exports = HandInExports(platform, scope, ::tell)

    fun handle(event: HandInsEvent) {
        if (event == HandInsEvent.Requested) return request()
        val now = state ?: return
        val open = open ?: return
        when (event) {
            HandInsEvent.Requested -> Unit
            HandInsEvent.Closed -> close()
            HandInsEvent.FilesRequested -> scope.launch { bring(platform.files.open(KINDS)) }
            HandInsEvent.PastingRequested -> show { copy(dialog = HandInsDialog.PastingLinks) }
            is HandInsEvent.LinksPasted -> bringLinks(event.text)
            is HandInsEvent.ScanRequested -> scope.launch { scan(event.words) }
            is HandInsEvent.OrderChosen -> show { copy(order = event.order).sorted() }
            HandInsEvent.GradingCancelled -> stopGrading()
            HandInsEvent.GradingResumed -> grade()
            is HandInsEvent.HandInChosen -> show { copy(opened = event.id?.let { OpenedHandIn(it) }, told = null) }
            is HandInsEvent.ComparisonChosen -> show { copy(opened = opened?.copy(beside = event.other)) }
            is HandInsEvent.CommentChanged -> comment(open, event.id, event.comment)
            is HandInsEvent.ReplayRequested -> replay(open, now, event)
            HandInsEvent.CsvRequested -> exports.saveCsv(open, now)
            HandInsEvent.PageRequested -> exports.savePage(open, now)
            HandInsEvent.FeedbackRequested -> exports.saveFeedback(open, now)
            is HandInsEvent.FeedbackFileRequested -> exports.saveFeedback(open, now, event.id)
            HandInsEvent.RemovalRequested -> show { copy(dialog = HandInsDialog.Removing(rows.size)) }
            HandInsEvent.RemovalConfirmed -> remove(open)
            HandInsEvent.DialogClosed -> show { copy(dialog = null) }
            HandInsEvent.MessageDismissed -> show { copy(told = null) }
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

    /** Closes the page and stops all work. */
    fun close() {
        reading?.cancel()
        grading?.cancel()
        resting = state?.copy(progress = null, isReading = false, dialog = null, told = null) ?: resting
        state = null
        comments.flush()
    }

    /** Waits until all comments are kept. */
    suspend fun saveNow() = comments.saveNow()

    private fun request() {
        if (visits.isVisiting) return goBack()
        if (state != null) return
        val known = open
        if (known != null && known.isFor(current.project, preferences.language)) return showAgain()
        val opened = OpenAssignment(title(), current.project, preferences.language, platform.store)
        open = opened
        resting = null
        state = opened.firstState(platform.qrScanner?.kind).copy(isReading = true)
        reading = scope.launch {
            val batches = opened.kept.read()
            for (batch in batches) opened.submissions.add(collect(opened, batch))
            show { copy(isReading = false) }
            update(opened)
        }
    }

    private fun showAgain() {
        state = resting
        when {
            // Reading was cut short.
            state == null -> {
                open = null
                request()
            }

            state?.isStopped == false -> grade()
        }
    }

    private fun bringLinks(text: String) {
        show { copy(dialog = null) }
        scope.launch { bring(listOf(OpenedFile(LINKS_FILE, text.encodeToByteArray()))) }
    }

    private suspend fun scan(words: QrScannerWords) {
        val scanner = platform.qrScanner ?: return
        val result = scanner.scan(words) { text ->
            val isUseful = isLink(text)
            if (isUseful) bringLinks(text)
            isUseful
        }
        messageFor(result)?.let(::tell)
    }

    /** Everything that was brought together belongs together, such as the files of a program. */
    private suspend fun bring(files: List<OpenedFile>) = bringing.withLock {
        reading?.join()
        val open = open
        if (open == null || files.isEmpty() || state == null) return@withLock
        show { copy(isReading = true, told = null) }
        val collected = files.map { CollectedFile(it.path, it.bytes) }
        val hasRoom = open.kept.size + collected.size <= KeptHandIns.MAXIMUM_FILES &&
            open.kept.bytes + collected.sumOf { it.bytes.size.toLong() } <= KeptHandIns.MAXIMUM_BYTES
        val message = if (hasRoom) take(open, collected) else TOO_MUCH
        show { copy(isReading = false, told = message) }
        update(open)
    }

    private suspend fun take(open: OpenAssignment, files: List<CollectedFile>): HandInsMessage {
        val found = collect(open, files)
        if (found.isEmpty()) return HandInsMessage.NothingFound
        val known = open.submissions.add(found)
        val kept = if (known == found.size) StoreResult.Done else open.kept.add(files)
        return notKept(kept) ?: HandInsMessage.Brought(found.size - known, known)
    }

    private suspend fun collect(open: OpenAssignment, files: List<CollectedFile>): List<Submission> =
        withContext(platform.background) { collectSubmissions(files, open.project, open.language) }

    /** Shows what is there now, and grades what is not graded. */
    private suspend fun update(open: OpenAssignment) {
        show { copy(rows = rowsFor(open.submissions.all, rows, open.kept.comments)).sorted() }
        grade()
        val all = open.submissions.all.toList()
        val pairs = withContext(platform.background) { compareSubmissions(all.map { it.second }, open.project) }
        val alike = mutableMapOf<String, MutableList<AlikeHandIn>>()
        for (pair in pairs.filter { it.isMarked }) {
            val (one, other) = all[pair.first] to all[pair.second]
            alike.getOrPut(one.first) { mutableListOf() } += AlikeHandIn(other.first, other.second.name, pair.isEqual)
            alike.getOrPut(other.first) { mutableListOf() } += AlikeHandIn(one.first, one.second.name, pair.isEqual)
        }
        show { copy(rows = rows.map { it.copy(alike = alike[it.id].orEmpty()) }) }
    }

    private fun grade() {
        grading?.cancel()
        val open = open ?: return
        val rows = state?.rows.orEmpty()
        val waiting = rows.filter { it.graded == null && it.submission is Submission.Usable }
        show { copy(isStopped = false) }
        if (waiting.isEmpty()) return show { copy(progress = null) }
        val done = rows.size - waiting.size
        show { copy(progress = GradingProgress(done, rows.size, done.toFloat() / rows.size, null)) }
        grading = scope.launch {
            // A hand-in with a wrong program must not hold up what is drawn first.
            delay(1)
            val loop = GradingLoop(platform, open.project, open.plan, physics, open.language)
            val onGraded = { id: String, result: GradedHandIn -> showResult(id, result) }
            loop.grade(waiting.associate { it.id to it.submission }, onGraded) { grading, left ->
                show { copy(progress = progressOf(rows.size, done, grading, left)) }
            }
            show { copy(progress = null).sorted() }
        }
    }

    private fun progressOf(all: Int, before: Int, grading: GradingState, left: Long?): GradingProgress {
        val share = if (grading.runsInTotal == 0) 1f else grading.runsDone.toFloat() / grading.runsInTotal
        val part = (before + share * grading.rows.size) / all
        val seconds = left?.let { ((it + MILLISECONDS / 2) / MILLISECONDS).toInt() }
        return GradingProgress(before + grading.results.size, all, part, seconds)
    }

    private fun showResult(id: String, result: GradedHandIn) = show {
        val graded = copy(rows = rows.map { if (it.id == id) it.copy(graded = result) else it })
        val progress = graded.progress
        // The rows keep their places until all are graded, so that none moves away from under a finger.
        graded.copy(progress = progress?.copy(handIns = progress.handIns + 1))
    }

    private fun stopGrading() {
        grading?.cancel()
        show { copy(progress = null, isStopped = true) }
    }

    private fun comment(open: OpenAssignment, id: String, comment: String) {
        show { copy(rows = rows.map { if (it.id == id) it.copy(comment = comment) else it }) }
        val all = state?.rows.orEmpty().filter { it.comment.isNotEmpty() }.associate { it.id to it.comment }
        comments.write(open.kept, all)
    }

    private fun replay(open: OpenAssignment, now: HandInsState, event: HandInsEvent.ReplayRequested) {
        val row = now.rows.firstOrNull { it.id == event.id } ?: return
        scope.launch { if (visits.visit(open, row, event.run)) close() }
    }

    private fun remove(open: OpenAssignment) {
        grading?.cancel()
        comments.forget()
        show { open.firstState(platform.qrScanner?.kind) }
        this.open = open.emptied()
        reading = scope.launch { open.kept.clear() }
    }

    private fun tell(message: HandInsMessage) = show { copy(told = message) }

    private fun show(change: HandInsState.() -> HandInsState) {
        state = state?.change()
    }

    private companion object {
        val KINDS = listOf(FileKind.PROJECT, FileKind.ZIP, FileKind.ROBOLANG, FileKind.JAVA, FileKind.TEXT)
        const val LINKS_FILE = "links.txt"
        const val MILLISECONDS = 1_000L
        val TOO_MUCH = HandInsMessage.TooMany(KeptHandIns.MAXIMUM_FILES, KeptHandIns.MAXIMUM_MEGABYTES)
    }
}

/** In the chosen order. */
private fun HandInsState.sorted(): HandInsState {
    val byName = rows.sortedWith(compareBy<HandInRow> { it.name.lowercase() }.thenBy { it.id })
    return copy(rows = if (order == HandInOrder.NAME) byName else byName.sortedWith(BY_NEED))
}

/** Who needs most help first, and among those with the same verdict who has met fewer goals. */
private val BY_NEED = compareBy<HandInRow> { it.verdict }.thenBy { it.results?.met ?: 0 }

/** Null if there is nothing more to say. */
private fun messageFor(result: QrScanResult): HandInsMessage? = when (result) {
    QrScanResult.Ended -> null
    QrScanResult.NoCodes -> HandInsMessage.NoCodes
    QrScanResult.NotAllowed -> HandInsMessage.CameraNotAllowed
    QrScanResult.NoCamera -> HandInsMessage.NoCamera
    is QrScanResult.Failed -> HandInsMessage.Unreadable(result.reason)
}

internal fun notKept(result: StoreResult): HandInsMessage? = when (result) {
    StoreResult.Done -> null
    StoreResult.Full -> HandInsMessage.NotKept("")
    is StoreResult.Failed -> HandInsMessage.NotKept(result.reason)
}
