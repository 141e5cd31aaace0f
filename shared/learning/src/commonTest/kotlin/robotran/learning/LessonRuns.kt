package robotran.learning

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

/** Runs [program] in the world of [lesson] with [seed] until its goals are decided. */
internal suspend fun runIn(lesson: Lesson, program: String, seed: Int = 1): Attempt =
    runIn(lesson, SourceFile(lesson.program.name, program), seed)

/** The same for a program in any language. */
internal suspend fun runIn(lesson: Lesson, program: SourceFile, seed: Int): Attempt {
    val session = sessionOf(lesson, program, seed)
    session.runForGoals()
    return lesson.attempt(program.text, session.state).also { session.close() }
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

private suspend fun sessionOf(lesson: Lesson, program: SourceFile, seed: Int): Session {
    val project = lesson.project(Language.ENGLISH, listOf(program))
    val loads = readRobotLoads(project, compiler)
    return Session(
        project.worldToRun.copy(seed = seed),
        assertIs<RobotProgramSets.Success>(loads, "${lesson.name}: $loads\n${program.text}").loads,
        loadPhysicsEngine(),
        language = Language.ENGLISH,
    )
}

private const val STEP_MILLISECONDS = 20
