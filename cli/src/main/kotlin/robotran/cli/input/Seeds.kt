package robotran.cli.input

/** A seed, a whole number from 0 on; null if [text] is none. */
internal fun readSeed(text: String): Int? = text.trim().takeIf { it.all(Char::isDigit) }?.toIntOrNull()

/** `A..B`, or `A` alone; null if [text] is neither, goes backwards or is more than [MAX_SEEDS]. */
internal fun readSeeds(text: String): IntRange? {
    val ends = text.split("..").map { readSeed(it) ?: return null }
    if (ends.size > 2 || ends.last() < ends.first() || ends.last() - ends.first() >= MAX_SEEDS) return null
    return ends.first()..ends.last()
}

/** As many runs of a program as grading makes at most. */
internal const val MAX_SEEDS = 10_000
