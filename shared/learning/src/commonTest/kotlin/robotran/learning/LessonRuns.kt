package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.languagesupport.SourceFile
import robotran.learning.hint.Attempt
import robotran.programs.ProgramCompiler
import robotran.projects.PENBOT_TARGET
import robotran.projects.RobotProgramSets
import robotran.projects.readRobotLoads
import robotran.simulation.Session
import robotran.simulation.grade.GoalRun
import robotran.simulation.grade.runForGoals
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.GoalProgress
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.HasParts
import kotlin.test.assertIs

private val compiler = ProgramCompiler(PENBOT_TARGET, language = Language.ENGLISH)

/** The tasks of the gallery's worlds and their harder variations. */
internal val worldTasks: List<Lesson> by lazy {
    WorldGallery.worlds.flatMap { listOf(it) + it.harder }.mapNotNull { it.lesson }
}

/** The lessons that are not about one brick, as they are written. */
internal val lessonsForAllBricks: List<Lesson> by lazy { Lessons.all.filter { it.brick == BrickKind.default } }

/** Runs [program] in the world of [lesson] at [place] with [seed] until its goals are decided. */
internal suspend fun runIn(
    lesson: Lesson,
    program: String,
    seed: Int = 1,
    place: LessonPlace = LessonPlace.FIRST,
    hasPassed: Boolean = false,
): Attempt = runIn(lesson, SourceFile(lesson.program.name, program), seed, place, hasPassed)

/** The same for a program in any language. */
internal suspend fun runIn(
    lesson: Lesson,
    program: SourceFile,
    seed: Int,
    place: LessonPlace = LessonPlace.FIRST,
    hasPassed: Boolean = false,
): Attempt {
    val session = sessionOf(lesson, program, seed, place)
    session.runForGoals()
    return lesson.attempt(program.text, session.state, place, hasPassed).also { session.close() }
}

/** The last run of [program] in the places of [lesson], in their order: the first in which it misses a goal. */
internal suspend fun runInAllPlaces(lesson: Lesson, program: String, seed: Int = 1): Attempt {
    val first = runIn(lesson, program, seed)
    val others = lesson.places.filter { it != LessonPlace.FIRST }
    return others.fold(first) { before, place ->
        if (before.isSolved) runIn(lesson, program, seed, place, hasPassed = true) else before
    }
}

/**
 * Whether at some moment of the run of [program] all goals held, apart from the end of the program: had the program come
 * to its end then, the task would have been solved.
 */
internal suspend fun isRightOnTheWay(lesson: Lesson, program: SourceFile): Boolean {
    val session = sessionOf(lesson, program, seed = 1)
    val run = GoalRun(session)
    var isRight = false
    while (!isRight && !run.isOver) {
        run.advance(STEP_MILLISECONDS)
        isRight = session.world.goals.zip(session.state.goals).all { (goal, progress) -> holds(goal, progress) }
    }
    session.close()
    return isRight
}

private fun holds(goal: Goal, progress: GoalProgress): Boolean {
    val parts = goal.parts.zip(progress.parts)
    val group = goal.condition as? HasParts
    return when {
        goal.condition is GoalCondition.EndWithin -> true
        group == null -> progress.holds
        group.needsAll -> parts.all { (part, told) -> holds(part, told) }
        else -> parts.any { (part, told) -> holds(part, told) }
    }
}

private suspend fun sessionOf(
    lesson: Lesson,
    program: SourceFile,
    seed: Int,
    place: LessonPlace = LessonPlace.FIRST,
): Session {
    val project = lesson.project(Language.ENGLISH, listOf(program), place)
    val loads = readRobotLoads(project, compiler)
    return Session(
        project.worldToRun.copy(seed = seed),
        assertIs<RobotProgramSets.Success>(loads, "${lesson.name}: $loads\n${program.text}").loads,
        loadPhysicsEngine(),
        language = Language.ENGLISH,
    )
}

private const val STEP_MILLISECONDS = 20
