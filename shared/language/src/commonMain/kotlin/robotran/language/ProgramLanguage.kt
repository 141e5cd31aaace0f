package robotran.language

/**
 * The languages that pupils program in.
 *
 * @property extension the extension of its file names.
 * @property ownName its name, the same in all languages of pupils.
 * @property mayHaveFiles whether a program may consist of several files.
 */
enum class ProgramLanguage(val extension: String, val ownName: String, val mayHaveFiles: Boolean) {
    ROBOLANG(".robo", "Robolang", false),

    /** For leJOS on an RCX, and for leJOS NXJ on an NXT. */
    JAVA(".java", "Java", true),

    /** For LEGO's own firmware of the RCX. The first file is the program, the others are those that it includes. */
    NQC(".nqc", "NQC", true),

    /** The assembly text of LEGO's own firmware. */
    LASM(".lasm", "LASM", false),
    ;

    companion object {
        /** The language of a pupil's first program, and of the programs that worlds give to their robots. */
        val default: ProgramLanguage get() = ROBOLANG

        /** The language of a file with this name; null if its extension is none of a program's text. */
        fun ofFile(name: String): ProgramLanguage? = entries.find { name.endsWith(it.extension, ignoreCase = true) }

        /** The same, [default] if the extension is none of a program's text. */
        fun ofFileOrDefault(name: String): ProgramLanguage = ofFile(name) ?: default
    }
}
