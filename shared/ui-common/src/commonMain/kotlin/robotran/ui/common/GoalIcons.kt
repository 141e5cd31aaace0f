package robotran.ui.common

import robotran.simulation.state.GoalStatus
import robotran.uikit.*

/** The icon of a goal with [status]. */
fun iconFor(status: GoalStatus) = when (status) {
    GoalStatus.MET -> RunIcons.DONE
    GoalStatus.FAILED -> RunIcons.CLOSE
    GoalStatus.PENDING -> RunIcons.OPEN
}
