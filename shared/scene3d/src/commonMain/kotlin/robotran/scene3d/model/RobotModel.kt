package robotran.scene3d.model

import robotran.simulation.state.RobotState
import robotran.world.RobotPlacement
import robotran.world.penbotPorts

/**
 * A robot in perspective.
 *
 * @property number its index in the world.
 */
internal interface RobotModel {
    val number: Int

    /**
     * Its columns in [state], with the look of [face].
     *
     * @param bumpersOnly what is seen of a robot with the eye of its own: the rest is behind.
     */
    fun columns(state: RobotState, face: RobotFace, bumpersOnly: Boolean): List<SceneNode>

    companion object {
        fun of(number: Int, build: RobotPlacement, palette: RobotPalette, round: Round): RobotModel =
            if (build.description.penbotPorts != null) {
                PenbotModel(number, build, palette, round)
            } else {
                BuiltRobotModel(number, build, palette, round)
            }
    }
}
