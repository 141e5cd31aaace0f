package robotran.ui.sheet

import androidx.compose.ui.graphics.Color
import robotran.uikit.*
import robotran.world.RobotColour
import robotran.world.RobotPlacement

/** The colours of the robot from above; the same in light and dark themes. */
object RobotColours {
    val CHASSIS = Color(0xFF26282B)
    val CHASSIS_EDGE = Color(0xFF0F1011)
    val TYRE = Color(0xFF3A3D41)
    val TREAD = Color(0xFF85898E)
    val BUMPER = Color(0xFF9AA0A5)
    val BUMPER_EDGE = Color(0xFF4A4F54)
    val GLASS = Color(0xFFBFC9B4)
    val CLIP = Color(0xFFC9CED2)
    val PEN_TIP_DOWN = RobotranColours.ON_OFF_RED
    val PEN_TIP_UP = Color(0xFFF4F4F2)
    val MOTOR = Color(0xFF6F7478)

    /** The light parts of an NXT, its motors and sensors, and what is orange on them. */
    val NXT_FACE = Color(0xFFEDEEEC)
    val NXT_GREY = Color(0xFFC9CED2)
    val ORANGE = Color(0xFFF07C1A)

    /** The pins of a micro:bit. */
    val GOLD = Color(0xFFD9B04A)

    /** View, On-Off, Prgm, Run. */
    val BUTTONS = listOf(CHASSIS, RobotranColours.ON_OFF_RED, CLIP, RobotranColours.RUN_GREEN)
    val LIGHT_SENSOR = Color(0xFF1E4FB5)
    val EYE = Color(0xFFFDFDFB)
    val PUPIL = Color(0xFF17191B)

    fun brick(colour: RobotColour): Color = when (colour) {
        RobotColour.YELLOW -> RobotranColours.YELLOW
        RobotColour.RED -> Color(0xFFD8402F)
        RobotColour.BLUE -> Color(0xFF3B82D6)
        RobotColour.GREEN -> Color(0xFF4BAA57)
        RobotColour.ORANGE -> Color(0xFFF08A24)
        RobotColour.PURPLE -> Color(0xFF9A5BC4)
        RobotColour.WHITE -> Color(0xFFF2F1EC)
        RobotColour.BLACK -> Color(0xFF4A4E53)
    }

    /** The edge colour of a brick, and the colour of its pen. */
    fun edge(colour: RobotColour): Color = when (colour) {
        RobotColour.YELLOW -> Color(0xFF8F7200)
        RobotColour.RED -> Color(0xFFA0261A)
        RobotColour.BLUE -> Color(0xFF1F5FA8)
        RobotColour.GREEN -> Color(0xFF226B30)
        RobotColour.ORANGE -> Color(0xFFA85A08)
        RobotColour.PURPLE -> Color(0xFF673087)
        RobotColour.WHITE -> Color(0xFF7C8085)
        RobotColour.BLACK -> Color(0xFF17191B)
    }

    /** The pen colour of the robot with this index in its world; always blue for the pupil's own. */
    fun ink(robot: Int, robots: List<RobotPlacement>): Color =
        robots.getOrNull(robot)?.takeIf { robot > 0 }?.let { edge(it.colour) } ?: SheetColours.INK
}
