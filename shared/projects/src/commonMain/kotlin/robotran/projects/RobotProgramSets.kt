package robotran.projects

import robotran.brick.program.BrickProgram
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.ProgramSource
import robotran.projects.messages.ProjectMessages
import robotran.projects.messages.RobotMessages
import robotran.robolang.LightSensorFacing
import robotran.robolang.RobolangProgram
import robotran.simulation.RobotProgramSet
import robotran.world.LightFacing
import robotran.world.RobotPlacement
import robotran.world.World
import robotran.world.messages.sentence
import robotran.world.robot.draftError

/** The result of compiling the programs of all robots of a world. */
sealed interface RobotProgramSets {
    /**
     * @property loads one for each robot, in the world's order; the first program's header sets the light sensor's
     * direction.
     * @property warnings for the given programs only, because the pupil cannot fix the world's own programs.
     */
    data class Success(val loads: List<RobotProgramSet>, val warnings: List<Diagnostic>) : RobotProgramSets

    /**
     * The programs cannot run.
     *
     * @property robot the name of the robot with the errors.
     * @property diagnostics all errors of its programs, never empty.
     */
    data class Failure(val robot: String, val diagnostics: List<Diagnostic>) : RobotProgramSets
}

/**
 * Compiles the programs of all robots of [world] for the slots of their bricks, in order; each for its robot. A robot
 * without a program in [given] uses the world's default program, if any. None can run as long as a robot is unfinished,
 * see [unfinishedRobot].
 *
 * @param given programs by robot name; see [forFirstRobot] for programs without a robot.
 * @throws Throwable like [ProgramCompiler.read].
 */
suspend fun readRobotLoads(
    world: World,
    reader: ProgramCompiler,
    given: Map<String, List<ProgramSource>>,
): RobotProgramSets {
    val messages = ProjectMessages.of(reader.language)
    assignmentError(world, given, messages)?.let { return it }
    unfinishedRobot(world, reader.language)?.let { return it }
    val loads = mutableListOf<RobotProgramSet>()
    val warnings = mutableListOf<Diagnostic>()
    for (robot in world.robots) {
        val sources = given[robot.name].orEmpty()
        val compiler = reader.forTarget(robot.description.target)
        val results = sources.ifEmpty { listOfNotNull(robot.givenProgram) }.map { compiler.compileOrThrow(it) }
        val diagnostics = results.filterIsInstance<ProgramResult.Failure>().flatMap { it.diagnostics }
        if (diagnostics.isNotEmpty()) return RobotProgramSets.Failure(robot.name, diagnostics)
        val ready = results.filterIsInstance<ProgramResult.Success>()
        val facing = ready.firstOrNull()?.let { lightFacingOf(it.program) }
        loads += RobotProgramSet(ready.map<ProgramResult.Success, BrickProgram?> { it.program }, lightFacing = facing)
        if (sources.isNotEmpty()) warnings += ready.flatMap { it.warnings }
    }
    return RobotProgramSets.Success(loads, warnings)
}

/**
 * The error of the first robot of [world] that is still being built and is impossible so far ([RobotPlacement.draft]);
 * null if there is none.
 */
fun unfinishedRobot(world: World, language: Language): RobotProgramSets.Failure? {
    val (_, robot, draft, error) = draftError(world) ?: return null
    val message = ProjectMessages.of(language).robotUnfinished(robot, draft.title, error.sentence(language))
    return RobotProgramSets.Failure(robot, listOf(Diagnostic(Severity.ERROR, "", null, message)))
}

/** As [readRobotLoads] of a world, for [project], in its [Project.worldToRun] and with the configurations of its robots. */
suspend fun readRobotLoads(project: Project, reader: ProgramCompiler): RobotProgramSets =
    when (val result = readRobotLoads(project.world, reader, project.programs)) {
        is RobotProgramSets.Failure -> result
        is RobotProgramSets.Success -> result.copy(loads = loadsWith(project.robots, project.world, result.loads))
    }

/**
 * [loads] of the robots of [world], with the first program, the light sensor's direction and the files from [robots];
 * keeps the programs of [loads].
 */
fun loadsWith(robots: List<ProjectRobot>, world: World, loads: List<RobotProgramSet>): List<RobotProgramSet> =
    world.robots.zip(loads) { place, load ->
        val robot = robots.firstOrNull { it.name == place.name }
        val first = robot?.firstProgram ?: 0
        val facing = robot?.lightFacing ?: load.programs.getOrNull(first)?.let(::lightFacingOf)
        load.copy(firstSlot = first, lightFacing = facing, files = robot?.files.orEmpty())
    }

/** The light sensor's direction in the header of [program]; null if it has none, like all Java programs. */
fun lightFacingOf(program: BrickProgram): LightFacing? = when ((program as? RobolangProgram)?.lightSensorFacing) {
    LightSensorFacing.DOWN -> LightFacing.DOWN
    LightSensorFacing.FORWARD -> LightFacing.FORWARD
    null -> null
}

/** These programs for the pupil's own robot, for [readRobotLoads]. */
fun World.forFirstRobot(programs: List<ProgramSource>): Map<String, List<ProgramSource>> =
    mapOf(robots.first().name to programs)

/** The program that the world gives to this robot; null if it gives none. */
val RobotPlacement.givenProgram: Program?
    get() = program?.let { Program("$name${ProgramLanguage.default.extension}", ProgramLanguage.default, it) }

private fun assignmentError(
    world: World,
    given: Map<String, List<ProgramSource>>,
    messages: RobotMessages,
): RobotProgramSets.Failure? {
    val names = world.robots.map { it.name }
    given.keys.firstOrNull { it !in names }?.let { name ->
        return RobotProgramSets.Failure(
            name,
            listOf(Diagnostic(Severity.ERROR, "", null, messages.unknownRobot(name, names))),
        )
    }
    return given.entries.firstOrNull { it.value.size > BrickProgram.MAX_PROGRAMS }?.let { (name, programs) ->
        RobotProgramSets.Failure(
            name,
            listOf(
                Diagnostic(
                    Severity.ERROR,
                    "",
                    null,
                    messages.tooManyPrograms(name, programs.size, BrickProgram.MAX_PROGRAMS),
                ),
            ),
        )
    }
}
