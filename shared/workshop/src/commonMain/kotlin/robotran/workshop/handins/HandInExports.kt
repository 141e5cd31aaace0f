package robotran.workshop.handins

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import robotran.assignments.comparing.compareSubmissions
import robotran.assignments.reporting.ClassReport
import robotran.assignments.reporting.csvFile
import robotran.assignments.reporting.feedbackFileName
import robotran.assignments.reporting.feedbackFiles
import robotran.assignments.reporting.feedbackZip
import robotran.assignments.reporting.feedbackZipName
import robotran.assignments.reporting.htmlReport
import robotran.documents.fileNameFor
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.Platform
import robotran.workshop.platform.Saving
import robotran.workshop.state.HandInsMessage
import robotran.workshop.state.HandInsState

/** Saves what a teacher takes away from grading. Hand-ins that are not graded yet are left out. */
internal class HandInExports(
    private val platform: Platform,
    private val scope: CoroutineScope,
    private val tell: (HandInsMessage) -> Unit,
) {
    fun saveCsv(open: OpenAssignment, state: HandInsState) =
        save(state.title, FileKind.CSV) { csvFile(reportOf(open, state), open.language) }

    fun savePage(open: OpenAssignment, state: HandInsState) = save(state.title, FileKind.HTML) {
        htmlReport(reportOf(open, state), platform.pictures, open.language).encodeToByteArray()
    }

    fun saveFeedback(open: OpenAssignment, state: HandInsState) =
        save(feedbackZipName(state.title, open.language), FileKind.ZIP) {
            feedbackZip(reportOf(open, state), open.language)
        }

    /** Saves the feedback for the hand-in [id] only. */
    fun saveFeedback(open: OpenAssignment, state: HandInsState, id: String) {
        val only = state.copy(rows = state.rows.filter { it.id == id })
        val name = only.rows.firstOrNull()?.name ?: return
        save(feedbackFileName(name, state.title, open.language), FileKind.PROJECT) {
            feedbackFiles(reportOf(open, only)).firstOrNull()?.bytes
        }
    }

    private fun save(name: String, kind: FileKind, make: () -> ByteArray?) {
        scope.launch {
            val bytes = withContext(platform.background) { make() } ?: return@launch
            when (val saving = platform.files.save(fileNameFor(name, kind), kind, bytes)) {
                is Saving.Saved -> tell(HandInsMessage.Saved(saving.name))
                is Saving.Failed -> tell(HandInsMessage.NotSaved(saving.reason, saving.isFull))
                Saving.Cancelled -> Unit
            }
        }
    }
}

/** What is graded, by name as in a teacher's own list, whatever the order on the screen. */
private fun reportOf(open: OpenAssignment, state: HandInsState): ClassReport {
    val rows = state.rows.filter { it.graded != null }.sortedBy { it.name.lowercase() }
    val results = rows.mapNotNull { it.graded }
    val comments = rows.withIndex().filter { it.value.comment.isNotBlank() }.associate { it.index to it.value.comment }
    return ClassReport(
        open.project,
        open.plan,
        results,
        compareSubmissions(results.map { it.submission }, open.project),
        comments,
        open.notes.toList(),
    )
}
