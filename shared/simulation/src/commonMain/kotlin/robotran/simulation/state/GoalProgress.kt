package robotran.simulation.state

/**
 * The progress of a goal. It uses only basic arithmetic, so it is the same on every target.
 *
 * @property sentence what to do, for the pupil.
 * @property progress 0..1 in hundredths; 1 only if the goal is met. 0 until the run ends for a condition that must
 * never become true.
 * @property parts its subgoals, if any.
 * @property holds whether it would be met if the run ended now.
 * @property shortfall what the run lacked; null while the goal is met or may still be met.
 */
data class GoalProgress(
    val sentence: String,
    val status: GoalStatus,
    val progress: Double,
    val parts: List<GoalProgress> = emptyList(),
    val holds: Boolean = status == GoalStatus.MET,
    val shortfall: GoalShortfall? = null,
)

enum class GoalStatus {
    /** Not decided yet, even if it [holds][GoalProgress.holds] now: what the run goes on to do may change that. */
    PENDING,

    /** Met for good: whatever the run goes on to do, it stays met. */
    MET,

    /** This run can no longer meet it. */
    FAILED,
}
