package robotran.scene3d

import robotran.scene3d.camera.Projection
import robotran.scene3d.camera.SpaceTransform
import robotran.scene3d.geometry.ConvexPolygon
import robotran.world.geometry.Point

/**
 * The shadows of [scene] on the paper, as polygons in pixels, in layers from the widest to the narrowest. Drawn over
 * each other, each in a faint black, they have a soft edge, softer the further it is from what casts them. The polygons
 * of a layer have the same direction, so that where they overlap it is not darker.
 */
fun shadowLayers(scene: Scene, projection: Projection): List<List<FloatArray>> {
    val transform = SpaceTransform.of(projection.view)
    return SOFTNESS.map { (reach, blur) ->
        scene.shades.mapNotNull { shade ->
            shadow(shade, reach, blur)?.let { transform.polygon(onPaper(it), projection) }
        }
    }
}

/** Of the light from the upper left; [reach] shortens it, [blur] makes it wider, in centimetres. */
private fun shadow(shade: Scene.Shade, reach: Double, blur: Double): ConvexPolygon? {
    val points = ArrayList<Point>(shade.footprint.size * 2 * BLUR_CORNERS.size)
    for (corner in 0 until shade.footprint.size) {
        val x = shade.footprint.x(corner)
        val y = shade.footprint.y(corner)
        for ((acrossX, acrossY) in BLUR_CORNERS) {
            points += Point(x + acrossX * blur / 2, y + acrossY * blur / 2)
            points += Point(
                x + ALONG_X * shade.top * reach + acrossX * blur,
                y + ALONG_Y * shade.top * reach + acrossY * blur,
            )
        }
    }
    return ConvexPolygon.around(points)
}

private fun onPaper(polygon: ConvexPolygon) = DoubleArray(polygon.size * 3) {
    when (it % 3) {
        0 -> polygon.x(it / 3)
        1 -> polygon.y(it / 3)
        else -> 0.0
    }
}

/** The way of a shadow for each centimetre of height. */
private const val ALONG_X = 0.5
private const val ALONG_Y = 0.36

private val SOFTNESS = listOf(1.1 to 1.0, 1.06 to 0.7, 1.02 to 0.45, 0.97 to 0.2, 0.92 to 0.0)
private val BLUR_CORNERS = listOf(
    1.0 to 0.0,
    0.7 to 0.7,
    0.0 to 1.0,
    -0.7 to 0.7,
    -1.0 to 0.0,
    -0.7 to -0.7,
    0.0 to -1.0,
    0.7 to -0.7,
)
