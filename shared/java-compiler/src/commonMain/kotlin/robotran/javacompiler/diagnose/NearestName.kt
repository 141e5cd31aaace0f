package robotran.javacompiler.diagnose

import robotran.language.editDistance

/** Longer names get no suggestion, and the number of comparisons is limited, to bound the time. */
private const val MAX_NAME_LENGTH = 40
private const val MAX_COMPARED_NAMES = 600

/** One typing error per three letters is allowed, because short names look alike too easily. */
private const val LETTERS_PER_TYPING_ERROR = 3

/** Returns the first candidate with the fewest typing errors in [name]; null if it has more than [maxErrors]. */
internal fun nearest(
    name: String,
    candidates: Collection<String>,
    maxErrors: Int = name.length / LETTERS_PER_TYPING_ERROR,
): String? {
    if (name.length > MAX_NAME_LENGTH) return null
    val others = candidates.asSequence().filter { it != name && it.length <= MAX_NAME_LENGTH }.take(MAX_COMPARED_NAMES)
    val lowercase = name.lowercase()
    return others.map { it to editDistance(lowercase, it.lowercase()) }.minByOrNull { it.second }
        ?.takeIf { (_, distance) -> distance <= maxErrors }?.first
}
