package robotran.nqc.api

import robotran.nqc.config.ParameterLimit

/**
 * A doc comment of a header, which is about all names until the next empty line:
 *
 *     /**
 *      * - en: Sets the power of motors, 0 to 7.
 *      * - es: ...
 *      * - de: ...
 *      * @limit power POWER
 *      * @names outputs OUT_A OUT_B
 *      */
 *     void SetPower(const int outputs, const int &power) { ... }
 *
 * `@limit` says which constants make sense for a parameter, as a [ParameterLimit]; `@names` which names of the API.
 */
internal class ApiDoc(comment: String) {
    /** One sentence about what the names do. */
    val help = ApiHelp(comment)

    private val tags = comment.lines().mapNotNull { line ->
        line.substringAfter(TAG, "").split(' ').takeIf { it.size > 2 }
    }

    /** The parameters that it says something about. */
    val taggedParameters: Set<String> get() = tags.map { it[1] }.toSet()

    /** The constants that make sense for [parameter]; null for all. */
    fun limitOf(parameter: String): ParameterLimit? =
        tags.firstOrNull { it[0] == LIMIT && it[1] == parameter }?.let { ParameterLimit.valueOf(it[2]) }

    /** The names of the API that [parameter] is made for. */
    fun namesFor(parameter: String): List<String> =
        tags.filter { it[0] == NAMES && it[1] == parameter }.flatMap { it.drop(2) }

    companion object {
        const val BEGINNING = "/**\n"

        /** The end of what a comment is about. */
        const val END = "\n\n"

        private const val TAG = " * @"
        private const val LIMIT = "limit"
        private const val NAMES = "names"
    }
}
