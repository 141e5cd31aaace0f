package robotran.learning

import robotran.language.Language
import robotran.learning.hint.Attempt
import robotran.programs.ProgramCompiler
import robotran.programs.SourceFile
import robotran.projects.PENBOT_TARGET
import robotran.projects.RobotLoads
import robotran.projects.readRobotLoads
import robotran.simulation.Session
import robotran.simulation.grade.runForGoals
import robotran.simulation.physics.loadPhysicsEngine
import kotlin.test.assertIs

private val compiler = ProgramCompiler(PENBOT_TARGET)

/** The tasks of the gallery's worlds and their harder variations. */
internal val worldTasks: List<Lesson> by lazy {
    WorldGallery.worlds.flatMap { listOf(it) + it.harder }.mapNotNull { it.lesson }
}

/** Runs [program] in the world of [lesson] with [seed] until its goals are decided. */
internal suspend fun runIn(lesson: Lesson, program: String, seed: Int = 1): Attempt =
    runIn(lesson, SourceFile(lesson.program.name, program), seed)

/** The same for a program in any language. */
internal suspend fun runIn(lesson: Lesson, program: SourceFile, seed: Int): Attempt {
    val project = lesson.project(Language.ENGLISH, listOf(program))
    val loads = readRobotLoads(project, compiler)
    val world = project.worldToRun.copy(seed = seed)
    val session = Session(
        world,
        assertIs<RobotLoads.Ready>(loads, "${lesson.name}: $loads\n${program.text}").loads,
        loadPhysicsEngine(),
    )
    session.runForGoals()
    return lesson.attempt(program.text, session.state).also { session.close() }
}
