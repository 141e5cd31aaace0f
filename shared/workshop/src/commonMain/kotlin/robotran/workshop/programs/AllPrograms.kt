package robotran.workshop.programs

import robotran.brick.kind.JavaPlatform
import robotran.documents.SavedBreakpoint
import robotran.language.Language
import robotran.nxt.storage.NxtFile
import robotran.programs.CompilerLoading
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.support
import robotran.projects.PENBOT_TARGET
import robotran.projects.Project
import robotran.projects.ProjectRobot
import robotran.projects.charactersInFile
import robotran.simulation.Breakpoint
import robotran.simulation.RobotProgramSet
import robotran.workshop.examples.firstProgram
import robotran.workshop.examples.isFirst
import robotran.workshop.service.ProgramsOfRobots
import robotran.workshop.service.Services
import robotran.workshop.service.WrittenPrograms
import robotran.workshop.service.asPupil
import robotran.workshop.state.Snippet
import robotran.world.RobotPlacement
import robotran.world.World

/**
 * The programs of all robots in a world, and which robot's are shown.
 *
 * @param roomInFile how many characters all programs may take in the project's file, see [charactersInFile].
 */
internal class AllPrograms(project: Project, services: Services, private val roomInFile: () -> Int) : ProgramsOfRobots {
    private val platform = services.platform
    private val preferences = services.preferences
    var compiler = ProgramCompiler(
        PENBOT_TARGET,
        project.settings.java,
        preferences.language,
        compilesBeside = platform.compilesBeside,
    )
        private set
    var robots = robotsOf(project)
        private set

    /** The name of the robot whose programs are shown, if it is there. */
    var chosenRobot = first.placement.name

    val first: RobotPrograms get() = robots.first()
    val shown: RobotPrograms get() = robots.firstOrNull { it.placement.name == chosenRobot } ?: first

    override val written: WrittenPrograms
        get() = WrittenPrograms(
            robots.map { it.list.programs },
            robots.map { robot -> robot.list.slots.map { it != null } },
        )

    override val count: Int get() = first.list.entries.size

    override val slotToRun: Int get() = first.shownProgram

    override fun projectRobots(world: World): List<ProjectRobot> =
        robots.filter { robot -> world.robots.any { it.name == robot.placement.name } }.mapNotNull {
            it.asProject(preferences.settings.programView)
        }

    override fun slotsBeginning(first: Int): List<Int> = starting(first).map { it.second }

    override fun loads(world: World, firstSlots: List<Int>): List<RobotProgramSet> =
        world.robots.mapIndexed { index, placement ->
            named(placement.name)?.load(firstSlots.getOrElse(index) { 0 }) ?: RobotProgramSet(emptyList())
        }

    override fun keepFiles(robot: String, files: List<NxtFile>): Boolean = named(robot)?.keep(files) == true

    override fun breakpoints(robot: String, slot: Int): Set<Breakpoint> = named(robot)?.breakpoints(slot).orEmpty()

    override fun breakpointsOf(program: Snippet): Set<Breakpoint> {
        val robot = named(program.robot) ?: return emptySet()
        val source = robot.list.programs.getOrNull(program.slot)?.files?.first()?.text
        return if (source == program.source) robot.breakpoints(program.slot) else emptySet()
    }

    override val savedBreakpoints: List<SavedBreakpoint>
        get() = robots.flatMap { robot -> robot.list.entries.flatMap { it.savedBreakpoints(robot.placement.name) } }

    /** Sets the breakpoints of all programs. */
    fun restoreBreakpoints(breakpoints: List<SavedBreakpoint>) {
        for (robot in robots) {
            val own = breakpoints.filter { it.robot == robot.placement.name }.groupBy { it.program }
            for ((program, lines) in own) {
                val slot = robot.list.entries.indexOfFirst { it.program.name == program }
                if (slot >= 0) robot.list.change(slot, robot.list.entries[slot].withBreakpoints(lines))
            }
        }
    }

    override fun isCompiled(slot: Int): Boolean = starting(slot).all { (robot, itsSlot) ->
        robot.list.isCompiled(itsSlot)
    }

    /** The robot that cannot start the program in [slot], or its own one, because of mistakes in it; null if all can. */
    fun withErrors(slot: Int): Pair<RobotPrograms, Int>? =
        starting(slot).firstOrNull { (robot, itsSlot) -> robot.isNeeded() && !robot.list.canRun(itsSlot) }

    /** Replaces all programs by those of [project]. */
    fun open(project: Project) {
        compiler = compiler.withJava(project.settings.java)
        robots = robotsOf(project)
        chosenRobot = first.placement.name
    }

    /**
     * Removes the first robot's programs that [isMeant]. If no other would be left than the first program as it came, it
     * begins with [beginning], or else with the programs of a robot to which nobody has given any.
     */
    fun remove(isMeant: (Program) -> Boolean, beginning: Program? = null) {
        val robot = first
        val placement = robot.placement
        val own = robot.list.programs.filterNot { isMeant(it) || it.isFirst }
        when {
            own.isEmpty() && beginning != null && placement.program == null -> robot.beginWith(beginning)

            robot.list.programs.none(isMeant) || robot.removeAll(isMeant) -> Unit

            placement.program == null -> robot.beginWith(firstProgram(preferences.language, preferences.words))

            else -> robots = listOf(robotOf(placement, ProjectRobot(placement.name), emptyList())) + robots.drop(1)
        }
    }

    /**
     * Puts the note of the first program into [language], and its words into those that the pupil prefers, unless the pupil
     * has changed that program.
     */
    fun translateFirst(language: Language) {
        for (robot in robots) {
            robot.list.programs.forEachIndexed { slot, program ->
                val translated = firstProgram(language, preferences.words)
                if (program.isFirst && program != translated) robot.replace(slot, translated)
            }
        }
    }

    /**
     * Updates the robots to those of [world]. Robots keep their programs by name; the first robot gets those of the
     * first.
     */
    fun moveTo(world: World) {
        val before = robots
        robots = world.robots.mapIndexed { index, placement ->
            val known =
                before.firstOrNull { it.placement.name == placement.name } ?: before.first().takeIf { index == 0 }
            known?.movedTo(placement) ?: robotOf(placement, ProjectRobot(placement.name), emptyList())
        }
        chosenRobot = shown.placement.name
    }

    /** Compiles all programs anew with [next]. */
    fun useCompiler(next: ProgramCompiler) {
        compiler = next
        robots = robots.map { it.compiledBy(next) }
    }

    /** Compiles all programs that have changed, in the background. */
    suspend fun compileChanged(): CompilerLoading {
        for (robot in robots) {
            val loading = robot.list.compilePending(platform.background)
            if (loading is CompilerLoading.Failure) return loading
        }
        return CompilerLoading.Success
    }

    /** Whether a robot has a program in Java for an NXT. */
    val needsNxjHelp: Boolean
        get() = robots.any { robot ->
            robot.brick.java == JavaPlatform.NXJ && robot.list.programs.any { it.language.support.hasSlowCompiler }
        }

    /** Whether the project can still be saved if [new] takes the place of [old] in one of its programs. */
    fun hasRoom(old: String, new: String): Boolean {
        if (new.length <= old.length) return true
        val programs = robots.flatMap { it.list.programs }
        if (programs.sumOf { it.characters } + new.length <= SURELY_SAVED) return true
        val now = programs.sumOf { program -> program.files.sumOf { charactersInFile(it.text) } }
        return now + charactersInFile(new) - charactersInFile(old) <= roomInFile()
    }

    private fun named(robot: String): RobotPrograms? = robots.firstOrNull { it.placement.name == robot }

    private fun starting(slot: Int): List<Pair<RobotPrograms, Int>> =
        robots.mapIndexed { index, robot -> robot to if (index == 0) slot else robot.shownProgram }

    /** The first robot, and all robots with a program that is not blank, need their programs. */
    private fun RobotPrograms.isNeeded() = this === first || !isBlank

    private fun robotsOf(project: Project): List<RobotPrograms> = project.world.robots.mapIndexed { index, placement ->
        val saved = project.robots.firstOrNull { it.name == placement.name } ?: ProjectRobot(placement.name)
        val programs = saved.programs.map { it.asPupil() }
        val isAlone = index == 0 && programs.isEmpty() && placement.program == null
        robotOf(
            placement,
            saved,
            if (isAlone) listOf(firstProgram(preferences.language, preferences.words)) else programs,
        )
    }

    private fun robotOf(placement: RobotPlacement, saved: ProjectRobot, programs: List<Program>) =
        RobotPrograms(placement, saved, compiler, programs, preferences.settings.programView)

    private companion object {
        /** In characters. Together they are short beside what a project's file may have. */
        const val SURELY_SAVED = 20_000
    }
}
