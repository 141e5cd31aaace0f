package robotran.nqc.generate

/**
 * What the generation of a whole program has used.
 *
 * @property releasesAll the original compiler keeps the temporary variable of an array's index until the end of the
 * task in some expressions. True to release it, for programs that do not fit otherwise.
 */
internal class GenerationBudget(val releasesAll: Boolean) {
    var steps = 0

    /** Whether a variable found no place. */
    var isOutOfVariables = false
}
