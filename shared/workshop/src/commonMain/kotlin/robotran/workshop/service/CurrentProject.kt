package robotran.workshop.service

import robotran.projects.Project
import robotran.simulation.state.SessionState
import robotran.workshop.state.PupilProgram

/** What is open, to be read. */
interface CurrentProject {
    /** What would be saved now: programs, world and settings; without inputs, see [replay]. */
    val project: Project

    /**
     * [project] with what was done to the session so far and with the programs that Run has started: makes the same
     * session again.
     */
    val replay: Project

    /** The program that is shown. */
    val shownProgram: PupilProgram

    /** The session as it is shown. */
    val session: SessionState
}
