package robotran.ui.sheet3d

import robotran.world.geometry.Trigonometry
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.sin

/** The platform's own functions: good enough for pictures, of which no run depends. */
object ScreenTrigonometry : Trigonometry {
    override fun sine(angle: Double): Double = sin(angle)

    override fun cosine(angle: Double): Double = cos(angle)

    override fun angle(x: Double, y: Double): Double = atan2(y, x)
}
