package robotran.build.messages

/**
 * A language of people, a row of the table of languages.
 *
 * @property tag as in BCP 47.
 * @property constant its name in code.
 * @property groupSign between thousands in numbers of more than [ungroupedDigits] digits.
 * @property isRightToLeft whether it is read from right to left.
 * @property singular the whole numbers that take the `one` arm of a plural.
 */
class SpokenLanguage(
    val tag: String,
    val constant: String,
    val ownName: String,
    val decimalSign: String,
    val groupSign: String,
    val ungroupedDigits: Int,
    val singular: List<Int>,
    val isRightToLeft: Boolean = false,
) {
    /** Of the generated classes, such as `German`. */
    val className: String get() = constant.split('_').joinToString("") {
        it.lowercase().replaceFirstChar(Char::uppercase)
    }
}

/**
 * Reads the rows of a Markdown table: tag, constant, own name, decimal sign, sign between thousands, digits without it,
 * numbers in the singular, direction. Signs are in backticks.
 */
fun readLanguages(path: String, text: String): List<SpokenLanguage> =
    text.lines().filter { it.startsWith("| ") }.drop(1).map { row ->
        val cells = row.trim('|', ' ').split(" | ").map { it.trim(' ').trim('`') }
        if (cells.size != COLUMNS) throw CatalogueException("$path: this row has not $COLUMNS cells: $row")
        val (tag, constant, ownName, decimalSign, groupSign) = cells
        SpokenLanguage(
            tag,
            constant,
            ownName,
            decimalSign,
            groupSign,
            cells[UNGROUPED].toInt(),
            cells[SINGULAR].split(',').map { it.trim().toInt() },
            isRightToLeft(path, cells[DIRECTION]),
        )
    }

private fun isRightToLeft(path: String, direction: String): Boolean = when (direction) {
    "right" -> false
    "left" -> true
    else -> throw CatalogueException("$path: a line goes on to the right or to the left, not to $direction")
}

private const val COLUMNS = 8
private const val UNGROUPED = 5
private const val SINGULAR = 6
private const val DIRECTION = 7
