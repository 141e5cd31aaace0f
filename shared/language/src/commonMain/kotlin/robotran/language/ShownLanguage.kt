package robotran.language

/**
 * The languages that a program can be shown in, besides the one that it is written in.
 *
 * @property programs the same, if pupils also program in it; null if they only read it.
 * @property extension the extension of its file names.
 */
enum class ShownLanguage(val programs: ProgramLanguage?, val extension: String) {
    JAVA(ProgramLanguage.JAVA),
    NQC(ProgramLanguage.NQC),
    LASM(ProgramLanguage.LASM),

    /** For hubs with Pybricks, and for a micro:bit. */
    PYTHON(null, ".py"),
    ;

    constructor(programs: ProgramLanguage) : this(programs, programs.extension)
}
