package robotran.simulation.state

/**
 * How a goal stands. Equal goals that are judged alike give equal progress on every target: it is made by basic
 * arithmetic only.
 *
 * @property sentence what is to be done, for a pupil.
 * @property progress 0..1 in hundredths; 1 only if it is met. Of what must never happen it is 0 until the run is over.
 * @property parts the goals that it is made of, if it is.
 */
data class GoalProgress(
    val sentence: String,
    val status: GoalStatus,
    val progress: Double,
    val parts: List<GoalProgress> = emptyList(),
)

enum class GoalStatus {
    /** Not decided yet; for what must never happen: it has not happened yet. */
    PENDING,

    /**
     * Stays so, but for a condition that does not ([robotran.world.GoalCondition.staysMet]) and for what is made of
     * one.
     */
    MET,

    /** It cannot be met any more in this run. */
    FAILED,
}
