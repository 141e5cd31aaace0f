package robotran.assignments.course

import robotran.language.Language
import robotran.languagesupport.SourceFile
import robotran.learning.Lesson
import robotran.learning.LessonPlace
import robotran.learning.LessonText
import robotran.learning.Lessons
import robotran.learning.Strand
import robotran.learning.WorldGallery
import robotran.learning.hint.HintCondition
import robotran.programs.Program
import robotran.programs.support
import robotran.projects.Assignment
import robotran.projects.AssignmentChecks
import robotran.projects.AssignmentHint
import robotran.projects.AssignmentLimits
import robotran.projects.Course
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.WorldVariation

/**
 * Courses of the lessons and worlds that come with Robotran, for teachers to read, change and give to pupils. Programs in
 * them, and program text in their tasks and hints, have the words that the caller names.
 */
object OwnCourses {
    /** The name of the course of the gallery's worlds. */
    const val WORLDS = "worlds"

    /** The names of all courses: the strands in their order, then [WORLDS]. */
    val names: List<String> get() = Lessons.strands.map { it.name } + WORLDS

    /** The course called [name], with checks and solutions; null if there is none. */
    fun named(name: String, language: Language, words: Language = Language.ENGLISH): Course? = if (name == WORLDS) {
        worlds(language, words)
    } else {
        Lessons.strands.firstOrNull { it.name == name }?.let { of(it, language, words) }
    }

    /** The lessons of [strand]. */
    fun of(strand: Strand, language: Language, words: Language = Language.ENGLISH): Course = Course(
        strand.title(language),
        strand.about(language),
        strand.lessons.map { assignmentOf(it, language, words) },
        "robotran-${strand.name}",
    )

    /** The worlds that have a task, the easy ones first. */
    fun worlds(language: Language, words: Language = Language.ENGLISH): Course = Course(
        CourseMessages.of(language).worlds(),
        CourseMessages.of(language).aboutWorlds(),
        WorldGallery.worlds.mapNotNull { it.lesson }.map { assignmentOf(it, language, words) },
        "robotran-$WORLDS",
    )

    /**
     * [lesson] as an assignment with checks and solution: the hint for what went wrong first, then those that give away
     * more with each failed try. A hand-in is graded in all places of the lesson.
     */
    fun assignmentOf(lesson: Lesson, language: Language, words: Language = Language.ENGLISH): Project {
        val text = lesson.text(language, words = words)
        val hints = conditionalHints(text) + listOf(
            AssignmentHint(text.nudge),
            AssignmentHint(text.part, afterTries = TRIES_BEFORE_PART),
            AssignmentHint(text.solution, afterTries = TRIES_BEFORE_SOLUTION),
        )
        val assignment = Assignment(
            id = "robotran-${lesson.name.replace('/', '-')}",
            text = text.paragraphs.joinToString("\n\n"),
            hints = hints.takeLast(AssignmentLimits.MAXIMUM_HINTS),
            checks = AssignmentChecks(SEEDS, variationsOf(lesson, language, words)),
            solution = listOf(programOf(lesson, lesson.solution, words)),
        )
        return lesson.project(language, listOf(inWords(lesson, lesson.program, words)), words = words)
            .copy(assignment = assignment)
    }

    /** The pupil tries an assignment in one place, so nothing went wrong only in the other one. */
    private fun conditionalHints(text: LessonText): List<AssignmentHint> =
        text.whens.filterNot { it.condition.phrase == HintCondition.AGAIN }
            .map { AssignmentHint(it.text, it.condition.phrase) }

    private fun variationsOf(lesson: Lesson, language: Language, words: Language): List<WorldVariation> =
        lesson.places.filter { it != LessonPlace.FIRST }.map { place ->
            WorldVariation(CourseMessages.of(language).again(), lesson.world(language, place, words))
        }

    private fun programOf(lesson: Lesson, file: SourceFile, words: Language) =
        ProjectProgram(Program(file.name, lesson.programLanguage, listOf(inWords(lesson, file, words))))

    private fun inWords(lesson: Lesson, file: SourceFile, words: Language) =
        file.copy(text = lesson.programLanguage.support.inWords(file.text, words))

    private val SEEDS = 1..20
    private const val TRIES_BEFORE_PART = 3
    private const val TRIES_BEFORE_SOLUTION = 5
}
