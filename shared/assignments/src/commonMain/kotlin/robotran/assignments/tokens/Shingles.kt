package robotran.assignments.tokens

import robotran.projects.Project
import robotran.projects.ProjectProgram

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
internal fun givenShingles(assignment: Project): Set<Int> {
    val first = assignment.world.robots.first()
    val open = assignment.robots.firstOrNull { it.name == first.name }?.programs.orEmpty()
    val solution = assignment.assignment?.solution.orEmpty().flatMap { program -> program.files.map { it.text.trim() } }
    val given = open.filter { program -> program.files.none { it.text.trim() in solution } }
    return shinglesOf(given + assignment.assignment?.start.orEmpty()).toSet()
}

/** The hashes of all runs of [SHINGLE_TOKENS] tokens of each program. */
internal fun shinglesOf(programs: List<ProjectProgram>): List<Int> = programs.flatMap { program ->
    val hashes = normalTokens(program).map { it.hashCode() }
    hashes.windowed(SHINGLE_TOKENS) { window ->
        window.fold(program.language.ordinal + 1) { hash, token -> hash * FACTOR + token }
    }
}

/** About two lines of Robolang. */
private const val SHINGLE_TOKENS = 4

/** About four lines of Robolang beyond what was given. */
internal const val FEWEST_SHINGLES = 10
private const val FACTOR = 1_000_003
