package robotran.assignments.comparing

import robotran.assignments.collecting.Submission
import robotran.projects.Project
import robotran.projects.ProjectProgram

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

/** The solution of [assignment], to be recognised. It cannot be if it is very short, since many find a short one. */
internal class KnownSolution(assignment: Project) {
    private val known by lazy { givenShingles(assignment) }
    private val solutions by lazy {
        assignment.assignment?.solution.orEmpty().map(::essenceOf).filter { it.size >= FEWEST_SHINGLES }
    }

    /** Whether one of [programs] differs from a solution at most in comments, blanks and chosen names. */
    fun isIn(programs: List<ProjectProgram>): Boolean =
        solutions.isNotEmpty() && programs.any { essenceOf(it) in solutions }

    private fun essenceOf(program: ProjectProgram): List<Int> = shinglesOf(listOf(program)).filterNot { it in known }
}

/** What pupils get of [assignment]. */
private fun givenShingles(assignment: Project): Set<Int> {
    val first = assignment.world.robots.first()
    val open = assignment.robots.firstOrNull { it.name == first.name }?.programs.orEmpty()
    val solution = assignment.assignment?.solution.orEmpty().flatMap { program -> program.files.map { it.text.trim() } }
    val given = open.filter { program -> program.files.none { it.text.trim() in solution } }
    return shinglesOf(given + assignment.assignment?.start.orEmpty()).toSet()
}

/** The hashes of all runs of [SHINGLE_TOKENS] tokens of each program. */
private fun shinglesOf(programs: List<ProjectProgram>): List<Int> = programs.flatMap { program ->
    val hashes = normalTokens(program).map { it.hashCode() }
    hashes.windowed(SHINGLE_TOKENS) { window ->
        window.fold(program.language.ordinal + 1) { hash, token -> hash * FACTOR + token }
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

/** About two lines of Robolang. */
private const val SHINGLE_TOKENS = 4

/** About four lines of Robolang beyond what was given. */
private const val FEWEST_SHINGLES = 10
private const val FACTOR = 1_000_003
