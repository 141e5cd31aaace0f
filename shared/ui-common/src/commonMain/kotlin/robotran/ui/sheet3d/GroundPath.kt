package robotran.ui.sheet3d

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Matrix
import androidx.compose.ui.graphics.Path
import robotran.scene3d.camera.Projection
import robotran.scene3d.camera.ScreenPoint
import robotran.world.geometry.Point

/** Adds the polygon with these [points], x and y in turn, in pixels. */
internal fun Path.addPolygon(points: FloatArray) {
    moveTo(points[0], points[1])
    for (corner in 1 until points.size / 2) lineTo(points[2 * corner], points[2 * corner + 1])
    close()
}

/** Adds what the camera sees of a polygon with these [corners] on the paper. */
internal fun Path.addGround(corners: List<Point>, projection: Projection, height: Double = 0.0) {
    val spatial = DoubleArray(corners.size * 3) {
        when (it % 3) {
            0 -> corners[it / 3].x
            1 -> corners[it / 3].y
            else -> height
        }
    }
    projection.polygon(spatial)?.let(::addPolygon)
}

/** [polygon] as a path of its own. */
internal fun groundPath(polygon: List<Point>, projection: Projection, height: Double = 0.0) =
    Path().apply { addGround(polygon, projection, height) }

fun ScreenPoint.toOffset() = Offset(x.toFloat(), y.toFloat())

/**
 * The matrix of Compose from the paper to pixels: from a place [x], [y] on it, right and up in steps of
 * [centimetres], with the second axis downwards if [isDown].
 */
internal fun Projection.groundMatrix(x: Double, y: Double, centimetres: Double = 1.0, isDown: Boolean = false): Matrix {
    val paper = paperMatrix()
    val matrix = Matrix()
    for (row in 0 until HOMOGENEOUS) {
        val alongX = paper[row * HOMOGENEOUS]
        val alongY = paper[row * HOMOGENEOUS + 1]
        val target = if (row < 2) row else PERSPECTIVE
        matrix[0, target] = (alongX * centimetres).toFloat()
        matrix[1, target] = (alongY * if (isDown) -centimetres else centimetres).toFloat()
        matrix[PERSPECTIVE, target] = (paper[row * HOMOGENEOUS + 2] + alongX * x + alongY * y).toFloat()
    }
    return matrix
}

private const val HOMOGENEOUS = 3

/** The index of the perspective in a matrix of Compose. */
private const val PERSPECTIVE = 3
