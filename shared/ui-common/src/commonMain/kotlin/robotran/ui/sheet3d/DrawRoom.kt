package robotran.ui.sheet3d

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Brush
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.scene3d.Scene
import robotran.scene3d.Shading
import robotran.scene3d.camera.Projection
import robotran.scene3d.drawnPolygons
import robotran.scene3d.shadowLayers
import robotran.world.Paper
import robotran.world.geometry.Point

/** The wall of the room and the desk, which grows lighter towards the horizon. */
internal fun DrawScope.drawRoom(colours: SpaceColours, projection: Projection) {
    val horizon = projection.horizon.toFloat()
    if (horizon > 0f) {
        val sky = Brush.verticalGradient(listOf(colours.skyTop, colours.horizon), horizon - size.height, horizon)
        drawRect(sky, Offset.Zero, Size(size.width, horizon.coerceAtMost(size.height)))
    }
    val top = horizon.coerceAtLeast(0f)
    if (top >= size.height) return
    val desk = Brush.verticalGradient(
        listOf(colours.horizon, colours.deskNear),
        horizon,
        horizon + projection.focal.toFloat() * DESK_FADE,
    )
    drawRect(desk, Offset(0f, top), Size(size.width, size.height - top))
}

/** What a sheet that lies on a desk does to the light at its edges. */
internal fun DrawScope.drawPaperShadow(paper: Paper, colours: SpaceColours, projection: Projection) {
    for (layer in 1..PAPER_SHADOWS) {
        val reach = layer * PAPER_SHADOW
        val corners = listOf(
            Point(-reach / 2, -reach),
            Point(paper.width + reach, -reach),
            Point(paper.width + reach, paper.height + reach / 2),
            Point(-reach / 2, paper.height + reach / 2),
        )
        drawPath(groundPath(corners, projection), colours.shadow)
    }
}

internal fun DrawScope.drawShadows(scene: Scene, colours: SpaceColours, projection: Projection) {
    for (layer in shadowLayers(scene, projection)) {
        val path = Path()
        for (polygon in layer) path.addPolygon(polygon)
        drawPath(path, colours.shadow)
    }
}

internal fun DrawScope.drawSolids3D(scene: Scene, colours: SpaceColours, projection: Projection) {
    val path = Path()
    val line = Stroke(1f)
    for (polygon in drawnPolygons(scene, projection)) {
        path.rewind()
        for (contour in polygon.contours) path.addPolygon(contour)
        val shading = polygon.shading
        if (shading == null) drawPath(path, Color(polygon.colour)) else drawPath(path, brushOf(shading))
        if (colours.hasOutlines && polygon.isSide) drawPath(path, colours.sheet.paperEdge, style = line)
    }
}

private fun brushOf(shading: Shading): Brush = Brush.linearGradient(
    colorStops = Array(shading.parts.size) { shading.parts[it] to Color(shading.colours[it]) },
    start = Offset(shading.fromX, shading.fromY),
    end = Offset(shading.toX, shading.toY),
)

/** In focal lengths below the horizon. */
private const val DESK_FADE = 0.9f
private const val PAPER_SHADOWS = 2

/** In centimetres. */
private const val PAPER_SHADOW = 0.5
