package robotran.cli.input

/** Parses a seed, an integer of at least 0; null if [text] is not one. */
internal fun readSeed(text: String): Int? = text.trim().takeIf { it.all(Char::isDigit) }?.toIntOrNull()

/** Parses `A..B` or `A`; null if [text] is neither, is descending or has more than [MAX_SEEDS] seeds. */
internal fun readSeeds(text: String): IntRange? {
    val ends = text.split("..").map { readSeed(it) ?: return null }
    if (ends.size > 2 || ends.last() < ends.first() || ends.last() - ends.first() >= MAX_SEEDS) return null
    return ends.first()..ends.last()
}

/** The max number of graded runs per program. */
internal const val MAX_SEEDS = 10_000
