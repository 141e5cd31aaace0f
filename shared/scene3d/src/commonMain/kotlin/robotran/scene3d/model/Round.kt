package robotran.scene3d.model

import robotran.scene3d.geometry.ConvexPolygon
import robotran.world.geometry.Trigonometry
import kotlin.math.PI

/** Makes circles of a few corners. */
internal class Round(private val trigonometry: Trigonometry) {
    /** A regular polygon with its corners on the circle. */
    fun circle(x: Double, y: Double, radius: Double, corners: Int, turn: Double = 0.0) = ConvexPolygon(
        DoubleArray(corners * 2) {
            val angle = turn + (it / 2) * 2 * PI / corners
            if (it % 2 == 0) x + radius * trigonometry.cosine(angle) else y + radius * trigonometry.sine(angle)
        },
    )

    /** A rectangle whose corners are cut off by [cut]. */
    fun cutRectangle(left: Double, bottom: Double, right: Double, top: Double, cut: Double) = ConvexPolygon(
        doubleArrayOf(
            left + cut,
            bottom,
            right - cut,
            bottom,
            right,
            bottom + cut,
            right,
            top - cut,
            right - cut,
            top,
            left + cut,
            top,
            left,
            top - cut,
            left,
            bottom + cut,
        ),
    )

    /** A disc at [height], seen from above. */
    fun disc(x: Double, y: Double, height: Double, radius: Double, colour: Int, corners: Int = DISC_CORNERS) =
        Decal(flat(circle(x, y, radius, corners), height), colour)

    /** Studs of LEGO bricks at these [places]: dark rings with the lit tops a little above them. */
    fun studs(places: List<Pair<Double, Double>>, height: Double, colour: Int): List<Decal> = listOf(
        Decal(places.map { stud(it, height) }, shaded(colour, STUD_SIDE)),
        Decal(places.map { stud(it, height + STUD_HEIGHT) }, shaded(colour, STUD_TOP)),
    )

    private fun stud(place: Pair<Double, Double>, height: Double) =
        flat(circle(place.first, place.second, STUD_RADIUS, STUD_CORNERS), height)

    fun cosine(angle: Double) = trigonometry.cosine(angle)

    fun sine(angle: Double) = trigonometry.sine(angle)

    companion object {
        private const val DISC_CORNERS = 12
        private const val STUD_CORNERS = 8

        /** LEGO's: 4.8 mm wide, 1.8 mm high. */
        private const val STUD_RADIUS = 0.26
        private const val STUD_HEIGHT = 0.18
        private const val STUD_SIDE = 0.72
        private const val STUD_TOP = 1.06

        /** [polygon] at [height]. */
        fun flat(polygon: ConvexPolygon, height: Double) = DoubleArray(polygon.size * 3) {
            when (it % 3) {
                0 -> polygon.x(it / 3)
                1 -> polygon.y(it / 3)
                else -> height
            }
        }

        /** A rectangle at [height]. */
        fun plate(left: Double, bottom: Double, right: Double, top: Double, height: Double, colour: Int) =
            Decal(flat(ConvexPolygon.rectangle(left, bottom, right, top), height), colour, fine = false)
    }
}
