package robotran.cli.input

import kotlinx.coroutines.runBlocking
import robotran.cli.console.messages
import robotran.cli.files.NamedProgram
import robotran.cli.files.ProgramFiles
import robotran.cli.files.readProgramFiles
import robotran.cli.messages.CommandMessages
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.projects.ProjectRobot
import robotran.projects.RobotProgramSets
import robotran.projects.loadsWith
import robotran.projects.readRobotLoads
import robotran.projects.target
import robotran.simulation.RobotProgramSet

/** A file for a robot of the world, such as `--robot red=Ram.robo`. */
internal data class RobotFile(val robot: String, val file: String)

/** Parses `NAME=FILE`; null if [text] has another form. */
internal fun readRobotFile(text: String): RobotFile? {
    val name = text.substringBefore('=', "").trim()
    val file = text.substringAfter('=', "").trim()
    return RobotFile(name, file).takeIf { name.isNotEmpty() && file.isNotEmpty() }
}

/** Parses `NAME=FILE`, or `FILE` for the first robot, whose name is then empty; null if [text] has another form. */
internal fun readRobotBuild(text: String): RobotFile? =
    if ('=' in text) readRobotFile(text) else RobotFile("", text.trim()).takeIf { it.file.isNotEmpty() }

/** The result of reading the programs of all robots in a world. */
internal sealed interface RobotProgramsResult {
    /**
     * @property loads one per robot, in the world's order.
     * @property notes how files of the others were read although they are unusual, in sentences.
     */
    data class Success(val loads: List<RobotProgramSet>, val notes: List<String> = emptyList()) : RobotProgramsResult

    /** The programs cannot run. Each of [reasons] is one line of text. If the files are readable, they have errors. */
    data class Failure(val reasons: List<String>, val isReadable: Boolean = true) : RobotProgramsResult
}

/**
 * Reads the programs of all robots in the world [place]: [own] for the first robot and [others] for the named ones. The
 * remaining robots get the programs of the project or the world.
 */
internal fun readLoads(
    place: LoadedWorld,
    compiler: ProgramCompiler,
    own: Submission,
    others: List<RobotFile>,
): RobotProgramsResult {
    val world = place.world
    val messages = CommandMessages.of(compiler.language)
    val given = mutableMapOf<String, List<NamedProgram>>()
    val notes = mutableListOf<String>()
    for ((robot, files) in others.groupBy({ it.robot }, { it.file })) {
        when (val read = readProgramFiles(files, messages)) {
            is ProgramFiles.Success -> given[robot] = read.programs.also { notes += read.notes }
            is ProgramFiles.Failure -> return RobotProgramsResult.Failure(listOf(read.reason))
        }
    }
    val first = world.robots.first().name
    if (first in given) return RobotProgramsResult.Failure(listOf(messages.firstRobotNamed(first)))
    val robots = place.others.filter { it.name !in given }
    robots.forEach { robot -> given[robot.name] = robot.programs.map { NamedProgram(it.name, it.program) } }
    given[first] = own.programs
    val result = runBlocking {
        readRobotLoads(
            world,
            compiler,
            given.mapValues { (_, programs) ->
                programs.map { it.source }
            },
        )
    }
    val choices = robots + ProjectRobot(first, firstProgram = own.firstProgram, lightFacing = own.lightFacing)
    return when (result) {
        is RobotProgramSets.Success -> RobotProgramsResult.Success(loadsWith(choices, world, result.loads), notes)

        is RobotProgramSets.Failure -> {
            val target = world.robots.firstOrNull { it.name == result.robot }?.description?.target
            val itsReader = if (target == null) compiler else compiler.forTarget(target)
            RobotProgramsResult.Failure(linesOf(result, given[result.robot].orEmpty(), itsReader))
        }
    }
}

/** The diagnostics with file names as the user entered them. This needs a separate read of each program. */
private fun linesOf(
    mistaken: RobotProgramSets.Failure,
    programs: List<NamedProgram>,
    compiler: ProgramCompiler,
): List<String> = programs
    .flatMap { program ->
        val result = runBlocking { compiler.compileOrThrow(program.source) }
        (result as? ProgramResult.Failure)?.diagnostics.orEmpty().map { lineOf(program, it) }
    }.ifEmpty { mistaken.diagnostics.map { if (it.file.isEmpty()) it.message else lineOf(it.file, it) } }
