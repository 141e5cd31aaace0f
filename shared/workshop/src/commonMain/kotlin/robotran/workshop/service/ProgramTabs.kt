package robotran.workshop.service

import robotran.language.source.Diagnostic
import robotran.programs.Program

/** The tabs with the programs of the current robot. */
interface ProgramTabs {
    /** Appends [program], or replaces the one with the same name if [replacing], and shows it. */
    fun addProgram(program: Program, replacing: Boolean = false)

    /** Shows the program at [index]. */
    fun chooseProgram(index: Int)

    /** Gives the first robot exactly [programs] and shows the first. Files of the same name can be undone. */
    fun replacePrograms(programs: List<Program>)

    /** Shows the line [line], from 1, of the first robot's program at [index]. */
    fun showLine(index: Int, line: Int)

    /** Removes the program at [index] without a message. */
    fun removeProgram(index: Int)

    /** Removes the first robot's programs that [isMeant] without a message; it always keeps some program. */
    fun removePrograms(isMeant: (Program) -> Boolean)

    /** Moves the caret of the shown program to [diagnostic]. */
    fun showDiagnostic(diagnostic: Diagnostic)
}
