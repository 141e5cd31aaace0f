package robotran.scene3d.model

/**
 * What the eyes of a robot show at one moment.
 *
 * @property gazeForwards where the pupils are, from the middle of the eyes: 1 for ahead, -1 for back.
 * @property gazeRightwards 1 for the robot's right, -1 for its left; with [gazeForwards] at most 1 long.
 */
data class RobotFace(val gazeForwards: Double = 0.0, val gazeRightwards: Double = 0.0, val lids: Lids = Lids.OPEN) {
    /** How the eyelids are. */
    enum class Lids {
        OPEN,
        SHUT,

        /** The upper lids hang down, most at the outer sides. */
        HANGING,

        /** The lower lids come up, as they do when somebody laughs. */
        RAISED,
    }

    companion object {
        /** It looks straight out of its eyes. */
        val STILL = RobotFace()
    }
}
