package robotran.ui.brick.front

import androidx.compose.foundation.Canvas
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.lerp

/** The colours of the lights of a matrix. */
internal class MatrixLook(val edge: Color, val off: Color, val on: Color)

/** 5 by 5 lights, each as bright as it is, 0..1. */
@Composable
internal fun LightMatrix(lights: List<Float>, look: MatrixLook, modifier: Modifier) = Canvas(modifier) {
    val cell = size.minDimension / SIDE
    val left = (size.width - SIDE * cell) / 2
    val corner = CornerRadius(cell * CORNER)
    for ((place, light) in lights.withIndex()) {
        val at = Offset(left + (place % SIDE + GAP) * cell, (place / SIDE + GAP) * cell)
        val side = Size(cell * (1 - 2 * GAP), cell * (1 - 2 * GAP))
        drawRoundRect(look.edge, at, side, corner)
        val inner = Rect(at, side).deflate(cell * EDGE)
        drawRoundRect(lerp(look.off, look.on, light), inner.topLeft, inner.size, corner)
    }
}

private const val SIDE = 5
private const val GAP = 0.09f
private const val CORNER = 0.2f
private const val EDGE = 0.04f
