package robotran.tinyvm.link

/** How much looking at code a program may still cost, in words compared. */
internal class VerifierBudget(private var words: Long) {
    /** Takes [count] words; false if there are no more. */
    fun spend(count: Int): Boolean {
        words -= count
        return words >= 0
    }
}
