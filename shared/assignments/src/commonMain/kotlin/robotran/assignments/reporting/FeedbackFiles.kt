package robotran.assignments.reporting

import robotran.assignments.collecting.PlatformName
import robotran.assignments.collecting.Submission
import robotran.assignments.doing.ordinaryText
import robotran.assignments.doing.pupilCopy
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.messages.ReportMessages
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
 * @property path the same with what the learning platform expects before it, such as the pupil's folder, if the hand-in
 * comes from one.
 */
class FeedbackFile(val name: String, val path: String, val bytes: ByteArray)

/** One file for each hand-in of [report], also for those that cannot be used: their pupils learn why. */
fun feedbackFiles(report: ClassReport, language: Language): List<FeedbackFile> {
    val taken = mutableSetOf<String>()
    val title = report.assignment.world.title
    return report.results.mapIndexedNotNull { index, result ->
        val project = feedbackProject(report, index, language)
        // Better the answer alone than none, if the hand-in cannot be written.
        val bytes = projectFile(project) ?: projectFile(Project(report.assignment.world, feedback = project.feedback))
            ?: return@mapIndexedNotNull null
        val prefix = PlatformName.prefixFor(result.submission.origin)
        val name = generateSequence(1) { it + 1 }
            .map { number -> feedbackFileName(result.submission.name, title, language, number) }
            .first { taken.add("$prefix$it".lowercase()) }
        FeedbackFile(name, "$prefix$name", bytes)
    }
}

/** All [feedbackFiles] as one zip, in the folders of the platform from which the hand-ins came. */
fun feedbackZip(report: ClassReport, language: Language): ByteArray =
    zipOf(feedbackFiles(report, language).map { ZipEntry(it.path, it.bytes) })

/** The same for all assignments of a course. */
fun feedbackZip(report: CourseReport, language: Language): ByteArray =
    report.tasks.flatMap { feedbackFiles(it, language) }.distinctBy { it.path }
        .map { ZipEntry(it.path, it.bytes) }.let(::zipOf)

/** The answer to the hand-in with the index [index]. It has nothing that only the teacher has. */
fun feedbackProject(report: ClassReport, index: Int, language: Language): Project {
    val result = report.results[index]
    val submission = result.submission
    val results = (result as? GradedHandIn.Graded)?.let { graded ->
        report.plan.worlds.map { world ->
            val runs = graded.runsIn(world.name).take(AssignmentLimits.MAXIMUM_SEEDS)
            FeedbackResult(world.name, runs.count { it.grade.passed }, runs.size)
        }
    }
    // What the machine says is told apart from what the teacher says.
    val nothing = ReportMessages.of(language).nothingToGrade().takeIf { result is GradedHandIn.Unusable }
    val reasons = listOfNotNull(nothing) + reasonsOf(result)
    val lines = listOf(report.comments[index].orEmpty(), reasons.joinToString(if (nothing == null) "\n" else " "))
    val comment = ordinaryText(
        lines.filter { it.isNotBlank() }.joinToString("\n"),
        AssignmentLimits.MAXIMUM_TEXT_CHARACTERS,
        severalLines = true,
    )
    val project = submission.project?.let(::withoutSecrets) ?: Project(
        report.assignment.world,
        listOfNotNull((submission as? Submission.Usable)?.robot),
        assignment = report.assignment.assignment?.let { Assignment(it.id, mayChangeWorld = it.mayChangeWorld) },
    )
    return project.copy(feedback = Feedback(comment, results.orEmpty()))
}

private fun withoutSecrets(project: Project): Project {
    val own = project.assignment ?: return project
    return if (own.checks == null && own.solution.isEmpty()) project else pupilCopy(project)
}
