package robotran.workshop.programs

import robotran.languagesupport.SourceFile

/** A removed program or file that the pupil can restore. */
internal sealed interface ClosedFile {
    val name: String

    class Program(val entry: ProgramBuffer) : ClosedFile {
        override val name: String get() = entry.program.name
    }

    /** A class of the Java program in [slot] that was its file at the index [index]. */
    class OfProgram(val slot: Int, val index: Int, val file: SourceFile, val editorState: FileEditorState) :
        ClosedFile {
        override val name: String get() = file.name

        fun inSlot(slot: Int) = OfProgram(slot, index, file, editorState)
    }
}
