package robotran.assignments.grading.workers

import robotran.assignments.collecting.Submission
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.projects.writeProject
import robotran.world.file.BuiltInWorlds

/** What grading needs of [submission]: its robot, for [readHandIn]. */
fun writeHandIn(submission: Submission.Usable): String {
    // A project file needs a world, and what its robot is called there does not matter.
    val world = BuiltInWorlds.plain
    return writeProject(Project(world, listOf(submission.robot.copy(name = world.robots.first().name))))
}

/** @throws IllegalArgumentException if [text] is not what [writeHandIn] has written. */
internal fun readHandIn(text: String): Submission.Usable = when (val result = readProject(text)) {
    is ProjectFileResult.Loaded -> Submission.Usable("", "", result.project.robots.single())
    is ProjectFileResult.Rejected -> throw IllegalArgumentException(result.message)
}
