package robotran.language.pasted

/** The kinds of pasted characters, which sentences name. */
internal enum class PastedCharacterKind(val isUnseen: Boolean = false) {
    QUOTATION_MARK,
    DASH,
    MATHEMATICAL,
    WIDE,
    SPACE(isUnseen = true),
    LINE_BREAK(isUnseen = true),
    INVISIBLE(isUnseen = true),
    ;

    companion object {
        /** The kind of a character that has to be written as [plain], except the wide ones. */
        fun of(plain: String): PastedCharacterKind = when (plain) {
            "\"", "'" -> QUOTATION_MARK
            "-" -> DASH
            " " -> SPACE
            "\n" -> LINE_BREAK
            else -> MATHEMATICAL
        }
    }
}
