package robotran.workshop.handins

import robotran.assignments.grading.GradingPlan
import robotran.language.Language
import robotran.projects.Project
import robotran.workshop.platform.KeyValueStore
import robotran.workshop.state.HandInsKind
import robotran.workshop.state.HandInsState

/**
 * The assignment that hand-ins are graded for.
 *
 * @property name of the project.
 * @property language of what grading says.
 */
internal class OpenAssignment(val name: String, val project: Project, val language: Language, store: KeyValueStore) {
    val plan = GradingPlan.of(project)
    val kept = KeptHandIns(store, project.assignment?.id ?: "world ${project.world.title}")
    val submissions = MergedSubmissions()

    fun isFor(project: Project, language: Language): Boolean = this.project == project && this.language == language

    /** The page before anything is brought in. */
    fun firstState(): HandInsState {
        val assignment = project.assignment
        return HandInsState(
            title = project.world.title.ifEmpty { name },
            kind = when {
                assignment == null -> HandInsKind.WORLD
                assignment.checks == null -> HandInsKind.WITHOUT_CHECKS
                else -> HandInsKind.WITH_CHECKS
            },
            plan = plan,
            solution = assignment?.solution.orEmpty(),
        )
    }
}
