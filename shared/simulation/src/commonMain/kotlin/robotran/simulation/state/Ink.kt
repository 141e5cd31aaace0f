package robotran.simulation.state

import robotran.world.geometry.Point

/**
 * All ink so far; immutable. A session returns the same object until more is drawn, so callers can detect changes by
 * identity.
 *
 * @property strokes one for each time the pen was put down, oldest first.
 * @property lengthCentimetres the exact length of the pen's path on the paper, including parts drawn twice.
 */
class Ink(val strokes: List<InkStroke>, val lengthCentimetres: Double) {
    companion object {
        val NONE = Ink(emptyList(), 0.0)
    }
}

/**
 * A line drawn without lifting the pen.
 *
 * @property points its corners; a single one if the pen did not move. Straight and nearly straight segments are merged;
 * the line stays within a twentieth of a millimetre of the pen's path.
 * @property robot index of the pen's robot in the world.
 */
class InkStroke(val points: List<Point>, val robot: Int = 0)
