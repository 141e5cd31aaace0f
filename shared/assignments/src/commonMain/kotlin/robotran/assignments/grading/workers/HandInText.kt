package robotran.assignments.grading.workers

import kotlinx.serialization.builtins.ListSerializer
import kotlinx.serialization.builtins.serializer
import kotlinx.serialization.json.Json
import robotran.assignments.collecting.Submission
import robotran.language.Language
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.projects.writeProject
import robotran.world.file.BuiltInWorlds

/** What grading needs of [submission]: the robots of all that may count, for [readHandIn]. */
fun writeHandIn(submission: Submission.Usable): String {
    // A project file needs a world, and what its robot is called there does not matter.
    val world = BuiltInWorlds.plain
    val name = world.robots.first().name
    val attempts = submission.attempts.map { writeProject(Project(world, listOf(it.robot.copy(name = name)))) }
    return Json.encodeToString(TEXTS, attempts)
}

/** @throws IllegalArgumentException if [text] is not what [writeHandIn] has written. */
internal fun readHandIn(text: String): Submission.Usable {
    val attempts = Json.decodeFromString(TEXTS, text).map(::attemptIn)
    require(attempts.isNotEmpty()) { "There is no program." }
    return attempts.first().copy(alternatives = attempts.drop(1))
}

private fun attemptIn(text: String): Submission.Usable = when (val result = readProject(text, Language.ENGLISH)) {
    is ProjectFileResult.Success -> Submission.Usable("", "", result.project.robots.single())
    is ProjectFileResult.Failure -> throw IllegalArgumentException(result.message)
}

private val TEXTS = ListSerializer(String.serializer())
