package robotran.ui.robot

import androidx.compose.ui.graphics.Color

/** What the workbench draws on its plan, which is light in every theme. */
internal object RobotBenchColours {
    val CASTER = Color(0xFF3A3D41)
    val LABEL = Color(0xFF1D2023)
    val LABEL_EDGE = Color(0xFF4A4F54)
    val WARNING = Color(0xFFB3261E)
}
