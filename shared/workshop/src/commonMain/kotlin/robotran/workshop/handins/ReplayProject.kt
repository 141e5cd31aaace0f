package robotran.workshop.handins

import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradingPlan
import robotran.projects.Project
import robotran.projects.ProjectSettings
import robotran.workshop.state.HandInRun

/**
 * A project that repeats a run of [submission]: the one of grading in [run], or the pupil's own for null. Null if there
 * is no such run. It is no hand-in itself, so that it can be changed and run like any project.
 */
internal fun replayProject(
    assignment: Project,
    plan: GradingPlan,
    submission: Submission.Usable,
    run: HandInRun?,
): Project? {
    if (run == null) {
        return submission.project?.takeIf { it.inputs.isNotEmpty() }
            ?.copy(assignment = null, tries = null, handIn = null, feedback = null)
    }
    val world = plan.worlds.firstOrNull { it.name == run.world }?.world?.copy(seed = run.seed) ?: return null
    val names = world.robots.map { it.name }
    val own = names.first()
    val others = assignment.robots.filter { it.name != assignment.world.robots.first().name && it.name != own }
    return Project(
        world,
        listOf(submission.robot.copy(name = own)) + others.filter { it.name in names },
        ProjectSettings(java = assignment.settings.java),
    )
}
