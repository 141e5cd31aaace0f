package robotran.desktop.cli

import kotlinx.coroutines.runBlocking
import robotran.desktop.files.NamedProgram
import robotran.desktop.files.ProgramFiles
import robotran.desktop.files.readProgramFiles
import robotran.desktop.messages.CommandMessages
import robotran.programs.ProgramReader
import robotran.programs.ProgramResult
import robotran.projects.RobotLoads
import robotran.projects.readRobotLoads
import robotran.world.RobotLoad
import robotran.world.World

/** A program for a robot of the world, as `--robot red=Ram.robo` says it. */
internal data class RobotFile(
    val robot: String,
    val file: String,
)

/** Reads `NAME=FILE`; null if that is not what [text] is. */
internal fun readRobotFile(text: String): RobotFile? {
    val name = text.substringBefore('=', "").trim()
    val file = text.substringAfter('=', "").trim()
    return RobotFile(name, file).takeIf { name.isNotEmpty() && file.isNotEmpty() }
}

/** What came of reading what the robots of a world are to run. */
internal sealed interface Loading {
    /** @property loads one for each robot, in the world's order. */
    data class Loaded(val loads: List<RobotLoad>) : Loading

    /** They cannot run; each of [reasons] is a line for a person. */
    data class Refused(val reasons: List<String>) : Loading
}

/** Reads the programs of all robots of [world]: [own] for the first one, [others] for those that are named, else what the world gives them. */
internal fun readLoads(
    world: World,
    reader: ProgramReader,
    own: List<NamedProgram>,
    others: List<RobotFile>,
): Loading {
    val messages = CommandMessages.of(reader.language)
    val given = mutableMapOf<String, List<NamedProgram>>()
    for ((robot, files) in others.groupBy({ it.robot }, { it.file })) {
        when (val read = readProgramFiles(files, messages)) {
            is ProgramFiles.Read -> given[robot] = read.programs
            is ProgramFiles.Refused -> return Loading.Refused(listOf(read.reason))
        }
    }
    val first = world.robots.first().name
    if (first in given) return Loading.Refused(listOf(messages.firstRobotNamed(first)))
    given[first] = own
    val result = runBlocking { readRobotLoads(world, reader, given.mapValues { (_, programs) -> programs.map { it.source } }) }
    return when (result) {
        is RobotLoads.Ready -> Loading.Loaded(result.loads)
        is RobotLoads.Mistaken -> Loading.Refused(linesOf(result, given[result.robot].orEmpty(), reader))
    }
}

/** The mistakes with the files as they were named, which only reading each program by itself tells. */
private fun linesOf(
    mistaken: RobotLoads.Mistaken,
    programs: List<NamedProgram>,
    reader: ProgramReader,
): List<String> =
    programs
        .flatMap { program ->
            val result = runBlocking { reader.read(program.source) }
            (result as? ProgramResult.Mistaken)?.mistakes.orEmpty().map { lineOf(program, it) }
        }.ifEmpty { mistaken.mistakes.map { if (it.file.isEmpty()) it.message else lineOf(it.file, it) } }
