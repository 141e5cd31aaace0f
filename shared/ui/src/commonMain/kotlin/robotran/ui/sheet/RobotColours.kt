package robotran.ui.sheet

import androidx.compose.ui.graphics.Color
import robotran.ui.theme.RobotranColours

/** The colours of the penbot seen from above; the same by day and by night. */
internal object RobotColours {
    val CHASSIS = Color(0xFF26282B)
    val CHASSIS_EDGE = Color(0xFF0F1011)
    val TYRE = Color(0xFF3A3D41)
    val TREAD = Color(0xFF85898E)
    val BUMPER = Color(0xFF9AA0A5)
    val BUMPER_EDGE = Color(0xFF4A4F54)
    val BRICK = RobotranColours.YELLOW
    val BRICK_EDGE = Color(0xFF8F7200)
    val GLASS = Color(0xFFBFC9B4)
    val CLIP = Color(0xFFC9CED2)
    val PEN_TIP_DOWN = RobotranColours.ON_OFF_RED
    val PEN_TIP_UP = Color(0xFFF4F4F2)
    val MOTOR = Color(0xFF6F7478)

    /** View, On-Off, Prgm, Run. */
    val BUTTONS = listOf(CHASSIS, RobotranColours.ON_OFF_RED, CLIP, RobotranColours.RUN_GREEN)
    val LIGHT_SENSOR = Color(0xFF1E4FB5)
}
