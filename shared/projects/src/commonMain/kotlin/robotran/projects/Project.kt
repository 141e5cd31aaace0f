package robotran.projects

import robotran.language.ProgramLanguage
import robotran.programs.JavaSettings
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramSource
import robotran.programs.SourceFile
import robotran.simulation.RecordedInput
import robotran.world.LightFacing
import robotran.world.UnknownFields
import robotran.world.World

/**
 * What a pupil keeps and shares: programs for the robots of a world, the world itself, and how they run.
 * `docs/worlds.md` describes the file it is kept in.
 *
 * @property world as the teacher made it; see [settings] for what the pupil has changed about it.
 * @property robots those of the world's robots that have been given something, each once.
 * @property inputs what was done to a session from outside, in order; with them the session can be repeated.
 * @property unknown what a newer Robotran or somebody else has written into the file.
 */
data class Project(
    val world: World,
    val robots: List<ProjectRobot> = emptyList(),
    val settings: ProjectSettings = ProjectSettings(),
    val inputs: List<RecordedInput> = emptyList(),
    val unknown: UnknownFields = UnknownFields.NONE,
) {
    /** The world as sessions of this project have it. */
    val worldToRun: World get() = world.copy(
        seed = settings.seed ?: world.seed,
        realism =
            settings.realism ?: world.realism,
    )

    /** The programs by the names of the robots, as [readRobotLoads] takes them. */
    val programs: Map<String, List<ProgramSource>> get() = robots.associate { robot ->
        robot.name to
            robot.programs.map { it.source }
    }
}

/**
 * What one robot of a [Project] has been given.
 *
 * @property name which robot of the world it is.
 * @property programs for the slots of its brick, five at most; none for what the world gives it.
 * @property firstProgram the program that Run starts as long as Prgm was not pressed, from 0.
 * @property lightFacing where the pupil has turned its light sensor, if the world leaves that open.
 */
data class ProjectRobot(
    val name: String,
    val programs: List<ProjectProgram> = emptyList(),
    val firstProgram: Int = 0,
    val lightFacing: LightFacing? = null,
    val unknown: UnknownFields = UnknownFields.NONE,
)

/**
 * A program as the pupil has written it.
 *
 * @property name what the pupil knows it by, usually the name of its first file.
 * @property files one for Robolang, one or more for Java.
 */
data class ProjectProgram(
    val name: String,
    val language: ProgramLanguage,
    val files: List<SourceFile>,
    val unknown: UnknownFields = UnknownFields.NONE,
) {
    val source: ProgramSource
        get() = when (language) {
            ProgramLanguage.ROBOLANG -> ProgramSource.Robolang(name, files.single().text)
            ProgramLanguage.JAVA -> ProgramSource.Java(name, files)
        }

    companion object {
        /** Null for class files, which nobody could go on writing. */
        fun of(source: ProgramSource): ProjectProgram? = when (source) {
            is ProgramSource.Robolang -> ProjectProgram(
                source.name,
                ProgramLanguage.ROBOLANG,
                listOf(SourceFile(source.name, source.text)),
            )

            is ProgramSource.Java -> ProjectProgram(source.name, ProgramLanguage.JAVA, source.files)

            is ProgramSource.CompiledClasses -> null
        }
    }
}

/**
 * How the programs of a [Project] run.
 *
 * @property seed instead of the world's; null for the world's.
 * @property realism the same, 0..1.
 * @property java how Java programs run; to be given to the [ProgramCompiler].
 */
data class ProjectSettings(
    val seed: Int? = null,
    val realism: Double? = null,
    val java: JavaSettings = JavaSettings(),
    val unknown: UnknownFields = UnknownFields.NONE,
)
