package robotran.ui.sheet3d

import androidx.compose.runtime.Immutable
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.lerp
import androidx.compose.ui.graphics.toArgb
import robotran.scene3d.model.RobotPalette
import robotran.scene3d.model.SceneColours
import robotran.ui.sheet.RobotColours
import robotran.ui.sheet.SheetColours
import robotran.uikit.*
import robotran.world.RobotPlacement

/**
 * The colours of the 3D view: those of the sheet, and what only a room has.
 *
 * @property skyTop the wall of the room, far above the desk.
 * @property horizon where the desk ends.
 * @property deskNear the desk in front.
 * @property shadow one layer of a shadow.
 * @property hasOutlines whether edges are drawn as lines, for contrast.
 */
@Immutable
internal data class SpaceColours(
    val sheet: SheetColours,
    val skyTop: Color,
    val horizon: Color,
    val deskNear: Color,
    val shadow: Color,
    val hasOutlines: Boolean,
) {
    fun scene(robots: List<RobotPlacement>): SceneColours = SceneColours(
        wall = lerp(SheetColours.WALL, Color.White, WALL_LIGHTER).toArgb(),
        wallTop = lerp(SheetColours.WALL, Color.White, WALL_TOP_LIGHTER).toArgb(),
        wallJoint = lerp(SheetColours.WALL, SheetColours.WALL_HATCHING, 0.7f).toArgb(),
        block = SheetColours.BLOCK.toArgb(),
        blockTop = lerp(SheetColours.BLOCK, Color.White, BLOCK_TOP_LIGHTER).toArgb(),
        blockGrain = SheetColours.BLOCK_GRAIN.toArgb(),
        lampOn = lerp(SheetColours.LAMP, Color.White, LAMP_LIGHTER).toArgb(),
        lampInfrared = lerp(SheetColours.LAMP_INFRARED, Color.White, LAMP_LIGHTER).toArgb(),
        lampOff = SheetColours.LAMP_OFF.toArgb(),
        lampShade = SheetColours.LAMP_SHADE.toArgb(),
        lampEdge = SheetColours.LAMP_EDGE.toArgb(),
        flag = SheetColours.FLAG.toArgb(),
        flagMet = SheetColours.REACH.toArgb(),
        flagLight = Color.White.toArgb(),
        robot = RobotPalette(
            brick = { RobotColours.brick(it).toArgb() },
            brickEdge = { RobotColours.edge(it).toArgb() },
            ink = { RobotColours.ink(it, robots).toArgb() },
            chassis = Color(0xFF34373B).toArgb(),
            chassisEdge = RobotColours.CHASSIS_EDGE.toArgb(),
            tyre = Color(0xFF35383C).toArgb(),
            tread = Color(0xFF4C5056).toArgb(),
            hub = RobotColours.CLIP.toArgb(),
            bumper = RobotColours.BUMPER.toArgb(),
            bumperEdge = RobotColours.BUMPER_EDGE.toArgb(),
            glass = RobotColours.GLASS.toArgb(),
            motor = RobotColours.MOTOR.toArgb(),
            clip = RobotColours.CLIP.toArgb(),
            lightSensor = RobotColours.LIGHT_SENSOR.toArgb(),
            sensorLamp = Color(0xFFFF4A3D).toArgb(),
            buttons = RobotColours.BUTTONS.map { it.toArgb() },
            beacon = SheetColours.LAMP.toArgb(),
            eye = RobotColours.EYE.toArgb(),
            pupil = RobotColours.PUPIL.toArgb(),
        ),
    )

    companion object {
        val LIGHT = of(RobotranColours.LIGHT)

        /** One layer of what something keeps of the light of a lamp. */
        val LAMP_SHADOW = Color(0x16000000)

        fun of(colours: RobotranColours): SpaceColours {
            val sky = if (colours.isDark) DARK_SKY else LIGHT_SKY
            return SpaceColours(
                SheetColours.of(colours),
                skyTop = lerp(colours.desk, sky, SKY),
                horizon = lerp(colours.desk, if (colours.isDark) Color.Black else Color.White, HORIZON),
                deskNear = colours.desk,
                shadow = Color.Black.copy(alpha = SHADOW_ALPHA),
                hasOutlines = colours.isHighContrast,
            )
        }

        private val LIGHT_SKY = Color(0xFFE9F1F7)
        private val DARK_SKY = Color(0xFF101418)
        private const val SKY = 0.8f
        private const val HORIZON = 0.22f
        private const val SHADOW_ALPHA = 0.065f
        private const val WALL_LIGHTER = 0.12f
        private const val WALL_TOP_LIGHTER = 0.3f
        private const val BLOCK_TOP_LIGHTER = 0.14f
        private const val LAMP_LIGHTER = 0.45f
    }
}
