package robotran.workshop.handins

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import robotran.assignments.collecting.byName
import robotran.assignments.comparing.compareSubmissions
import robotran.assignments.reporting.ClassReport
import robotran.assignments.reporting.CourseReport
import robotran.assignments.reporting.csvFile
import robotran.assignments.reporting.feedbackFileName
import robotran.assignments.reporting.feedbackFiles
import robotran.assignments.reporting.feedbackZip
import robotran.assignments.reporting.feedbackZipName
import robotran.assignments.reporting.htmlReport
import robotran.documents.fileNameFor
import robotran.projects.Project
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.Platform
import robotran.workshop.platform.Saving
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInsMessage
import robotran.workshop.state.HandInsState

/** Saves what a teacher takes away from grading. Hand-ins that are not graded yet are left out. */
internal class HandInExports(
    private val platform: Platform,
    private val scope: CoroutineScope,
    private val tell: (HandInsMessage) -> Unit,
) {
    fun saveCsv(open: OpenAssignment, state: HandInsState) = save(state.title, FileKind.CSV) {
        val reports = reportsOn(open, state)
        if (open.course == null) {
            csvFile(reports.single(), open.language)
        } else {
            csvFile(course(reports, state), open.language)
        }
    }

    fun savePage(open: OpenAssignment, state: HandInsState) = save(state.title, FileKind.HTML) {
        val reports = reportsOn(open, state)
        val page = if (open.course == null) {
            htmlReport(reports.single(), platform.pictures, open.language)
        } else {
            htmlReport(course(reports, state), platform.pictures, open.language)
        }
        page.encodeToByteArray()
    }

    fun saveFeedback(open: OpenAssignment, state: HandInsState) =
        save(feedbackZipName(state.title, open.language), FileKind.ZIP) {
            feedbackZip(course(reportsOn(open, state), state), open.language)
        }

    /** Saves the feedback for the hand-in [id] only. */
    fun saveFeedback(open: OpenAssignment, state: HandInsState, id: String) {
        val only = state.copy(rows = state.rows.filter { it.id == id })
        val row = only.rows.firstOrNull() ?: return
        val title = only.taskOf(row).title.ifEmpty { state.title }
        save(feedbackFileName(row.name, title, open.language), FileKind.PROJECT) {
            reportsOn(open, only).flatMap { feedbackFiles(it, open.language) }.firstOrNull()?.bytes
        }
    }

    private fun course(reports: List<ClassReport>, state: HandInsState) = CourseReport(state.title, reports)

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

/** What is graded for each assignment, by name as in a teacher's own list, whatever the order on the screen. */
private fun reportsOn(open: OpenAssignment, state: HandInsState): List<ClassReport> {
    val rows = state.rows.filter { it.graded != null }.sortedWith(compareBy(byName(open.language)) { it.submission })
    val reports = open.tasks.mapIndexed { task, graded ->
        val notes = open.notes.toList().takeIf { open.course == null }.orEmpty()
        reportOn(graded, rows.filter { it.task == task }, notes)
    }
    val unsorted = rows.filter { it.task !in open.tasks.indices }
    if (unsorted.isEmpty()) return reports
    return reports + reportOn(GradedTask(Project(open.project.world.copy(title = ""))), unsorted, emptyList())
}

private fun reportOn(task: GradedTask, rows: List<HandInRow>, notes: List<String>): ClassReport {
    val results = rows.mapNotNull { it.graded }
    val comments = rows.withIndex().filter { it.value.comment.isNotBlank() }.associate { it.index to it.value.comment }
    val pairs = compareSubmissions(results.map { it.submission }, task.project)
    return ClassReport(task.project, task.plan, results, pairs, comments, notes)
}
