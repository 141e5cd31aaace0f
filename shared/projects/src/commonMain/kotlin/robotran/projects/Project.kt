package robotran.projects

import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.nxt.storage.NxtFile
import robotran.programs.JavaSettings
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramSource
import robotran.programs.toLasm
import robotran.simulation.RecordedInput
import robotran.world.LightFacing
import robotran.world.UnknownFields
import robotran.world.World

/**
 * A project that a pupil saves and shares: a world, programs for its robots, and run settings. `docs/worlds.md`
 * describes the file format.
 *
 * @property world the teacher's original; [settings] holds the pupil's changes.
 * @property robots those of the world's robots that have a configuration, each once.
 * @property inputs the external inputs of a session, in order, to replay it.
 * @property assignment the task that a teacher has set in this project; null for any other project.
 * @property tries the pupil's tries at [assignment].
 * @property handIn marks the project as handed in for [assignment].
 * @property feedback the teacher's answer to [handIn].
 * @property unknown fields of the file from a newer Robotran or another program.
 */
data class Project(
    val world: World,
    val robots: List<ProjectRobot> = emptyList(),
    val settings: ProjectSettings = ProjectSettings(),
    val inputs: List<RecordedInput> = emptyList(),
    val assignment: Assignment? = null,
    val tries: AssignmentTries? = null,
    val handIn: HandIn? = null,
    val feedback: Feedback? = null,
    val unknown: UnknownFields = UnknownFields.NONE,
) {
    /** The world with this project's settings, for sessions. */
    val worldToRun: World get() = world.copy(
        seed = settings.seed ?: world.seed,
        realism = settings.realism ?: world.realism,
    )

    /** The programs by robot name, for [readRobotLoads]. */
    val programs: Map<String, List<ProgramSource>> get() = robots.associate { robot ->
        robot.name to
            robot.programs.map { it.program }
    }

    /** The same project with an empty flash memory in each robot. */
    fun withoutFiles(): Project = copy(robots = robots.map { it.copy(files = emptyList()) })

    /** The same project, which does not say how its programs are shown, nor which is in front. */
    fun withoutViews(): Project = copy(
        robots = robots.map { robot ->
            robot.copy(programs = robot.programs.map { it.copy(view = null) }, firstProgram = 0)
        },
    )
}

/**
 * The configuration of one robot of a [Project].
 *
 * @property name the robot's name in the world.
 * @property programs for the slots of its brick, at most five; empty for the world's default program.
 * @property firstProgram index of the program that Run starts if Prgm was not pressed.
 * @property lightFacing the light sensor's direction that the pupil chose, if the world leaves it open.
 * @property files what its programs have written into an NXT's flash memory. A run begins with them; grading does not.
 */
data class ProjectRobot(
    val name: String,
    val programs: List<ProjectProgram> = emptyList(),
    val firstProgram: Int = 0,
    val lightFacing: LightFacing? = null,
    val unknown: UnknownFields = UnknownFields.NONE,
    val files: List<NxtFile> = emptyList(),
)

/**
 * A program in a project file.
 *
 * @property view how the pupil sees a program that has blocks; null for what the reader is used to.
 */
data class ProjectProgram(
    val program: Program,
    val view: ProgramView? = null,
    val unknown: UnknownFields = UnknownFields.NONE,
) {
    val name: String get() = program.name
    val language: ProgramLanguage get() = program.language
    val files: List<SourceFile> get() = program.files

    companion object {
        /** An `.rcx` file becomes assembly text. Null if it cannot, and for class files, which cannot be edited. */
        fun of(source: ProgramSource): ProjectProgram? = when (source) {
            is Program -> ProjectProgram(source)
            is ProgramSource.FirmwareImage -> source.toLasm()?.let(::ProjectProgram)
            is ProgramSource.CompiledClasses -> null
        }
    }
}

/**
 * The settings for runs of a [Project].
 *
 * @property seed replaces the world's seed; null keeps it.
 * @property realism replaces the world's realism, 0..1; null keeps it.
 * @property java settings of Java programs, for the [ProgramCompiler].
 */
data class ProjectSettings(
    val seed: Int? = null,
    val realism: Double? = null,
    val java: JavaSettings = JavaSettings(),
    val unknown: UnknownFields = UnknownFields.NONE,
)
