package robotran.build.messages

/**
 * A language of people, a row of the table of languages.
 *
 * @property tag as in BCP 47.
 * @property constant its name in code.
 * @property groupSign between thousands in numbers of more than [ungroupedDigits] digits.
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
) {
    /** Of the generated classes, such as `German`. */
    val className: String get() = constant.split('_').joinToString("") {
        it.lowercase().replaceFirstChar(Char::uppercase)
    }
}

/**
 * Reads the rows of a Markdown table: tag, constant, own name, decimal sign, sign between thousands, digits without it,
 * numbers in the singular. Signs are in backticks.
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
        )
    }

private const val COLUMNS = 7
private const val UNGROUPED = 5
private const val SINGULAR = 6
