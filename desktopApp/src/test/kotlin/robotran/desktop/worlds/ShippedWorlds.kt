package robotran.desktop.worlds

import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramSource
import robotran.projects.PENBOT_TARGET
import robotran.projects.RobotProgramSets
import robotran.projects.forFirstRobot
import robotran.projects.readRobotLoads
import robotran.simulation.RobotProgramSet
import robotran.world.World
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld
import java.io.File

/** The worlds of the folder `worlds` in the tree, and their solutions. */
internal object ShippedWorlds {
    private val tree = File(System.getProperty("robotran.tree"))
    private val reader = ProgramCompiler(PENBOT_TARGET, language = Language.ENGLISH)

    /** All worlds by name, such as `line-loop`. */
    val all: Map<String, World> = tree.resolve("worlds").listFiles().orEmpty().filter {
        it.name.endsWith(ENDING)
    }.sortedBy { it.name }
        .associate { it.name.removeSuffix(ENDING) to loaded(it) }

    /** The worlds that have goals. */
    val withGoals: Map<String, World> = all.filterValues { it.goals.isNotEmpty() }

    /** The solutions of the world [name]: one, or one in each language. */
    fun solutionsOf(name: String): List<File> = tree.resolve("learning/worlds/$name").listFiles().orEmpty()
        .filter { it.nameWithoutExtension == "solution" }.sorted().also { check(it.isNotEmpty()) { name } }

    /** The programs of all robots in [world]. The pupil's robot gets [file], or an empty program for null. */
    fun loads(world: World, file: File?): List<RobotProgramSet> = when (
        val loads = runBlocking {
            readRobotLoads(world, reader, world.forFirstRobot(listOf(source(file))))
        }
    ) {
        is RobotProgramSets.Success -> loads.loads
        is RobotProgramSets.Failure -> error("${loads.robot}: ${loads.diagnostics}")
    }

    private fun source(file: File?): ProgramSource {
        if (file == null) return Program("empty.robo", ProgramLanguage.ROBOLANG, "")
        val language = checkNotNull(ProgramLanguage.ofFile(file.name)) { file.name }
        return Program(file.name, language, file.readText())
    }

    private fun loaded(file: File): World = when (val result = readWorld(file.readText(), Language.ENGLISH)) {
        is WorldFileResult.Success -> result.world
        is WorldFileResult.Failure -> error("${file.name}: ${result.message}")
    }

    private const val ENDING = ".world.json"
}
