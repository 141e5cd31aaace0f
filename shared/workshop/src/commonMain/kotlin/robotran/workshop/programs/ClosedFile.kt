package robotran.workshop.programs

import robotran.workshop.state.ProgramFile

/** What a pupil has taken away and can bring back. */
internal sealed interface ClosedFile {
    /** What it is called. */
    val name: String

    /** A whole program. */
    class Program(val entry: ProgramBuffer) : ClosedFile {
        override val name: String get() = entry.program.name
    }

    /** A class of the Java program in [slot], where it was the file at [place]. */
    class OfProgram(val slot: Int, val place: Int, val file: ProgramFile, val memory: ProgramFileMemory) : ClosedFile {
        override val name: String get() = file.name
    }
}
