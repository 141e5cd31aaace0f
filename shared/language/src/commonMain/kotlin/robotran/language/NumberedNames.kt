package robotran.language

/**
 * Whether [typed] names another one of a series than [name], such as `OUT_D` and `OUT_A`, `way2` and `way1`: then it is
 * no typing error of it.
 */
fun isOtherOfSeries(typed: String, name: String): Boolean {
    val ending = endingOf(typed)
    return ending.isNotEmpty() && !typed.equals(name, ignoreCase = true) &&
        !endingOf(name).equals(ending, ignoreCase = true)
}

/** The [names] that differ from [typed] only in the number or letters at their end, as `S1` from `S5`; sorted. */
fun othersOfSeries(typed: String, names: Iterable<String>): List<String> {
    val ending = endingOf(typed)
    if (ending.isEmpty()) return emptyList()
    val beginning = typed.dropLast(ending.length)
    return names.filter { name ->
        name != typed && name.length == typed.length && name.startsWith(beginning) &&
            endingOf(name) == name.drop(beginning.length)
    }.distinct().sorted()
}

/** The number or the letters that tell the names of a series apart; empty if [name] is none of a series. */
private fun endingOf(name: String): String {
    val number = name.takeLastWhile { it in DIGITS }
    if (number.isNotEmpty()) return number
    val last = name.substringAfterLast('_')
    val isLetters = last.length <= MAX_LETTERS && last.isNotEmpty() && last.all { it in SERIES }
    return when {
        last.length == 1 && last[0] in CAPITALS -> last
        isLetters && last.length < name.length -> last
        name.length > 1 && name.last() in CAPITALS && name[name.length - 2].isLowerCase() -> name.takeLast(1)
        else -> ""
    }
}

private val DIGITS = '0'..'9'
private val CAPITALS = 'A'..'Z'

/** The letters of a brick's outputs, one more than there are. */
private val SERIES = 'A'..'D'
private const val MAX_LETTERS = 4
