package robotran.assignments.reporting

import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.documents.ZipEntry
import robotran.documents.projectFile
import robotran.documents.zipOf
import robotran.language.Language
import robotran.projects.Assignment
import robotran.projects.AssignmentLimits
import robotran.projects.Feedback
import robotran.projects.FeedbackResult
import robotran.projects.Project

/**
 * A file for one pupil, with the hand-in and the teacher's answer.
 *
 * @property name as [feedbackFileName] makes it, unique among the files of a class.
 */
class FeedbackFile(val name: String, val bytes: ByteArray)

/** One file for each hand-in of [report] that has programs. */
fun feedbackFiles(report: ClassReport, language: Language = Language.ENGLISH): List<FeedbackFile> {
    val taken = mutableSetOf<String>()
    val title = report.assignment.world.title
    return report.results.mapIndexedNotNull { index, result ->
        val bytes = feedbackProject(report, index)?.let(::projectFile) ?: return@mapIndexedNotNull null
        val name = generateSequence(1) { it + 1 }
            .map { number -> feedbackFileName(result.submission.name, title, language, number) }
            .first { taken.add(it.lowercase()) }
        FeedbackFile(name, bytes)
    }
}

/** All [feedbackFiles] as one zip. */
fun feedbackZip(report: ClassReport, language: Language = Language.ENGLISH): ByteArray =
    zipOf(feedbackFiles(report, language).map { ZipEntry(it.name, it.bytes) })

/** The answer to the hand-in with the index [index]; null if it has no programs. */
fun feedbackProject(report: ClassReport, index: Int): Project? {
    val result = report.results[index]
    val submission = result.submission as? Submission.Usable ?: return null
    val results = (result as? GradedHandIn.Graded)?.let { graded ->
        report.plan.worlds.map { world ->
            val runs = graded.runsIn(world.name).take(AssignmentLimits.MAXIMUM_SEEDS)
            FeedbackResult(world.name, runs.count { it.grade.passed }, runs.size)
        }
    }
    val comment = report.comments[index].orEmpty().take(AssignmentLimits.MAXIMUM_TEXT_CHARACTERS)
    val project = submission.project ?: Project(
        report.assignment.world,
        listOf(submission.robot),
        assignment = report.assignment.assignment?.let { Assignment(it.id, mayChangeWorld = it.mayChangeWorld) },
    )
    return project.copy(feedback = Feedback(comment, results.orEmpty()))
}
