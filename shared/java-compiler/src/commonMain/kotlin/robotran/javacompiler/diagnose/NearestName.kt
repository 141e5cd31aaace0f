package robotran.javacompiler.diagnose

import robotran.language.nearestWords

/** Longer names get no suggestion, and the number of comparisons is limited, to bound the time. */
private const val MAX_NAME_LENGTH = 40
private const val MAX_COMPARED_NAMES = 600

/** One typing error per three letters is allowed, because short names look alike too easily. */
private const val LETTERS_PER_TYPING_ERROR = 3

/** Returns the candidates with the fewest typing errors in [name]; none if they have more than [maxErrors]. */
internal fun nearest(
    name: String,
    candidates: Collection<String>,
    maxErrors: Int = name.length / LETTERS_PER_TYPING_ERROR,
): List<String> {
    if (name.length > MAX_NAME_LENGTH) return emptyList()
    val others = candidates.asSequence().filter { it != name && it.length <= MAX_NAME_LENGTH }.take(MAX_COMPARED_NAMES)
    return nearestWords(name, others.asIterable(), maxErrors)
}
