package robotran.workshop.service

import robotran.projects.Project
import robotran.simulation.state.SessionState
import robotran.workshop.state.PupilProgram

/** Read access to the open project. */
interface CurrentProject {
    /** The project as it would be saved now: programs, world and settings, without inputs, see [replay]. */
    val project: Project

    /** [project] with the inputs of the session and the programs that Run started. It reproduces the session. */
    val replay: Project

    val shownProgram: PupilProgram

    val session: SessionState
}
