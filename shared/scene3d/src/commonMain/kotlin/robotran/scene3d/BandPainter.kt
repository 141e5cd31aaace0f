package robotran.scene3d

import robotran.scene3d.camera.Projection
import robotran.scene3d.camera.SpaceTransform
import robotran.scene3d.geometry.Vector3
import robotran.scene3d.model.Band
import robotran.scene3d.model.Face
import robotran.scene3d.model.SceneNode
import robotran.scene3d.model.shaded

/** What is seen of a round side, as one polygon with a gradient across it. */
internal class BandPainter(
    private val band: Band,
    private val eye: Vector3,
    private val light: Vector3,
    private val transform: SpaceTransform,
    private val projection: Projection,
) {
    /** A polygon without its solid. */
    class Painted(private val contours: List<FloatArray>, private val colour: Int, private val shading: Shading?) {
        fun of(solid: SceneNode.Solid) = DrawnPolygon(contours, colour, shading, false, solid)
    }

    fun paint(): Painted? {
        val faces = band.faces
        val seen = faces.map { it.distanceTo(eye) > 0 }
        if (seen.none { it }) return null
        // The first one that is seen after one that is not; from far above, all may be.
        val first = faces.indices.firstOrNull { seen[it] && !seen[(it + faces.size - 1) % faces.size] } ?: 0
        val run = generateSequence(first) { (it + 1) % faces.size }.take(faces.size).takeWhile { seen[it] }
            .map { faces[it] }.toList()
        val outline = run.flatMap { it.corner(LOWER) } + run.last().corner(LOWER_NEXT) +
            run.last().corner(UPPER_NEXT) + run.asReversed().flatMap { it.corner(UPPER) }
        val points = transform.polygon(outline.toDoubleArray(), projection) ?: return null
        val colour = run.first().colour
        if (run.first().glows) return Painted(listOf(points), colour, null)
        return Painted(listOf(points), colour, shading(run))
    }

    private fun shading(run: List<Face>): Shading? {
        val first = pixel(run.first().corner(LOWER)) ?: return null
        val last = pixel(run.last().corner(LOWER_NEXT)) ?: return null
        val wayX = last.x - first.x
        val wayY = last.y - first.y
        val squared = wayX * wayX + wayY * wayY
        if (squared < 1) return null
        val parts = FloatArray(run.size)
        val colours = IntArray(run.size)
        var before = 0.0
        for ((number, face) in run.withIndex()) {
            val from = pixel(face.corner(LOWER)) ?: return null
            val to = pixel(face.corner(LOWER_NEXT)) ?: return null
            val x = (from.x + to.x) / 2 - first.x
            val y = (from.y + to.y) / 2 - first.y
            before = ((x * wayX + y * wayY) / squared).coerceIn(before, 1.0)
            parts[number] = before.toFloat()
            colours[number] = shaded(face.colour, brightness(face.normal, light))
        }
        return if (run.size < 2) {
            null
        } else {
            Shading(first.x.toFloat(), first.y.toFloat(), last.x.toFloat(), last.y.toFloat(), parts, colours)
        }
    }

    private fun pixel(corner: List<Double>) = transform.toScreen(corner[0], corner[1], corner[2], projection)

    private fun Face.corner(number: Int): List<Double> = List(AXES) { corners[number * AXES + it] }

    private companion object {
        const val AXES = 3
        const val LOWER = 0
        const val LOWER_NEXT = 1
        const val UPPER_NEXT = 2
        const val UPPER = 3
    }
}
