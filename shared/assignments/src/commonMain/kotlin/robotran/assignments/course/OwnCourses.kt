package robotran.assignments.course

import robotran.assignments.messages.CourseMessages
import robotran.language.Language
import robotran.learning.GalleryWorld
import robotran.learning.Lesson
import robotran.learning.Strand
import robotran.learning.WorldGallery
import robotran.projects.Assignment
import robotran.projects.AssignmentChecks
import robotran.projects.AssignmentHint
import robotran.projects.Project
import robotran.projects.ProjectProgram

/** The lessons of [strand] as a course like that of any teacher. */
fun courseOf(strand: Strand, language: Language): Course =
    Course(strand.title(language), strand.about(language), strand.lessons.map { assignmentOf(it, language) })

/**
 * The tasks of [worlds] as a course: each world, then its harder variations.
 *
 * @param worlds of the gallery; those without a task are left out.
 */
fun courseOf(worlds: List<GalleryWorld>, language: Language): Course {
    val messages = CourseMessages.of(language)
    val lessons = worlds.flatMap { listOf(it) + it.harder }.mapNotNull { it.lesson }
    return Course(messages.worldsTitle(), messages.aboutWorlds(), lessons.map { assignmentOf(it, language) })
}

/** The same for all worlds of the gallery. */
fun courseOfWorlds(language: Language): Course = courseOf(WorldGallery.worlds, language)

/**
 * [lesson] as an assignment: with its text, the program to begin with, its hints and its solution. Grading takes five
 * seeds.
 */
fun assignmentOf(lesson: Lesson, language: Language): Project {
    val text = lesson.text(language)
    val staged = listOf(text.nudge, text.part, text.solution)
    val hints = text.whens.map { AssignmentHint(it.text, it.condition.phrase) } +
        staged.mapIndexed { index, hint -> AssignmentHint(hint, afterTries = index + 1) }
    return lesson.project(language).copy(
        assignment = Assignment(
            id = lesson.name,
            text = (text.paragraphs + text.task).joinToString("\n\n"),
            hints = hints,
            checks = AssignmentChecks(SEEDS),
            solution = listOf(solutionOf(lesson)),
        ),
    )
}

private fun solutionOf(lesson: Lesson): ProjectProgram {
    val file = lesson.solution
    return ProjectProgram(file.name, lesson.code, listOf(file))
}

private val SEEDS = 1..5
