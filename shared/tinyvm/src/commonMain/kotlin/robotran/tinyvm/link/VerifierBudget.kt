package robotran.tinyvm.link

/** The words that the verifier may still compare for a program. */
internal class VerifierBudget(private var words: Long) {
    /** Spends [count] words; returns false if the budget is exceeded. */
    fun spend(count: Int): Boolean {
        words -= count
        return words >= 0
    }
}
