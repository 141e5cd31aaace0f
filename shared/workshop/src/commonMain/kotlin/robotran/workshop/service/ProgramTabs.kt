package robotran.workshop.service

import robotran.workshop.state.PupilProgram

/** The tabs of the programs of the robot that is shown. */
interface ProgramTabs {
    /** Puts [program] behind the others, or in place of the one of the same name if [replacing], and shows it. */
    fun addProgram(program: PupilProgram, replacing: Boolean = false)

    /** Shows the program at [index]. */
    fun chooseProgram(index: Int)
}
