package robotran.cli.translate

/** What `translate` writes. */
internal enum class TargetLanguage {
    /** Java for leJOS, or for an NXT with leJOS NXJ. */
    JAVA,

    /** For LEGO's own firmware. */
    NQC,

    /** The commands of LEGO's own firmware. */
    LASM,

    /** For a hub with Pybricks. */
    PYTHON,
    ;

    val word: String get() = name.lowercase()

    companion object {
        fun of(word: String): TargetLanguage? = entries.find { it.word == word.lowercase() }
    }
}
