package robotran.workshop.learning

import robotran.brick.program.BrickProgram
import robotran.programs.Program
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Notices
import robotran.workshop.service.ProgramTabs
import robotran.workshop.service.ScreenNavigator
import robotran.workshop.service.pupilPrograms
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane

/** Puts programs that come with the app into tabs beside the pupil's own. */
internal class NewTabs(
    private val current: CurrentProject,
    private val tabs: ProgramTabs,
    private val navigator: ScreenNavigator,
    private val notices: Notices,
) {
    /** Shows the first program that [isMeant]. Returns false if there is none. */
    fun choose(isMeant: (Program) -> Boolean): Boolean {
        val index = current.project.pupilPrograms.indexOfFirst(isMeant)
        if (index < 0) return false
        tabs.chooseProgram(index)
        navigator.show(Pane.PROGRAM)
        return true
    }

    /**
     * Adds [program] and shows it, in the place of one with its name if [replacing]. If there is no room, shows a message
     * and returns false.
     */
    fun add(program: Program, replacing: Boolean = false): Boolean {
        val programs = current.project.pupilPrograms
        if (programs.size >= BrickProgram.MAX_PROGRAMS && !(replacing && programs.any { it.name == program.name })) {
            notices.show(Notice.NoSlotForExample)
            return false
        }
        tabs.addProgram(program, replacing)
        navigator.show(Pane.PROGRAM)
        return true
    }

    /**
     * Adds [program], which comes with a world, and shows it. An unchanged program that a world brought makes room for
     * it, also one of the same name. If there is still no room, shows a message and returns false.
     */
    fun addGiven(program: Program): Boolean {
        val programs = current.project.pupilPrograms
        val isFull = programs.size >= BrickProgram.MAX_PROGRAMS
        val given = programs.filter { it.isGiven }
        val replaced = given.firstOrNull { it.name == program.name }
            ?: if (isFull) given.firstOrNull { it != current.shownProgram } ?: given.firstOrNull() else null
        if (isFull && replaced == null) {
            notices.show(Notice.NoSlotForTask)
            return false
        }
        // The only program cannot go before another has come.
        if (replaced != null && programs.size > 1) tabs.removePrograms { it == replaced }
        tabs.addProgram(program)
        navigator.show(Pane.PROGRAM)
        return true
    }

    /** Removes the first program that [isMeant], if there is one. */
    fun remove(isMeant: (Program) -> Boolean) {
        val index = current.project.pupilPrograms.indexOfFirst(isMeant)
        if (index >= 0) tabs.removeProgram(index)
    }
}
