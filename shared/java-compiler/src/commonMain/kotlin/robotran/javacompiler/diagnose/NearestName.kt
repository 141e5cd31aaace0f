package robotran.javacompiler.diagnose

import robotran.language.editDistance

/** Longer names get no suggestion, and only so many are compared, so that it costs next to nothing. */
private const val LONGEST_NAME = 40
private const val COMPARED_NAMES = 600

/** Short names look alike too easily: one slip in three letters. */
private const val LETTERS_FOR_A_SLIP = 3

/**
 * The one of [candidates] that [name] is a slip of, with at most [forgiven] slips; null if none is near enough. The
 * first one wins a draw.
 */
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
