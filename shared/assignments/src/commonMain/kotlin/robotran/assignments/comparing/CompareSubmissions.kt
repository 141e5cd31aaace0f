package robotran.assignments.comparing

import robotran.assignments.collecting.Submission
import robotran.assignments.tokens.FEWEST_SHINGLES
import robotran.assignments.tokens.givenShingles
import robotran.assignments.tokens.shinglesOf
import robotran.projects.Project

/**
 * Two submissions with much in common.
 *
 * @property first index in the list that was compared; less than [second].
 * @property share of what they have in common, without what was given, 0..1: twice the common part of both together.
 */
data class SimilarPair(val first: Int, val second: Int, val share: Double) {
    /** Whether they differ at most in comments, blanks, order and chosen names. */
    val isEqual: Boolean get() = share == 1.0

    /** Whether a teacher should look at them. */
    val isMarked: Boolean get() = share >= MARKED_SHARE

    companion object {
        const val MARKED_SHARE = 0.8

        /** Below it, pairs are left out. */
        const val LOWEST_SHARE = 0.5
    }
}

/**
 * Finds the pairs of [submissions] whose programs are equal or nearly so, the most similar first. Comments, blanks and
 * chosen names do not count, and neither does what was given: the programs of [assignment] that the pupil began with.
 * Programs to which little was added are not compared at all. Two languages have nothing in common.
 */
fun compareSubmissions(submissions: List<Submission>, assignment: Project): List<SimilarPair> {
    val known = givenShingles(assignment)
    val shingles = submissions.map { submission ->
        val programs = (submission as? Submission.Usable)?.robot?.programs.orEmpty()
        shinglesOf(programs).filterNot { it in known }.toIntArray().apply { sort() }
    }
    val long = shingles.indices.filter { shingles[it].size >= FEWEST_SHINGLES }
    return long.flatMapIndexed { number, one ->
        long.drop(number + 1).mapNotNull { other ->
            val share = shareOf(shingles[one], shingles[other])
            if (share < SimilarPair.LOWEST_SHARE) null else SimilarPair(one, other, share)
        }
    }.sortedByDescending { it.share }
}

/**
 * Submissions of which each has much in common with another one of the group.
 *
 * @property members indices, ascending.
 * @property lowestShare the least share of the pairs that make it a group.
 */
data class SimilarGroup(val members: List<Int>, val lowestShare: Double)

/** The marked pairs of [pairs], with what belongs together as one group. */
fun similarGroups(pairs: List<SimilarPair>): List<SimilarGroup> {
    val marked = pairs.filter { it.isMarked }
    val groupOf = mutableMapOf<Int, MutableSet<Int>>()
    for (pair in marked) {
        val first = groupOf.getOrPut(pair.first) { mutableSetOf(pair.first) }
        val second = groupOf.getOrPut(pair.second) { mutableSetOf(pair.second) }
        if (first === second) continue
        first += second
        second.forEach { groupOf[it] = first }
    }
    return marked.groupBy { groupOf.getValue(it.first).min() }.map { (_, inside) ->
        SimilarGroup(groupOf.getValue(inside.first().first).sorted(), inside.minOf { it.share })
    }
}

/** Both sorted. */
private fun shareOf(one: IntArray, other: IntArray): Double {
    // The share cannot be more than this, and most pairs need no closer look.
    if (2.0 * minOf(one.size, other.size) / (one.size + other.size) < SimilarPair.LOWEST_SHARE) return 0.0
    var common = 0
    var left = 0
    var right = 0
    while (left < one.size && right < other.size) {
        val a = one[left]
        val b = other[right]
        if (a == b) common++
        if (a <= b) left++
        if (b <= a) right++
    }
    return 2.0 * common / (one.size + other.size)
}
