package robotran.programs

/** The files of a pupil's program. */
sealed interface ProgramSource {
    /** The program's name, usually the name of its first file. */
    val name: String

    /** A program in Robolang, which always has one file. */
    data class Robolang(override val name: String, val text: String) : ProgramSource

    /**
     * A program in Java, for leJOS on an RCX or for leJOS NXJ on an NXT.
     *
     * @property files one or more source files. The main class is the class of the first file if it has a main method,
     * or else the first class that has one.
     */
    data class Java(override val name: String, val files: List<SourceFile>) : ProgramSource

    /**
     * A program in Java that was compiled elsewhere.
     *
     * @property classFiles the contents of its class files by file name.
     * @property mainClass the main class, with slashes; null for the first class with a main method.
     */
    class CompiledClasses(
        override val name: String,
        val classFiles: Map<String, ByteArray>,
        val mainClass: String? = null,
    ) : ProgramSource
}

/**
 * One file of a program.
 *
 * @property name its name, with or without folders, such as `Square.java`; it must match a public class in the file.
 * @property text its content, with any line breaks.
 */
data class SourceFile(val name: String, val text: String)
