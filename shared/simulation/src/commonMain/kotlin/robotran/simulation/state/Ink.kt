package robotran.simulation.state

import robotran.world.geometry.Point

/**
 * Everything drawn so far; never changes once given out. A session gives out the same object until more is drawn, so
 * asking whether two are the same one tells whether to draw anew.
 *
 * @property strokes one for each time the pen was put down, the oldest first.
 * @property lengthCentimetres the exact way of the pen on the paper, also of what is drawn twice in the same place.
 */
class Ink(val strokes: List<InkStroke>, val lengthCentimetres: Double) {
    companion object {
        val NONE = Ink(emptyList(), 0.0)
    }
}

/**
 * A line drawn without lifting the pen.
 *
 * @property points its corners; a single one where the pen was put down and lifted in place. Straight and nearly
 * straight pieces are merged, the line stays within a twentieth of a millimetre of the pen's way.
 * @property robot whose pen it was: its number in the world, from 0.
 */
class InkStroke(val points: List<Point>, val robot: Int = 0)
