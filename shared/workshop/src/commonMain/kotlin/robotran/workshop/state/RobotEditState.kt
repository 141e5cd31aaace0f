package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.robotediting.RobotEditing
import robotran.world.RobotColour

/**
 * The state of the workbench.
 *
 * @property robot the index of the robot in the world.
 * @property colour that of its brick.
 * @property sheetShown whether the robot is shown on the sheet instead of its plan.
 * @property fileError why a file was not opened, as a sentence; null if none was refused.
 * @property isSavingRefused whether the user tried to save an impossible robot.
 * @property hintsShown whether sentences about the robot are shown; false once the user has closed them.
 * @property number of the robot in the workbench: another one after a whole robot was replaced.
 */
@Immutable
data class RobotEditState(
    val editing: RobotEditing,
    val robot: Int,
    val colour: RobotColour,
    val sheetShown: Boolean = false,
    val fileError: String? = null,
    val isSavingRefused: Boolean = false,
    val hintsShown: Boolean = true,
    val number: Int = 0,
)
