package robotran.desktop.worlds

import kotlinx.coroutines.runBlocking
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramSource
import robotran.programs.SourceFile
import robotran.projects.PENBOT_CALIBRATION
import robotran.projects.RobotLoads
import robotran.projects.forFirstRobot
import robotran.projects.readRobotLoads
import robotran.simulation.RobotLoad
import robotran.world.World
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld
import java.io.File

/** The worlds of the folder `worlds` and their solutions, as they lie in the tree. */
internal object ShippedWorlds {
    private val tree = File(System.getProperty("robotran.tree"))
    private val solutions = tree.resolve("examples/solutions").listFiles().orEmpty().sortedBy { it.name }
    private val reader = ProgramCompiler(PENBOT_CALIBRATION)

    /** Each world by its name, such as `line-loop`. */
    val all: Map<String, World> = tree.resolve("worlds").listFiles().orEmpty().filter {
        it.name.endsWith(ENDING)
    }.sortedBy { it.name }
        .associate { it.name.removeSuffix(ENDING) to loaded(it) }

    /** Those in which there is something to be reached. */
    val withGoals: Map<String, World> = all.filterValues { it.goals.isNotEmpty() }

    /** The solution of the world called [name]: a Robolang program of the same name, or a Java class of it. */
    fun solutionOf(name: String): File {
        val ofThisName = solutions.filter { it.nameWithoutExtension.lowercase() in listOf(name, name.replace("-", "")) }
        return ofThisName.singleOrNull() ?: error("The world $name has ${ofThisName.size} solutions")
    }

    /** Every solution there is. */
    val solutionFiles: List<File> get() = solutions

    /** What the robots of [world] get if the pupil's own is given the program in [file], or an empty one for null. */
    fun loads(world: World, file: File?): List<RobotLoad> = when (
        val loads = runBlocking {
            readRobotLoads(world, reader, world.forFirstRobot(listOf(source(file))))
        }
    ) {
        is RobotLoads.Ready -> loads.loads
        is RobotLoads.HasErrors -> error("${loads.robot}: ${loads.diagnostics}")
    }

    private fun source(file: File?): ProgramSource = when (file?.extension) {
        null -> ProgramSource.Robolang("empty.robo", "")
        "java" -> ProgramSource.Java(file.name, listOf(SourceFile(file.name, file.readText())))
        else -> ProgramSource.Robolang(file.name, file.readText())
    }

    private fun loaded(file: File): World = when (val result = readWorld(file.readText())) {
        is WorldFileResult.Loaded -> result.world
        is WorldFileResult.Rejected -> error("${file.name}: ${result.message}")
    }

    private const val ENDING = ".world.json"
}
