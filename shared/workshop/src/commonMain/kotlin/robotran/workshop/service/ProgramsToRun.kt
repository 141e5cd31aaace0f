package robotran.workshop.service

import robotran.documents.SavedBreakpoint
import robotran.nxt.storage.NxtFile
import robotran.programs.Program
import robotran.projects.ProjectRobot
import robotran.simulation.Breakpoint
import robotran.simulation.RobotProgramSet
import robotran.workshop.state.CompileStatus
import robotran.workshop.state.Snippet
import robotran.world.World

/** The programs of all robots, as written and as compiled. */
interface ProgramsOfRobots {
    val written: WrittenPrograms

    /** The number of programs of the first robot. */
    val count: Int

    /** The slot of the first robot's program that Run in the run bar starts: the one shown last. */
    val slotToRun: Int

    /**
     * The slots of the programs that Run in the run bar starts: [first] for the first robot, the last shown program for
     * the others.
     */
    fun slotsBeginning(first: Int): List<Int>

    /**
     * The programs of all robots in [world] as last compiled. Run starts the programs in [firstSlots], one per robot.
     */
    fun loads(world: World, firstSlots: List<Int>): List<RobotProgramSet>

    /** Whether the program in [slot] of the first robot, and those of the others, are compiled. */
    fun isCompiled(slot: Int): Boolean

    /** The breakpoints of the program in [slot] of the robot [robot]. */
    fun breakpoints(robot: String, slot: Int): Set<Breakpoint>

    /** The breakpoints at the lines of [program]; none if its source has changed since. */
    fun breakpointsOf(program: Snippet): Set<Breakpoint>

    /**
     * Keeps the [files] that the robot [robot] has in its flash memory now, for its next run and for the project. Returns
     * whether they are others than before.
     */
    fun keepFiles(robot: String, files: List<NxtFile>): Boolean

    /** The programs of all robots in [world] as stored in a project. */
    fun projectRobots(world: World): List<ProjectRobot>

    /** The breakpoints of all programs, in order. */
    val savedBreakpoints: List<SavedBreakpoint>
}

/** The programs of all robots as a run needs them. */
interface ProgramsToRun : ProgramsOfRobots {
    val shownProgram: Program

    /** The name of the robot whose programs are shown. */
    val shownRobot: String

    val compileStatus: CompileStatus

    /**
     * Whether the program in [slot] of the first robot, and those of the others, can run now. Shows the first error if
     * there is one. If a program is not compiled yet, has it compiled.
     */
    fun canStart(slot: Int): Boolean

    /** Compiles all changed programs, and publishes that. */
    suspend fun compile()

    /** Shows the programs of the robot [name]. */
    fun showRobot(name: String)

    /** Shows the file [name] of the program in [slot] of the robot [robot], if that program is shown. */
    fun showFile(robot: String, slot: Int, name: String)
}

/** All programs of all robots, and which of them can run. Two values are equal if nothing has changed between them. */
data class WrittenPrograms(val programs: List<List<Program>>, val runnable: List<List<Boolean>>)
