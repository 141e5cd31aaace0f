package robotran.simulation.state

/**
 * The progress of a goal. It uses only basic arithmetic, so it is the same on every target.
 *
 * @property sentence what to do, for the pupil.
 * @property progress 0..1 in hundredths; 1 only if the goal is met. 0 until the run ends for a condition that must
 * never become true.
 * @property parts its subgoals, if any.
 * @property shortfall what the run lacked; null while the goal is met or may still be met.
 */
data class GoalProgress(
    val sentence: String,
    val status: GoalStatus,
    val progress: Double,
    val parts: List<GoalProgress> = emptyList(),
    val shortfall: GoalShortfall? = null,
)

enum class GoalStatus {
    /** Not decided yet; for a condition that must never become true: it has not become true yet. */
    PENDING,

    /**
     * Final, except for a condition that may change ([robotran.world.GoalCondition.staysMet]) and for groups that
     * contain one.
     */
    MET,

    /** This run can no longer meet it. */
    FAILED,
}
