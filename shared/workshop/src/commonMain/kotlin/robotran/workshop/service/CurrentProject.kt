package robotran.workshop.service

import robotran.blockediting.BlockProgram
import robotran.documents.SavedBreakpoint
import robotran.programs.Program
import robotran.projects.Project
import robotran.simulation.state.SessionState
import robotran.world.RobotPlacement
import robotran.world.World

/** Read access to the open project. */
interface CurrentProject {
    /** The project as it would be saved now: programs, world and settings, without inputs, see [replay]. */
    val project: Project

    /** The world of [project]. */
    val world: World get() = project.world

    /** [project] with the inputs of the session and the programs that Run started. It reproduces the session. */
    val replay: Project

    /** Where its programs stop. */
    val savedBreakpoints: List<SavedBreakpoint> get() = emptyList()

    val shownProgram: Program

    /** [shownProgram] in blocks; null if it is shown as text alone. */
    val shownBlocks: BlockProgram? get() = null

    /** The robot whose programs are shown. */
    val shownRobot: RobotPlacement get() = project.world.robots.first()

    val session: SessionState
}
