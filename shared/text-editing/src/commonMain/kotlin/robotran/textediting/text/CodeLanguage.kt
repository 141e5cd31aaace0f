package robotran.textediting.text

/**
 * What a program is written in.
 *
 * @property indent the blanks that a line inside a block has more than the line before the block.
 */
enum class CodeLanguage(val indent: String) {
    ROBOLANG("  "),
    JAVA("    "),
}
