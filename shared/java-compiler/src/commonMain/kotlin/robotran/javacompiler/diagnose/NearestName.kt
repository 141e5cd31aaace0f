package robotran.javacompiler.diagnose

import robotran.language.editDistance

/** Longer names get no suggestion, and the number of comparisons is limited, to bound the time. */
private const val LONGEST_NAME = 40
private const val COMPARED_NAMES = 600

/** One typing error per three letters is allowed, because short names look alike too easily. */
private const val LETTERS_FOR_A_SLIP = 3

/** Returns the first candidate with the fewest typing errors in [name]; null if it has more than [forgiven]. */
internal fun nearest(
    name: String,
    candidates: Collection<String>,
    forgiven: Int = name.length / LETTERS_FOR_A_SLIP,
): String? {
    if (name.length > LONGEST_NAME) return null
    val others = candidates.asSequence().filter { it != name && it.length <= LONGEST_NAME }.take(COMPARED_NAMES)
    val lowercase = name.lowercase()
    return others.map { it to editDistance(lowercase, it.lowercase()) }.minByOrNull { it.second }
        ?.takeIf { (_, distance) -> distance <= forgiven }?.first
}
