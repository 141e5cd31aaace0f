package robotran.workshop.handins

import robotran.assignments.collecting.CollectedHandIns
import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradingPlan
import robotran.language.Language
import robotran.projects.Project
import robotran.workshop.platform.KeyValueStore
import robotran.workshop.state.HandInsKind
import robotran.workshop.state.HandInsState
import robotran.workshop.state.QrScannerKind

/**
 * The assignment that hand-ins are graded for.
 *
 * @property name of the project.
 * @property language of what grading says.
 */
internal class OpenAssignment(
    val name: String,
    val project: Project,
    val language: Language,
    private val store: KeyValueStore,
) {
    val plan = GradingPlan.of(project)
    val kept = KeptHandIns(store, project.assignment?.id ?: "world ${project.world.title}")
    val submissions = MergedSubmissions()

    /** On files that are no hand-ins, in sentences. */
    val notes = linkedSetOf<String>()

    /** The number of the last link that was pasted or scanned. */
    var lastLink = 0

    /** Adds what was found in one batch of files. Returns the hand-ins that are new. */
    fun take(collected: CollectedHandIns): List<Submission> {
        notes += collected.notes
        return submissions.add(collected.submissions)
    }

    /** Whether [project] would give the same grades, in the same words. */
    fun isFor(project: Project, language: Language): Boolean =
        graded(this.project) == graded(project) && this.language == language

    /** The same without hand-ins. */
    fun emptied() = OpenAssignment(name, project, language, store)

    /** What matters: the teacher's own tries do not. */
    private fun graded(project: Project) = project.withoutViews().copy(tries = null, inputs = emptyList())

    /**
     * The page before anything is brought in.
     *
     * @param scanners the platform's.
     */
    fun firstState(scanners: List<QrScannerKind>): HandInsState {
        val assignment = project.assignment
        return HandInsState(
            title = project.world.title.ifEmpty { name },
            kind = when {
                assignment == null -> HandInsKind.WORLD
                assignment.checks == null -> HandInsKind.WITHOUT_CHECKS
                else -> HandInsKind.WITH_CHECKS
            },
            plan = plan,
            scanners = scanners,
            solution = assignment?.solution.orEmpty(),
        )
    }
}
